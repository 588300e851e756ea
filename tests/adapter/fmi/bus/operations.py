"""Operations of FMI-LS-BUS for CAN as bytes, and an importer of FMUs with a bus, over FMPy's functions of FMI 3.0."""

import struct
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

FORMAT_ERROR, CAN, CAN_FD = 0x01, 0x10, 0x11


class Operation(NamedTuple):
    """An operation; of one that transmits a frame, its identifier and data."""

    code: int
    arguments: bytes

    @property
    def frame(self) -> tuple[int, bool, bytes]:
        """Identifier, whether it has 29 bits, and data."""
        identifier, is_extended = struct.unpack_from("<IB", self.arguments)
        fixed = {CAN: 8, CAN_FD: 9}[self.code]
        (length,) = struct.unpack_from("<H", self.arguments, fixed - 2)
        assert len(self.arguments) == fixed + length
        return identifier, bool(is_extended), self.arguments[fixed:]


def operation(code: int, arguments: bytes) -> bytes:
    return struct.pack("<II", code, 8 + len(arguments)) + arguments


def transmit(identifier: int, data: bytes, *, is_extended: bool = False, is_fd: bool = False) -> bytes:
    if is_fd:
        return operation(CAN_FD, struct.pack("<IBBBH", identifier, is_extended, 0, 0, len(data)) + data)
    return operation(CAN, struct.pack("<IBBH", identifier, is_extended, 0, len(data)) + data)


def operations(data: bytes) -> Iterator[Operation]:
    while data:
        code, length = struct.unpack_from("<II", data)
        assert 8 <= length <= len(data)
        yield Operation(code, data[8:length])
        data = data[length:]


class Instance:
    """An FMU in event mode, by the names of its variables."""

    def __init__(self, file: Path, *, has_events: bool = True) -> None:
        import fmpy
        from fmpy.fmi3 import FMU3Slave

        self.description = fmpy.read_model_description(str(file))
        self.variables = {each.name: each for each in self.description.modelVariables}
        self.fmu = FMU3Slave(
            guid=self.description.instantiationToken, modelIdentifier=self.description.coSimulation.modelIdentifier,
            unzipDirectory=fmpy.extract(str(file)), instanceName="tested",
        )  # fmt: skip
        self.fmu.instantiate(eventModeUsed=has_events)
        self.fmu.enterInitializationMode(startTime=0.0)
        self.fmu.exitInitializationMode()
        self.now = 0.0

    def reference(self, name: str) -> int:
        return int(self.variables[name].valueReference)

    def bus(self, member: str) -> int:
        return next(int(e.valueReference) for name, e in self.variables.items() if name.endswith(f".{member}"))

    def get(self, name: str) -> Any:
        kind = {"Enumeration": "Int64"}.get(self.variables[name].type, self.variables[name].type)
        return getattr(self.fmu, f"get{kind}")([self.reference(name)])[0]

    def set(self, name: str, value: Any) -> None:
        kind = {"Enumeration": "Int64"}.get(self.variables[name].type, self.variables[name].type)
        getattr(self.fmu, f"set{kind}")([self.reference(name)], [value])

    def take(self) -> bytes:
        """Operations that it sends now."""
        if not self.fmu.getClock([self.bus("Tx_Clock")])[0]:
            return b""
        return bytes(self.fmu.getBinary([self.bus("Tx_Data")])[0])

    def give(self, data: bytes) -> None:
        """Operations that it receives now."""
        if data:
            self.fmu.setClock([self.bus("Rx_Clock")], [True])
            self.fmu.setBinary([self.bus("Rx_Data")], [data])

    def update(self) -> bool:
        return bool(self.fmu.updateDiscreteStates()[0])

    def step(self, to: float) -> bool:
        needs_event, *_ = self.fmu.doStep(currentCommunicationPoint=self.now, communicationStepSize=to - self.now)
        self.now = to
        return bool(needs_event)

    def settle(self, data: bytes = b"") -> bytes:
        """An event, with operations that are received in it: those that are sent in all of its iterations."""
        sent = self.take()
        self.give(data)
        while self.update():
            sent += self.take()
        self.fmu.enterStepMode()
        return sent

    def close(self) -> None:
        self.fmu.terminate()
        self.fmu.freeInstance()


def settle_together(instances: Sequence[Instance]) -> None:
    """An event of two FMUs that are connected by their terminals."""
    first, second = instances
    is_needed = True
    while is_needed:
        sent = [each.take() for each in instances]
        first.give(sent[1])
        second.give(sent[0])
        needed = [each.update() for each in instances]
        is_needed = any(needed)
    for each in instances:
        each.fmu.enterStepMode()
