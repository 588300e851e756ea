"""Windows of the end-to-end state machine of a required port, and settings for data that no function protects."""

from collections.abc import Sequence

from sigcat import codes
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import Context
from sigcat.integration.autosar_classic.deployment.e2e_settings import E2eSettings, ElementE2eSettings, WindowSettings
from sigcat.integration.autosar_classic.elements import Element
from sigcat.names import did_you_mean


def windows_of(element: Element, settings: E2eSettings) -> model.E2eWindows:
    """The windows of a data element."""
    stated = settings.elements
    own = stated.get(element.identity) or stated.get(element.name) or ElementE2eSettings.model_validate({})
    return model.E2eWindows(
        init=_window(own.init or settings.init),
        valid=_window(own.valid or settings.valid),
        invalid=_window(own.invalid or settings.invalid),
    )


def _window(settings: WindowSettings) -> model.E2eWindow:
    return model.E2eWindow(size=settings.window_size, min_ok=settings.min_ok_state, max_error=settings.max_error_state)


def report_unknown_elements(elements: Sequence[Element], context: Context) -> None:
    """Keys of `elements` that name no protected data."""
    known = {key for element in elements if element.is_checked for key in (element.identity, element.name)}
    for key in sorted(context.settings.e2e.elements.keys() - known):
        message = f"{key!r}, which the deployment file names under `autosarClassic: e2e: elements`, must be consumed with an `e2eError`."
        fix = did_you_mean(key, sorted(known)) or "Remove it, or name an `e2eError` in the function."
        pointer = ("autosarClassic", "e2e", "elements", key)
        context.findings.report_deployment(codes.DEPLOYMENT_NAMES_NOTHING_CLASSIC, message, pointer, fix, key)
