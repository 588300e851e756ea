"""Definitions of other functions of a project, for files that are checked without them."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.findings import has_errors
from sigcat.function.extension.extended_catalogue import extended
from sigcat.function.folder_functions import folder_functions, name_of
from sigcat.function.function_file import read_function_file
from sigcat.function.sets.check_set import read_set
from sigcat.limits import DEFAULT_LIMITS, Limits


@collector_paused()
def with_others(
    files: Sequence[tuple[bytes, str]], catalogue: Catalogue, folders: Iterable[Path], limits: Limits = DEFAULT_LIMITS
) -> Catalogue:
    """Return the catalogue, with the definitions of other functions in folders if files have errors without these.

    Function JSON names the layers that it was made from: a file that needs no other is made from its own.
    """
    folders = tuple(folders)
    if not folders or not any(has_errors(each.findings) for each in read_set(files, catalogue, limits)[0]):
        return catalogue
    others = [read_function_file(data, name, limits) for data, name in other_functions(files, folders, limits)]
    return extended(catalogue, others).catalogue if others else catalogue


def other_functions(
    files: Sequence[tuple[bytes, str]], folders: Iterable[Path], limits: Limits = DEFAULT_LIMITS
) -> list[tuple[bytes, str]]:
    """Return the function files of folders whose functions are not among the files."""
    own = {name_of(read_function_file(data, name, limits)) for data, name in files}
    found = ((path.read_bytes(), str(path)) for path in folder_functions(folders))
    return [(data, name) for data, name in found if name_of(read_function_file(data, name, limits)) not in own]
