"""A change that is proposed from the page of a node."""

import html
import re
import subprocess
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, Source, shipped_sources
from sigcat.cli import main
from sigcat.web.site import create_site
from tests.api.conftest import SOURCES, Ask, asker
from tests.web.test_compare import text_of

TREE = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Speed: {type: sensor, datatype: float, unit: km/h, description: Speed of the vehicle.}
Vehicle.Door: {type: branch, instances: [Left, Right], description: A door.}
Vehicle.Door.IsOpen: {type: actuator, datatype: boolean, description: Whether the door is open.}
"""
OVERLAY = """\
# Our own limits.
Vehicle.Speed:
  type: sensor
  datatype: float
  max: 250  # by law
  description: >-
    Speed of the vehicle,
    as measured.

Vehicle.Body: {type: branch, description: The body.}
Vehicle.Body.Mass: {type: attribute, datatype: float, unit: kg, description: Mass.}  # flow
"""


@pytest.fixture(scope="module")
def site() -> Ask:
    return asker(create_site(Library([*shipped_sources(), *SOURCES])))


class Repository:
    """A project in a repository of git, and the service over it."""

    def __init__(self, folder: Path, overlay: bytes = OVERLAY.encode()) -> None:
        self.folder = folder
        self.overlay = folder / "signals" / "our own.vspec"
        self.overlay.parent.mkdir()
        self.overlay.write_bytes(overlay)
        (folder / "tree.vspec").write_text(TREE)
        self.git("init", "--quiet")
        self.git("-c", "core.autocrlf=false", "add", ".")
        self.source = Source("own", "Own", folder / "tree.vspec", (self.overlay,) if overlay else ())
        self.ask = asker(create_site(Library([self.source])))

    def git(self, *arguments: str, text: bytes = b"") -> None:
        """Run git in the folder."""
        done = subprocess.run(["git", *arguments], cwd=self.folder, input=text, capture_output=True, check=False)
        assert done.returncode == 0, done.stderr.decode()

    def proposed(self, **fields: str) -> str:
        """The text of the overlay after the patch was applied."""
        answer = self.ask("/propose", "POST", data={"catalogue": "own", "download": "patch", **fields})
        assert answer.status_code == 200, answer.text
        assert answer.headers["content-disposition"] == 'attachment; filename="proposal.patch"'
        self.git("apply", "--check", "-", text=answer.content)
        self.git("apply", "-", text=answer.content)
        return self.overlay.read_bytes().decode() if self.overlay.exists() else ""


def proposed(site: Ask, **fields: str) -> str:
    page = site("/propose?part=", "POST", data={"catalogue": "interfaces", **fields})
    assert page.status_code == 200, page.text
    return page.text


def source_of(page: str) -> str:
    """The overlay that a page shows."""
    lines = re.findall(r'id="line-\d+"><span[^>]*>\d+</span><code>(.*?)</code>', page)
    return html.unescape("\n".join(lines))


# -- the page -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("mode", ["form", "text"])
@pytest.mark.parametrize("path", ["Vehicle.Speed", "Vehicle.Cabin", "Vehicle.Cabin.Door.Row1.DriverSide.IsOpen"])
def test_a_node_is_changed_from_its_page_without_a_finding_before_the_first_edit(
    site: Ask, path: str, mode: str
) -> None:
    (link,) = re.findall(r'href="([^"]+)">Change</a>', site(f"/tree/interfaces/{path}").text)
    page = site(f"{html.unescape(link)}&as={mode}").text
    assert "No changes yet. Edit an attribute to see its effect." in page
    assert "No findings." in page
    assert "O106" not in page


def test_a_text_without_a_change_has_no_finding_either(site: Ask) -> None:
    text = "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  unit: km/h\n"
    page = proposed(site, change="Vehicle.Speed", text=text, **{"as": "text"})
    assert "No changes yet" in page
    assert "O106" not in page


def test_the_form_makes_an_overlay_of_what_differs(site: Ask) -> None:
    page = proposed(site, change="Vehicle.Speed", **{"a.max": "300", "a.unit": "m/s", "a.comment": "Not: negative."})
    assert source_of(page) == (
        "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  unit: m/s\n  max: 300\n  comment: 'Not: negative.'"
    )
    assert re.findall(r"/rules/(\w+)", page) == ["O103", "O104"]
    assert "1 breaking" in text_of(f'id="content"{page}').replace("\u00a0", " ")


def test_findings_are_at_the_lines_of_the_overlay(site: Ask) -> None:
    page = proposed(site, change="Vehicle.Speed", **{"a.unit": "kmh"})
    assert re.search(r'<li class="marked error" id="line-4">.*km/h', page, re.DOTALL)
    assert 'href="#line-4"' in page


def test_a_cleared_field_stays_as_an_overlay_cannot_remove_it(site: Ask) -> None:
    page = proposed(site, change="Vehicle.Speed", **{"a.unit": ""})
    assert "An overlay cannot remove an attribute: <code>unit</code> stays" in " ".join(page.split())


def test_a_value_cannot_add_lines(site: Ask) -> None:
    page = proposed(
        site, change="Vehicle.Speed", **{"a.max": "1\n  delete: true", "a.description": "A.\n  delete: true"}
    )
    assert source_of(page).count("\n") == 4
    assert "delete" not in re.findall(r"\n  (\w+):", source_of(page))


def test_those_who_use_the_signal_are_named(site: Ask) -> None:
    page = site("/propose?change=Vehicle.Chassis.Brake.CylP").text
    assert re.search(r"Used by <span[^>]*>1<", page)
    assert 'href="/functions/core_acc"><span>CoreAcc</span> <span class="number">consumes it' in page
    tried = proposed(site, change="Vehicle.Chassis.Brake.CylP", **{"a.unit": "kPa"})
    assert "builds to other Function JSON" in tried


@pytest.mark.parametrize(
    ("path", "word", "added"),
    [
        ("Vehicle.Cabin", "Add below", "Vehicle.Cabin.New"),
        ("Vehicle.Speed", "Add beside", "Vehicle.New"),
        ("Vehicle.Cabin.Door.Row1.DriverSide", "Add below", "Vehicle.Cabin.Door.New"),
    ],
)
def test_a_signal_is_added_below_a_branch(site: Ask, path: str, word: str, added: str) -> None:
    (link,) = re.findall(rf'href="([^"]+)">{word}</a>', site(f"/tree/interfaces/{path}").text)
    page = site(html.unescape(link)).text
    assert source_of(page).startswith(f"{added}:\n  type: sensor\n")
    assert "No findings." in page
    named = proposed(site, below=path, name="Humidity", **{"a.description": "Humidity of the air."})
    assert f"{added.rpartition('.')[0]}.Humidity:\n" in source_of(named)


def test_an_interface_is_added_with_the_attributes_that_one_of_its_kind_needs(site: Ask) -> None:
    text = source_of(site("/propose?below=Vehicle.Function.CoreAcc.Error").text)
    assert text.startswith("Vehicle.Function.CoreAcc.Error.New:\n")
    assert "\n  resetCondition: " in text


def test_the_form_is_continued_as_text(site: Ask) -> None:
    answer = site(
        "/propose", "POST", data={"catalogue": "interfaces", "change": "Vehicle.Speed", "as": "text", "a.max": "300"}
    )
    text = answer.text.partition("data-lines>")[2].partition("</textarea>")[0].strip()
    assert text == "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  max: 300"


def test_an_overlay_is_downloaded(site: Ask, tmp_path: Path) -> None:
    fields = {"catalogue": "interfaces", "change": "Vehicle.Speed", "a.max": "300", "download": "overlay"}
    answer = site("/propose", "POST", data=fields)
    assert answer.headers["content-disposition"] == 'attachment; filename="overlay.vspec"'
    (tmp_path / "overlay.vspec").write_text(answer.text)
    assert main(["lint", str(tmp_path / "overlay.vspec"), "-s", "interfaces"]) == 0


@pytest.mark.parametrize("query", ["change=Vehicle.Sped", "below=Vehicle.Sped"])
def test_what_is_not_there_cannot_be_changed(site: Ask, query: str) -> None:
    answer = site(f"/propose?{query}")
    assert answer.status_code == 404
    assert "Vehicle.Speed" in answer.text


def test_without_a_node_any_overlay_is_tried(site: Ask) -> None:
    assert site("/propose?catalogue=vss").headers["location"] == "/try?catalogue=vss"
    assert site("/propose", "POST", data={"as": "form"}).status_code == 422
    menu = site("/propose?change=Vehicle.Speed").text.partition('class="menu"')[2].partition("</details>")[0]
    assert "/propose?catalogue=vss" in menu
    assert "change=" not in menu


def test_markup_shows_as_text(site: Ask) -> None:
    page = proposed(site, change="Vehicle.Speed", **{"a.description": "<script>alert(1)</script>", "a.max": "<script>"})
    assert "<script>" not in page


# -- the patch ----------------------------------------------------------------------------------------------------


def test_git_applies_a_patch_that_changes_only_the_value(tmp_path: Path) -> None:
    text = Repository(tmp_path).proposed(change="Vehicle.Speed", **{"a.max": "200"})
    assert text == OVERLAY.replace("max: 250  # by law", "max: 200  # by law")


def test_an_attribute_is_added_to_the_statement_and_a_text_of_several_lines_replaced(tmp_path: Path) -> None:
    text = Repository(tmp_path).proposed(change="Vehicle.Speed", **{"a.min": "0", "a.description": "Speed."})
    assert text == OVERLAY.replace(">-\n    Speed of the vehicle,\n    as measured.\n", "Speed.\n  min: 0\n")


def test_a_statement_on_one_line_is_edited_in_its_line(tmp_path: Path) -> None:
    text = Repository(tmp_path).proposed(change="Vehicle.Body.Mass", **{"a.unit": "g", "a.min": "0"})
    assert text == OVERLAY.replace("unit: kg, description: Mass.}", "unit: g, description: Mass., min: 0}")


def test_a_node_of_the_tree_gets_a_statement_in_the_overlay(tmp_path: Path) -> None:
    text = Repository(tmp_path).proposed(change="Vehicle.Door.Left.IsOpen", **{"a.comment": "Locked, too."})
    assert text == OVERLAY + (
        "\nVehicle.Door.Left.IsOpen:\n  type: actuator\n  datatype: boolean\n  comment: Locked, too.\n"
    )


def test_a_new_node_is_added_to_the_overlay_of_its_branch(tmp_path: Path) -> None:
    text = Repository(tmp_path).proposed(below="Vehicle.Body", name="Height", **{"a.unit": "mm"})
    assert text.startswith(OVERLAY)
    assert "\nVehicle.Body.Height:\n  type: sensor\n  datatype: float\n  unit: mm\n" in text


def test_without_an_overlay_the_patch_makes_one(tmp_path: Path) -> None:
    repository = Repository(tmp_path, b"")
    repository.proposed(change="Vehicle.Speed", **{"a.max": "200"})
    assert (tmp_path / "proposal.vspec").read_text() == (
        "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  max: 200\n"
    )


@pytest.mark.parametrize(
    "overlay",
    [
        OVERLAY.replace("\n", "\r\n"),
        f"\ufeff{OVERLAY}",
        OVERLAY.rstrip("\n"),
        OVERLAY.replace("Mass.}", "Mass \u2028.}"),
        OVERLAY.replace("# Our own limits.", "# Unsere Grenzen: höchstens."),
    ],
)
def test_whatever_bytes_the_overlay_has_git_applies_the_patch(tmp_path: Path, overlay: str) -> None:
    repository = Repository(tmp_path, overlay.encode())
    text = repository.proposed(change="Vehicle.Speed", **{"a.max": "200"})
    assert text == overlay.replace("250", "200")


def test_the_changed_value_is_the_one_of_the_project(tmp_path: Path) -> None:
    repository = Repository(tmp_path)
    repository.proposed(change="Vehicle.Speed", **{"a.max": "200"})
    changed = asker(create_site(Library([repository.source])))
    values = changed("/api/v1/catalogues/own/nodes/Vehicle.Speed").json()["attributes"]
    assert [each["value"] for each in values if each["name"] == "max"] == [200]


def test_a_patch_of_nothing_is_refused(tmp_path: Path) -> None:
    answer = Repository(tmp_path).ask("/propose", "POST", data={"change": "Vehicle.Speed", "download": "patch"})
    assert (answer.status_code, "Nothing is changed yet" in answer.text) == (422, True)


def test_a_patch_of_an_overlay_with_errors_is_refused(tmp_path: Path) -> None:
    fields = {"change": "Vehicle.Speed", "as": "text", "text": "Vehicle.Speed: [", "download": "patch"}
    answer = Repository(tmp_path).ask("/propose", "POST", data=fields)
    assert (answer.status_code, "has errors" in answer.text) == (422, True)


def test_a_file_that_has_changed_meanwhile_is_not_patched(tmp_path: Path) -> None:
    repository = Repository(tmp_path)
    repository.overlay.write_text(OVERLAY + "# Changed.\n")
    answer = repository.ask("/propose", "POST", data={"change": "Vehicle.Speed", "a.max": "1", "download": "patch"})
    assert (answer.status_code, "has changed since the service read it" in answer.text) == (422, True)


def test_a_file_that_is_gone_is_not_patched(tmp_path: Path) -> None:
    repository = Repository(tmp_path)
    repository.overlay.unlink()
    answer = repository.ask("/propose", "POST", data={"change": "Vehicle.Speed", "a.max": "1", "download": "patch"})
    assert answer.status_code == 422


def test_an_overlay_that_is_included_below_a_branch_gets_the_statement_at_its_end(tmp_path: Path) -> None:
    repository = Repository(tmp_path, b"#include part.vspec Vehicle\nVehicle.Own: {type: branch, description: Own.}\n")
    (repository.overlay.parent / "part.vspec").write_text("Speed: {type: sensor, datatype: float, max: 250}\n")
    repository.ask = asker(create_site(Library([repository.source])))
    text = repository.proposed(change="Vehicle.Speed", **{"a.max": "200"})
    assert text.endswith("\n\nVehicle.Speed:\n  type: sensor\n  datatype: float\n  max: 200\n")


def test_a_long_text_is_checked_and_not_repeated(site: Ask) -> None:
    text = "Vehicle.Speed: {type: sensor, datatype: float, max: 3}\n" + "# <<<<<<<<\n" * 30_000
    page = site(
        "/propose", "POST", data={"catalogue": "interfaces", "change": "Vehicle.Speed", "as": "text", "text": text}
    )
    assert page.status_code == 200
    assert len(page.text) < 50_000
    assert "too long" in page.text
