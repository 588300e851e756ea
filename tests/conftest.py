"""No test sees the settings or releases of who runs it, and a run says at its end what was skipped for want of what."""

import os
import tempfile
from collections import Counter

import pytest

from tests.needs import OFFICIAL

OF_THE_RUN = ("SIGCAT_BROWSER", "SIGCAT_FUZZ", "SIGCAT_SLOW")
"""Variables that say how to test."""
_DATA = tempfile.TemporaryDirectory(prefix="sigcat-tests-")


def pytest_configure() -> None:
    """Processes that tests start inherit this environment; so do the workers of pytest-xdist."""
    os.environ["VSS_RELEASES"] = str(OFFICIAL)
    for name in list(os.environ):
        if name.startswith("SIGCAT_") and name not in OF_THE_RUN:
            del os.environ[name]
    os.environ["SIGCAT_DATA"] = _DATA.name


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """One line for each thing that was missing."""
    reasons = Counter(reason_of(report) for report in terminalreporter.stats.get("skipped", ()))
    for reason, count in sorted(reasons.items()):
        terminalreporter.write_line(f"{count} skipped for want of {reason}")


def reason_of(report: pytest.TestReport) -> str:
    """Why a test was skipped."""
    assert isinstance(report.longrepr, tuple)
    return report.longrepr[2].removeprefix("Skipped: ")
