"""History of a node over releases."""

from collections.abc import Mapping
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.migration.node_history import (
    NodeHistory,
    Release,
    history_summary,
    node_history,
    official_releases,
)
from tests.migration.chained_releases import CHAIN, SPEED, source_of
from tests.needs import OFFICIAL
from tests.needs import official_releases as with_official_releases


@pytest.fixture
def chain(tmp_path: Path) -> Mapping[str, Catalogue]:
    return {name: _tree(tmp_path, name, text) for name, text in CHAIN.items()}


def _tree(folder: Path, name: str, text: str) -> Catalogue:
    return load(source_of(folder, name, text))


def _history(path: str, catalogue: Catalogue, chain: Mapping[str, Catalogue], *names: str) -> NodeHistory:
    return node_history(path, catalogue, [Release(name, chain[name]) for name in names or chain])


def test_a_node_is_followed_from_where_it_was_added_to_where_it_was_removed(chain: Mapping[str, Catalogue]) -> None:
    history = _history("Vehicle.Speed", chain["5.0"], chain)
    assert history_summary(history) == (
        "in 3.1 already; unit changed in 4.0; moved in 4.1 or 4.2 or 5.0 from Vehicle.Velocity; removed in 5.1 or 6.0"
    )
    assert [event.path for event in history.events] == ["Vehicle.Velocity", "Vehicle.Velocity", "Vehicle.Speed", ""]
    (unit,) = history.events[1].attributes
    assert (unit.name, unit.old, unit.new, unit.compatibility) == ("unit", "km/h", "m/s", "breaking")


def test_the_history_is_the_same_from_every_release_but_for_the_direction(chain: Mapping[str, Catalogue]) -> None:
    history = _history("Vehicle.Velocity", chain["4.0"], chain)
    assert history.events == _history("Vehicle.Speed", chain["5.0"], chain).events
    assert "moved in 4.1 or 4.2 or 5.0 to Vehicle.Speed" in history_summary(history)


def test_a_node_of_a_later_release_is_added_there(chain: Mapping[str, Catalogue]) -> None:
    history = _history("Vehicle.Other", chain["6.0"], chain)
    assert history_summary(history) == "since 5.1 or 6.0"
    assert history.events[0].skipped == ("5.1",)


def test_the_oldest_release_here_is_not_called_the_first(chain: Mapping[str, Catalogue]) -> None:
    history = _history("Vehicle.Velocity", chain["4.0"], chain, "4.0", "5.0")
    assert history.events[0].kind == "oldest"
    assert history_summary(history).startswith("in 4.0 already; ")
    assert history.missing == ("3.0", "3.1", "4.1", "4.2")


def test_what_an_overlay_changes_happened_in_the_catalogue_itself(
    chain: Mapping[str, Catalogue], tmp_path: Path
) -> None:
    overlay = tmp_path / "own.vspec"
    overlay.write_text(
        "Vehicle.Speed: {type: sensor, datatype: float, max: 90}\n"
        "Vehicle.Own: {type: sensor, datatype: float, description: Own.}\n"
    )
    own = load(Source("own", "Own", tmp_path / "5.0.vspec", (overlay,)))
    assert "; max changed in this catalogue; removed in 5.1 or 6.0" in history_summary(
        _history("Vehicle.Speed", own, chain)
    )
    assert history_summary(_history("Vehicle.Own", own, chain)) == "since this catalogue"


def test_without_its_release_the_catalogue_has_its_place_in_the_chain(
    chain: Mapping[str, Catalogue], tmp_path: Path
) -> None:
    own = _tree(tmp_path, "5.1", SPEED.format("Speed", "double", "m/s"))
    history = _history("Vehicle.Speed", own, chain, "4.0", "5.0", "6.0")
    assert "datatype, fka changed in this catalogue" in history_summary(history)
    assert history_summary(history).endswith("removed in 6.0")


def test_a_tree_that_does_not_say_its_release_is_not_compared(chain: Mapping[str, Catalogue], tmp_path: Path) -> None:
    file = tmp_path / "own.vspec"
    file.write_text("Vehicle: {type: branch, description: A vehicle.}\n")
    history = _history("Vehicle", load(Source("own", "Own", file)), chain)
    assert (history.release, history.events) == ("", ())


def test_a_move_that_only_the_definition_shows_is_not_certain(tmp_path: Path) -> None:
    old = _tree(
        tmp_path, "4.0", "Vehicle.Deep: {type: branch, description: Deep.}\n" + SPEED.format("Deep.A", "float", "m/s")
    )
    new = _tree(
        tmp_path, "4.1", "Vehicle.Flat: {type: branch, description: Flat.}\n" + SPEED.format("Flat.A", "float", "m/s")
    )
    history = node_history("Vehicle.Flat.A", new, [Release("4.0", old), Release("4.1", new)])
    assert history_summary(history) == "in 4.0 already; probably moved in 4.1 from Vehicle.Deep.A"
    assert not history.events[1].is_certain


def test_instances_of_a_branch_change(tmp_path: Path) -> None:
    door = "Vehicle.Door: {{type: branch, instances: {}, description: A door.}}\nVehicle.Door.IsOpen: {{type: actuator, datatype: boolean, description: Open.}}\n"
    old, new = (_tree(tmp_path, name, door.format(each)) for name, each in (("4.0", "[A, B]"), ("4.1", "[A, B, C]")))
    releases = [Release("4.0", old), Release("4.1", new)]
    (_, event) = node_history("Vehicle.Door", new, releases).events
    assert [(a.name, a.rule) for a in event.attributes] == [("instances", "instances-added")]
    assert history_summary(node_history("Vehicle.Door.C", new, releases)) == "since 4.1"


def test_official_releases_are_in_order_and_own_trees_are_not_among_them(
    chain: Mapping[str, Catalogue], tmp_path: Path
) -> None:
    sources = [Source(name, name, tmp_path / f"{name}.vspec", release=f"v{name}") for name in chain]
    with_overlay = Source("own", "Own", tmp_path / "5.0.vspec", (tmp_path / "own.vspec",), release="v5.0")
    candidate = Source("rc", "RC", tmp_path / "6.0.vspec", release="v7.0-rc1")
    sides = [(source, chain.get(source.id, chain["5.0"])) for source in (*sources[::-1], with_overlay, candidate)]
    assert [each.number for each in official_releases(sides)] == ["3.1", "4.0", "5.0", "6.0"]


def test_a_pulled_release_counts_before_the_shipped_tree(chain: Mapping[str, Catalogue], tmp_path: Path) -> None:
    _, shipped = shipped_sources()
    pulled = Source("v6.0", "VSS 6.0", tmp_path / "6.0.vspec", release="v6.0")
    assert [each.number for each in official_releases([(shipped, load(shipped))])] == ["6.0"]
    (release,) = official_releases([(shipped, load(shipped)), (pulled, chain["6.0"])])
    assert release.catalogue is chain["6.0"]


@with_official_releases
@pytest.mark.parametrize(
    ("path", "summary"),
    [
        ("Vehicle.Speed", "in 5.0 already"),
        ("Vehicle.Powertrain.CombustionEngine.Speed", "in 5.0 already; datatype changed in 5.1 or 6.0"),
        (
            "Vehicle.Cabin.Seat.Row1.DriverSide.Massage.Level",
            "in 5.0 already; moved in 5.1 or 6.0 from Vehicle.Cabin.Seat.Row1.DriverSide.Massage",
        ),
        ("Vehicle.Powertrain.FuelSystem.IsFuelLevelEmpty", "since 5.1 or 6.0"),
    ],
)
def test_the_official_releases(path: str, summary: str) -> None:
    found = [
        Release(
            name[1:], load(Source(name, name, OFFICIAL / name / "spec/VehicleSignalSpecification.vspec", release=name))
        )
        for name in ("v5.0", "v6.0")
    ]
    assert history_summary(node_history(path, found[1].catalogue, found)) == summary


def test_a_release_whose_tree_does_not_say_its_number_has_that_of_its_name(
    chain: Mapping[str, Catalogue], tmp_path: Path
) -> None:
    file = tmp_path / "plain.vspec"
    file.write_text("Vehicle: {type: branch, description: A vehicle.}\n" + SPEED.format("Speed", "float", "m/s"))
    releases = official_releases([(source := Source("v5.0", "VSS 5.0", file, release="v5.0"), load(source))])
    assert [each.number for each in releases] == ["5.0"]
    assert history_summary(node_history("Vehicle.Speed", chain["5.0"], releases)) == (
        "in 5.0 already; fka changed in this catalogue"
    )
