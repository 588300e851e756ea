"""Pages of functions, of sets, of changes and to try a text, as the server writes them."""

import re
from html import unescape
from io import BytesIO
from urllib.parse import parse_qs
from zipfile import ZIP_DEFLATED, ZipFile

import pytest

from scripts.cases import FUNCTIONS
from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.variables import variables
from sigcat.function.function_json.walk import runnables
from sigcat.web.pictures.interface_diagram import interface_diagram
from sigcat.web.pictures.timeline import time_line
from sigcat.web.site import create_site
from sigcat.web.views.code_view import code_view
from sigcat.web.views.generated_documents import VIEWS
from tests.adapter.written import absent, error, signal, step
from tests.adapter.written import function as written
from tests.api.conftest import SOURCES, Ask, asker
from tests.function.test_wiring import function, gives
from tests.needs import IS_SLOW_RUN


@pytest.fixture(scope="module")
def site() -> Ask:
    return asker(create_site(Library([*shipped_sources(), *SOURCES])))


def post(site: Ask, **form: str) -> str:
    page = site("/try", "POST", data=form)
    assert page.status_code == 200
    return page.text


def test_a_function_shows_its_interfaces_as_a_diagram(site: Ask) -> None:
    page = site("/functions/core_acc").text
    assert "CoreAcc_BrakePressureTimeout_ErrorSts" in page
    assert re.search(r'href="/tree/interfaces/Vehicle.Chassis.Brake.CylP"><text', page)


def test_a_function_shows_how_its_code_is_called_and_what_the_adapter_does(site: Ask) -> None:
    page = unescape(re.sub(r"<[^>]+>", "", site("/functions/eco_control_mpc").text))
    for text in (
        "functions that take pointers to the objects of an instance",
        "ExtU_EcoControlMpc_T mpc_inputs ← inputs",
        "EcoControlMpc_initialize(EcoControlMpc_M)",
        "late after 2000 ms: takes the start value, sets EcoControlMpc_HorizonTimeout_ErrorSts",
        "initially OFF; unknown: keeps the last",
    ):
        assert text in page


@pytest.mark.parametrize("name", FUNCTIONS.names)
def test_each_word_of_the_code_stands_on_the_page(name: str) -> None:
    made = FunctionJson.model_validate_json(FUNCTIONS.text(name), by_name=False)
    shown = str(code_view(made))
    expressions = [each.expression for each in variables(made)]
    symbols = [located.runnable.symbol for located in runnables(made) if located.runnable.symbol]
    assert [text for text in (*expressions, *symbols) if text not in shown] == []


def test_of_a_function_that_says_nothing_of_its_code_there_is_none() -> None:
    assert code_view(function("Acc", gives("Vehicle.Speed"))) is None


def test_optional_signals_are_marked_and_scaled_ones_say_their_scale() -> None:
    speed = signal("Speed", Factor="0.01", Offset="-40", Units="km/h")
    items = [signal("There", Optional=True, AbsentError="Lost"), absent(signal("Lacking")), speed]
    made = written(step(*items, error("Lost")))
    marks = {port.outer: port.mark for port in interface_diagram(made).ports if port.kind == "signal"}
    assert marks == {"There": " (optional)", "Lacking": " (optional, not in this catalogue)", "Speed": ""}
    view = code_view(made)
    assert view is not None
    notes = {row.name: row.notes for row in view.variables}
    assert notes["There"] == ("optional: without the signal, sets Lost",)
    assert notes["Lacking"] == ("optional",)
    assert notes["Speed"] == ("number × 0.01 - 40 km/h",)


def test_a_set_beside_a_function_leads_to_the_wiring_of_all_of_it(site: Ask) -> None:
    page = site("/functions/core_acc?catalogue=vss").text
    address = next(unescape(link) for link in re.findall(r'href="(/wiring\?f=[^"]+)"', page))
    assert parse_qs(address.partition("?")[2]) == {"f": ["core_acc", "eco_control_mpc"], "catalogue": ["vss"]}
    assert site(address).status_code == 200


@pytest.mark.parametrize(
    "address", ["/functions", "/wiring", "/rules", "/changes?old=bare&new=small", "/catalogues/interfaces"]
)
def test_links_are_escaped_once(site: Ask, address: str) -> None:
    links = re.findall(r'href="([^"]+)"', site(address).text)
    assert len(links) > 5
    assert not [link for link in links if "&" in unescape(link) and "amp;" in unescape(link)]


@pytest.mark.parametrize("view", ["source", *VIEWS])
def test_what_is_made_from_a_function_is_read_and_downloaded(site: Ask, view: str) -> None:
    page = site(f"/functions/core_acc?view={view}").text
    addresses = re.findall(r'href="(/functions/core_acc/files/[^"]+)"', page)
    assert addresses
    for address in addresses if IS_SLOW_RUN else addresses[:: len(addresses) // 5 + 1]:
        file = site(address)
        assert file.status_code == 200
        assert file.headers["content-disposition"].startswith("attachment")
        assert file.content


@pytest.mark.parametrize("tab", ["autosar-adaptive", "autosar-classic", "ros2", "core"])
def test_all_files_of_a_platform_are_one_archive(site: Ask, tab: str) -> None:
    page = site(f"/functions/core_acc?view={tab}").text
    (address,) = re.findall(r'href="(/functions/core_acc/files/[^"]+zip)"', page)
    kept = site(address)
    assert kept.headers["content-disposition"].endswith(f"CoreAcc.{tab}.zip")
    entries = ZipFile(BytesIO(kept.content)).infolist()
    names = [entry.filename for entry in entries]
    assert {entry.compress_type for entry in entries} == {ZIP_DEFLATED}
    listed = re.findall(r'href="/functions/core_acc\?view=([^"]+)"', page[page.index('aria-label="Files"') :])
    assert len(names) == len(set(names)) == len(set(listed))
    assert site(address).content == kept.content


def test_each_file_of_a_platform_has_an_address(site: Ask) -> None:
    page = site("/functions/core_acc?view=ros2-packages.core_acc.package.xml").text
    assert 'aria-label="core_acc/package.xml"' in page
    assert site("/functions/core_acc?view=ros2-packages.nope").status_code == 404


def test_function_json_of_the_page_is_that_of_the_api(site: Ask) -> None:
    source = site("/functions/core_acc/files/source").content
    built = site("/api/v1/functions/build", "POST", content=source)
    assert site("/functions/core_acc.json").content == built.content


def test_a_function_that_does_not_fit_the_catalogue_shows_its_findings_beside_its_lines(site: Ask) -> None:
    page = site("/functions/core_acc?catalogue=small").text
    assert "cannot be built" in page
    assert re.search(r'<li class="marked error" id="line-\d+">', page)


def test_near_names_are_proposed_for_functions_and_views(site: Ask) -> None:
    assert "core_acc" in site("/functions/core_ac").text
    assert site("/functions/core_acc?view=nope").status_code == 404
    assert site("/functions/core_acc/files/nope").status_code == 404


def test_ecocontrol_is_wired(site: Ask) -> None:
    wiring = site("/wiring.json").json()
    assert wiring["links"] == [
        {
            "path": "Vehicle.ADAS.EcoControl.AccelerationProposal",
            "from": "EcoControlMpc",
            "to": "CoreAcc",
            "mismatches": [],
        }
    ]
    page = site("/wiring").text
    assert "EcoControlMpc_Step" in page
    addresses = re.findall(r'href="(/wiring/files/[^"]+)"', page)
    of_views = {address.partition("?")[0].partition(".")[0]: unescape(address) for address in addresses}
    assert len(of_views) > 4
    assert {site(address).status_code for address in of_views.values()} == {200}


def test_sets_are_bounded(site: Ask) -> None:
    assert site("/wiring?" + "&".join(f"f=x{n}" for n in range(30))).status_code == 422
    assert site("/wiring?f=nope").status_code == 404


def test_the_time_line_repeats_after_the_common_period() -> None:
    line = time_line([function("One", gives(), cycle=20), function("Two", gives(), cycle=50)])
    assert line is not None
    assert line.horizon == "100\u00a0ms"
    assert [len(lane.marks) for lane in line.lanes] == [5, 2]


@pytest.mark.parametrize("cycle", [1, 7, 10**9, 10**30])
def test_a_time_line_is_bounded(cycle: int) -> None:
    line = time_line([function("One", gives(), cycle=cycle), function("Two", gives(), cycle=999_983)])
    assert line is not None
    assert sum(len(lane.marks) for lane in line.lanes) <= 2_000


def test_a_posted_overlay_shows_its_findings_and_stays_in_the_field(site: Ask) -> None:
    page = post(site, kind="overlay", catalogue="interfaces", text="Vehicle.Speed:\r\n  type: sensr\r\n")
    assert 'class="marked error" id="line-2"' in page
    assert "Vehicle.Speed:\n  type: sensr\n</textarea>" in page


def test_a_posted_function_shows_its_diagram(site: Ask) -> None:
    text = site("/functions/eco_control_mpc/files/source").text
    assert "Interfaces of EcoControlMpc" in post(site, kind="function", text=text)
    json = site("/functions/eco_control_mpc.json").text
    assert "Interfaces of EcoControlMpc" in post(site, kind="function", text=json)


@pytest.mark.parametrize("view", ["interfaces", *VIEWS])
def test_a_posted_function_has_the_views_of_a_shipped_one(site: Ask, view: str) -> None:
    source = site("/functions/core_acc/files/source").text
    own = post(site, kind="function", text=source, view=view)
    shipped = site(f"/functions/core_acc?view={view}").text
    of_shipped = re.findall(r'<pre id="text-1">.*?</pre>', shipped, re.DOTALL)
    assert re.findall(r'<pre id="text-1">.*?</pre>', own, re.DOTALL) == of_shipped
    assert bool(of_shipped) is (view != "interfaces")
    assert site("/try", "POST", data={"kind": "function", "view": "nope"}).status_code == 404


def test_a_posted_file_is_checked_byte_for_byte(site: Ask) -> None:
    page = site(
        "/try", "POST", data={"kind": "tree"}, files=[("file", ("mine.vspec", b"Vehicle: {type: br\xe4nch}\n"))]
    )
    assert "Byte 0xE4 is not UTF-8." in page.text
    assert "type: br\ufffdnch" in page.text


@pytest.mark.parametrize("kind", ["overlay", "tree", "function"])
@pytest.mark.parametrize(
    "text",
    ["", "</textarea><script>alert(1)</script>", "a: [" * 100_000, "\x00", "{}", "- 1", '{"FunctionInfo": 3}', "é: ü"],
)
def test_whatever_is_posted_shows_as_text(site: Ask, kind: str, text: str) -> None:
    page = post(site, kind=kind, text=text)
    assert "<script>alert" not in page


def test_markup_in_a_posted_function_shows_as_text(site: Ask) -> None:
    text = site("/functions/core_acc.json").text.replace('"BrkCylP"', '"<img src=x onerror=alert(1)>"')
    page = post(site, kind="function", text=text.replace("Determines", "</text><script>alert(1)</script>"))
    assert "<img" not in page
    assert "<script>alert" not in page


@pytest.mark.parametrize("form", [{"kind": "nope"}, {f"f{n}": "1" for n in range(50)}])
def test_a_form_that_the_page_does_not_have_is_refused(site: Ask, form: dict[str, str]) -> None:
    assert site("/try", "POST", data=form).status_code == 422


def test_changes_stand_below_their_branches_with_old_and_new(site: Ask) -> None:
    page = site("/changes?old=bare&new=small").text
    assert "<h1>The small tree alone → A small tree</h1>" in page
    assert re.search(r'<span class="old"><span class="unseen">from </span>float</span>', page)


def test_changes_have_their_classes_for_a_binding(site: Ask) -> None:
    page = site("/changes?old=bare&new=small").text
    assert "Breaks for" in page
    assert "binding=ros2" in page
    bound = site("/changes?old=vss&new=interfaces&binding=protobuf").text
    assert "for protobuf:" in bound
    assert "&amp;binding=protobuf" in bound
    assert "No differences." in site("/changes?old=vss&new=vss&binding=protobuf").text
    unknown = site("/changes?old=vss&new=interfaces&binding=<b>").text
    assert "changes: " in unknown
    assert "<b>&" not in unknown


def test_changes_are_filtered_by_class_and_kind(site: Ask) -> None:
    everything = site("/changes?old=vss&new=interfaces").text
    added = site("/changes?old=vss&new=interfaces&kind=added").text
    assert everything.count('<li class="change ') > added.count('<li class="change ') > 0
    assert "Remove filter Kind: added" in added
    assert "No differences." in site("/changes?old=vss&new=vss").text


def test_overlays_are_switched_off_by_the_address(site: Ask) -> None:
    page = site("/tree/interfaces~without.error/Vehicle.Function.CoreAcc").text
    assert 'href="/tree/interfaces/Vehicle.Function.CoreAcc" role="switch" aria-checked="false"' in page
    assert site("/tree/interfaces~without.error/Vehicle.Function.CoreAcc.Error").status_code == 307
    assert site("/tree/interfaces~without.nope").status_code == 404
    assert site("/tree/interfaces~nope").status_code == 404


def test_a_variant_without_every_overlay_is_the_base_tree(site: Ask) -> None:
    names = ("ecocontrol", "error", "mode", "safety_reaction", "scheduling")
    bare = "~".join(["interfaces", *(f"without.{name}" for name in names)])
    assert "No differences." in site(f"/changes?old=vss&new={bare}").text


def test_instances_are_folded_to_their_definition(site: Ask) -> None:
    page = site("/tree/interfaces~folded/Vehicle.Chassis.Axle.Wheel").text
    assert "<b>×4</b> in the tree" in page
    one = site("/tree/interfaces~folded/Vehicle.Chassis.Axle.Row1.Wheel.Left.Speed")
    assert one.headers["location"].endswith("/tree/interfaces~folded/Vehicle.Chassis.Axle.Wheel.Speed")
    back = site("/tree/interfaces/Vehicle.Chassis.Axle.Wheel.Speed")
    assert back.headers["location"].endswith("/tree/interfaces/Vehicle.Chassis.Axle.Row1.Wheel.Left.Speed")


def test_a_node_tells_who_uses_it_its_names_and_the_units_of_its_fields(site: Ask) -> None:
    signal = site("/tree/interfaces/Vehicle.ADAS.EcoControl.AccelerationProposal").text
    assert re.search(r"EcoControlMpc</a></span><span class=\"hint\">provides it", signal)
    assert re.search(r"CoreAcc</a></span><span class=\"hint\">consumes it", signal)
    assert "ADAS_EcoControl_AccelerationProposal" in signal
    assert re.search(r"0x[0-9A-F]{8}", signal)
    error = site("/tree/interfaces/Vehicle.Function.CoreAcc.Error.AliveError").text
    assert re.search(r'<span class="muted">ms</span>', error)


def test_findings_of_a_rule_lead_to_their_nodes_and_name_files_of_the_catalogue(site: Ask) -> None:
    page = site("/rules/V109?catalogue=vss").text
    findings = page[page.index("Findings in") :]
    assert "/vspec/" not in findings
    links = re.findall(r'<p class="where"><a href="([^"]+)">', findings)
    assert len(links) == findings.count('<p class="where">')
    instances = [link for link in links if site(link).status_code != 200]
    assert instances
    assert all(site(site(link).headers["location"]).status_code == 200 for link in instances)


def test_a_catalogue_is_pictured(site: Ask) -> None:
    page = site("/catalogues/interfaces").text
    assert 'class="overlaid"' in page
    assert "by overlays, on the rim" in page


def test_the_files_of_a_platform_are_folders_below_the_title_of_their_view() -> None:
    site = asker(create_site(Library([source for source in shipped_sources() if source.id == "interfaces"])))
    page = site("/functions/core_acc?view=ros2").text.replace("<wbr>", "")
    assert re.findall("<h3>([^<]*)</h3>", page) == ["ROS 2", "ROS 2 packages"]
    assert "core_acc/include/core_acc/" in re.findall("<h4>([^<]*)</h4>", page)
