"""The start page: catalogues and functions with their state."""

import re
from pathlib import Path

from sigcat.catalogue.hosting.library import Library, Source, shipped_sources
from sigcat.function.hosting import FunctionLibrary
from sigcat.web.site import create_site
from tests.api.conftest import SETTINGS, SOURCES, TREE, asker

FUNCTION = """\
function: Speedy
type: ASW
components:
  - name: Speedy
    data: [{path: Vehicle.Speed, as: required}]
"""


def test_it_names_catalogues_functions_and_what_to_do() -> None:
    site = asker(create_site(Library(shipped_sources())))
    page = site("/").text
    for text in (
        "Look up a signal",
        "Check an overlay",
        "Declare a function",
        "VSS 6.0",
        "CoreAcc",
        "All functions are valid",
        "Recent changes",
    ):
        assert text in page
    assert 'class="bad"' not in page


def test_changes_of_the_default_catalogue_are_counted_and_lead_to_their_page() -> None:
    page = asker(create_site(Library(shipped_sources())))
    (link,) = re.findall(r'<a href="(/changes[^"]+)">VSS 6.0 → VSS 6.0 with function interfaces</a>', page("/").text)
    (counted,) = re.findall(r">([0-9,]+)\u00a0changes<", page("/").text)
    assert f"{counted}\u00a0changes: " in page(link.replace("&amp;", "&")).text
    alone = asker(create_site(Library([Source("bare", "Bare", TREE / "tree.vspec")])))
    assert "Recent changes" not in alone("/").text


def test_a_catalogue_of_a_company_is_compared_with_the_tree_that_it_extends(tmp_path: Path) -> None:
    overlay = tmp_path / "own.vspec"
    overlay.write_text("Vehicle.Own: {type: branch, description: Signals of the company.}\n")
    shipped = shipped_sources()
    (plain,) = (each for each in shipped if not each.overlays)
    own = Source("own", "Own", plain.spec, overlays=(overlay,))
    page = asker(create_site(Library([own, *shipped])))("/").text
    assert ">VSS 6.0 → Own</a>" in page
    assert ">1\u00a0change<" in page


def test_errors_of_a_catalogue_lead_to_its_findings() -> None:
    page = asker(create_site(Library(SOURCES), SETTINGS))("/").text
    assert '<a class="bad" href="/catalogues/broken#findings">' in page


def test_shipped_functions_never_look_broken() -> None:
    """They are valid over the catalogue that they need, and left out where none is hosted."""
    with_interfaces = asker(create_site(Library(shipped_sources()[::-1])))("/").text
    assert "/functions/core_acc?catalogue=interfaces" in with_interfaces
    assert 'class="bad"' not in with_interfaces
    alone = asker(create_site(Library([Source("bare", "Bare", TREE / "tree.vspec")])))
    assert "core_acc" not in alone("/").text
    assert 'class="bad">errors' not in alone("/functions").text


def test_a_function_with_errors_is_counted_and_leads_to_them(tmp_path: Path) -> None:
    (tmp_path / "speedy.function.yaml").write_text(FUNCTION.replace("Vehicle.Speed", "Vehicle.Sped"))
    functions = FunctionLibrary([tmp_path])
    page = asker(create_site(Library(shipped_sources()), functions=functions))("/").text
    assert "1\u00a0function has errors" in page
    assert '<a class="bad" href="/functions/speedy">' in page
