"""Every export has the same bytes as that of `vspec export` on the original files."""

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

import pytest

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.exporting.export import export
from sigcat.catalogue.exporting.exporters import EXPORTERS
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.data import ROOT_FILE
from tests.catalogue.exporting.reference_export import reference_export
from tests.needs import OFFICIAL, official_releases, sampled
from tests.reference_tools import checked_with

TREE = Path(__file__).parent / "tree"
V5 = OFFICIAL / "v5.0" / "spec" / "VehicleSignalSpecification.vspec"
DOORS = OFFICIAL / "v5.0" / "overlays" / "extensions" / "dual_wiper_systems.vspec"
NEEDS = {"avro": ["types"]}


class Case(NamedTuple):
    """An export, and the same as arguments of `vspec export`."""

    format: str
    options: Mapping[str, object] = MappingProxyType({})
    arguments: tuple[str, ...] = ()
    overlay: bool = True
    types: bool = True


CASES = [
    Case("json", {"extended_attributes": ["ASILlevel"]}, ("-e", "ASILlevel")),
    Case("json", {"expand": False, "pretty": True}, ("--no-expand", "--pretty"), overlay=False),
    Case("json", {"extend_all_attributes": True, "types_output": "t.json"}, ("--extend-all-attributes", "--types-output", "t.json")),
    Case("json", {"stats_radial": "radial.json"}, ("--stats-radial", "radial.json"), types=False),
    Case("yaml", {"extended_attributes": ["ASILlevel"]}, ("-e", "ASILlevel")),
    Case("yaml", {"expand": False, "types_output": "t.yaml"}, ("--no-expand", "--types-output", "t.yaml"), overlay=False),
    Case("csv", {"extended_attributes": ["ASILlevel"]}, ("-e", "ASILlevel")),
    Case("csv", {"expand": False, "types_output": "t.csv"}, ("--no-expand", "--types-output", "t.csv"), overlay=False),
    Case("csv", {"stats_sankey": "s.csv"}, ("--stats-sankey", "s.csv"), types=False, overlay=False),
    Case("jsonschema", {"require_all_properties": True}, ("--require-all-properties",)),
    Case("id", {"case_sensitive": True}, ("--case-sensitive",)),
    Case("id", {"types_output": "t.yaml"}, ("--types-output", "t.yaml")),
    Case("tree", {"attr": ["datatype", "unit"]}, ("--attr", "datatype", "--attr", "unit")),
    Case("protobuf", {"include_comments": True}, ("--include-comments",)),
    Case("protobuf", {"add_optional": True}, ("--add-optional",), types=False),
    Case("ddsidl", {"all_idl_features": True}, ("--all-idl-features",)),
    Case("franca", {"franca_vss_version": "7.0"}, ("--franca-vss-version", "7.0")),
    Case("plantuml"),
    Case("go", {"package": "cars", "short_names": False}, ("--package", "cars", "--no-short-names")),
    Case("binary", types=False),
    Case("binary", {"types_output": "t.bin"}, ("--types-output", "t.bin")),
    Case("s2dm"),
    Case("s2dm", {"modular": True, "flat_domains": False}, ("--modular", "--nested-domains")),
    Case("ros2interface", types=False),
    Case(
        "ros2interface",
        {"mode": "leaf", "srv": "both", "topics": ["*.IsOpen", "Speed"], "timestamp_struct_fqn": "Types.Geo.Time"},
        ("--mode", "leaf", "--srv", "both", "--topics", "*.IsOpen", "--topics", "Speed", "--timestamp-struct-fqn", "Types.Geo.Time"),
    ),
    Case("samm", {"split_depth": 2}, ("--split-depth", "2")),
    Case("apigear", {"apigear_template_qt6_path": "qt"}, ("--apigear-template-qt6-path", "qt")),
    Case("avro", {"namespace": "a.b", "file_prefix": "x"}, ("--namespace", "a.b", "--file-prefix", "x")),
    Case("vhal", {"property_group": 2}, ("--property-group", "2"), types=False, overlay=False),
]  # fmt: skip


def named(case: Case) -> str:
    return " ".join((case.format, *case.arguments))


FIRST = {case.format: case for case in reversed(CASES)}
"""One export of each format; `make slow` takes them with other options too."""


@checked_with("vss-tools", "Every export has the same bytes")
@pytest.mark.parametrize("case", sampled(CASES, list(FIRST.values())), ids=named)
def test_a_tree_with_everything(case, tmp_path):
    tree = tree_without_structs(tmp_path) if not case.types else TREE / "tree.vspec"
    overlays = [TREE / "overlay.vspec"] if case.overlay else []
    types = [TREE / "types.vspec"] if case.types else []
    arguments = [
        "-s", str(tree), *case.arguments,
        *(f"-l{path}" for path in overlays), *(f"-t{path}" for path in types),
    ]  # fmt: skip
    expected = reference_export(EXPORTERS[case.format], arguments, tmp_path / "reference")
    catalogue = read_catalogue(tree, overlays, types=types)
    assert catalogue.findings == () or case.overlay
    files = export(catalogue, case.format, case.options)
    assert {file.name: file.data for file in files} == expected


def tree_without_structs(folder: Path) -> Path:
    """The tree without the signal of a struct type, for exporters that take no types."""
    head, _, _ = (TREE / "tree.vspec").read_text().partition("Vehicle.Position:")
    (folder / "tree.vspec").write_text(head)
    for name in ("units.yaml", "quantities.yaml"):
        (folder / name).write_bytes((TREE / name).read_bytes())
    return folder / "tree.vspec"


@cache
def shipped() -> Catalogue:
    return read_catalogue(ROOT_FILE)


@cache
def official() -> Catalogue:
    return read_catalogue(V5, [DOORS])


SLOW = ("id", "s2dm", "vhal")
"""Formats of which one whole tree is enough; the last one takes no overlays."""
WHOLE = [name for name, exporter in EXPORTERS.items() if not exporter.needs_types]


@checked_with("vss-tools", "Every export has the same bytes")
@pytest.mark.parametrize("name", sampled(WHOLE, {"csv"}))
def test_the_shipped_tree(name, tmp_path):
    expected = reference_export(EXPORTERS[name], ["-s", str(ROOT_FILE)], tmp_path / "reference")
    assert {file.name: file.data for file in export(shipped(), name)} == expected


@checked_with("vss-tools", "Every export has the same bytes")
@official_releases
@pytest.mark.parametrize("name", sampled([name for name in WHOLE if name not in SLOW], {"ros2interface"}))
def test_an_official_release_with_its_overlay(name, tmp_path):
    expected = reference_export(EXPORTERS[name], ["-s", str(V5), "-l", str(DOORS)], tmp_path / "reference")
    assert {file.name: file.data for file in export(official(), name)} == expected


@checked_with("vss-tools", "Every export has the same bytes")
def test_units_that_are_given(tmp_path):
    """vss-tools lists the units that it was given alone; where these suffice, sigcat does so too."""
    tree = tree_without_structs(tmp_path)
    units = tmp_path / "given.yaml"
    more = "ppm:\n  definition: Parts per million.\n  unit: parts per million\n  quantity: relation\n  allowed-datatypes: ['numeric']\n"
    units.write_text(f"{(TREE / 'units.yaml').read_text()}\n{more}")
    quantities = tmp_path / "given_quantities.yaml"
    quantities.write_text(f"{(TREE / 'quantities.yaml').read_text()}\nsmell:\n  definition: How much it smells.\n")
    arguments = ["-s", str(tree), "-u", str(units), "-q", str(quantities)]
    expected = reference_export(EXPORTERS["s2dm"], arguments, tmp_path / "reference")
    catalogue = read_catalogue(tree, units=[units], quantities=[quantities])
    assert {file.name: file.data for file in export(catalogue, "s2dm")} == expected
