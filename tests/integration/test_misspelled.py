"""Keys of an Integration JSON that nothing would read."""

import json
from collections.abc import Callable

import pytest

from sigcat.cli import main
from sigcat.data import EXAMPLES
from sigcat.errors import InputRefused
from sigcat.integration.autosar_adaptive.document import read_integration as read_adaptive
from sigcat.integration.autosar_classic.document import read_integration as read_classic
from sigcat.integration.ros2.document import read_integration as read_ros2

EXPECTED = EXAMPLES / "ecocontrol/expected"
PLATFORMS = [(read_adaptive, "autosar-adaptive"), (read_classic, "autosar-classic"), (read_ros2, "ros2")]


def refused(read: Callable[..., object], document: object) -> list[tuple[str, str]]:
    with pytest.raises(InputRefused) as raised:
        read(json.dumps(document, indent=1).encode(), "edited.json")
    return [(finding.rule, f"{finding.message} {finding.fix}") for finding in raised.value.findings]


def edited(platform: str, old: str, new: str) -> object:
    """The document of a platform with a key that was written otherwise once."""
    text = (EXPECTED / f"{platform}.json").read_text()
    assert f'"{old}":' in text
    return json.loads(text.replace(f'"{old}":', f'"{new}":', 1))


@pytest.mark.parametrize(("read", "platform"), PLATFORMS)
def test_a_key_that_is_near_a_missing_one_is_refused(read, platform):
    assert refused(read, edited(platform, "VssPath", "VssPth")) == [
        ("F003", "Unknown key 'VssPth'; its value would be ignored. Did you mean 'VssPath'?")
    ]


@pytest.mark.parametrize(("read", "platform"), PLATFORMS)
def test_further_keys_are_taken(read, platform):
    """A document may have more than sigcat knows, also beside one with a near name."""
    document = json.loads((EXPECTED / f"{platform}.json").read_text())
    document["ReviewedBy"] = "them"
    document["ComponentLists"] = []
    assert read(json.dumps(document).encode(), "edited.json")


@pytest.mark.parametrize(("read", "platform"), PLATFORMS)
def test_carried_functions_keep_the_keys_that_they_were_given_with(read, platform):
    document = json.loads((EXPECTED / f"{platform}.json").read_text())
    del document["SourceFunctionList"][0]["Provenance"]
    document["SourceFunctionList"][0]["Provenence"] = {}
    assert read(json.dumps(document).encode(), "edited.json")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("version: 3.0", "`version` must be '3.0' or '2.0', not 3.0. Put quotes around it: it is read as a number."),
        ("Off: 1", "A key must be a text, not false. Put quotes around it: YAML reads words such as OFF"),
        ("interface: Off", "`interface` must be 'coSimulation' or 'scheduledExecution', not false.\n"),
    ],
)
def test_a_scalar_that_yaml_reads_otherwise_is_explained(text, said, tmp_path, capsys):
    (tmp_path / "deployment.yaml").write_text(f"fmi: {{{text}}}\n")
    function = EXAMPLES / "core_acc" / "function.yaml"
    deployment = str(tmp_path / "deployment.yaml")
    assert main(["integrate", "fmi", str(function), "--isolated", "--deployment", deployment]) == 1
    assert said in capsys.readouterr().err
