"""Run `sigcat diff` and `sigcat try` in process, and make trees to compare."""

from sigcat.catalogue.comparing.changes import Change
from sigcat.catalogue.comparing.diff import compare
from sigcat.cli import main
from tests.catalogue.trees import ROOT, catalogue_of


def sigcat(*arguments: str) -> int:
    """Exit status of a command."""
    return main(arguments)


def changes(old: str, new: str) -> tuple[Change, ...]:
    """Changes between the trees of two texts, below the root that both have."""
    return compare(catalogue_of(ROOT + old), catalogue_of(ROOT + new))


def signal(path: str, **attributes: object) -> str:
    """A sensor of datatype float, in vspec."""
    given = {"type": "sensor", "datatype": "float", "description": f"Value of {path}.", **attributes}
    return f"{path}:\n" + "".join(f"  {name}: {value}\n" for name, value in given.items())
