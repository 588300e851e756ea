"""Benchmarks of `make bench` start; their figures are for people, and are not tested."""

import gc
import subprocess
import tracemalloc
from pathlib import Path

import pytest

from bench import __main__, browser, measuring, servers, transport, trees
from bench import ros2 as ros2_row
from scripts import run_autosar
from sigcat.adapter.toolchain import toolchain
from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.exporting.export_json import tree_data, tree_json
from sigcat.comparison.running import processes
from tests.needs import cpp_compiler, own_network, ros2, slow


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


@pytest.mark.parametrize("missing", ["cmake", "c++", "ip"])
def test_events_are_left_out_with_a_line_where_they_cannot_be_measured(missing: str, monkeypatch, capsys) -> None:
    monkeypatch.delenv("CXX", raising=False)
    monkeypatch.setattr(transport, "which", lambda name: None if name == missing else name)
    assert not [line for line in __main__._table(["event"], 1) if "an event" in line]
    assert len(capsys.readouterr().err.splitlines()) == 1


@cpp_compiler
def test_the_programs_of_events_fit_what_is_generated(tmp_path: Path) -> None:
    run_autosar.generate_into(tmp_path)
    folders = (
        tmp_path / "generated/include",
        tmp_path / "bench/include",
        tmp_path,
        measuring.ROOT / "examples/core_acc",
    )
    flags = ("-std=c++17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", *(f"-I{folder}" for folder in folders))
    sources = sorted(map(str, transport.PROGRAMS.glob("event_*.cpp")))
    done = subprocess.run([*toolchain().cpp, *flags, *sources], check=False, capture_output=True, text=True)
    assert (len(sources), done.stderr) == (2, "")


@ros2
@slow
def test_the_generated_node_and_the_one_by_hand_answer(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(ros2_row, "TRIPS", 20)
    built = ros2_row._build(tmp_path)
    for node in ("reflex/reflex_node", "by_hand/by_hand_node"):
        assert 0 < ros2_row._measured(built, tmp_path, node)[0] < 1e6


@cpp_compiler
@own_network
def test_each_datagram_of_the_reference_is_received_after_it_was_sent(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(transport, "EVENTS", 20)
    for name in ("datagram_sender", "datagram_receiver"):
        source = str(transport.PROGRAMS / f"{name}.cpp")
        subprocess.run([*toolchain().cpp, "-std=c++17", source, "-pthread", "-o", str(tmp_path / name)], check=True)
    sent, received = transport._times(processes.own_network() or (), tmp_path, "datagram", ("received",))
    assert all(begin < end for begin, end in zip(sent, received, strict=True))
