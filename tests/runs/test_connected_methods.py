"""Methods of one function of a set that another one uses."""

from pathlib import Path

import pytest

from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.errors import InputRefused
from sigcat.integration.reading import read_functions
from sigcat.runs.prepare import prepare

CASE = Path(__file__).parent / "cases/methods_of_another_function"


def connected(old="", new=""):
    """Server and client, of which a text is changed."""
    client = (CASE / "client.yaml").read_text()
    assert old in client
    texts = [
        ((CASE / "server.yaml").read_bytes(), str(CASE / "server.yaml")),
        (client.replace(old, new).encode(), str(CASE / "client.yaml")),
    ]
    functions, _ = read_functions(texts, load(shipped_sources()[0]))
    return prepare(functions).connections


def test_the_function_that_offers_a_method_answers_it_and_no_trace():
    connections = connected()
    answered = {connections.entries[index].names[0]: server.member for index, server in connections.servers.items()}
    assert answered == {"FetchLimit": 0, "Reset": 0}
    assert "FetchLimit" not in connections.received


def test_a_method_that_nobody_offers_is_answered_by_the_trace():
    connections = connected("name: FetchLimit", "name: FetchSpeed")
    assert {connections.entries[index].names[0] for index in connections.servers} == {"Reset"}
    assert "FetchSpeed" in connections.received


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("{name: Limit, datatype: float", "{name: Limit, datatype: double"),
        ("{name: Place, datatype: uint16", "{name: Place, datatype: uint8"),
    ],
)
def test_both_sides_must_have_the_same_arguments_and_results(old, new):
    with pytest.raises(InputRefused) as refused:
        connected(old, new)
    (finding,) = refused.value.findings
    assert (finding.rule, Path(finding.file).name, finding.line) == ("F100", "client.yaml", 17)
    assert "arguments and results that it has in Server" in finding.message
