"""The functions that the RTE has for a component: which ones, its ports and the accesses of its runnables say."""

from collections.abc import Iterator
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.component.methods import argument
from sigcat.adapter.autosar_classic.code.plan import RteType, SwcPlan
from sigcat.adapter.autosar_classic.code.rte_types import type_of
from sigcat.integration.autosar_classic.model import (
    Access,
    ClassicIntegration,
    ClientServerInterface,
    Element,
    Port,
    Runnable,
)


class Parameter(NamedTuple):
    """An argument of a function."""

    declaration: str
    name: str


class Call(NamedTuple):
    """A function of the RTE."""

    kind: str
    """`Read`, `IsUpdated`, `IRead` and so on."""
    result: str
    parameters: tuple[Parameter, ...]
    port: str = ""
    element: str = ""
    runnable: str = ""

    @property
    def name(self) -> str:
        """The name by which runnables call it: `Rte_Read_<port>_<element>`."""
        return self.own_name("")

    def own_name(self, swc: str) -> str:
        """The name of the function itself, which has the component in it (SWS_Rte, API mapping)."""
        return "_".join(filter(None, ("Rte", self.kind, swc, self.runnable, self.port, self.element)))

    def head(self, swc: str) -> str:
        """Its prototype, without a semicolon."""
        known = ", ".join(each.declaration for each in self.parameters) or "void"
        space = "" if self.result.endswith("*") else " "
        return f"{self.result}{space}{self.own_name(swc)}({known})"


class Apis:
    """All of them, each once, in the order of the runnables."""

    def __init__(self, swc: SwcPlan, model: ClassicIntegration, types: dict[str, RteType]) -> None:
        self.swc, self.model, self.types = swc, model, types
        self.ports = {port.name: port for port in swc.component.ports}
        self.services = {each.name: each for each in model.client_server_interfaces}
        self.groups = {each.name: each.group for each in model.mode_switch_interfaces}
        self.data = {
            **{(one.name, each.name): each.type for one in model.sender_receiver_interfaces for each in one.elements},
            **{(one.name, each.name): each.type for one in model.parameter_interfaces for each in one.elements},
        }

    def all(self) -> tuple[Call, ...]:
        found: dict[str, Call] = {}
        for runnable in self.swc.component.runnables:
            for access in runnable.accesses:
                found.update((each.name, each) for each in self._of(access, runnable))
        found.update((each.name, each) for each in self._own())
        return tuple(found.values())

    def _own(self) -> Iterator[Call]:
        """Calls of the RTE within the component."""
        component = self.swc.component
        for area in component.exclusive_areas:
            yield Call("Enter", "void", (), element=area.name)
            yield Call("Exit", "void", (), element=area.name)
        for memory in component.memories:
            yield Call("Pim", f"Rte_PimType_{component.name}_{memory.type} *", (), element=memory.name)
        for each in component.parameters:
            yield Call("CData", _returned(self._type(each.type)), (), element=each.name)

    def _of(self, access: Access, runnable: Runnable) -> Iterator[Call]:
        port = access.port or ""
        if access.kind == "InternalTrigger":
            yield Call("IrTrigger", "void", (), element=access.name, runnable=runnable.name)
        elif access.kind in ("Mode", "ModeSwitch"):
            type_ = f"Rte_ModeType_{self.groups[self.ports[port].interface]}"
            if access.kind == "Mode":
                yield Call("Mode", type_, (), port, access.element)
            else:
                mode = (Parameter(f"{type_} mode", "mode"),)
                yield Call("Switch", "Std_ReturnType", mode, port, access.element)
        elif access.kind in ("SynchronousCall", "AsynchronousCall", "Result"):
            yield self._operation(access, self.ports[port])
        elif access.kind == "ImplicitRead":
            yield from self._implicit(access, runnable)
        else:
            yield from self._data(access, self.ports[port])

    def _type(self, name: str) -> RteType:
        return type_of(name, self.model, self.types)

    def _data(self, access: Access, port: Port) -> Iterator[Call]:
        type_, ends = self._type(self.data[port.interface, access.element]), (port.name, access.element)
        filled = (Parameter(argument(type_, "data", is_out=True), "data"), *_transformer_error(port))
        given = (Parameter(argument(type_, "data", is_out=False), "data"),)
        if access.kind == "Parameter":
            yield Call("Prm", _returned(type_), (), *ends)
        elif access.kind == "QueuedReceive":
            yield Call("Receive", "Std_ReturnType", filled, *ends)
        elif access.kind in ("QueuedSend", "ExplicitWrite"):
            yield Call("Send" if access.kind == "QueuedSend" else "Write", "Std_ReturnType", given, *ends)
        else:
            yield Call("Read", "Std_ReturnType", filled, *ends)
            if _element(port, access).update:
                yield Call("IsUpdated", "boolean", (), *ends)

    def _implicit(self, access: Access, runnable: Runnable) -> Iterator[Call]:
        port = self.ports[access.port or ""]
        type_, ends = self._type(self.data[port.interface, access.element]), (port.name, access.element, runnable.name)
        yield Call("IRead", _returned(type_), (), *ends)
        if _element(port, access).never_received:
            yield Call("IStatus", "Std_ReturnType", (), *ends)

    def _operation(self, access: Access, port: Port) -> Call:
        interface: ClientServerInterface = self.services[port.interface]
        operation = next(each for each in interface.operations if each.name == access.element)
        wanted = {"SynchronousCall": ("IN", "INOUT", "OUT"), "AsynchronousCall": ("IN", "INOUT"), "Result": ("OUT",)}
        parameters = tuple(
            Parameter(argument(self._type(each.type), each.name, is_out=each.direction != "IN"), each.name)
            for each in operation.arguments if each.direction in wanted[access.kind]
        )  # fmt: skip
        kind = "Result" if access.kind == "Result" else "Call"
        return Call(kind, "Std_ReturnType", parameters, port.name, access.element)


def _element(port: Port, access: Access) -> Element:
    return next(each for each in port.elements if each.name == access.element)


def _transformer_error(port: Port) -> Iterator[Parameter]:
    """The argument that PORT-API-OPTION adds to the functions that read a port (SWS_Rte, error handling of transformers)."""
    if port.reports_transformer_errors:
        yield Parameter("Std_TransformerError *transformerError", "transformerError")


def _returned(type_: RteType) -> str:
    """Numbers as they are, what is large by its address."""
    return type_.name if type_.is_number else f"const {type_.pointed} *"
