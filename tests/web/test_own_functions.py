"""Functions of the user on pages, and users of a node: in the tree, on its page, in a search."""

import re
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, Source, shipped_sources
from sigcat.data import ROOT_FILE
from sigcat.function.hosting import FunctionLibrary
from sigcat.web.site import create_site
from tests.api.conftest import Ask, asker
from tests.function.test_hosting import noise

OVERLAY = "Vehicle.Cabin.AcmeNoise: {type: sensor, datatype: float, description: Noise in the cabin.}\n"


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Ask:
    folder = tmp_path_factory.mktemp("own")
    (folder / "cabin.vspec").write_text(OVERLAY)
    (folder / "functions").mkdir()
    for name, path in (("Noise", "Vehicle.Cabin.AcmeNoise"), ("Doors", "Vehicle.Cabin.Door.Row1.DriverSide.IsOpen")):
        (folder / "functions" / f"{name.lower()}.function.yaml").write_text(noise(name, path))
    acme = Source("acme", "Acme", ROOT_FILE, (folder / "cabin.vspec",))
    return asker(create_site(Library([*shipped_sources(), acme]), functions=FunctionLibrary([folder / "functions"])))


def below(page: str) -> str:
    """The section that says who uses what is below a node."""
    return page.partition("Functions that use what is below")[2].partition("</section>")[0]


def test_functions_of_ones_own_have_pages_like_shipped_ones(site: Ask) -> None:
    listed = site("/functions.json?catalogue=acme").json()["functions"]
    assert [(each["id"], each["ok"], each["shipped"]) for each in listed][:2] == [
        ("doors", True, False),
        ("noise", True, False),
    ]
    assert "functions/noise.function.yaml" in site("/functions/noise?catalogue=acme").text
    assert site("/functions/noise.json?catalogue=acme").json()["FunctionInfo"]["FunctionName"] == "Noise"
    source = site("/functions/noise/files/source?catalogue=acme")
    assert source.text == noise("Noise", "Vehicle.Cabin.AcmeNoise")


def test_functions_of_ones_own_are_a_set(site: Ask) -> None:
    page = site("/wiring?catalogue=acme").text
    assert "<h1>Your functions</h1>" in page
    assert site("/wiring.json?catalogue=acme").json()["functions"] == ["Doors", "Noise"]
    links = re.findall(r'href="(/wiring\?[^"]+)"[^>]*>EcoControl', page)
    assert site(links[0].replace("&amp;", "&")).status_code == 200


def test_where_a_function_does_not_build_its_page_says_which_overlay_it_needs(site: Ask) -> None:
    for address in ("/functions?catalogue=vss", "/functions/noise?catalogue=vss"):
        assert re.search(r"needs the overlay <code>cabin</code> of <a[^>]*>Acme</a>", site(address).text)
    needs = {each["id"]: each["needs"] for each in site("/functions.json?catalogue=vss").json()["functions"]}
    assert needs["noise"] == ["cabin"]
    assert {"error", "scheduling"} <= set(needs["core_acc"])
    assert needs["doors"] == []
    without = site("/functions.json?catalogue=interfaces~without.error").json()["functions"]
    assert {each["id"]: each["needs"] for each in without}["core_acc"] == ["error"]


def test_a_node_names_the_functions_that_use_it(site: Ask) -> None:
    page = site("/tree/acme/Vehicle.Cabin.AcmeNoise").text
    assert re.search(r'href="/functions/noise\?catalogue=acme">Noise</a>.*consumes it', page)
    assert below(page) == ""


def test_a_branch_tells_which_functions_use_what_is_below_it(site: Ask) -> None:
    section = below(site("/tree/acme/Vehicle.Cabin").text)
    assert re.findall(r'">(\w+)</a></span><span class="description">([^<]*)</span>', section) == [
        ("Doors", "consumes 1"),
        ("Noise", "consumes 1"),
    ]


def test_a_folded_definition_has_the_uses_of_its_instances(site: Ask) -> None:
    page = site("/tree/interfaces~folded/Vehicle.Cabin.Door.IsOpen").text
    assert re.search(r'href="/functions/doors\?catalogue=interfaces~folded">Doors', page)
    assert "at <code>Vehicle.<wbr>Cabin.<wbr>Door.<wbr>Row1.<wbr>DriverSide.<wbr>IsOpen</code>" in page
    assert "Doors" in below(site("/tree/interfaces~folded/Vehicle.Cabin.Door").text)


def test_rows_of_the_tree_count_functions(site: Ask) -> None:
    rows = {row[1]: row[4:] for row in site("/rows/acme?path=Vehicle.Cabin").json()["rows"]}
    assert (rows["AcmeNoise"], rows["Door"], rows["Seat"]) == ([1], [1], [])
    folded = {row[1]: row[4:] for row in site("/rows/interfaces~folded?path=Vehicle.Cabin.Door").json()["rows"]}
    assert folded["IsOpen"] == [1]
    page = site("/tree/acme/Vehicle.Cabin?open=Vehicle.Cabin").text
    assert re.search(r'>AcmeNoise</a>\s*<span class="users"><span aria-hidden="true">ƒ1</span>', page)


def test_hits_of_a_search_name_functions_one_instance_or_all(site: Ask) -> None:
    assert "used by Noise" in site("/search/acme?q=acmenoise").text
    assert "used by Doors" in site("/search/acme?q=door+isopen").text


def test_rows_that_are_kept_belong_to_the_functions_too(tmp_path: Path) -> None:
    functions = FunctionLibrary([tmp_path], has_shipped=False)
    site = asker(create_site(Library(shipped_sources()[1:]), functions=functions))

    def state() -> str:
        return str(re.findall(r'data-state="([^"]+)"', site("/tree/vss").text)[0])

    before = state()
    assert "immutable" in site(f"/rows/vss?v={before}").headers["cache-control"]
    (tmp_path / "speed.function.yaml").write_text(noise("SpeedWatch"))
    functions.reload()
    assert state() != before
    assert site(f"/rows/vss?v={before}").headers["cache-control"] == "no-cache"


def test_without_any_function_every_page_stands() -> None:
    site = asker(create_site(Library(shipped_sources()[1:]), functions=FunctionLibrary(has_shipped=False)))
    for address in ("/", "/functions", "/wiring", "/wiring.json", "/try?kind=function", "/search/vss?q=speed"):
        assert site(address).status_code == 200


def test_a_function_whose_file_broke_is_shown_as_it_was_and_its_pages_say_so(tmp_path: Path) -> None:
    file = tmp_path / "noise.function.yaml"
    file.write_text(noise())
    library = Library(shipped_sources())
    functions = FunctionLibrary([tmp_path], catalogues=library)
    site = asker(create_site(library, functions=functions))
    file.write_text(noise().replace("Vehicle.Speed", "Vehicle.Sped"))
    functions.reload()
    page = site("/functions/noise").text
    assert "The file of this function has errors" in page
    assert "Vehicle.Sped" in page.partition('id="rejected"')[2]
    assert 'href="/functions/noise#rejected"' in site("/functions").text
    listed = {each["id"]: each for each in site("/functions.json").json()["functions"]}
    assert (listed["noise"]["ok"], listed["noise"]["rejected"], listed["core_acc"]["rejected"]) == (True, 1, 0)
    assert 'id="rejected"' not in site("/functions/core_acc").text


def test_findings_in_functions_count_on_the_page_of_a_catalogue_and_on_rules(tmp_path: Path) -> None:
    """Those of a function that is made for another catalogue do not: there is nothing wrong with it."""
    (tmp_path / "wrong.function.yaml").write_text(noise("Wrong", "Vehicle.Sped"))
    (tmp_path / "acme.function.yaml").write_text(noise("Acme", "Vehicle.Cabin.AcmeNoise"))
    (tmp_path / "cabin.vspec").write_text(OVERLAY)
    acme = Source("acme", "Acme", ROOT_FILE, (tmp_path / "cabin.vspec",))
    library = Library([*shipped_sources(), acme])
    service = create_site(library, functions=FunctionLibrary([tmp_path], has_shipped=False))
    site = asker(service)
    for name, expected in (("interfaces", 1), ("acme", 1)):
        without = len(service.state.rules.findings_in(library.get(name).catalogue))
        (own,) = re.findall(r'id="findings">Findings <span class="number">(\d+)', site(f"/catalogues/{name}").text)
        rules = site(f"/rules?catalogue={name}").text
        of_each = re.search(r"With findings(.*?)</section>", rules, re.DOTALL)
        assert of_each
        assert sum(int(number) for number in re.findall(r"(\d+)\u00a0finding", of_each.group(1))) == int(own)
        assert int(own) == without + expected
        assert "wrong.function.yaml" in site(f"/rules/F010?catalogue={name}").text


def test_the_schedule_names_a_priority_where_there_is_one(tmp_path: Path) -> None:
    for name, priority in (("Quiet", ""), ("Loud", "priority: 20, ")):
        text = noise(name).replace("cycleTime: 100", f"{priority}cycleTime: 100")
        (tmp_path / f"{name.lower()}.function.yaml").write_text(text)
    site = asker(create_site(Library(shipped_sources()), functions=FunctionLibrary([tmp_path])))
    quiet, loud = (site(f"/functions/{name}?view=schedule").text.replace("\u00a0", " ") for name in ("quiet", "loud"))
    assert ">every 100 ms<" in quiet
    assert ">every 100 ms, priority 20<" in loud
