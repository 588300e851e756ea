"""Detection of the kind of a file: one answer for the linter, the service, its pages and the hooks of pre-commit."""

import json
import re
from pathlib import Path

import pytest
import yaml

from sigcat.data import EXAMPLES, INTERFACE_RULES, OVERLAYS, VSPEC
from sigcat.file_kind import FileKind, file_kind, holds_function, holds_only_structs, is_json
from sigcat.platforms.schemas import SCHEMAS, schema
from sigcat.rules.linting.discovery import discover
from sigcat.rules.linting.posted import lint_text
from sigcat.rules.rule_set import RuleSet

PROJECT = Path(__file__).parents[1]
OVERLAY = b"Vehicle.Speed:\n  type: sensor\n  datatype: float\n"
FUNCTION = b"function: CoreAcc\ncomponents:\n  - name: Main\n"
RULES = b"ACME001:\n  name: short\n  check: path-depth\n"
FUNCTION_JSON = b'{"FunctionInfo": {"FunctionName": "CoreAcc"}}'
ROS2_JSON = b'{"FunctionInfo": {}, "CommunicationList": []}'
ADAPTIVE_JSON = b'{"FunctionInformation": {}}'


@pytest.mark.parametrize(
    ("data", "name", "kind"),
    [
        (OVERLAY, "body.vspec", "vspec"),
        (FUNCTION, "body.vspec", "vspec"),
        (OVERLAY, "BODY.VSPEC", "vspec"),
        (OVERLAY, "body.yaml", "vspec"),
        (b"Vehicle.Speed: {datatype: float, type: sensor}\n", "body.yaml", "vspec"),
        (OVERLAY, "", "vspec"),
        (b"", "units.yaml", "units"),
        (b"", "quantities.yml", "quantities"),
        (b"", "function.yaml", "function"),
        (b"", "acc.function.yml", "function"),
        (b"", "malfunction.yaml", "unknown"),
        (FUNCTION, "acc.yaml", "function"),
        (b"function: CoreAcc\n", "acc.yaml", "function"),
        (b'"function": "CoreAcc"\n', "acc.yaml", "function"),
        (b"function:\ncomponents:\n", "acc.yaml", "function"),
        (b"function:\n  handler: main\n", "serverless.yaml", "unknown"),
        (FUNCTION_JSON, "acc.json", "function json"),
        (FUNCTION_JSON, "ACC.JSON", "function json"),
        (FUNCTION_JSON, "function.yaml", "function json"),
        (b"\xef\xbb\xbf" + FUNCTION_JSON, "", "function json"),
        (ROS2_JSON, "acc.ros2.json", "integration json"),
        (ADAPTIVE_JSON, "acc.json", "integration json"),
        (b'{"name": "left-pad"}', "package.json", "unknown"),
        (b"{function: CoreAcc, components: []}", "function.yaml", "function"),
        (RULES, "our-rules.yaml", "rules"),
        (RULES.replace(b"\n", b"\r\n"), "our-rules.yaml", "rules"),
        (b"services:\n  web:\n    type: process\n", "compose.yaml", "unknown"),
        (b'{"openapi": "3.1.0", "components": {"schemas": {"A": {"properties": {"FunctionInfo": {}}}}}}', "api.json", "unknown"),
        (b'{"openapi": "3.1.0", "components": {"example": {"FunctionInformation": {}}}}', "", "unknown"),
        (b'{\n  "swagger": "2.0", "example": {\n"type": "sensor"}}', "api.yaml", "unknown"),
        (b"openapi: 3.1.0\ninfo:\n  example: {type: sensor}\n", "api.yaml", "unknown"),
        (b"openapi: '3.1.0'\nfunction: CoreAcc\ncomponents:\n  schemas: {}\n", "api.yaml", "unknown"),
        (b"$schema: https://json-schema.org/draft/2020-12/schema\nexamples: [{type: sensor}]\n", "a.yaml", "unknown"),
        (b'{"$schema": "x", "properties": {"FunctionInfo": {}, "FunctionInformation": {}}}', "a.schema.json", "unknown"),
        (b'{"$schema": "x", "FunctionInfo": {}}', "acc.json", "function json"),
        (b'{"A": "}\\"", "FunctionInfo": {', "acc.json", "function json"),
    ],
)  # fmt: skip
def test_name_and_content_tell_the_kind(data: bytes, name: str, kind: FileKind) -> None:
    assert file_kind(data, name) == kind


def test_everything_that_is_shipped_is_what_its_folder_says() -> None:
    kinds = {
        "rules": list(INTERFACE_RULES.glob("*.yaml")),
        "vspec": [*VSPEC.rglob("*.vspec"), *OVERLAYS.glob("*.vspec")],
        "function": list(EXAMPLES.rglob("function.yaml")),
    }
    for kind, files in kinds.items():
        assert files, kind
        assert {file_kind(file.read_bytes(), file.name) for file in files} == {kind}


def test_no_schema_and_no_description_of_an_api_is_a_document() -> None:
    written = [json.dumps(schema(name)).encode() for name in SCHEMAS]
    assert len(written) > 5
    described = (PROJECT / "docs/reference/openapi.json").read_bytes()
    assert {file_kind(data, "a.json") for data in (*written, described)} == {"unknown"}


def test_brackets_and_quotation_marks_are_read_once() -> None:
    for part in (b'"\\"' * 175_000, b"{" * 500_000, b'"' * 500_000):
        assert file_kind(part + b'"FunctionInfo"', "a.json") == "unknown"


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        (b"Types.Point:\n  type: struct\n", True),
        (b"Types.Point: {type: struct}\n", True),
        (b"Types.Point: {type: struct}\nVehicle.Speed: {type: sensor}\n", False),
        (OVERLAY, False),
    ],
)
def test_a_file_of_struct_types_holds_no_signal(text: bytes, answer: bool) -> None:
    assert holds_only_structs(text) is answer


def test_function_json_is_read_as_json_whatever_it_is_called() -> None:
    assert is_json(FUNCTION_JSON, "posted.yaml")
    assert is_json(b"", "acc.json")
    assert not is_json(FUNCTION, "function.yaml")
    assert not is_json(b"{function: CoreAcc}", "function.yaml")


@pytest.mark.parametrize("data", [FUNCTION, FUNCTION_JSON, ADAPTIVE_JSON])
@pytest.mark.parametrize("is_tree", [False, True])
def test_a_function_among_vspec_texts_is_one_finding(data: bytes, is_tree: bool) -> None:
    assert holds_function(data)
    (finding,) = lint_text(data, "posted.vspec", None, RuleSet(()), is_tree=is_tree)
    assert (finding.rule, finding.line) == ("F003", 1)


@pytest.mark.parametrize(
    "name",
    ["Body.vspec", "units.yaml", "quantities.yml", "function.yaml", "acc.function.yml", "malfunction.yaml", "ci.yaml",
     "our_units.yaml", "vspec", "function.json"],
)  # fmt: skip
def test_the_hook_for_changed_files_is_given_what_its_name_tells(name: str) -> None:
    hooks = {hook["id"]: hook for hook in yaml.safe_load((PROJECT / ".pre-commit-hooks.yaml").read_text())}
    is_known = file_kind(b"", name) != "unknown"
    for path in (name, f"folder/{name}"):
        assert bool(re.search(hooks["sigcat-lint"]["files"], path)) is is_known
        assert re.search(hooks["sigcat-lint-tree"]["files"], path) or not is_known


@pytest.mark.parametrize(
    ("name", "data", "in_folder", "by_name"),
    [
        ("a.yaml", b"a: 1\n", "other", "overlay"),
        ("a.json", b"{}", "other", "function"),
        ("a.JSON", b"{}", "other", "function"),
        ("ros2.json", ROS2_JSON, "other", "function"),
        ("a.yaml", FUNCTION, "function", "function"),
        ("units.yaml", b"", "vocabulary", "vocabulary"),
    ],
)
def test_a_file_that_the_user_names_is_not_passed_over(
    tmp_path: Path, name: str, data: bytes, in_folder: str, by_name: str
) -> None:
    file = tmp_path / name
    file.write_bytes(data)
    assert [source.kind for source in discover([tmp_path])] == [in_folder]
    assert [source.kind for source in discover([file])] == [by_name]
