"""No test sees the settings or releases of who runs it, and a run says at its end what was skipped for want of what."""

import os
import signal
import tempfile
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import hypothesis
import pytest

from tests import real_parts
from tests.judges import Verdicts, note
from tests.needs import OFFICIAL

OF_THE_RUN = ("SIGCAT_BROWSER", "SIGCAT_FUZZ", "SIGCAT_SLOW")
"""Variables that say how to test."""
IN_BROWSER = "tests/web/in_browser"
_VERDICTS = Verdicts()
_DATA = tempfile.TemporaryDirectory(prefix="sigcat-tests-")


def pytest_addoption(parser: pytest.Parser) -> None:
    """The option of tests/judges.py."""
    parser.addoption("--verdicts", type=Path, metavar="FILE", help="write what the judges of other projects said")


def pytest_configure(config: pytest.Config) -> None:
    """Processes that tests start inherit this environment; so do the workers of pytest-xdist."""
    config.addinivalue_line("markers", "judge(name, question): somebody else's judgement; see tests/judges.py")
    config.addinivalue_line(
        "markers", "real: what `make real` runs and `make test` leaves out; see tests/real_parts.py"
    )
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as a shell has it for what it starts in the background
        signal.signal(signal.SIGINT, signal.default_int_handler)
    os.environ["VSS_RELEASES"] = str(OFFICIAL)
    for name in list(os.environ):
        if name.startswith("SIGCAT_") and name not in OF_THE_RUN:
            del os.environ[name]
    os.environ["SIGCAT_DATA"] = _DATA.name
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # hundreds of processes would compile everything again
    hypothesis.settings.register_profile("untimed", deadline=None)  # how long an example takes is the machine's load
    hypothesis.settings.load_profile("untimed")


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """The tests of a file share services, so one worker runs them all; those that share the browser are one file to it."""
    from xdist.scheduler import LoadFileScheduling  # type: ignore[import-untyped]

    class Scheduling(LoadFileScheduling):  # type: ignore[misc]
        def _split_scope(self, nodeid: str) -> str:
            file: str = super()._split_scope(nodeid)
            return IN_BROWSER if file.startswith(IN_BROWSER) else file

    return Scheduling(config, log)


def pytest_itemcollected(item: pytest.Item) -> None:
    """A test that schemathesis makes of an operation is named after it: workers run one test of each name."""
    if label := getattr(item, "operation_label", None):
        item._id = replace(item.id, params=label)  # it gives its label as a name, of which pytest 9.2 makes no id


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Files without a test that is wanted are not read."""
    return real_parts.has_none(collection_path, config.option.markexpr) or None


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Two tests of one name would be one to pytest-xdist; who stands for others must be there."""
    for item in items:
        real_parts.note(item)
    is_whole = not config.getoption("lf", default=False) and not any("::" in argument for argument in config.args)
    if is_whole and (missing := real_parts.missing(items)):
        raise pytest.UsageError(f"tests/real_parts.py names tests that are not there: {', '.join(missing)}")
    doubled = [name for name, count in Counter(item.nodeid for item in items).items() if count > 1]
    if doubled:
        raise pytest.UsageError(f"Tests must have names of their own: {', '.join(doubled)}")


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Its reports say who judges it."""
    note(item)


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Judgements are counted."""
    _VERDICTS.add(report)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """One line for each thing that was missing; what the judges said goes into the file that was named."""
    if file := config.getoption("--verdicts"):
        _VERDICTS.write(file)
    if line := real_parts.left_out(config.option.markexpr):
        terminalreporter.write_line(line)
    reasons = Counter(reason_of(report) for report in terminalreporter.stats.get("skipped", ()))
    for reason, count in sorted(reasons.items()):
        terminalreporter.write_line(f"{count} skipped for want of {reason}")


def reason_of(report: pytest.TestReport) -> str:
    """Why a test was skipped."""
    assert isinstance(report.longrepr, tuple)
    return report.longrepr[2].removeprefix("Skipped: ")
