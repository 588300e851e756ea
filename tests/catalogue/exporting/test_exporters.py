"""One table lists the exporters. Of vss-tools' it has every exporter, every option, every default; it takes others too."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from scripts.command_line import command_parsers
from sigcat.catalogue.exporting import exporters as table
from sigcat.catalogue.exporting.export import exported
from sigcat.catalogue.exporting.exporter import Exporter, Job
from sigcat.catalogue.exporting.exporters import EXPORTERS, exporter_named
from sigcat.catalogue.exporting.files import Export, ExportedFile
from sigcat.catalogue.exporting.vss_tools.exporter_calls import call_of
from sigcat.errors import InputRefused, NotFound
from tests.catalogue.trees import ROOT, catalogue_of

TREE_OPTIONS = {"vspec", "include-dirs", "overlays", "quantities", "units", "types"}
LEFT_OUT = {"id": {"validate-only"}}
"""Options that keep an exporter from writing anything."""

DESCRIBE = """
import importlib, json, vss_tools.cli
exporters = vss_tools.cli.export.lazy_subcommands
def described(module):
    command = importlib.import_module(module.partition(":")[0]).cli
    longest = lambda names: max(names, key=len, default="").lstrip("-")
    return [[longest(p.opts), longest(p.secondary_opts), p.to_info_dict()["default"], p.multiple,
             list(getattr(p.type, "choices", ())), p.is_flag, [*p.opts, *p.secondary_opts]] for p in command.params]
print(json.dumps({name: described(module) for name, module in exporters.items()}, default=lambda _: None))
"""


@pytest.fixture(scope="module")
def exporters():
    output = subprocess.run([sys.executable, "-c", DESCRIBE], capture_output=True, text=True, check=True).stdout
    return json.loads(output)


def test_every_exporter_is_there(exporters):
    assert {name for name, exporter in EXPORTERS.items() if exporter.same_as == f"vspec export {name}"} == set(
        exporters
    )


@pytest.mark.parametrize(
    "exporter", [exporter for exporter in EXPORTERS.values() if exporter.same_as], ids=lambda exporter: exporter.name
)
def test_every_option_of_an_exporter_is_there(exporters, exporter: Exporter):
    call = call_of(exporter.name)
    theirs = {name: rest for name, *rest in exporters[exporter.name]}
    ours = {option.name: option for option in exporter.options if not option.own}
    tree = TREE_OPTIONS if call.takes_tree_options else {"vspec"}
    assert set(ours) | tree | {call.output} | LEFT_OUT.get(exporter.name, set()) == set(theirs)
    for name, option in ours.items():
        off, default, multiple, choices, is_flag, _ = theirs[name]
        assert (option.kind == "switch") == bool(off), name
        assert not off or option.spelled_off == off
        assert (option.kind == "flag") == (is_flag and not off), name
        assert (option.kind == "texts") == multiple, name
        assert list(option.choices) == choices, name
        assert name == "namespace" or (option.default or None) == (default or None), name


@pytest.mark.parametrize("name", [exporter.name for exporter in EXPORTERS.values() if exporter.same_as])
def test_the_command_knows_every_spelling_of_vspec(exporters, name):
    (parser,) = (parser for parser in command_parsers() if parser.prog == f"sigcat export {name}")
    spellings = {spelled for *_, spelled_as in exporters[name] for spelled in spelled_as}
    left_out = {f"--{option}" for option in LEFT_OUT.get(name, ())}
    assert spellings - left_out - {text for action in parser._actions for text in action.option_strings} == set()


def test_an_unknown_format_is_refused_with_the_nearest_one():
    with pytest.raises(NotFound, match="Did you mean 'protobuf'") as refusal:
        exporter_named("protobuff")
    assert refusal.value.nearest == ("protobuf",)


def test_a_folder_has_no_suffix_and_is_a_zip_archive_for_those_who_need_one_file():
    assert {name for name, f in EXPORTERS.items() if f.is_folder} == {
        name for name, f in EXPORTERS.items() if f.media_type == "application/zip"
    }


def paths(job: Job) -> Export:
    lines = "".join(f"{path}\n" for path in job.catalogue.nodes)
    return Export((ExportedFile(job.output_name, lines.encode()),))


def test_an_exporter_of_ones_own_takes_one_record(monkeypatch):
    own = Exporter("paths", "one path a line", ".txt", "text/plain", (), paths)
    monkeypatch.setattr(table, "EXPORTERS", {**EXPORTERS, own.name: own})
    (file,) = exported(catalogue_of(ROOT), "paths").files
    assert (file.name, file.data) == ("Vehicle.txt", b"Vehicle\n")


def test_the_documentation_lists_every_exporter():
    text = (Path(__file__).parents[3] / "docs" / "reference" / "exports.md").read_text()
    assert [name for name in EXPORTERS if f"`{name}`" not in text] == []


@pytest.mark.parametrize("text", ["Speed. */ int evil = 1; /*", "Speed.\nint evil = 1;"])
@pytest.mark.parametrize(("name", "is_unescaped"), [("ddsidl", True), ("protobuf", False)])
def test_a_text_that_ends_the_comment_of_the_file_is_reported(name, is_unescaped, text):
    speed = f"Vehicle.Speed:\n  type: sensor\n  datatype: float\n  description: {json.dumps(text)}\n"
    made = exported(catalogue_of(ROOT + speed), name)
    assert [(each.rule, each.path, each.line) for each in made.findings] == (
        [("X005", "Vehicle.Speed", 7)] if is_unescaped else []
    )
    bare = [line for file in made.files for line in file.data.decode().splitlines() if line.startswith("int evil")]
    assert bool(bare) == (is_unescaped and "\n" in text)


VALUES = ["P = 0; }", "A\n  uint32 brake = 7;", "A // B", 'A"B', "#A"]


@pytest.mark.parametrize("value", VALUES)
@pytest.mark.parametrize("name", ["protobuf", "ddsidl", "franca", "plantuml", "ros2interface"])
def test_an_allowed_value_that_is_code_in_the_file_is_reported_and_refused_strictly(name, value):
    mode = (
        f"Vehicle.Mode:\n  type: sensor\n  datatype: string\n  description: Mode.\n  allowed: [{json.dumps(value)}]\n"
    )
    made = exported(catalogue_of(ROOT + mode), name)
    assert ("X005", "Vehicle.Mode", 8) in [(each.rule, each.path, each.line) for each in made.findings]
    with pytest.raises(InputRefused) as refused:
        exported(catalogue_of(ROOT + mode), name, {"strict": True})
    assert [each.rule for each in refused.value.findings] == ["X005"]


@pytest.mark.parametrize("attribute", ["description", "comment", "default", "deprecation"])
def test_a_text_that_leaves_a_comment_of_a_message_is_reported(attribute):
    values = {"type": "attribute", "datatype": "string", "description": "Mode.", attribute: "A\n  uint32 brake = 7; //"}
    mode = "Vehicle.Mode:\n" + "".join(f"  {key}: {json.dumps(value)}\n" for key, value in values.items())
    made = exported(catalogue_of(ROOT + mode), "protobuf", {"include-comments": True})
    assert [(each.rule, each.path) for each in made.findings] == [("X005", "Vehicle.Mode")]


@pytest.mark.parametrize("name", ["go", "protobuf", "ddsidl", "franca", "plantuml"])
def test_an_instance_that_is_code_in_the_file_is_reported_and_refused_strictly(name):
    door = 'Vehicle.Door:\n  type: branch\n  description: Door.\n  instances: ["A = 0; }"]\n'
    tree = ROOT + door + "Vehicle.Door.IsOpen: {type: sensor, datatype: boolean, description: Open.}\n"
    with pytest.raises(InputRefused) as refused:
        exported(catalogue_of(tree), name, {"strict": True})
    assert ("X005", "Vehicle.Door", 7) in [(each.rule, each.path, each.line) for each in refused.value.findings]
