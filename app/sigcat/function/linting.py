"""Check function files for a lint, over the tree that it has chosen."""

from collections.abc import Callable, Sequence

from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.function.code_files import CodeCheck
from sigcat.function.sets.check_set import check_functions
from sigcat.rules.linting.options import CheckedFunctions


def checked_functions(
    tree: Source,
    files: Sequence[tuple[bytes, str]],
    is_whole: bool,
    *,
    load_tree: Callable[[Source], Catalogue],
    check_code: CodeCheck | None = None,
) -> CheckedFunctions:
    """Check function files against a tree. `load_tree` loads it: an editor keeps it loaded; `check_code` checks headers."""
    catalogue = load_tree(tree)
    findings = check_functions(files, catalogue, is_whole=is_whole, check_code=check_code)
    return CheckedFunctions(findings, tuple(file.name for file in catalogue.files))
