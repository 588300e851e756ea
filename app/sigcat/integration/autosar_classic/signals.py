"""Data elements that travel over a bus, as the deployment says."""

from collections.abc import Mapping, Sequence

from sigcat import codes
from sigcat.function.document.text import optional
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import Context
from sigcat.integration.autosar_classic.elements import Element
from sigcat.integration.autosar_classic.signal_lengths import needs_of
from sigcat.integration.autosar_names import distinct, short_name
from sigcat.names import did_you_mean

SECTION = ("autosarClassic", "signals")


def _elements_by_name(elements: Sequence[Element]) -> Mapping[str, Element]:
    """Data elements by what the deployment may call them: the path or name of the signal, and the name of the port."""
    return {key: element for element in elements if element.kind == "data" for key in (element.identity, element.name)}


def system_signals(
    elements: Sequence[Element], composition: model.Composition, context: Context
) -> tuple[model.SystemSignal, ...]:
    """The system signal of each data element that the deployment names one for. Only what crosses the border has one."""
    known = _elements_by_name(elements)
    ports = {port.interface: port.name for port in composition.ports}
    outside = [key for key, element in known.items() if element.name in ports]
    chosen = {}
    for key, settings in sorted(context.settings.signals.items()):
        element = known.get(key)
        if element is None or element.name not in ports:
            what = "comes from a component of the set" if element else "is not in the set"
            message = f"{key!r}, which the deployment file names under `autosarClassic: signals`, must come from outside or go there: it {what}."
            fix = "" if element else did_you_mean(key, outside)
            context.findings.report_deployment(
                codes.DEPLOYMENT_NAMES_NOTHING_CLASSIC, message, (*SECTION, key), fix or "Take it away.", key
            )
        else:
            chosen[element.name] = (element, settings)
    wanted = {
        name: short_name(f"{settings.message}_{settings.signal}" if settings.message else settings.signal)
        for name, (_, settings) in chosen.items()
    }
    names = distinct(wanted)
    return tuple(
        model.SystemSignal(
            port=ports[name],
            element=element.leaf,
            signal=names[name],
            message=settings.message,
            database=optional(settings.database),
            length=settings.length,
        )
        for name, (element, settings) in chosen.items()
    )


def report_narrow_signals(elements: Sequence[Element], integration: model.ClassicIntegration, context: Context) -> None:
    """Signals of buses that are too short for values that their data elements have."""
    needs, known = needs_of(integration), _elements_by_name(elements)
    for key, settings in context.settings.signals.items():
        element = known.get(key)
        need = needs.get((element.name, element.leaf)) if element else None
        if need is not None and not need.fits(settings.length, has_database=settings.database is not None):
            message = f"{settings.signal} must have at least {need.bits} bits for every value of {key}, not {settings.length}."
            pointer = (*SECTION, key, "length")
            context.findings.report_deployment(codes.SIGNAL_TOO_SHORT, message, pointer, need.advice, key)
