"""One measurement in a separate process: `python -m bench.probe NAME TREE`. Prints one number.

What is imported is imported before the clock starts.
"""

import gc
import logging
import sys
import tracemalloc
from collections.abc import Callable, Mapping
from pathlib import Path
from time import perf_counter


def get_trees(tree: Path) -> float:
    """Seconds that vss-tools takes to load a tree."""
    from vss_tools.main import get_trees as load

    logging.disable(logging.CRITICAL)
    start = perf_counter()
    load(tree)
    return perf_counter() - start


def compose(tree: Path) -> float:
    """Seconds that sigcat takes from files to a frozen catalogue."""
    from sigcat.catalogue.composing.compose import read_catalogue

    start = perf_counter()
    read_catalogue(tree)
    return perf_counter() - start


def floor(tree: Path) -> float:
    """Seconds that libyaml takes to compose the same files, with nothing made of them."""
    import yaml

    from sigcat.catalogue.composing.compose import read_catalogue

    catalogue = read_catalogue(tree)
    sources = [*(file for layer in catalogue.layers for file in layer.files), *catalogue.vocabulary.files]
    gc.disable()  # as sigcat does while it reads
    start = perf_counter()
    for source in sources:
        yaml.compose(Path(source.name).read_bytes(), Loader=yaml.CSafeLoader)
    return perf_counter() - start


def memory(tree: Path) -> float:
    """Bytes that a catalogue holds."""
    from sigcat.catalogue.composing.compose import read_catalogue
    from sigcat.data import ROOT_FILE

    read_catalogue(ROOT_FILE)  # what is loaded once and for all is not part of a catalogue
    gc.collect()
    tracemalloc.start()
    catalogue = read_catalogue(tree)
    gc.collect()
    held, _ = tracemalloc.get_traced_memory()
    assert catalogue.nodes
    return held


PROBES: Mapping[str, Callable[[Path], float]] = {
    "get_trees": get_trees, "compose": compose, "floor": floor, "memory": memory,
}  # fmt: skip

if __name__ == "__main__":
    print(PROBES[sys.argv[1]](Path(sys.argv[2])))
