"""Definitions of other functions of a project, for files that are checked without them."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.findings import has_errors
from sigcat.function.extension.extended_catalogue import extended
from sigcat.function.folder_functions import folder_functions, name_of
from sigcat.function.function_file import FunctionFile, read_function_file
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
    own = {name_of(read_function_file(data, name, limits)) for data, name in files}
    found = (read_function_file(path.read_bytes(), str(path), limits) for path in folder_functions(folders))
    others: list[FunctionFile] = [each for each in found if name_of(each) not in own]
    return extended(catalogue, others).catalogue if others else catalogue
