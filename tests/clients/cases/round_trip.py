"""The round trip of a generated Python client: `python round_trip.py ADDRESS DECLARATION`. Type-checked, then run."""

import io
import json
import sys
from pathlib import Path

from sigcat_client import Client
from sigcat_client.api.catalogues import get_node, get_tree, list_catalogues, list_nodes, search_nodes
from sigcat_client.api.changes import diff_catalogues, try_overlay
from sigcat_client.api.exports import export_csv, export_json, export_ros2interface, export_yaml
from sigcat_client.api.functions import build_function_json, validate_function
from sigcat_client.api.integration import (
    generate_arxml,
    generate_autosar_adaptive,
    generate_autosar_classic,
    generate_classic_arxml,
    generate_ros2,
    integrate_functions,
)
from sigcat_client.api.lint import lint
from sigcat_client.api.registry import (
    can_deploy,
    check_versions,
    get_registry_version,
    get_version_content,
    list_registry_names,
    list_registry_users,
    publish_versions,
    record_deployment,
)
from sigcat_client.models import (
    CatalogueList,
    Decision,
    DeploymentAnswer,
    Diff,
    ExportMode,
    FunctionJson,
    LintReport,
    Node,
    NodePage,
    PlatformName,
    Problem,
    RegistryChange,
    RegistryGroup,
    RegistryNamePage,
    RegistryReceipt,
    RegistryUserList,
    RegistryVersion,
    Ros2Distribution,
    SearchPage,
    Severity,
    TreeNode,
    Trial,
    VssTree,
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
        export(client, catalogue)
        build(client, catalogue, declaration)
        publish(client, catalogue, declaration)


def read(client: Client, catalogue: str) -> None:
    tree = get_tree.sync(catalogue, client=client, depth=2)
    assert isinstance(tree, TreeNode)
    assert tree.subtrees
    listed = list_nodes.sync(catalogue, client=client, fields="path,unit", limit=3)
    assert isinstance(listed, NodePage)
    assert listed.rows[0]["path"] == tree.path
    page = search_nodes.sync(catalogue, client=client, q="wheel speed", limit=5)
    assert isinstance(page, SearchPage)
    found = page.hits[0]
    node = get_node.sync(catalogue, found.path, client=client)
    assert isinstance(node, Node)
    assert (node.path, node.datatype, node.unit) == (found.path, found.datatype, found.unit)
    missing = get_node.sync(catalogue, "Vehicle.Sped", client=client)
    assert isinstance(missing, Problem)
    assert missing.nearest


def change(client: Client, catalogue: str) -> None:
    report = lint.sync(client=client, body=file(b"Vehicle.Speed:\n  type: sensr\n"))
    assert isinstance(report, LintReport)
    assert not report.ok
    assert report.findings[0].line == 2
    assert report.findings[0].severity in Severity
    trial = try_overlay.sync(catalogue, client=client, body=file(OVERLAY))
    assert isinstance(trial, Trial)
    assert trial.changes[0].path == "Vehicle.Speed"
    diff = diff_catalogues.sync("vss", client=client, to=catalogue)
    assert isinstance(diff, Diff)
    assert diff.summary.total == len(diff.changes)


def export(client: Client, catalogue: str) -> None:
    tree = export_json.sync(catalogue, client=client, pretty=True)
    assert isinstance(tree, VssTree)
    assert "Vehicle" in tree
    table = export_csv.sync(catalogue, client=client)
    assert isinstance(table, str)
    assert table.startswith("Signal,")
    for exported in (
        export_yaml.sync(catalogue, client=client),
        export_ros2interface.sync(catalogue, client=client, mode=ExportMode.LEAF, topics=["Vehicle.Speed"]),
    ):
        assert isinstance(exported, File)
        assert exported.payload.read()


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
    application = generate_autosar_adaptive.sync_detailed(client=client, body=file(integrated.content), bench=True)
    assert application.content.startswith(b"PK"), application.content
    classic = integrate_functions.sync_detailed(PlatformName("autosar-classic"), client=client, body=file(text))
    classic_arxml = generate_classic_arxml.sync_detailed(client=client, body=file(classic.content))
    assert classic_arxml.content.startswith(b"PK"), classic_arxml.content
    components = generate_autosar_classic.sync_detailed(client=client, body=file(classic.content), bench=True)
    assert components.content.startswith(b"PK"), components.content
    for_ros = integrate_functions.sync_detailed(PlatformName("ros2"), client=client, body=file(text))
    packages = generate_ros2.sync_detailed(
        client=client, body=file(for_ros.content), distribution=Ros2Distribution("humble")
    )
    assert packages.content.startswith(b"PK"), packages.content


def publish(client: Client, catalogue: str, declaration: Path) -> None:
    text, functions = declaration.read_bytes(), RegistryGroup("functions")
    receipt = publish_versions.sync(client=client, body=file(text), catalogue=catalogue)
    assert isinstance(receipt, RegistryReceipt), receipt
    published = receipt.versions_posted[0]
    reference = f"{published.name}@{published.versionid}"
    content = get_version_content.sync(functions, published.name, published.versionid, client=client)
    assert isinstance(content, File)
    assert content.payload.read() == text
    version = get_registry_version.sync(functions, published.name, published.versionid, client=client, inline="uses")
    assert isinstance(version, RegistryVersion)
    assert version.uses
    names = list_registry_names.sync(functions, client=client)
    assert isinstance(names, RegistryNamePage)
    assert names.total == 1
    users = list_registry_users.sync(client=client, path=version.uses[0].element)
    assert isinstance(users, RegistryUserList)
    assert users.users[0].name == published.name
    change = record_deployment.sync(client=client, function=reference, line="SUV-2025")
    assert isinstance(change, RegistryChange)
    answer = can_deploy.sync(client=client, function=reference, line="SUV-2025")
    assert isinstance(answer, DeploymentAnswer)
    assert answer.decision == Decision("yes")
    report = check_versions.sync(client=client, body=file(text), catalogue=catalogue)
    assert isinstance(report, LintReport)
    assert report.ok


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
