"""The tree of 100,000 signals in a real browser, beside what the browser needs to fetch and parse the same rows."""

import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from statistics import median
from time import perf_counter

from bench import trees
from bench.measuring import ROOT
from bench.rows import HUNDRED_THOUSAND, Bench, Row

_SERVE = """
import sys
from pathlib import Path
from sigcat.api.server import run
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library, Source
from sigcat.web.site import create_site
settings = Settings(port=0, log="none")
run(create_site(Library([Source("big", "big", Path(sys.argv[1]))]), settings), settings)
"""
_FETCH = "async () => { await (await fetch('/rows/big?path=&depth=1000', { cache: 'no-store' })).json(); }"
_TO_THE_END = "view => { view.scrollTop = view.scrollHeight; }"


def expand_all(bench: Bench) -> Row:
    """From the address with every branch open to rows in sight, then to the last row."""
    path = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if path is None:
        return Row("browser: 100,000 signals, all open", "", "no Chromium found", "", "", is_met=False)
    from playwright.sync_api import sync_playwright

    shown, fetched, most = [], [], 0
    tree = trees.flat(bench.folder / "browser", HUNDRED_THOUSAND)
    with _service(tree) as address, sync_playwright() as playwright:
        page = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"]).new_page()
        for _ in range(bench.runs):
            page.goto("about:blank")
            start = perf_counter()
            page.goto(f"{address}/tree/big?open=*")
            page.wait_for_selector("[role=treeitem]")
            shown.append(perf_counter() - start)
            page.locator("[data-tree] .rows").evaluate(_TO_THE_END)
            page.wait_for_selector("[role=treeitem]:last-child")
            most = max(most, page.locator("[role=treeitem]").count())
            start = perf_counter()
            page.evaluate(_FETCH)
            fetched.append(perf_counter() - start)
    figure, reference = median(shown), median(fetched)
    return Row(
        f"browser: 100,000 signals, all open, to the first row; {most} rows in the document",
        f"{figure * 1000:.0f} ms", f"fetch and parse the rows: {reference * 1000:.0f} ms",
        f"{figure / reference:.2f} ×", "at most 100 rows", most <= 100,
    )  # fmt: skip


ROWS: Mapping[str, Callable[[Bench], Row]] = {"browser": expand_all}


@contextmanager
def _service(tree: Path) -> Iterator[str]:
    command = [sys.executable, "-c", _SERVE, str(tree)]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        match = re.search(r"http://\S+", process.stdout.readline())
        if match is None:
            sys.exit("The service did not start.")
        try:
            yield match.group()
        finally:
            process.terminate()
