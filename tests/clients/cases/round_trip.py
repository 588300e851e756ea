"""The round trip of a generated Python client: `python round_trip.py ADDRESS DECLARATION`. Type-checked, then run."""

import io
import json
import sys
from pathlib import Path

from sigcat_client import Client
from sigcat_client.api.catalogues import get_node, get_tree, list_catalogues, search_nodes
from sigcat_client.api.changes import diff_catalogues, try_overlay
from sigcat_client.api.functions import build_function_json, validate_function
from sigcat_client.api.integration import generate_arxml, integrate_functions
from sigcat_client.api.lint import lint
from sigcat_client.models import (
    CatalogueList,
    Diff,
    FunctionJson,
    LintReport,
    Node,
    PlatformName,
    Problem,
    SearchPage,
    TreeNode,
    Trial,
)
from sigcat_client.types import File

OVERLAY = b"Vehicle.Speed:\n  type: sensor\n  datatype: float\n  unit: km/h\n  max: 100\n"


def file(data: bytes) -> File:
    return File(payload=io.BytesIO(data))


def main(address: str, declaration: Path) -> None:
    with Client(base_url=address) as client:
        listed = list_catalogues.sync(client=client)
        assert isinstance(listed, CatalogueList)
        catalogue = listed.catalogues[0].id
        read(client, catalogue)
        change(client, catalogue)
        build(client, catalogue, declaration)


def read(client: Client, catalogue: str) -> None:
    tree = get_tree.sync(catalogue, client=client, depth=2)
    assert isinstance(tree, TreeNode)
    assert tree.subtrees
    page = search_nodes.sync(catalogue, client=client, q="wheel speed", limit=5)
    assert isinstance(page, SearchPage)
    node = get_node.sync(catalogue, page.hits[0].path, client=client)
    assert isinstance(node, Node)
    assert node.path == page.hits[0].path
    missing = get_node.sync(catalogue, "Vehicle.Sped", client=client)
    assert isinstance(missing, Problem)
    assert missing.nearest


def change(client: Client, catalogue: str) -> None:
    report = lint.sync(client=client, body=file(b"Vehicle.Speed:\n  type: sensr\n"))
    assert isinstance(report, LintReport)
    assert not report.ok
    assert report.findings[0].line == 2
    trial = try_overlay.sync(catalogue, client=client, body=file(OVERLAY))
    assert isinstance(trial, Trial)
    assert trial.changes[0].path == "Vehicle.Speed"
    diff = diff_catalogues.sync("vss", client=client, to=catalogue)
    assert isinstance(diff, Diff)
    assert diff.summary.total == len(diff.changes)


def build(client: Client, catalogue: str, declaration: Path) -> None:
    text = declaration.read_bytes()
    built = build_function_json.sync(client=client, body=file(text), catalogue=catalogue)
    assert isinstance(built, FunctionJson)
    document = json.dumps(built.to_dict()).encode()
    report = validate_function.sync(client=client, body=file(document))
    assert isinstance(report, LintReport)
    assert report.ok, report.findings
    platform = PlatformName("autosar-adaptive")
    integrated = integrate_functions.sync_detailed(platform, client=client, body=file(text))
    assert integrated.status_code == 200, integrated.content
    arxml = generate_arxml.sync_detailed(client=client, body=file(integrated.content))
    assert arxml.content.startswith(b"PK"), arxml.content


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
