"""No test sees the settings or releases of the user, and the end of a run lists the skipped tests with their reasons."""

import gc
import os
import signal
import sys
import tempfile
from collections import Counter
from collections.abc import Generator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests import properties, real_parts
from tests.needs import OFFICIAL
from tests.reference_tools import Results, note

OF_THE_RUN = ("SIGCAT_BROWSER", "SIGCAT_FUZZ", "SIGCAT_SLOW")
"""Variables that say how to test."""
IN_BROWSER = "tests/web/in_browser"
_RESULTS = Results()
_FOUND: list[str] = []
_DATA = tempfile.TemporaryDirectory(prefix="sigcat-tests-")


def pytest_addoption(parser: pytest.Parser) -> None:
    """The option of tests/reference_tools.py."""
    parser.addoption("--results", type=Path, metavar="FILE", help="write the results of the reference tools")


def pytest_configure(config: pytest.Config) -> None:
    """Processes that tests start inherit this environment; so do the workers of pytest-xdist."""
    config.addinivalue_line(
        "markers", "reference_tool(name, requirement): checked with a third-party tool; see tests/reference_tools.py"
    )
    config.addinivalue_line(
        "markers", "real: what `make real` runs and `make test` leaves out; see tests/real_parts.py"
    )
    config.addinivalue_line("markers", "property: a property test; `make fuzz` searches with these")
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as a shell has it for what it starts in the background
        signal.signal(signal.SIGINT, signal.default_int_handler)
    os.environ["VSS_RELEASES"] = str(OFFICIAL)
    for name in list(os.environ):
        if name.startswith("SIGCAT_") and name not in OF_THE_RUN:
            del os.environ[name]
    os.environ["SIGCAT_DATA"] = _DATA.name
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # hundreds of processes would compile everything again
    sys.dont_write_bytecode = (
        False  # and each worker would rewrite the assertions of every test, and parse the shipped tree
    )
    properties.load_profile()


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """The tests of a file share services, so one worker runs them all; those that share the browser are one file to it.

    Files with few tests come first: these are the slow ones, and no worker waits for the last of them.
    """
    from xdist.scheduler import LoadFileScheduling  # type: ignore[import-untyped]

    class Scheduling(LoadFileScheduling):  # type: ignore[misc]
        def schedule(self) -> None:
            is_first = self.collection is None
            super().schedule()
            if is_first:
                for scope in reversed(tuple(self.workqueue)):
                    self.workqueue.move_to_end(scope)

        def _split_scope(self, nodeid: str) -> str:
            file: str = super()._split_scope(nodeid)
            return IN_BROWSER if file.startswith(IN_BROWSER) else file

    return Scheduling(config, log)


def pytest_itemcollected(item: pytest.Item) -> None:
    """A test that schemathesis makes of an operation is named after it: workers run one test of each name."""
    if label := getattr(item, "operation_label", None):
        item._id = replace(item.id, params=label)  # it gives its label as a name, of which pytest 9.2 makes no id


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Files without a selected test are not read."""
    return real_parts.has_none(collection_path, config.option.markexpr) or None


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """What is collected stays: the search for garbage in it would take half of the time, and go on in all tests."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(20_000, 20, 20)  # for large heaps: the usual 700 takes a tenth of the time of the tests
        gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_sessionfinish() -> None:
    """The process ends: pytest would search everything for garbage five times, and Python once more."""
    gc.freeze()


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Two tests of one name would be one to pytest-xdist; tests that represent others must exist."""
    for item in items:
        real_parts.note(item)
    properties.prepare(items)
    is_whole = not config.getoption("lf", default=False) and not any("::" in argument for argument in config.args)
    if is_whole and (missing := real_parts.missing(items)):
        raise pytest.UsageError(f"tests/real_parts.py names tests that are not there: {', '.join(missing)}")
    doubled = [name for name, count in Counter(item.nodeid for item in items).items() if count > 1]
    if doubled:
        raise pytest.UsageError(f"Tests must have unique names: {', '.join(doubled)}")


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Add the reference tool of a test to its reports."""
    note(item)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> None:
    """The report of a failed search has the example that failed."""
    if call.excinfo:
        properties.note(item)


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Count the checks of reference tools, and write failures that a search found to the file of examples."""
    _RESULTS.add(report)
    if "PYTEST_XDIST_WORKER" not in os.environ and (line := properties.write(report)):
        _FOUND.append(line)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """Write one line for each missing requirement, and the results of the reference tools into their file."""
    if file := config.getoption("--results"):
        _RESULTS.write(file)
    for line in _FOUND:
        terminalreporter.write_line(line)
    if line := real_parts.left_out(config.option.markexpr):
        terminalreporter.write_line(line)
    reasons = Counter(reason_of(report) for report in terminalreporter.stats.get("skipped", ()))
    for reason, count in sorted(reasons.items()):
        terminalreporter.write_line(f"{count} skipped for want of {reason}")


def reason_of(report: pytest.TestReport) -> str:
    """Why a test was skipped."""
    assert isinstance(report.longrepr, tuple)
    return report.longrepr[2].removeprefix("Skipped: ")
