"""A CAN bus in Integration JSON for FMI: the messages of an FMU, and how their signals become variables."""

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from sigcat.catalogue.network.formula import BadFormula, read_formula
from sigcat.function.document.field_types import CIdentifier, Grammar
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import Integer, Listed, Number, WireModel, always, own

MOST_BYTES = 64
"""Bytes of a message: those of CAN FD."""
MOST_BITS = 52
"""Bits of a whole number: a double holds all of their values."""
REAL_BITS = (32, 64)
_LARGEST_IDENTIFIER = 2**29 - 1


def _is_formula(text: str) -> bool:
    try:
        read_formula(text)
    except BadFormula:
        return False
    return True


FORMULA = Grammar("a formula of x", _is_formula)
Formula = Annotated[str, FORMULA]
Unsigned = Annotated[Integer, Field(ge=0, le=2**64 - 1)]
Index = Annotated[Integer, Field(ge=0, le=2**32 - 1)]


class BusValue(WireModel):
    """A number that is converted separately."""

    given: Number = always(
        "Given", "The number: as it is transmitted, or of one that is sent the value of the variable."
    )
    meant: Number | None = own("Meant", "What it becomes; absent if it is not a value.")


class BusMapping(WireModel):
    """A variable that a signal of a message is received as, or sent from."""

    reference: Index = always("ValueReference", "Variable.")
    direction: Literal["received", "sent"] = always("Direction", "Whether the FMU receives or sends the signal.")
    interval: Unsigned = always("ShortestInterval", "Shortest time between two values.", unit="ns")
    counts_attempts: bool = always(
        "CountsAttempts",
        "Whether the interval also begins with a value that is not handed over, as in the KUKSA CAN provider.",
    )
    on_change: bool = always("OnChange", "Whether only changes are handed over.")
    formula: Formula | None = own("Formula", "Formula of the number x.")
    values: Listed[BusValue] = always("ConvertedValues", "Numbers that are converted separately.")
    is_listed: bool = always("OnlyConvertedValues", "Whether other numbers are not values.")
    allowed: Listed[Number] = always("AllowedNumbers", "Valid values of the variable; empty if all are.")


class BusSelector(WireModel):
    """A multiplexer, and its numbers that select a signal."""

    signal: Index = always("MultiplexerIndex", "Index of the multiplexer in the message.")
    numbers: Annotated[Listed[Unsigned], Field(min_length=1)] = always("SelectingNumbers", "Its numbers.")


class BusSignal(WireModel):
    """A signal of a message."""

    name: Text = always("Name", "Name in the CAN database.")
    start: Index = always("StartBit", "Its first bit, as a DBC numbers them.")
    length: Annotated[Integer, Field(ge=1, le=64)] = always("BitLength", "Its bits.")
    order: Literal["littleEndian", "bigEndian"] = always("BitOrder", "Byte order.")
    encoding: Literal["unsigned", "signed", "real"] = always("NumberEncoding", "What its bits are.")
    factor: Number = always("NumberFactor", "From its number to that of its unit.")
    offset: Number = always("NumberOffset", "Added after the factor.")
    min: Number | None = own("Min", "Smallest valid number in its unit.")
    max: Number | None = own("Max", "Largest valid number in its unit.")
    initial: Unsigned = always("InitialBits", "Its bits before a value is sent.")
    selectors: Listed[BusSelector] = always("Multiplexers", "Multiplexers that select it, its own last.")
    mappings: Listed[BusMapping] = always("VariableMappings", "Variables of it.")

    @property
    def first(self) -> int:
        """Its first bit: of big endian the highest, where bits are counted from the highest one of the first byte."""
        return self.start if self.order == "littleEndian" else self.start // 8 * 8 + 7 - self.start % 8

    @property
    def size(self) -> int:
        """Bytes that a frame must have to hold it."""
        return -(-(self.first + self.length) // 8)


class BusMessage(WireModel):
    """A message of the bus."""

    name: Text = always("Name", "Name in the CAN database.")
    identifier: Annotated[Integer, Field(ge=0, le=_LARGEST_IDENTIFIER)] = always("CanIdentifier", "Its identifier.")
    is_extended: bool = always("IsExtended", "Whether the identifier has 29 bits.")
    is_fd: bool = always("IsCanFd", "Whether it is a frame of CAN FD.")
    length: Annotated[Integer, Field(ge=0, le=MOST_BYTES)] = always("DataBytes", "Bytes of its data.")
    signals: Listed[BusSignal] = always("MessageSignals", "Its signals.")


class FmuBus(WireModel):
    """A CAN bus of an FMU, by FMI-LS-BUS 1.0."""

    name: CIdentifier = always("Name", "Name of the bus and of its terminal.")
    is_replacing: bool = always("ReplacesVariables", "Whether the variables that it carries are only on the bus.")
    messages: Annotated[Listed[BusMessage], Field(min_length=1)] = always(
        "BusMessages", "Messages that the FMU receives or sends."
    )

    @property
    def mappings(self) -> Iterator[BusMapping]:
        """All mappings of all messages."""
        return (each for message in self.messages for signal in message.signals for each in signal.mappings)

    @property
    def hidden(self) -> frozenset[int]:
        """Value references of the variables that are only on the bus."""
        return frozenset(each.reference for each in self.mappings) if self.is_replacing else frozenset()
