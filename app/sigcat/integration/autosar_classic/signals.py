"""Data elements that travel over a bus, as the deployment says."""

from collections.abc import Sequence

from sigcat import codes
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import Context
from sigcat.integration.autosar_classic.elements import Element
from sigcat.integration.autosar_names import distinct, short_name
from sigcat.names import did_you_mean


def system_signals(
    elements: Sequence[Element], composition: model.Composition, context: Context
) -> tuple[model.SystemSignal, ...]:
    """The system signal of each data element that the deployment names one for. Only what crosses the border has one."""
    known = {key: element for element in elements if element.kind == "data" for key in (element.identity, element.name)}
    ports = {port.interface: port.name for port in composition.ports}
    chosen = {}
    for key, settings in sorted(context.settings.signals.items()):
        element = known.get(key)
        if element is None or element.name not in ports:
            what = "comes from a component of the set" if element else "is not in the set"
            message = f"{key!r}, which the deployment file names under `autosarClassic: signals`, must come from outside or go there: it {what}."
            context.findings.report(codes.DEPLOYMENT_NAMES_NOTHING_CLASSIC, message, key, did_you_mean(key, known))
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
            database=settings.database,
            length=settings.length,
        )
        for name, (element, settings) in chosen.items()
    )
