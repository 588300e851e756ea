"""A catalogue that is sent with its files: it is composed of these alone, whatever their names and includes say."""

import json
from pathlib import Path
from typing import Any

import pytest

from sigcat.catalogue.hosting.source import Source, load
from sigcat.errors import InputRefused
from sigcat.limits import DEFAULT_LIMITS
from sigcat.registry.candidates.catalogue_files import content_of_files, document_of, files_of, sent_catalogue

ROOT = "Vehicle: {type: branch, description: A vehicle.}\n"
SPEED = "Vehicle.Speed: {type: sensor, datatype: float, unit: km/h, description: A speed.}\n"


def document(files: dict[str, str], tree: str = "tree.vspec", **more: Any) -> bytes:
    return json.dumps({"name": "fleet", "tree": tree, "files": files, **more}).encode()


def refusal(data: bytes) -> str:
    with pytest.raises(InputRefused) as caught:
        sent_catalogue(data, "fleet.catalogue.json", DEFAULT_LIMITS)
    return " ".join(f"{each.file}: {each.message}" for each in caught.value.findings)


def test_a_catalogue_is_what_it_was_where_it_was_read(tmp_path: Path) -> None:
    for name, text in {
        "vss/tree.vspec": f"{ROOT}#include parts/speed.vspec Vehicle\n",
        "vss/parts/speed.vspec": "Speed: {type: sensor, datatype: float, unit: knot, description: A speed.}\n",
        "own/limit.vspec": "Vehicle.Speed: {max: 60}\n",
        "own/units.yaml": "knot: {definition: A nautical mile an hour., unit: knot, quantity: velocity, allowed-datatypes: [numeric]}\n",
    }.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    overlay, units = tmp_path / "own/limit.vspec", tmp_path / "own/units.yaml"
    source = Source("fleet", "", tmp_path / "vss/tree.vspec", overlays=(overlay,), units=(units,))
    read = load(source)
    assert not read.findings
    sent = sent_catalogue(document_of(source, read), "fleet.catalogue.json", DEFAULT_LIMITS)
    assert {path: dict(node.values) for path, node in sent.catalogue.nodes.items()} == {
        path: dict(node.values) for path, node in read.nodes.items()
    }
    assert sent.content == content_of_files(files_of(read))
    assert (sent.catalogue.name, list(json.loads(sent.content)["files"])[:3]) == (
        "fleet",
        ["tree.vspec", "parts/speed.vspec", "../own/limit.vspec"],
    )


@pytest.mark.parametrize(
    "name",
    [
        "/etc/sigcat.vspec",
        "a/../../b.vspec",
        "../" * 17 + "a.vspec",
        "..",
        "a//b.vspec",
        "./a.vspec",
        "C:\\a",
        "a\0b",
        "a/",
    ],
)
def test_a_name_outside_is_refused(name: str) -> None:
    assert "must be a relative path" in refusal(document({"tree.vspec": ROOT, name: SPEED}))


@pytest.mark.parametrize("files", [{"a": "", "a/b": ""}, {"a/b": "", "a": ""}, {"x" * 300: ""}])
def test_names_that_no_folder_can_have_together_are_refused(files: dict[str, str]) -> None:
    assert "The names of the files must fit into a folder" in refusal(document({"tree.vspec": ROOT, **files}))


def test_an_include_of_a_file_of_the_service_is_not_read(tmp_path: Path) -> None:
    secret = tmp_path / "secret.vspec"
    secret.write_text("Password: {type: sensor, datatype: float, description: Secret.}\n")
    for target in (str(secret), f"{'../' * 40}{secret.relative_to('/')}"):
        said = refusal(document({"tree.vspec": f"{ROOT}#include {target} Vehicle\n"}))
        assert "Password" not in said
        assert "tree.vspec: Include" in said


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"{", "the document of a catalogue is invalid: Invalid JSON"),
        (b"[]", "the document of a catalogue is invalid"),
        (document({"tree.vspec": ROOT}, more=1), "more of a catalogue is invalid"),
        (document({"tree.vspec": 1}), "files.tree.vspec of a catalogue is invalid"),  # type: ignore[dict-item]
        (document({"other.vspec": ROOT}), "`files` must have 'tree.vspec', which the catalogue names."),
        (document({"tree.vspec": ROOT}, overlays=["o.vspec"]), "`files` must have 'o.vspec'"),
        (b'{"name": "x", "tree": "t", "files": {"t": "\\ud800"}}', "the document of a catalogue is invalid"),
        (document({"tree.vspec": f"{ROOT}{SPEED}Vehicle.A.B: {{type: branch}}\n"}), "tree.vspec: "),
    ],
)
def test_what_is_not_a_catalogue_is_refused(data: bytes, said: str) -> None:
    assert said in refusal(data)


def test_findings_do_not_name_folders_of_the_service() -> None:
    said = refusal(
        document({"tree.vspec": ROOT + "Vehicle.A.B: {type: branch, description: B.}\n#include no.vspec Vehicle\n"})
    )
    assert "/" not in said.replace("'.'", "")
