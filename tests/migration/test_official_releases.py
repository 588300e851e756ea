"""Overlays and functions between official releases: every certain change is right, by what both sides resolve to."""

import random
import shutil
from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
import yaml

from scripts.census import RELEASES
from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import source_of_tree
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.yaml_document import read_document
from sigcat.cli import main
from sigcat.data import EXAMPLES
from sigcat.data import OVERLAYS as OVERLAYS_FOLDER
from sigcat.function.function_json.conversion import between
from sigcat.migration.changed_text import Migrated, migrated
from sigcat.migration.migration import Migration
from sigcat.migration.overlay_changes import OverlayFile, overlay_changes
from sigcat.migration.table import release_of, tables_between
from tests.needs import IS_SLOW_RUN, OFFICIAL, c_compiler, official_releases

OVERLAYS = 200 if IS_SLOW_RUN else 100
_HERE = [name for name in RELEASES if (OFFICIAL / name).is_dir()]
_NEIGHBOURS = list(pairwise(_HERE)) or [("v5.0", "v6.0")]
PAIRS = [pair for old, new in _NEIGHBOURS for pair in ((old, new), (new, old))]
SIGNALS = ("sensor", "actuator", "attribute")


def _migration(old: str, new: str) -> Migration:
    trees = [load(source_of_tree(str(OFFICIAL / name / "spec"))) for name in (old, new)]
    return Migration(trees[0], trees[1], tables_between(*map(release_of, trees)))


def _values(path: str, catalogue: Catalogue) -> Mapping[str, Any]:
    node = catalogue.get(path)
    return node.values if node is not None else catalogue.definitions[path].values


def _paths(migration: Migration) -> tuple[list[str], list[str]]:
    """Return the signals of the old tree, and those of them that change."""
    old = migration.old
    signals = [p for p in {**old.definitions, **old.nodes} if _values(p, old).get("type") in SIGNALS]
    changed = []
    for path in signals:
        both = migration.definitions(path, migration.fate(path).path)
        if both is None or any(both[0].get(name) != both[1].get(name) for name in ("unit", "datatype")):
            changed.append(path)
    return signals, changed


def _overlay(choice: random.Random, paths: tuple[list[str], list[str]], old: Catalogue) -> str:
    lines = [choice.choice(["# ours: ä", "# 'quoted'", ""])]
    for path in dict.fromkeys(
        choice.choice(choice.choice([each for each in paths if each])) for _ in range(choice.randint(1, 6))
    ):
        lines += _statement(choice, path, _values(path, old))
    return choice.choice(["\n", "\r\n"]).join([*lines, choice.choice(["", "# end"])])


def _statement(choice: random.Random, path: str, values: Mapping[str, Any]) -> Iterator[str]:
    quote = choice.choice(["", "'", '"'])
    yield f"{quote}{path}{quote}:  # {path}"
    for name in ("type", "datatype", "unit"):
        if name in values and choice.random() < 0.5:
            yield f"  {name}: {quote}{values[name]}{quote}"
    if values["datatype"] in ("float", "double", "uint16", "int16", "uint32"):
        yield f"  max: {choice.choice([1, 50, 100])}   # limit"
    yield f"  comment: {path} stays in texts"


def _migrated(text: str, migration: Migration) -> Migrated:
    document = read_document(text.encode(), "ours.vspec")
    assert document.root is not None
    return migrated(
        "ours.vspec",
        text.encode(),
        overlay_changes(OverlayFile("ours.vspec", document.text, document.root, "", migration)),
    )


def _limit(values: Mapping[str, Any], stated: Mapping[str, Any], catalogue: Catalogue) -> tuple[Fraction, str]:
    unit = catalogue.vocabulary.unit(str(stated.get("unit", values.get("unit"))))
    return Fraction(str(stated["max"])), unit.key if unit is not None else ""


def _check(path: str, before: Mapping[str, Any], target: str, after: Mapping[str, Any], migration: Migration) -> None:
    """Compare what a statement means on both sides."""
    old, new = _values(path, migration.old), _values(target, migration.new)
    assert before["comment"] == after["comment"]
    if "datatype" in before:
        assert after["datatype"] == new["datatype"]
    if "max" in before:
        limit, unit = _limit(old, before, migration.old)
        limit_after, unit_after = _limit(new, after, migration.new)
        conversion = between(unit, unit_after)
        assert conversion is not None
        assert abs(conversion(limit) - limit_after) * 20 <= abs(conversion.factor)


@official_releases
@pytest.mark.parametrize(("old", "new"), PAIRS)
def test_generated_overlays_mean_the_same(old, new):
    migration, choice = _migration(old, new), random.Random(f"{old} {new}")
    paths = _paths(migration)
    checked = 0
    for _ in range(OVERLAYS):
        text = _overlay(choice, paths, migration.old)
        result = _migrated(text, migration)
        after = result.after.decode()
        assert not _migrated(after, migration).is_changed
        undecided = {finding.path for finding in result.findings}
        both = zip(yaml.safe_load(text).items(), yaml.safe_load(after).items(), strict=True)
        for (path, before), (target, stated) in both:
            if path not in undecided:
                assert target == migration.fate(path).path
                _check(path, before, target, stated, migration)
                checked += 1
        lines = {line for line, _ in result.changes}
        kept = [line for number, line in enumerate(text.split("\n"), 1) if number not in lines]
        assert [line for line in kept if line not in after.split("\n")] == []
    assert checked > OVERLAYS


FUNCTION = """\
function: Trip
description: Watches the trip.
responsible: Engine team
code: {signature: globals, sources: [trip.c], headers: [trip.h]}
components:
  - name: Trip
    runnables:
      - interface: Step
        symbol: step
        data:
          - {path: Vehicle.TripMeterReading, role: consumed, variable: trip}
          - {path: Vehicle.Powertrain.CombustionEngine.ECT, role: consumed, variable: ect}
          - {path: Vehicle.Powertrain.CombustionEngine.Speed, role: consumed, variable: speed}
          - {path: Vehicle.Cooling, role: provided, variable: out}
define:
  scheduling:
    Step: {description: Watches., cycleTime: 10, asil: QM}
  data:
    Vehicle.Cooling: {datatype: float, asil: QM, description: Cooling.}
"""
HEADER = "extern float trip, ect, out; extern unsigned short speed; void step(void);\n"
CODE = '#include "trip.h"\nfloat trip, ect, out; unsigned short speed;\nvoid step(void) { out = trip / 3.0f + ect * speed; }\n'
TRACE = (
    "time,Vehicle.TripMeterReading,Vehicle.Powertrain.CombustionEngine.ECT,Vehicle.Powertrain.CombustionEngine.Speed\n"
)


@official_releases
@c_compiler
@pytest.mark.real
def test_a_migrated_function_gives_the_same_bits(tmp_path, monkeypatch):
    folder, runs = tmp_path / "project", [tmp_path / name for name in ("before.csv", "after.csv")]
    folder.mkdir()
    monkeypatch.chdir(folder)
    rows = "".join(f"{n / 100},{12.5 + n / 1000},{20.1 * n},{800 + 37 * n}\n" for n in range(40))
    for name, text in (("function.yaml", FUNCTION), ("trip.h", HEADER), ("trip.c", CODE), ("drive.csv", TRACE + rows)):
        (folder / name).write_text(text)
    old, new = (str(OFFICIAL / name / "spec") for name in ("v5.0", "v6.0"))
    run = ("simulate", "function.yaml", "--trace", "drive.csv", "--isolated")
    assert main([*run, "-s", old, "-o", str(runs[0])]) == 0
    assert main(["migrate", "--isolated", old, new, "."]) == 0
    assert (folder / "trip.c").read_text() == CODE
    assert main([*run, "-s", new, "-o", str(runs[1])]) == 0
    assert runs[0].read_bytes() == runs[1].read_bytes()


EXAMPLE_FUNCTIONS = ("core_acc", "eco_control_mpc", "wheel_speed_calculation")
NOT_IN_5 = "Vehicle.ADAS.ObstacleDetection.Front.Center.Distance"
OWN_IN_5 = "Vehicle.ADAS.EcoControl.ObstacleDistance"
"""The distance, which the tree of 5.0 does not have, as a signal of the project."""
SHOWN_ROWS = 2_000


def _ecocontrol_for_5(folder: Path) -> list[str]:
    """Write the examples as they are for 5.0, and return the arguments that simulate them but for the tree."""
    for name in EXAMPLE_FUNCTIONS:
        shutil.copytree(EXAMPLES / name, folder / name, ignore=shutil.ignore_patterns("expected", "build"))
    function = folder / "core_acc" / "function.yaml"
    function.write_text(function.read_text().replace(NOT_IN_5, OWN_IN_5))
    rows = (EXAMPLES / "ecocontrol" / "drive.csv").read_text().replace(NOT_IN_5, OWN_IN_5).splitlines(keepends=True)
    (folder / "drive.csv").write_text("".join(rows[:SHOWN_ROWS]))
    shutil.copytree(OVERLAYS_FOLDER, folder / "overlays")
    (folder / "overlays" / "own.vspec").write_text(
        f"{OWN_IN_5}: {{type: sensor, datatype: float, unit: m, description: Distance to the obstacle.}}\n"
    )
    functions = [str(folder / name / "function.yaml") for name in EXAMPLE_FUNCTIONS]
    layers = [word for file in sorted((folder / "overlays").glob("*.vspec")) for word in ("-l", str(file))]
    units = ["-u", str(folder / "overlays" / "units.yaml")]
    return [*functions, "--trace", str(folder / "drive.csv"), "--isolated", *layers, *units]


@official_releases
@c_compiler
@pytest.mark.real
def test_the_example_functions_give_the_same_bits_in_each_release(tmp_path):
    folder = tmp_path / "project"
    arguments = _ecocontrol_for_5(folder)
    trees = [tree for name in ("v5.0", "v6.0", "master") if (tree := OFFICIAL / name / "spec").is_dir()]
    runs = []
    for number, tree in enumerate(trees):
        if number:
            assert main(["migrate", "--isolated", str(trees[number - 1]), str(tree), str(folder)]) == 0
        assert main(["simulate", *arguments, "-s", str(tree), "-o", str(tmp_path / "run.csv")]) == 0
        runs.append((tmp_path / "run.csv").read_bytes())
    assert len(runs) > 1
    assert runs[0].count(b"\n") > 10_000
    assert len(set(runs)) == 1
