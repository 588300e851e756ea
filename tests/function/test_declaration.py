"""`function.yaml`: the structure of the file, and what is said about a wrong one."""

import datetime as dt
import re

import jsonschema
import pytest
import yaml

from sigcat.cli import main
from sigcat.data import EXAMPLES
from sigcat.function.declaration.declaration import declaration_schema, read_declaration
from sigcat.function.function_file import check_function, checked_file
from tests.function.shipped import FUNCTIONS, interfaces

HEAD = "function: F\ndescription: Does.\nresponsible: Team\ncomponents: [{name: F, runnables: [F_Step]}]\n"


def found(text: str) -> list[tuple[str, int, int, str]]:
    return [(f.rule, f.line, f.column, f.pointer) for f in read_declaration(text.encode(), "f").findings]


@pytest.mark.parametrize("path", FUNCTIONS, ids=lambda path: path.parent.name)
def test_the_schema_for_editors_accepts_the_examples(path):
    """Editors see a date as a text."""
    value = yaml.safe_load(path.read_text(encoding="utf-8"))
    value["date"] = str(value["date"])
    jsonschema.Draft202012Validator(declaration_schema()).validate(value)


def test_an_interface_may_be_given_by_its_name_alone():
    declared = read_declaration(HEAD.encode(), "f").declaration
    assert declared is not None
    assert declared.components[0].runnables[0].interface == "F_Step"


def test_every_defect_is_told_at_once():
    text = (
        "function: 5\ndescripton: x\nresponsible: Team\ncomponents:\n  - name: a\n    runnables:\n"
        "      - interface: X\n        data: [{path: A.B, role: consume, timeout: -1, queueLength: 1.5}]\n"
    )
    at = "/components/0/runnables/0/data/0"
    assert sorted(found(text)) == [
        ("F003", 2, 1, "/descripton"),
        ("F004", 1, 11, "/function"),
        ("F004", 8, 34, f"{at}/role"),
        ("F004", 8, 52, f"{at}/timeout"),
        ("F004", 8, 69, f"{at}/queueLength"),
    ]


def test_a_misspelled_key_is_answered_with_the_right_one():
    finding = read_declaration((HEAD + "athority: us\n").encode(), "f").findings[0]
    assert (finding.rule, finding.fix) == ("F003", "Did you mean 'authority'?")


def test_a_misspelled_key_is_one_finding_where_it_stands():
    """A misspelled key is not reported as missing as well; a missing one is."""
    assert found(HEAD.replace("description", "descripton")) == [("F003", 2, 1, "/descripton")]
    assert found(HEAD.replace("description", "remark")) == [("F002", 1, 1, ""), ("F003", 2, 1, "/remark")]


def test_a_word_that_yaml_reads_as_a_boolean_is_explained():
    text = HEAD + "modes: {active: [{mode: OFF, description: Off., runnables: []}]}\n"
    finding = read_declaration(text.encode(), "f").findings[0]
    assert finding.message == "`mode` must be a text, not false."
    assert "Put quotes around" in finding.fix


def test_a_key_that_yaml_reads_as_a_boolean_is_explained():
    full = next(path for path in FUNCTIONS if path.parent.name == "core_acc").read_text(encoding="utf-8")
    (finding,) = read_declaration(full.replace("{KM_PER_HOUR: 0", "{OFF: 0").encode(), "f").findings
    assert (finding.rule, finding.message) == ("F004", "A key must be a text, not false.")
    assert "Put quotes around" in finding.fix


@pytest.mark.parametrize("date", ["2025-01-01", "'2025-01-01'", '"2025-01-01"'])
def test_a_date_may_stand_in_quotes(date):
    declared = read_declaration((HEAD + f"date: {date}\n").encode(), "f").declaration
    assert declared is not None
    assert declared.date == dt.date(2025, 1, 1)


@pytest.mark.parametrize(
    ("date", "shown"),
    [("'2025-13-01'", "'2025-13-01'"), ("01.01.2025", "'01.01.2025'"), ("2025-01-01T10:00:00", "2025-01-01T10:00:00"),
     ("true", "true"), ("7", "7"), ("[]", "a list")],
)  # fmt: skip
def test_what_is_no_date_is_told_in_the_words_of_yaml(date, shown):
    (finding,) = read_declaration((HEAD + f"date: {date}\n").encode(), "f").findings
    assert finding.message == f"`date` must be a date such as 2025-09-12, not {shown}."


@pytest.mark.parametrize("text", ["- 1", "5", "text", "~"])
def test_a_file_that_is_no_mapping_is_one_finding(text):
    assert [rule for rule, *_ in found(text)] in (["F004"], ["F002"])


@pytest.mark.parametrize("name", ["*/ #include <x>", '"><script>alert(1)</script>', "a\nb", "'; DROP TABLE", "名前"])
def test_names_are_taken_as_they_are_written(name):
    text = yaml.safe_dump({**yaml.safe_load(HEAD), "description": name}, allow_unicode=True)
    declared = read_declaration(text.encode(), "f").declaration
    assert declared is not None
    assert declared.description == name


def test_of_an_own_interface_the_last_name_is_enough():
    """In every place that names errors, safety reactions, calls and modes: the Function JSON is the same."""
    full = next(path for path in FUNCTIONS if path.parent.name == "core_acc").read_text(encoding="utf-8")
    short = re.sub(r"CoreAcc_(\w+?)_ErrorSts|(AccReqInvalid)_SftyCondSts|CoreAcc_(?:Mode_)?([A-Z]\w+)", r"\1\2\3", full)
    assert {line.split(":")[0].strip() for line in short.splitlines() if "CoreAcc_" in line} == {"symbol"}
    built, of_short = (checked_file(text.encode(), "f.yaml", interfaces()) for text in (full, short))
    assert of_short.function
    assert built.function
    assert of_short.findings == built.findings == ()
    assert of_short.function.model_copy(update={"provenance": built.function.provenance}) == built.function


def test_a_last_name_that_only_another_function_has_is_not_meant():
    text = (
        "function: EcoControlMpc\ndescription: Control.\nresponsible: Control team\n"
        "components: [{name: E, runnables: [Init, {interface: Step, errors: [AliveError]}, Terminate]}]\n"
    )
    found = check_function(text.encode(), "f.yaml", interfaces())
    assert [(f.rule, f.path) for f in found if f.rule == "F013"] == [("F013", "AliveError")]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (
            "version: 1.0",
            "`version` must be a text, not 1.0. Put quotes around it: it is read as a number.",
        ),
        (
            "define: {types: {Line: {description: A., fields: {X: {datatype: float, description: X.}}}}}",
            "'Line' must be a path. Write a branch above the name, such as 'Branch.Line'.",
        ),
        (
            "modes: {zzz: 1}",
            "Unknown key 'zzz'. Use one of interfaces, in, out, active.",
        ),
    ],
)
def test_a_value_of_the_wrong_form_is_answered_with_the_right_one(line, message):
    text = (
        f"function: A\ndescription: A.\nresponsible: A team\ncomponents: [{{name: A, runnables: [A_Init]}}]\n{line}\n"
    )
    told = read_declaration(text.encode(), "f.yaml").findings
    assert [f"{finding.message} {finding.fix}" for finding in told] == [message]


@pytest.mark.parametrize(
    ("before", "after", "said"),
    [
        (
            "contract: Global variables\n        parallel",
            'contract: "a;b"\n        parallel',
            "25:19: error F113 `contract` must be a name of letters, digits, spaces and the signs _ - . : , /, not 'a;b'.",
        ),
        ("  - name: CoreAcc\n", '  - name: "a;b"\n', "18:11: error F113 `name` must be a name of letters"),
        (
            "  - name: CoreAcc\n",
            f"  - name: {'x' * 501}\n",
            "18:11: error F113 `name` must have at most 500 characters, not 501. Shorten it.",
        ),
    ],
)
def test_a_text_of_a_wrong_type_is_called_as_in_the_declaration(before, after, said, tmp_path, capsys):
    text = (EXAMPLES / "core_acc/function.yaml").read_text()
    assert before in text
    (tmp_path / "function.yaml").write_text(text.replace(before, after))
    assert main(["lint", str(tmp_path)]) == 1
    assert said in capsys.readouterr().out
