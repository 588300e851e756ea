"""Integration JSON for FMI from anywhere: the model, or everything that is wrong with it."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.function.document.document import Pointer
from sigcat.integration.checked_document import DocumentKind
from sigcat.integration.fmi.bus import MOST_BITS, REAL_BITS, BusMapping, BusMessage, BusSignal
from sigcat.integration.fmi.model import FmiIntegration, Fmu
from sigcat.integration.problem import Problem
from sigcat.integration.references import places


def _problems(model: FmiIntegration) -> Iterator[Problem]:
    """Everything that a modelDescription.xml cannot have."""
    names = [each.name.lower() for each in model.fmus]
    for index, fmu in enumerate(model.fmus):
        if names.index(fmu.name.lower()) < index:
            yield Problem(("FmuList", index, "Name"), f"Each FMU must have its own name, and {fmu.name} is used twice.")
        yield from _variables(fmu, index)
        if fmu.bus is not None:
            yield from _bus(model, fmu, index)


def _variables(fmu: Fmu, index: int) -> Iterator[Problem]:
    seen: set[str] = set()
    for number, variable in enumerate(fmu.variables):
        at = ("FmuList", index, "VariableList", number)
        if variable.name in seen:
            message = f"Each variable must have its own name, and {variable.name} is used twice."
            yield Problem((*at, "Name"), message, "Rename one of the two.")
        seen.add(variable.name)
        if variable.reference != number:
            message = f"ValueReference must be the index of the variable, {number}, not {variable.reference}."
            yield Problem((*at, "ValueReference"), message, "Integrate the functions again.")


def _bus(model: FmiIntegration, fmu: Fmu, index: int) -> Iterator[Problem]:
    assert fmu.bus is not None
    at = ("FmuList", index, "CanBus")
    if model.version is not None or model.interface is not None:
        refusal = f"{fmu.name} must be an FMU of FMI 3.0 for co-simulation, as it has a bus."
        yield Problem(at, refusal, "Remove the bus.")
    if next(fmu.bus.mappings, None) is None:
        yield Problem(at, "The bus must have a signal with a variable.", "Remove the bus.")
    for below, message in places(fmu.bus, "BusMessages/*", at):
        for place, signal in places(message, "MessageSignals/*", below):
            yield from _signal(message, signal, place)
            for here, mapping in places(signal, "VariableMappings/*", place):
                yield from _mapping(fmu, signal, mapping, here)


def _signal(message: BusMessage, signal: BusSignal, at: Pointer) -> Iterator[Problem]:
    """Everything that the tables of a bus cannot have."""
    fix = "Integrate the functions again."
    if signal.size > message.length:
        yield Problem((*at, "StartBit"), f"The signal must be within the {message.length} bytes of its message.", fix)
    if signal.factor == 0:
        yield Problem((*at, "NumberFactor"), "The factor must not be 0.", fix)
    if signal.encoding == "real" and signal.length not in REAL_BITS:
        yield Problem((*at, "BitLength"), "A real number must have 32 or 64 bits.", fix)
    if signal.encoding != "real" and signal.length > MOST_BITS and signal.mappings:
        yield Problem((*at, "BitLength"), f"A whole number with a variable must have at most {MOST_BITS} bits.", fix)
    for index, selector in enumerate(signal.selectors):
        if selector.signal >= len(message.signals):
            text = "A multiplexer must be a signal of the message, by its index."
            yield Problem((*at, "Multiplexers", index), text, fix)


def _mapping(fmu: Fmu, signal: BusSignal, mapping: BusMapping, at: Pointer) -> Iterator[Problem]:
    fix = "Integrate the functions again."
    variable = fmu.variables[mapping.reference] if mapping.reference < len(fmu.variables) else None
    wanted = "input" if mapping.direction == "received" else "output"
    if variable is None or variable.causality != wanted or variable.length is not None:
        yield Problem((*at, "ValueReference"), f"What is {mapping.direction} must be one number, an {wanted}.", fix)
    if mapping.direction == "sent" and signal.encoding != "real":
        for index, each in enumerate(mapping.values):
            low = -(2 ** (signal.length - 1)) if signal.encoding == "signed" else 0
            if each.meant is not None and not low <= each.meant < low + 2**signal.length:
                yield Problem((*at, "ConvertedValues", index), "The number must fit the bits of the signal.", fix)


read_integration = DocumentKind("fmi", FmiIntegration, codes.NOT_WRITABLE_AS_FMU, _problems).read
"""The model of a document. Raises InputRefused with every finding."""
