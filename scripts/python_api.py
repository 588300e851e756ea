"""Compare the public Python API with that of the last release: `python -m scripts.python_api`.

With `--release` the API becomes the released one, to which later ones are compared; if it breaks its users, it does not.
`make generate` writes docs/reference/python-api.pyi: the signatures of all public names.
"""

import ast
import subprocess
import sys
import sysconfig
from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

from griffe import find_breaking_changes, visit

from sigcat import _NAMES as PUBLIC

ROOT = Path(__file__).parents[1]
FILE = "docs/reference/python-api.pyi"
RELEASED = ROOT / "docs" / "reference" / "python-api-released.pyi"
"""The API of the last release. It moves with releases only, so that a change is found however many commits ago."""
_HEADING = '"""The public Python API of sigcat: generated, see python.md. Imports are omitted."""\n\n'


@lru_cache(maxsize=1)
def signatures() -> str:
    """Return the signatures of all public names, as one stub. stubgen is part of mypy."""
    with TemporaryDirectory() as folder:
        modules = [word for module in PUBLIC for word in ("-m", f"sigcat.{module}")]
        command = [f"{sysconfig.get_path('scripts')}/stubgen", "--quiet", "--no-analysis", "--include-docstrings"]
        subprocess.run([*command, *modules, "--search-path", f"{ROOT}/app", "-o", folder], check=True)
        stubs = {module: Path(folder, "sigcat", *module.split(".")).with_suffix(".pyi") for module in PUBLIC}
        trees = {module: ast.parse(path.read_text("utf-8")) for module, path in stubs.items()}
    public = [ast.unparse(node) for module, tree in trees.items() for node in _public(tree, PUBLIC[module])]
    return _HEADING + "\n\n".join(public) + "\n"


def _public(tree: ast.Module, names: tuple[str, ...]) -> Iterator[ast.stmt]:
    """Return the public definitions. Constructors are not public, but for those of exceptions and tuples."""
    for node in tree.body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and node.name in names:
            if isinstance(node, ast.ClassDef) and not node.bases:
                node.body = [each for each in node.body if getattr(each, "name", "") != "__init__"] or [ast.Pass()]
            yield node


def files() -> Mapping[str, str]:
    """Return the file that is checked in."""
    return {FILE: signatures()}


def breaking_changes(old: str, new: str) -> list[str]:
    """Return the changes that break users of `old`, one line for each."""
    before, after = (visit("sigcat", Path("sigcat.pyi"), text) for text in (old, new))
    return [" ".join(each.explain().split()) for each in find_breaking_changes(before, after)]


def release(new: str, released: Path = RELEASED) -> list[str]:
    """Make the API the released one, unless it breaks its users. Return the changes that do."""
    broken = breaking_changes(released.read_text("utf-8"), new) if released.is_file() else []
    if not broken:
        released.write_text(new, encoding="utf-8")
    return broken


def main() -> int:
    """Print changes that break users of the released API; 1 if there are any."""
    new = signatures()
    broken = release(new) if "--release" in sys.argv[1:] else breaking_changes(RELEASED.read_text("utf-8"), new)
    for change in broken:
        print(f"breaks users of the Python API: {change}")
    return int(bool(broken))


if __name__ == "__main__":
    sys.exit(main())
