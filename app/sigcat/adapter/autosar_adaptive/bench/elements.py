"""What a reader of a proxy or a skeleton should know of its events, fields and methods."""

from sigcat.adapter.autosar_adaptive.bench.common import told
from sigcat.function.document.text import Text, sentence
from sigcat.integration.autosar_adaptive.model import Event, Method, ServiceField


def about_event(event: Event) -> Text:
    """Path, unit and cycle of an event."""
    cycle = f"every {event.cycle_time:g} ms" if event.cycle_time else None
    return sentence(event.vss_path or event.description or event.name, event.unit, cycle)


def about_field(field: ServiceField) -> Text:
    """Path of a field, or what it means."""
    return sentence(field.vss_path or field.description or field.name)


def about_method(method: Method) -> Text:
    """What a method does, and the units of its arguments."""
    units = (told(each) for each in (*(method.inputs or ()), *(method.outputs or ())))
    return sentence(method.description or method.name, *units)
