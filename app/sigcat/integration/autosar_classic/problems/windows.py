"""Windows of the end-to-end state machine that AUTOSAR, or a release of it, does not have."""

from collections.abc import Iterator

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.deployment.releases import RELEASES_WITH_ONE_WINDOW
from sigcat.integration.autosar_classic.model import ClassicIntegration, E2eWindow, E2eWindows
from sigcat.integration.problem import Problem
from sigcat.integration.references import places


def window_problems(model: ClassicIntegration, release: str) -> Iterator[Problem]:
    """Problems of the windows of all ports, for a release."""
    for at, windows in places(model, "Components/*/Ports/*/Elements/*/E2eWindows"):
        yield from _of_windows(windows, at, release)


def _of_windows(windows: E2eWindows, at: Pointer, release: str) -> Iterator[Problem]:
    for state, window in (("Init", windows.init), ("Valid", windows.valid), ("Invalid", windows.invalid)):
        yield from _of_window(window, (*at, state))
    if release in RELEASES_WITH_ONE_WINDOW and len(windows.sizes) > 1:
        message = f"Release {release} has one window for all states, and these have {len(windows.sizes)} sizes."
        yield Problem(at, message, "Give all states the same `windowSize`, or generate a later release.")


def _of_window(window: E2eWindow, at: Pointer) -> Iterator[Problem]:
    for key, number in (("MinOkState", window.min_ok), ("MaxErrorState", window.max_error)):
        if number > window.size:
            message = f"{key} must be at most the window size, {window.size}, not {number}."
            yield Problem((*at, key), message, "Correct the number, or the window size.")
