"""The language server: from a key press to its diagnostics, and the first diagnostics of a file, on the standard tree."""

import shutil
from collections.abc import Callable, Mapping
from pathlib import Path
from statistics import median
from time import perf_counter

from bench.editor import Editor, editor
from bench.rows import Bench, Row
from sigcat.data import EXAMPLES, OVERLAYS, ROOT_FILE, VSPEC

_KEY_PRESSES = 40
_FIRST, _EACH = 0.5, 0.1
"""Targets in seconds."""


def key_press_in_overlay(bench: Bench) -> Row:
    """An overlay over the standard tree."""
    return _key_presses("an overlay", _project(bench) / "overlays" / "ecocontrol.vspec")


def key_press_in_part(bench: Bench) -> Row:
    """One file of the standard tree."""
    return _key_presses("a file of the tree", _project(bench) / "vspec" / "Cabin" / "HVAC.vspec")


def key_press_in_root(bench: Bench) -> Row:
    """The root file, for which the whole tree is checked."""
    return _key_presses("the root of the tree", _project(bench) / "vspec" / ROOT_FILE.name)


def key_press_in_function(bench: Bench) -> Row:
    """A function of the example, over the standard tree with its overlays."""
    return _key_presses("a function.yaml", _project(bench) / "functions" / "core_acc" / "function.yaml")


def first_diagnostics(bench: Bench) -> Row:
    """A file that is opened in a server that runs."""
    folder = _project(bench)
    with editor(folder) as client:
        client.open(folder / "vspec" / "Cabin" / "HVAC.vspec")
        files = sorted((folder / "overlays").glob("*.vspec"))
        taken = median(_seconds(client.open, path) for path in files)
    return _row("first diagnostics of an overlay that is opened, server warm", taken, _FIRST)


def _key_presses(what: str, path: Path) -> Row:
    root = next(parent for parent in path.parents if (parent / "sigcat.toml").is_file())
    with editor(root) as client:
        client.open(path)
        text = client.texts[path]
        taken = sorted(_typed(client, path, f"{text}\n# {'x' * number}") for number in range(_KEY_PRESSES))
    p95 = taken[int(len(taken) * 0.95) - 1]
    return _row(f"diagnostics after a key press in {what}, standard tree, p95", p95, _EACH)


def _typed(client: Editor, path: Path, text: str) -> float:
    return _seconds(lambda changed: client.change(changed, text), path)


def _seconds(work: Callable[[Path], object], path: Path) -> float:
    start = perf_counter()
    work(path)
    return perf_counter() - start


def _project(bench: Bench) -> Path:
    """A project with a copy of the standard tree and its overlays."""
    folder = bench.folder / "language-server"
    if not folder.is_dir():
        shutil.copytree(VSPEC, folder / "vspec")
        shutil.copytree(OVERLAYS, folder / "overlays")
        shutil.copytree(EXAMPLES / "core_acc", folder / "functions" / "core_acc")
        text = f'[[catalogue]]\nid = "vss"\nspec = "vspec/{ROOT_FILE.name}"\noverlays = ["overlays/*.vspec"]\n'
        (folder / "sigcat.toml").write_text(text, encoding="utf-8")
    return folder


def _row(work: str, seconds: float, target: float) -> Row:
    figure, wanted = f"{seconds * 1000:.0f} ms", f"at most {target * 1000:.0f} ms"
    return Row(work, figure, f"target: {target * 1000:.0f} ms", f"{seconds / target:.2f} ×", wanted, seconds <= target)


ROWS: Mapping[str, Callable[[Bench], Row]] = {
    "lsp-overlay": key_press_in_overlay, "lsp-part": key_press_in_part, "lsp-root": key_press_in_root, "lsp-function": key_press_in_function,
    "lsp-first": first_diagnostics,
}  # fmt: skip
