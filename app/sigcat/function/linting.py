"""Check function files for a lint, over the tree that it has chosen."""

from collections.abc import Callable, Sequence

from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.function.code_files import CodeCheck
from sigcat.function.sets.check_set import check_functions
from sigcat.rules.linting.options import CheckedFunctions


def checked_functions(
    tree: Source,
    files: Sequence[tuple[bytes, str]],
    is_whole: bool,
    *,
    check_code: CodeCheck | None = None,
    load_tree: Callable[[Source], Catalogue] = load,
) -> CheckedFunctions:
    """Check function files against a tree. The tree is loaded only when it is called; `check_code` checks headers."""
    catalogue = load_tree(tree)
    findings = check_functions(files, catalogue, is_whole=is_whole, check_code=check_code)
    return CheckedFunctions(findings, tuple(file.name for file in catalogue.files))
