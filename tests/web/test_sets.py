"""Sets of functions: several posted documents, alone and with shipped ones."""

import json
import re

import httpx
import pytest

from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.platforms.platform import Platform
from sigcat.platforms.table import PLATFORMS
from sigcat.web.forms import PostedFile
from sigcat.web.site import create_site
from sigcat.web.views.function_sets import as_text, distinct, documents_in
from sigcat.web.views.generated_documents import CORE, SET_VIEWS
from tests.api.conftest import Ask, asker


@pytest.fixture(scope="module")
def site() -> Ask:
    return asker(create_site(Library(shipped_sources())))


@pytest.fixture(scope="module")
def proposing(site: Ask) -> str:
    """The declaration of the function that proposes an acceleration, as Function JSON."""
    return site("/functions/eco_control_mpc.json").text


def connected(site: Ask, *files: tuple[str, str], **form: object) -> httpx.Response:
    posted = [("file", (name, text.encode(), "application/yaml")) for name, text in files]
    return site("/wiring", "POST", data=form, files=posted or [("file", ("", b""))])


def mismatched(page: str) -> list[str]:
    return re.findall(r'<g class="wire mismatched"><title>(\S+)', page)


def test_posted_files_are_connected_with_shipped_functions(site: Ask, proposing: str) -> None:
    page = connected(site, ("mpc.json", proposing), f="core_acc").text
    assert "Posted functions" in page
    assert "2\u00a0functions fit together" in page
    assert len(re.findall(r'<g class="wire"', page)) == 1
    assert "EcoControlMpc_Step" in page


def test_pasted_documents_are_connected_and_stay_in_the_field(site: Ask) -> None:
    texts = [site(f"/functions/{each}/files/source").text for each in ("core_acc", "eco_control_mpc")]
    page = connected(site, text=f"--- # acc.yaml\n{texts[0]}\n---\n{texts[1]}").text
    assert "2\u00a0functions fit together" in page
    field = page[page.index("<textarea") : page.index("</textarea>")]
    assert "--- # acc.yaml" in field
    assert "--- # document 2" in field


def test_a_mismatch_is_red_and_told_beside_its_line(site: Ask, proposing: str) -> None:
    other = proposing.replace('"VssDatatype": "float",\n', '"VssDatatype": "uint8",\n')
    page = connected(site, ("mpc.json", other), f="core_acc").text
    assert mismatched(page) == ["Vehicle.ADAS.EcoControl.AccelerationProposal"]
    assert re.search(r'/rules/F100\?catalogue=interfaces">F100</a>', page)
    assert "fit together" not in page


def test_two_providers_of_one_signal_are_told(site: Ask, proposing: str) -> None:
    twin = proposing.replace("EcoControlMpc", "Rival")
    page = connected(site, ("mpc.json", proposing), ("rival.json", twin)).text
    assert re.search(r"F104</a>\s*<p>[^<]* must have one provider; EcoControlMpc and Rival provide it", page)


def test_findings_stand_beside_the_lines_of_each_posted_file(site: Ask) -> None:
    page = connected(site, ("a.yaml", "function: A\nversion: x\n"), ("b.yaml", "function: B\ncomponents: 3\n")).text
    assert re.search(r'<h2 class="as-written">a\.yaml</h2>.*<h2 class="as-written">b\.yaml</h2>', page, re.DOTALL)
    assert re.search(r'<li class="marked error" id="file-2-2">', page)


def test_what_a_set_makes_is_kept_as_files(site: Ask, proposing: str) -> None:
    made = connected(site, ("mpc.json", proposing), f="core_acc", download="ros2")
    assert made.headers["content-disposition"].startswith("attachment")
    assert made.json()["FunctionInfo"]
    missing = connected(site, ("mpc.json", proposing), download="nope")
    assert missing.status_code == 404


def test_an_archive_of_files_that_cannot_be_made_is_refused_with_the_reasons(site: Ask, proposing: str) -> None:
    other = proposing.replace('"VssUnit": "m/s^2"', '"VssUnit": "km/h"')
    refused = connected(site, ("mpc.json", other), f="core_acc", download="ros2.zip")
    assert refused.status_code == 422
    assert "ROS 2 cannot be made" in refused.text
    assert "must have one datatype and unit" in refused.text


@pytest.mark.parametrize(
    "text",
    [
        "", "---\n---\n", "{", "a: [" * 50_000, "</textarea><script>alert(1)</script>", "\x00", "- 1",
        '--- # </code><script>alert(1)</script>\nfunction: "<script>alert(1)</script>"\n',
    ],
)  # fmt: skip
def test_whatever_is_posted_shows_as_text(site: Ask, text: str) -> None:
    for page in (connected(site, text=text), connected(site, ("<img src=x>.yaml", text), f="core_acc")):
        assert page.status_code == 200
        assert "<script>alert" not in page.text
        assert "<img" not in page.text


def test_the_limits_of_the_service_hold_for_what_is_posted(site: Ask) -> None:
    strict = asker(create_site(Library(shipped_sources()[:1]), Settings(nesting=4)))
    deep = "function: A\ncomponents: [{runnables: [{data: [{values: {A: [1]}}]}]}]\n"
    for ask, is_told in ((site, False), (strict, True)):
        tried = ask("/try", "POST", data={"kind": "function", "text": deep}).text
        assert ("levels" in tried) is is_told
        assert ("levels" in connected(ask, ("deep.yaml", deep)).text) is is_told


@pytest.mark.parametrize("kind", ["overlay", "tree", "function"])
@pytest.mark.parametrize(
    ("settings", "text", "told"),
    [
        (Settings(nesting=9), "[" * 40 + "]" * 40, "levels"),
        (Settings(values=1_000), "[" + "1, " * 1_001 + "1]", "values"),
    ],
)
def test_each_limit_holds_for_whatever_is_tried(site: Ask, settings: Settings, text: str, told: str, kind: str) -> None:
    strict = asker(create_site(Library(shipped_sources()[:1]), settings))
    for ask, is_told in ((site, False), (strict, True)):
        page = ask("/try", "POST", data={"kind": kind, "text": f"Vehicle.A: {{type: sensor, x: {text}}}\n"}).text
        findings = page[page.index('class="verdict"') : page.index('class="whole"')]
        assert (told in findings) is is_told


def test_views_of_a_set_are_tabs(site: Ask, proposing: str) -> None:
    assert "&lt;AUTOSAR" not in site("/wiring").text
    assert "&lt;AUTOSAR" in site("/wiring?f=core_acc&view=arxml").text
    assert "&lt;AUTOSAR" in connected(site, ("mpc.json", proposing), view="arxml").text
    assert "ara::exec::ExecutionClient" in site("/wiring?f=core_acc&view=application.CoreAccExecutable.main.cpp").text
    message = "ros2-packages.core_acc_interfaces.msg.AccelerationLongitudinal.msg"
    assert "builtin_interfaces/Time stamp" in site(f"/wiring?f=core_acc&view={message}").text
    assert site("/wiring?view=nope").status_code == 404


def test_sets_are_bounded_and_named_functions_exist(site: Ask) -> None:
    assert connected(site, *((f"{n}.yaml", "function: A\n") for n in range(21))).status_code == 422
    assert connected(site, f="nope").status_code == 404
    assert connected(site, catalogue="nope").status_code == 404
    assert site("/wiring", "POST", data={"f": "core_acc"}).status_code == 200


def test_a_text_of_several_documents_is_taken_apart_and_put_together() -> None:
    files = (PostedFile("a.yaml", b"function: A\n"), PostedFile("b b.json", b'{"a": "---"}\n'))
    assert documents_in(as_text(files)) == (
        PostedFile("a.yaml", b"function: A\n\n"),
        PostedFile("b b.json", b'{"a": "---"}\n'),
    )
    assert [file.name for file in documents_in("function: A\n---\n\n---\nfunction: B")] == ["document 1", "document 2"]


def test_files_of_one_name_are_told_apart() -> None:
    assert [file.name for file in distinct([PostedFile("a", b"1"), PostedFile("a", b"2")])] == ["a", "a (2)"]


def test_no_view_takes_the_place_of_another_one() -> None:
    """A generator with the name of its platform needs a separate `view`."""
    names = [CORE, *(name for platform in PLATFORMS.values() for name in _views(platform))]
    assert sorted(names) == sorted(set(names)) == sorted(SET_VIEWS)


def _views(platform: Platform) -> list[str]:
    return [platform.name, *{generator.view or generator.name for generator in platform.generators}]


def test_names_in_a_box_stand_beside_each_other(site: Ask, proposing: str) -> None:
    long = proposing.replace('"EcoAccProp"', f'"{"Proposed" * 8}"').replace('"EnaMpc"', f'"{"Measured" * 8}"')
    page = connected(site, ("mpc.json", long), f="core_acc").text
    boxes = [
        (float(x), float(width)) for x, width in re.findall(r'<rect class="box" x="(\d+)" y="\d+" width="(\d+)"', page)
    ]
    assert len(boxes) == 2
    assert boxes[0][1] > 2 * 64 * 7
    assert boxes[1][0] > sum(boxes[0])
    assert f'viewBox="0 0 {int(sum(boxes[1])) + 40} ' in page


def test_the_scaling_of_a_variable_is_shown(site: Ask) -> None:
    text = site("/functions/core_acc.json").text
    document = json.loads(text)
    calls = [call for each in document["ComponentList"] for call in each["functionList"]]
    contracts = [contract for call in calls for contract in call.get("funcContractList") or ()]
    signal = next(each for of in contracts for each in of["SignalList"] or () if each["Name"] == "SetSpd")
    signal.update(Factor="0.01", Offset="-40")
    page = connected(site, ("acc.json", json.dumps(document))).text
    assert "value = SetSpd ×\u00a00.01 −\u00a040" in page
    assert page.count("value = ") == 1
