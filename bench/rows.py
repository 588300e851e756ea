"""Measured rows, each with its reference."""

import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from statistics import median
from time import perf_counter
from typing import NamedTuple

from bench import trees
from bench.integration import write_set
from bench.measuring import command, interleaved, probe
from sigcat.catalogue.composing.compose import compose, read_catalogue
from sigcat.catalogue.exporting.export_json import tree_data, tree_json
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.catalogue.reading.layers import read_layer
from sigcat.catalogue.search import SearchIndex
from sigcat.data import ROOT_FILE, VSPEC

TWENTY_THOUSAND = 20_000
HUNDRED_THOUSAND = 100_000


class Row(NamedTuple):
    """A figure beside its reference, as texts."""

    work: str
    figure: str
    reference: str
    ratio: str
    target: str
    is_met: bool


class Bench(NamedTuple):
    """Folder of trees, and number of measurements."""

    folder: Path
    runs: int


class Missing(Exception):
    """A requirement of a row is missing on this machine; the message says how to get it."""


def standard(bench: Bench) -> Row:
    """The standard tree, cold and in process."""
    tree = trees.copied(VSPEC, bench.folder) / ROOT_FILE.name
    figure, reference = interleaved([probe("compose", tree), probe("get_trees", tree)], bench.runs)
    return _faster("compose the standard tree, cold", figure, "`get_trees`", reference, 10)


def standard_command(bench: Bench) -> Row:
    """The same as a command."""
    tree, output = str(trees.copied(VSPEC, bench.folder) / ROOT_FILE.name), str(bench.folder / "out.json")
    ours = command(sys.executable, "-m", "sigcat.cli", "export", "json", "-s", tree, "-o", output)
    vspec = command(str(Path(sys.executable).with_name("vspec")), "export", "json", "-s", tree, "-o", output)
    return _faster("`sigcat export json`", *_split(interleaved([ours, vspec], bench.runs), "`vspec export json`"), 6)


def flat(bench: Bench) -> Row:
    """Twenty thousand signals below one branch."""
    tree = trees.flat(bench.folder, TWENTY_THOUSAND)
    figure, reference = interleaved([probe("compose", tree), probe("get_trees", tree)], min(bench.runs, 3))
    return _faster("compose 20,000 flat signals", figure, "`get_trees`", reference, 10)


def instances(bench: Bench) -> Row:
    """A hundred thousand signals below instances, beside five times twenty thousand flat ones."""
    hundred = probe("compose", trees.below_instances(bench.folder, HUNDRED_THOUSAND))
    twenty = probe("compose", trees.flat(bench.folder / "instances", TWENTY_THOUSAND))
    figure, reference = interleaved([hundred, twenty], bench.runs)
    return at_most("compose 100,000 signals below instances", figure, "5 × 20,000 flat", 5 * reference, 1)


def floor(bench: Bench) -> Row:
    """The standard tree beside libyaml alone."""
    tree = trees.copied(VSPEC, bench.folder) / ROOT_FILE.name
    figure, reference = interleaved([probe("compose", tree), probe("floor", tree)], bench.runs)
    return at_most("compose the standard tree", figure, "`yaml.compose` of the same files", reference, 8)


def recompose(bench: Bench) -> Row:
    """The shipped tree with its overlays, after one more overlay changed."""
    source = shipped_sources()[0]
    files = [*source.overlays, trees.overlay(bench.folder, 1)]

    def cold() -> float:
        start = perf_counter()
        read_catalogue(source.spec, files, units=source.units)
        return perf_counter() - start

    def warm() -> float:
        earlier = read_catalogue(source.spec, files, units=source.units)
        changed = trees.overlay(bench.folder, round(perf_counter()))
        start = perf_counter()
        layers = [*earlier.layers[:-1], read_layer(changed, is_overlay=True)]
        compose(layers, earlier.vocabulary, earlier=earlier)
        return perf_counter() - start

    figure, reference = interleaved([warm, cold], 3 * bench.runs)
    return _faster("recompose after one overlay changed", figure, "cold", reference, 5)


def search(bench: Bench) -> Row:
    """A thousand searches for three words, ranked, with counts of every filter."""
    index = SearchIndex(read_catalogue(trees.flat(bench.folder / "search", HUNDRED_THOUSAND)))
    p99 = median(_p99_of_searches(index) for _ in range(bench.runs))
    return Row("search 100,000 signals for three words, p99", time_of(p99), "", "", "at most 10 ms", p99 <= 0.01)


def _p99_of_searches(index: SearchIndex) -> float:
    taken = []
    for query in trees.queries(1000):
        start = perf_counter()
        index.search(query)
        taken.append(perf_counter() - start)
    return sorted(taken)[989]


def memory(bench: Bench) -> Row:
    """Memory of a catalogue of a hundred thousand signals, next to its JSON."""
    tree = trees.flat(bench.folder / "memory", HUNDRED_THOUSAND)
    size = len(tree_json(tree_data(read_catalogue(tree))).encode())
    held = probe("memory", tree)()
    ratio = held / size
    work, wanted = "memory for 100,000 flat signals", "at most 6 ×"
    return Row(work, f"{held / 1e6:.0f} MB", f"its JSON: {size / 1e6:.0f} MB", f"{ratio:.1f} ×", wanted, ratio <= 6)


def integration(bench: Bench) -> Row:
    """3 executables, 18 services and 162 events, from function files to ARXML, as one process."""
    figure, reference = _integration(bench, 1)
    work = "functions to Integration JSON and ARXML, 162 events"
    return Row(
        work, time_of(figure), f"read and write the same bytes: {time_of(reference)}", "", "under 1 s", figure < 1
    )


def integration_ten(bench: Bench) -> Row:
    """Ten times as many of all of them."""
    small, _ = _integration(bench, 1)
    large, _ = _integration(bench, 10)
    return at_most("the same, 1,620 events", large, "10 × 162 events", 10 * small, 1)


def application(bench: Bench) -> Row:
    """Applications and the bench runtime, of the same set, as a command."""
    folder = write_set(bench.folder / "applications")
    command(sys.executable, "-m", "bench.integration", "derive", str(folder))()
    words = (sys.executable, "-m", "sigcat.cli", "generate", "autosar-adaptive", "--bench")
    document, output = str(folder / "output/integration.json"), str(folder / "application")
    (figure,) = interleaved([command(*words, document, "-o", output)], bench.runs)
    return Row(
        "`sigcat generate autosar-adaptive --bench`, 162 events", time_of(figure), "", "", "under 2 s", figure < 2
    )


def components(bench: Bench) -> Row:
    """Software components of AUTOSAR Classic and the test RTE, of the same set, as a command."""
    folder = write_set(bench.folder / "components")
    sigcat = (sys.executable, "-m", "sigcat.cli")
    functions = sorted(str(file) for file in folder.glob("function*.yaml"))
    units = ("-u", str(VSPEC / "units.yaml"), "-q", str(VSPEC / "quantities.yaml"))
    tree = ("-s", str(folder / "tree.vspec"), *units)
    document, output = str(folder / "classic.json"), str(folder / "made")
    command(*sigcat, "integrate", "autosar-classic", *functions, *tree, "-o", document)()
    words = (*sigcat, "generate", "autosar-classic", "--bench", document, "-o", output)
    (figure,) = interleaved([command(*words)], bench.runs)
    return Row(
        "`sigcat generate autosar-classic --bench`, 162 data elements", time_of(figure), "", "", "under 2 s", figure < 2
    )


def _integration(bench: Bench, times: int) -> list[float]:
    folder = str(write_set(bench.folder / f"set{times}", times))
    words = (sys.executable, "-m", "bench.integration")
    return interleaved([command(*words, "derive", folder), command(*words, "floor", folder)], bench.runs)


ROWS: Mapping[str, Callable[[Bench], Row]] = {
    "standard": standard, "command": standard_command, "flat": flat, "instances": instances, "floor": floor,
    "recompose": recompose, "search": search, "memory": memory, "integration": integration, "integration10": integration_ten,
    "application": application,
    "components": components,
}  # fmt: skip


def _split(medians: list[float], name: str) -> tuple[float, str, float]:
    figure, reference = medians
    return figure, name, reference


def _faster(work: str, figure: float, name: str, reference: float, wanted: int) -> Row:
    ratio = f"{reference / figure:.1f} × faster"
    return Row(
        work,
        time_of(figure),
        f"{name}: {time_of(reference)}",
        ratio,
        f"at least {wanted} ×",
        reference / figure >= wanted,
    )


def at_most(work: str, figure: float, name: str, reference: float, wanted: int) -> Row:
    ratio = figure / reference
    return Row(
        work, time_of(figure), f"{name}: {time_of(reference)}", f"{ratio:.2f} ×", f"at most {wanted} ×", ratio <= wanted
    )


def time_of(seconds: float) -> str:
    return (
        f"{seconds:.2f} s"
        if seconds >= 1
        else f"{seconds * 1000:.0f} ms"
        if seconds >= 0.02
        else f"{seconds * 1000:.1f} ms"
    )
