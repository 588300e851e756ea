"""sigcat exports every tree that vss-tools exports: one table says which errors of a tree stop an export."""

import shutil
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.exporting.export import export
from sigcat.catalogue.exporting.stopping import DECISIONS
from sigcat.data import INTERFACE_RULES, ROOT_FILE, VSPEC
from sigcat.errors import InputRefused
from sigcat.rules.compiled import compiled_rules
from tests.catalogue.vss_tools_output import Job, outputs
from tests.needs import OFFICIAL, official_releases
from tests.reference_tools import checked_with

ERRORS = [rule for rule in compiled_rules(INTERFACE_RULES) if rule.check == "composition" and rule.severity == "error"]
ROOT = "Vehicle: {type: branch, description: A vehicle.}\n"


def files_of(example: str | Mapping[str, Any]) -> dict[str, str]:
    """The files of an example of a rule, the tree first."""
    parts: dict[str, Any] = {"base": example} if isinstance(example, str) else dict(example)
    if "files" in parts:
        return dict(parts["files"])
    if "units" in parts:
        return {"tree.vspec": ROOT, "units.yaml": parts["units"], "quantities.yaml": parts["quantities"]}
    base = parts.get("whole") or parts["base"]
    return {"tree.vspec": base if "whole" in parts or base.startswith("-") else ROOT + base}


EXAMPLES = {
    f"{rule.id} {number}": (DECISIONS.get(rule.id, ""), files_of(example))
    for rule in ERRORS
    for number, example in enumerate(rule.bad, 1)
}
MORE = {
    "a node twice": "Vehicle.A: {type: branch, description: A.}\nVehicle.A: {type: branch, description: B.}\n",
    "an attribute twice": "Vehicle.A: {type: branch, description: A., description: B.}\n",
    "ranges with spaces": "Vehicle.A: {type: branch, description: A., instances: ['Circuit[1, 2]', 'Row[ 1,2]']}\n",
    "a range with a space refined": "Vehicle.A: {type: branch, description: A., instances: 'Circuit[2, 1]'}\n"
    "Vehicle.A.Circuit1: {type: branch, description: One.}\nVehicle.A.B: {type: sensor, datatype: int8}\n",
    "nodes inside a node": "Vehicle.A: {type: branch, B: {type: sensor, datatype: int8}, children: {C: {type: branch}}}\n",
    "numbers that are none": "Vehicle.A: {type: sensor, datatype: float, min: -.inf, x: [.nan, {y: .inf}], z: .nan}\n"
    "Vehicle.B: {type: sensor, datatype: 'float[]', default: [.nan], allowed: [.nan, 1.5]}\n",
    "empty names": "Vehicle..A: {type: branch}\nVehicle.: {type: branch, description: A.}\n",
    "a slash": "Vehicle.A/B: {type: branch, description: A.}\n",
    "nothing to include": "Vehicle.A: {type: branch, includes: ~, description: A.}\n",
    "a switch as a fraction": "Vehicle.A: {type: branch, instantiate: 1.0, aggregate: 0.0}\n",
    "a pattern in the first file": "Vehicle.A: {type: branch}\nVehicle.*: {type: branch, description: B.}\n",
}
OVERLAYS = {
    "a pattern and nodes of the same file": "Vehicle.A: {type: branch, comment: C.}\nVehicle.*: {comment: All.}\n"
    "Vehicle.New: {type: branch, description: N.}\n",
    "a pattern before a node": "Vehicle.*: {comment: All.}\nVehicle.A: {description: D.}\n",
}


def job(folder: Path, files: dict[str, str], arguments: tuple[str, ...] = ()) -> Job:
    folder.mkdir(parents=True)
    for name in ("units.yaml", "quantities.yaml"):
        shutil.copy(VSPEC / name, folder)
    for name, text in files.items():
        (folder / name).write_text(text)
    return Job("json", folder, ["-s", next(iter(files)), *arguments])


@pytest.fixture(scope="module")
def cases(tmp_path_factory) -> dict[str, Job]:
    folder = tmp_path_factory.mktemp("cases")
    jobs = {name: job(folder / name, files) for name, (_, files) in EXAMPLES.items()}
    jobs |= {name: job(folder / name, {"tree.vspec": ROOT + text}) for name, text in MORE.items()}
    base = f"{ROOT}Vehicle.A: {{type: branch, description: A.}}\n"
    return jobs | {
        name: job(folder / name, {"tree.vspec": base, "overlay.vspec": text}, ("-l", "overlay.vspec"))
        for name, text in OVERLAYS.items()
    }


@pytest.fixture(scope="module")
def expected_outputs(cases) -> dict[str, str | None]:
    return outputs(cases)


def ours(job: Job) -> str | None:
    """The export of sigcat; None where it is refused."""
    tree, overlays = job.folder / job.arguments[1], [job.folder / name for name in job.arguments[3::2]]
    try:
        (file,) = export(read_catalogue(tree, overlays), "json")
    except InputRefused:
        return None
    return file.data.decode()


def test_every_error_of_a_tree_is_decided():
    assert {rule.id for rule in ERRORS} == set(DECISIONS)


@checked_with(
    "vss-tools",
    "sigcat exports every tree that vss-tools exports, with the same bytes, and refuses those that it refuses",
)
@pytest.mark.parametrize("name", EXAMPLES)
def test_an_error_stops_an_export_where_it_stops_that_of_vss_tools(name, cases, expected_outputs):
    decision, _ = EXAMPLES[name]
    assert (expected_outputs[name] is not None) == (decision == "exported") or decision == "limit"
    assert ours(cases[name]) == (None if decision == "limit" else expected_outputs[name])


@checked_with(
    "vss-tools",
    "sigcat exports every tree that vss-tools exports, with the same bytes, and refuses those that it refuses",
)
@pytest.mark.parametrize("name", [*MORE, *OVERLAYS])
def test_what_vss_tools_exports_has_the_same_bytes(name, cases, expected_outputs):
    assert expected_outputs[name] is not None
    assert ours(cases[name]) == expected_outputs[name]


@cache
def public_jobs() -> dict[str, Job]:
    releases = {name: OFFICIAL / name / "spec" / "VehicleSignalSpecification.vspec" for name in ("v5.0", "v6.0")}
    overlays = [
        (tree, overlay)
        for tree in releases.values()
        for overlay in sorted((tree.parents[1] / "overlays").rglob("*.vspec"))
    ]
    return {
        f"{tree.parents[1].name} {overlay.stem} on {base.name}": Job("json", Path.cwd(), ["-s", str(base), "-l", str(overlay)])
        for tree, overlay in overlays
        for base in (tree, ROOT_FILE)
    }  # fmt: skip


@checked_with(
    "vss-tools",
    "sigcat exports every tree that vss-tools exports, with the same bytes, and refuses those that it refuses",
)
@official_releases
def test_every_public_overlay_that_vss_tools_exports_is_exported():
    told = outputs(public_jobs())
    exported = {name: text for name, text in told.items() if text is not None}
    assert exported
    assert {name: ours(public_jobs()[name]) == text for name, text in exported.items()} == dict.fromkeys(exported, True)
