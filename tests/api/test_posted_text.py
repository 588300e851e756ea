"""Texts that are posted: linted, built, validated, and refused when they are hostile."""

import json
from collections.abc import AsyncIterator

import pytest

from sigcat.api.application import create_app
from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.data import EXAMPLES
from tests.api.conftest import Ask, asker
from tests.needs import published, published_files

DECLARATION = (EXAMPLES / "core_acc" / "function.yaml").read_bytes()


@pytest.fixture(scope="module")
def shipped() -> Ask:
    return asker(create_app(Library(shipped_sources()[:1])))


def test_an_overlay_is_checked_over_the_catalogue(ask: Ask) -> None:
    report = ask("/api/v1/lint", "POST", content=b"Vehicle.Sped:\n  min: 0\n", params={"name": "mine.vspec"}).json()
    assert not report["ok"]
    (error, *_) = [finding for finding in report["findings"] if finding["severity"] == "error"]
    assert (error["file"], error["line"], error["path"]) == ("mine.vspec", 1, "Vehicle.Sped")


def test_a_clean_overlay_has_no_findings(ask: Ask) -> None:
    text = b"Vehicle.Speed:\n  type: sensor\n  datatype: double\n  ASILlevel: B\n"
    assert ask("/api/v1/lint", "POST", content=text).json()["finding_counts"]["errors"] == 0


def test_a_declaration_becomes_function_json(shipped: Ask) -> None:
    built = shipped("/api/v1/functions/build", "POST", content=DECLARATION)
    assert built.status_code == 200
    assert built.json()["FunctionInfo"]["FunctionName"] == "CoreAcc"
    assert built.headers["sigcat-warnings"].isdecimal()
    assert shipped("/api/v1/functions/build", "POST", content=DECLARATION).content == built.content
    assert shipped("/api/v1/functions/validate", "POST", content=built.content).json()["ok"]


def test_a_declaration_that_cannot_be_built_is_refused_with_every_finding(shipped: Ask) -> None:
    refused = shipped("/api/v1/functions/build", "POST", content=DECLARATION.replace(b"Vehicle.", b"Vehicel."))
    assert refused.status_code == 422
    problem = refused.json()
    assert problem["type"] == "/problems/invalid-input"
    assert len(problem["findings"]) > 1
    assert all(finding["line"] and finding["pointer"] for finding in problem["findings"])
    linted = shipped("/api/v1/lint?kind=function", "POST", content=DECLARATION.replace(b"Vehicle.", b"Vehicel."))
    assert {f["message"] for f in linted.json()["findings"]} >= {f["message"] for f in problem["findings"]}


def test_a_declaration_is_validated_as_it_is_without_a_name(shipped: Ask) -> None:
    report = shipped("/api/v1/functions/validate", "POST", content=DECLARATION).json()
    assert report["ok"], report


@published_files
def test_the_published_function_json_is_accepted_with_warnings(shipped: Ask) -> None:
    content = published("function_model_core_acc.json")
    report = shipped("/api/v1/functions/validate", "POST", content=content).json()
    assert report["ok"]
    assert report["finding_counts"]["warnings"]


HOSTILE = {
    "nothing": b"",
    "not UTF-8": b"\xff\xfe\x00\xd8",
    "zeros": b"\0" * 500,
    "deep YAML": b"[" * 5_000,
    "deep JSON": b'{"a":' * 1_900,
    "aliases": b"a: &a [x]\nb: &b [*a,*a]\n" + b"".join(b"%c: &%c [*%c,*%c,*%c]\n" % (c + 1, c + 1, c, c, c) for c in range(98, 118)),
    "a tag": b"!!python/object/apply:os.system ['echo']",
    "a scalar": b"42",
    "a list": b"- 1\n- 2\n",
    "an include": b"#include /etc/passwd\n",
    "big numbers": b"Vehicle.X: {type: sensor, datatype: uint8, max: 1e999, min: " + b"9" * 4_000 + b"}",
    "markup": b"Vehicle.<script>alert(1)</script>: {type: sensor}",
    "a slow pattern": b"Vehicle.X: {type: sensor, datatype: string, pattern: '(a+)+$', default: " + b"a" * 40 + b"b}",
}  # fmt: skip


@pytest.mark.parametrize("address", ["/api/v1/lint", "/api/v1/lint?kind=tree", "/api/v1/lint?kind=function",
                                     "/api/v1/functions/build", "/api/v1/functions/validate"])  # fmt: skip
@pytest.mark.parametrize("case", HOSTILE)
def test_hostile_text_gets_a_clear_answer(ask: Ask, address: str, case: str) -> None:
    answer = ask(address, "POST", content=HOSTILE[case])
    assert answer.status_code in (200, 422), answer.text
    if answer.status_code == 422:
        assert answer.json()["findings"]
    json.dumps(answer.json(), allow_nan=False)


def test_a_body_beyond_the_limit_is_refused(ask: Ask) -> None:
    refused = ask("/api/v1/lint", "POST", content=b"a" * 10_001)
    assert refused.status_code == 413
    assert refused.json()["type"] == "/problems/body-too-large"
    assert "10,000 bytes" in refused.json()["detail"]


def test_a_body_that_does_not_tell_its_length_is_counted(ask: Ask) -> None:
    async def endless() -> AsyncIterator[bytes]:
        while True:
            yield b"a" * 1_000

    assert ask("/api/v1/lint", "POST", content=endless()).status_code == 413


@pytest.mark.parametrize("headers", [{"Content-Type": "multipart/form-data; boundary=x"}, {"Content-Encoding": "gzip"}])
def test_forms_and_compressed_bodies_are_refused_with_what_to_do(ask: Ask, headers: dict[str, str]) -> None:
    refused = ask("/api/v1/lint", "POST", content=b"Vehicle: {}", headers=headers)
    assert refused.status_code == 415
    assert refused.json()["detail"]


@pytest.mark.parametrize(
    "media_type", ["text/yaml", "application/json", "application/x-www-form-urlencoded", "nonsense"]
)
def test_the_media_type_does_not_matter(ask: Ask, media_type: str) -> None:
    assert ask("/api/v1/lint", "POST", content=b"{}", headers={"Content-Type": media_type}).status_code == 200


def test_a_function_that_is_posted_as_an_overlay_is_one_finding(shipped: Ask) -> None:
    report = shipped("/api/v1/lint?name=mine.yaml", "POST", content=DECLARATION).json()
    assert report["finding_counts"] == {"errors": 1, "warnings": 0, "infos": 0}
    assert report["findings"][0]["message"] == "The text must be an overlay, not a function."
    assert report["findings"][0]["fix"] == "Check it with the kind `function`."
