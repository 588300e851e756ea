"""Each limit has a setting that reaches every route which reads a posted text, and a clear answer."""

import pytest

from sigcat.api.application import create_app
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library
from tests.api.conftest import Ask, asker

LINT, TRIAL = "/api/v1/lint", "/api/v1/catalogues/small/trial"
BUILD, VALIDATE = "/api/v1/functions/build", "/api/v1/functions/validate"
INTEGRATE, ARXML = "/api/v1/integrate/ros2", "/api/v1/generate/arxml"
YAML = (LINT, f"{LINT}?kind=tree", f"{LINT}?kind=function", TRIAL, BUILD, INTEGRATE)
JSON = (VALIDATE, ARXML, f"{LINT}?kind=function&name=a.json", f"{INTEGRATE}?name=a.json")


@pytest.fixture(scope="module")
def narrow(library: Library) -> Ask:
    return asker(create_app(library, Settings(body_bytes=50_000, nesting=5, values=1_000, nodes=1_000)))


@pytest.fixture(scope="module")
def wide(library: Library) -> Ask:
    return asker(create_app(library, Settings(nesting=9, values=9_000, nodes=9_000)))


def told(ask: Ask, address: str, text: bytes) -> str:
    """Return the texts of the findings."""
    answer = ask(address, "POST", content=text)
    assert answer.status_code in (200, 422), answer.text
    return " ".join(finding["message"] for finding in answer.json()["findings"])


@pytest.mark.parametrize("address", [*YAML, *JSON])
def test_nesting(narrow: Ask, wide: Ask, address: str) -> None:
    # YAML with fewer brackets than could hurt is measured where values are built
    text = (
        b'{"a": ' + b"[" * 6 + b"]" * 6 + b"}" if address in JSON else b"a: {b: " + b"[" * 3_000 + b"]" * 3_000 + b"}"
    )
    assert "nest deeper than 5 levels" in told(narrow, address, text)
    assert "nest deeper than 5 levels" not in told(wide, address, text)


@pytest.mark.parametrize("address", [*YAML, *JSON])
def test_values(narrow: Ask, wide: Ask, address: str) -> None:
    text = b'{"a": {"b": [' + b",".join(b"1" for _ in range(1_500)) + b"]}}"
    assert "1,000" in told(narrow, address, text)
    assert "9,000" not in told(wide, address, text)


def test_nodes(narrow: Ask, wide: Ask) -> None:
    text = b"Vehicle.Row: {type: branch, description: X., instances: ['Row[1,40]', 'Place[1,40]']}"
    assert "the limit is 1,000" in told(narrow, TRIAL, text)
    assert "the limit is" not in told(wide, TRIAL, text)


@pytest.mark.parametrize("address", [*YAML, *JSON])
def test_bytes(narrow: Ask, wide: Ask, address: str) -> None:
    refused = narrow(address, "POST", content=b"#" * 50_001)
    assert (refused.status_code, refused.json()["type"]) == (413, "/problems/body-too-large")
    assert "50,000 bytes" in refused.json()["detail"]
    assert wide(address, "POST", content=b"#" * 50_001).status_code in (200, 422)


@pytest.mark.parametrize("written", ["9" * 1_001, "1:" * 600 + "1", "1:" * 600 + "1.5", "0x" + "F" * 1_000])
def test_a_number_that_would_take_long_to_read_is_no_value(wide: Ask, written: str) -> None:
    text = f"Vehicle.X: {{type: sensor, datatype: float, description: X., max: {written}}}"
    assert "a number has at most 1,000 characters" in told(wide, LINT, text.encode())


def test_many_includes_of_a_text_are_refused_together(wide: Ask) -> None:
    messages = told(wide, LINT, b"#include a.vspec\n" * 350)
    assert messages.count("only files can include files") == 100
    assert "250 more includes are not read." in messages


def test_of_very_many_wrong_keys_the_first_are_told_and_how_many_more_there_are(wide: Ask) -> None:
    text = "".join(f"k{number}: 1\n" for number in range(2_000))
    report = wide(f"{LINT}?kind=function", "POST", content=text.encode()).json()
    assert report["finding_counts"]["errors"] == 1_001
    missing = 4
    assert f"{2_000 + missing - 1_000:,} more values are wrong" in " ".join(f["message"] for f in report["findings"])
