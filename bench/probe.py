"""One measurement in a separate process: `python -m bench.probe NAME TREE`. Prints one number.

What is imported is imported before the clock starts.
"""

import gc
import logging
import sys
import tracemalloc
from collections.abc import Callable, Mapping
from pathlib import Path
from time import perf_counter, process_time


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


def vehicles(project_file: Path) -> float:
    """Processor time to compose all vehicles of a project."""
    from sigcat.project.read_project import read_project
    from sigcat.project.vehicles import each_composed

    project = read_project(project_file)
    start = process_time()
    assert list(each_composed(project, project.vehicles))
    return process_time() - start


def vehicles_memory(project_file: Path) -> float:
    """Bytes that all vehicles of a project hold, with the catalogue that they share."""
    from sigcat.project.read_project import read_project
    from sigcat.project.vehicles import each_composed

    small, project = read_project(project_file.with_name("small.toml")), read_project(project_file)
    assert list(each_composed(small, small.vehicles))  # loads the modules
    gc.collect()
    tracemalloc.start()
    composed = list(each_composed(project, project.vehicles))
    gc.collect()
    held, _ = tracemalloc.get_traced_memory()
    assert len(composed) == len(project.vehicles)
    return held


PROBES: Mapping[str, Callable[[Path], float]] = {
    "get_trees": get_trees, "compose": compose, "floor": floor, "memory": memory,
    "vehicles": vehicles, "vehicles-memory": vehicles_memory,
}  # fmt: skip

if __name__ == "__main__":
    print(PROBES[sys.argv[1]](Path(sys.argv[2])))
