"""The table of formats says what vss-tools says: every exporter, every option, every default."""

import json
import subprocess
import sys

import pytest

from sigcat.catalogue.exporting.vss_tools.formats import FORMATS, Format, format_named, options_of
from sigcat.errors import NotFound

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
             list(getattr(p.type, "choices", ())), p.is_flag] for p in command.params]
print(json.dumps({name: described(module) for name, module in exporters.items()}, default=lambda _: None))
"""


@pytest.fixture(scope="module")
def exporters():
    output = subprocess.run([sys.executable, "-c", DESCRIBE], capture_output=True, text=True, check=True).stdout
    return json.loads(output)


def test_every_exporter_is_there(exporters):
    assert set(FORMATS) == set(exporters)


@pytest.mark.parametrize("format_", FORMATS.values(), ids=lambda format_: format_.name)
def test_every_option_of_an_exporter_is_there(exporters, format_: Format):
    theirs = {name: rest for name, *rest in exporters[format_.name]}
    ours = {option.name: option for option in options_of(format_) if not option.own}
    tree = TREE_OPTIONS if format_.takes_tree_options else {"vspec"}
    assert set(ours) | tree | {format_.output} | LEFT_OUT.get(format_.name, set()) == set(theirs)
    for name, option in ours.items():
        off, default, multiple, choices, is_flag = theirs[name]
        assert (option.kind == "switch") == bool(off), name
        assert not off or option.spelled_off == off
        assert (option.kind == "flag") == (is_flag and not off), name
        assert (option.kind == "texts") == multiple, name
        assert list(option.choices) == choices, name
        assert name == "namespace" or (option.default or None) == (default or None), name


def test_an_unknown_format_is_refused_with_the_nearest_one():
    with pytest.raises(NotFound, match="Did you mean 'protobuf'") as refusal:
        format_named("protobuff")
    assert refusal.value.nearest == ("protobuf",)


def test_a_folder_has_no_suffix_and_is_a_zip_archive_for_those_who_need_one_file():
    assert {name for name, f in FORMATS.items() if f.is_folder} == {
        name for name, f in FORMATS.items() if f.media_type == "application/zip"
    }
