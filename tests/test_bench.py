"""What `make bench` starts can be started; its figures are for people, and no test."""

import gc
import tracemalloc
from pathlib import Path

import pytest

from bench import __main__, browser, servers, trees
from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.exporting.export_json import tree_data, tree_json


@pytest.mark.parametrize("script", [browser._SERVE, servers.SERVICE, servers.FLOOR], ids=["site", "api", "floor"])
def test_what_the_scripts_of_servers_import_is_there(script: str) -> None:
    for line in script.splitlines():
        if line.startswith(("from ", "import ")):
            exec(line, {})


def test_a_row_that_needs_a_release_is_left_out_with_a_line(tmp_path: Path, monkeypatch, capsys) -> None:
    monkeypatch.setenv("VSS_RELEASES", str(tmp_path))
    assert not [line for line in __main__._table(["lint-parser"], 1) if "official release" in line]
    assert "the row lint-parser is left out for want of the official release" in capsys.readouterr().err


def test_a_catalogue_takes_no_more_than_six_times_its_json(tmp_path: Path) -> None:
    tree = trees.flat(tmp_path, 1_500)
    size = len(tree_json(tree_data(read_catalogue(tree))).encode())
    gc.collect()
    tracemalloc.start()
    try:
        catalogue = read_catalogue(tree)
        gc.collect()
        held, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert len(catalogue.nodes) > 1_500
    assert held < 6 * size
