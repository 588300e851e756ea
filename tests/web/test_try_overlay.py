"""Page of an overlay that is tried, and the way to it from the page of a node."""

import re
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, Source, shipped_sources
from sigcat.cli import main
from sigcat.data import OVERLAYS, ROOT_FILE
from sigcat.function.hosting import FunctionLibrary
from sigcat.web.site import create_site
from tests.api.conftest import SOURCES, Ask, asker
from tests.function.test_hosting import noise

SPEED = "Vehicle.Speed: {type: sensor, datatype: float, unit: km/h, max: 300, description: Speed.}\n"


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Ask:
    folder = tmp_path_factory.mktemp("functions")
    (folder / "hum.function.yaml").write_text(noise("Hum", "Vehicle.Cabin.Hum"))
    acme = Source("acme", "Acme", ROOT_FILE, (OVERLAYS / "ecocontrol.vspec",), (OVERLAYS / "units.yaml",))
    return asker(create_site(Library([*shipped_sources(), acme, *SOURCES]), functions=FunctionLibrary([folder])))


def tried(site: Ask, text: str, catalogue: str = "interfaces") -> str:
    page = site("/try?part=", "POST", data={"kind": "overlay", "catalogue": catalogue, "text": text})
    assert page.status_code == 200
    return page.text


def section(page: str, title: str) -> str:
    """The text of the section with this title."""
    found = re.search(rf"<h2>{title}.*?</section>", page, re.DOTALL)
    assert found, title
    return " ".join(re.sub(r"<[^>]+>", " ", found[0]).split())


def test_nodes_are_new_or_changed(site: Ask) -> None:
    page = tried(site, SPEED + "Vehicle.Cabin.Door.Hum: {type: sensor, datatype: uint8, description: A hum.}\n")
    nodes = section(page, "Nodes")
    assert "Vehicle. Speed changed float km/h" in nodes
    assert "Vehicle. Cabin. Door. Hum new ×4 uint8" in nodes
    assert re.search(r'href="/tree/interfaces/Vehicle.Speed">Vehicle', page)


def test_changes_stand_in_their_classes(site: Ask) -> None:
    page = tried(site, "Vehicle.Speed: {type: sensor, datatype: uint8, unit: km/h, description: Speed.}\n")
    changes = section(page, "Changes")
    assert "1 breaking" in changes
    assert "datatype from float → to uint8" in changes


def test_functions_that_use_a_changed_node_are_named_with_what_becomes_of_them(site: Ask) -> None:
    page = tried(site, "Vehicle.Chassis.Brake.CylP: {type: sensor, datatype: double, unit: km/h}\n")
    affected = section(page, "Functions affected")
    assert "CoreAcc builds to other Function JSON uses Vehicle. Chassis. Brake. CylP" in affected
    assert "EcoControlMpc" not in affected
    told = tried(site, 'Vehicle.Chassis.Brake.CylP: {type: sensor, datatype: double, comment: "P."}\n')
    assert "CoreAcc builds as before" in section(told, "Functions affected")


def test_a_function_that_waits_for_what_an_overlay_adds_builds_with_it(site: Ask) -> None:
    page = tried(site, "Vehicle.Cabin.Hum: {type: sensor, datatype: float, description: A hum.}\n")
    assert "Hum builds now" in section(page, "Functions affected")


def test_a_node_that_is_deleted_is_missed_by_its_functions(site: Ask) -> None:
    page = tried(site, "Vehicle.Chassis.Brake.CylP: {type: sensor, datatype: double, delete: true}\n")
    assert "CoreAcc no longer builds" in section(page, "Functions affected")


def test_an_overlay_that_does_nothing_says_so(site: Ask) -> None:
    page = tried(site, "# nothing\n")
    assert "It changes nothing." in section(page, "Changes")
    assert "None." in section(page, "Functions affected")
    assert "It changes nothing in its present form." in section(tried(site, "Vehicle.\n"), "Changes")


@pytest.mark.parametrize(
    "text", ["", "function: Noise\n", "a: [", "Vehicle.X: 1\n", "- a\n", "Vehicle: {type: branch, delete: true}"]
)
def test_any_text_has_a_page(site: Ask, text: str) -> None:
    for catalogue in ("interfaces", "interfaces~folded", "broken"):
        assert "data-tally" in tried(site, text, catalogue)


@pytest.mark.parametrize(
    ("catalogue", "options"),
    [
        ("interfaces", "-s interfaces"),
        ("vss~folded", "-s vss"),
        ("acme", "-s vss -l overlays/ecocontrol.vspec -u overlays/units.yaml"),
        ("acme~without.ecocontrol", "-s vss -u overlays/units.yaml"),
    ],
)
def test_the_commands_do_the_same(
    site: Ask, catalogue: str, options: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    page = section(tried(site, SPEED, catalogue), "On the command line")
    assert f"sigcat try overlay.vspec {options}" in page
    assert f"sigcat lint overlay.vspec {options}" in page
    monkeypatch.chdir(ROOT_FILE.parents[1])
    (tmp_path / "overlay.vspec").write_text(SPEED)
    assert main(["try", str(tmp_path / "overlay.vspec"), *options.split()]) == 0
    assert "~ Speed  [compatible]" in capsys.readouterr().out
    assert main(["lint", str(tmp_path / "overlay.vspec"), *options.split()]) == 0


def test_the_example_is_about_the_root_of_the_catalogue(tmp_path: Path) -> None:
    tree = tmp_path / "crane.vspec"
    tree.write_text(
        "Crane: {type: branch, description: A crane.}\nCrane.Load: {type: sensor, datatype: float, description: Load.}\n"
    )
    page = asker(create_site(Library([Source("crane", "Crane", tree)])))("/try").text
    assert "Crane.Speed:" in page
    assert "V022" not in page


def test_what_the_service_rehearses_is_what_the_page_does() -> None:
    """A rehearsal that fails is passed over while the service runs: here it is not."""
    service = create_site(Library(shipped_sources()))
    rehearsals = list(service.state.rehearsals())
    assert [work.function.__name__ for work in rehearsals] == ["compile_templates", "rehearse"]
    for work in rehearsals:
        work.function(*work.arguments, **work.options)


def test_a_service_without_catalogues_rehearses_no_text() -> None:
    assert [work.function.__name__ for work in create_site(Library([])).state.rehearsals()] == ["compile_templates"]


@pytest.mark.parametrize("kind", ["overlay", "tree", "function"])
def test_a_long_text_is_checked_and_not_repeated(site: Ask, kind: str) -> None:
    """A page repeats a text twice, once to be changed and once with its findings: of four megabytes it would make many more."""
    text = SPEED.replace("km/h", "knots per hour") + "# <<<<<<<<\n" * 30_000
    page = site("/try", "POST", data={"kind": kind, "catalogue": "interfaces", "text": text})
    assert page.status_code == 200
    assert len(page.text) < 50_000
    assert "too long" in page.text
    assert "<code>Vehicle.Speed" in page.text, "the line with a finding is shown"
