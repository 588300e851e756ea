"""Text of a tree stays text in every form of an answer: it opens no markup, and a spreadsheet computes nothing from it."""

import csv
import io
import json
import re

import pytest
import yaml

from sigcat.api.application import create_app
from sigcat.catalogue.hosting.library import Library, Source
from sigcat.web.site import create_site
from tests.api.conftest import Ask, asker

HOSTILE = {
    "a formula": "=HYPERLINK(1)",
    "another formula": "@SUM(1)",
    "HTML": "</td></script><script>alert(1)</script>",
    "XML": "]]><x/><!-- ",
    "Markdown": "| a | [x](javascript:x) ``",
    "a comment of C++": "*/ system(1); /*",
    "lines": "a\nVehicle.Forged,1\r\nb",
}
CODE = re.compile(r"(?<!`)(`+)(?!`)(.+?)(?<!`)\1(?!`)")
"""A span of code in Markdown: it ends with as many backticks as it begins with (CommonMark 6.1)."""
API = "/api/v1/catalogues"


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Library:
    folder = tmp_path_factory.mktemp("hostile")
    nodes = {f"Vehicle.N{number}": text for number, text in enumerate(HOSTILE.values())}
    tree = {path: {"type": "sensor", "datatype": "float", "description": text} for path, text in nodes.items()}
    (folder / "new.vspec").write_text(json.dumps({"Vehicle": {"type": "branch", "description": "X."}, **tree}))
    for node in tree.values():
        node["description"] = "Before."
    (folder / "old.vspec").write_text(json.dumps({"Vehicle": {"type": "branch", "description": "X."}, **tree}))
    return Library([Source(name, name, folder / f"{name}.vspec") for name in ("new", "old")])


@pytest.fixture(scope="module")
def get(library: Library) -> Ask:
    return asker(create_app(library))


@pytest.mark.parametrize("path", ["nodes?fields=description,path", "search?q=n"])
def test_no_cell_of_a_table_is_a_formula_and_no_row_is_forged(get: Ask, path: str) -> None:
    table = get(f"{API}/new/{path}", headers={"Accept": "text/csv"}).text
    rows = list(csv.reader(io.StringIO(table, newline="")))
    assert not [cell for row in rows for cell in row if cell.startswith(("=", "+", "-", "@"))]
    assert "Vehicle.Forged" not in {cell for row in rows for cell in row}


@pytest.mark.parametrize("case", HOSTILE)
def test_json_and_yaml_say_the_text_as_it_is(get: Ask, case: str) -> None:
    address = f"{API}/new/nodes?fields=path,description&q=n{list(HOSTILE).index(case)}"
    (node,) = get(address).json()["rows"]
    assert node["description"] == HOSTILE[case]
    assert yaml.safe_load(get(address, headers={"Accept": "application/yaml"}).text)["rows"] == [node]


def test_a_report_in_markdown_opens_no_markup(get: Ask) -> None:
    report = get(f"{API}/old/diff?to=new", headers={"Accept": "text/markdown"}).text
    assert "Vehicle.N2" in report
    outside = CODE.sub("", report)
    assert not [text for text in ("<script>", "<x/>", "](javascript:", "system(1)") if text in outside]
    assert "\nVehicle.Forged" not in report


@pytest.mark.parametrize("address", ["/tree/new/Vehicle.N{}", "/search/new?q=n", "/changes?old=old&new=new"])
def test_pages_show_markup_as_text(library: Library, address: str) -> None:
    ask = asker(create_site(library))
    for number in range(len(HOSTILE)):
        page = ask(address.format(number)).text
        assert "<script>alert" not in page
        assert "]]><x/>" not in page
