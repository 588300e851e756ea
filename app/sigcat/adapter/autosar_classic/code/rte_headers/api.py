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

    name: str
    """As runnables call it: `Rte_Read_<port>_<element>`."""
    result: str
    parameters: tuple[Parameter, ...]
    kind: str
    """`Read`, `IsUpdated`, `IRead` and so on."""
    port: str = ""
    element: str = ""
    runnable: str = ""

    def own_name(self, swc: str) -> str:
        """The name of the function itself, which has the component in it (SWS_Rte, API mapping)."""
        return self.name.replace(f"Rte_{self.kind}", f"Rte_{self.kind}_{swc}", 1)

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
            yield Call(f"Rte_Enter_{area.name}", "void", (), "Enter", element=area.name)
            yield Call(f"Rte_Exit_{area.name}", "void", (), "Exit", element=area.name)
        for memory in component.memories:
            yield Call(
                f"Rte_Pim_{memory.name}",
                f"Rte_PimType_{component.name}_{memory.type} *",
                (),
                "Pim",
                element=memory.name,
            )
        for each in component.parameters:
            yield Call(f"Rte_CData_{each.name}", _returned(self._type(each.type)), (), "CData", element=each.name)

    def _of(self, access: Access, runnable: Runnable) -> Iterator[Call]:
        port, name = access.port or "", f"{access.port}_{access.element}"
        if access.kind == "InternalTrigger":
            trigger = f"Rte_IrTrigger_{runnable.name}_{access.name}"
            yield Call(trigger, "void", (), "IrTrigger", element=access.name, runnable=runnable.name)
        elif access.kind in ("Mode", "ModeSwitch"):
            type_ = f"Rte_ModeType_{self.groups[self.ports[port].interface]}"
            if access.kind == "Mode":
                yield Call(f"Rte_Mode_{name}", type_, (), "Mode", port, access.element)
            else:
                mode = (Parameter(f"{type_} mode", "mode"),)
                yield Call(f"Rte_Switch_{name}", "Std_ReturnType", mode, "Switch", port, access.element)
        elif access.kind in ("SynchronousCall", "AsynchronousCall", "Result"):
            yield self._operation(access, self.ports[port])
        elif access.kind == "ImplicitRead":
            yield from self._implicit(access, runnable)
        else:
            yield from self._data(access, self.ports[port])

    def _type(self, name: str) -> RteType:
        return type_of(name, self.model, self.types)

    def _data(self, access: Access, port: Port) -> Iterator[Call]:
        type_, name = self._type(self.data[port.interface, access.element]), f"{port.name}_{access.element}"
        ends = (port.name, access.element)
        filled = (Parameter(argument(type_, "data", is_out=True), "data"), *_transformer_error(port))
        given = (Parameter(argument(type_, "data", is_out=False), "data"),)
        if access.kind == "Parameter":
            yield Call(f"Rte_Prm_{name}", _returned(type_), (), "Prm", *ends)
        elif access.kind == "QueuedReceive":
            yield Call(f"Rte_Receive_{name}", "Std_ReturnType", filled, "Receive", *ends)
        elif access.kind == "QueuedSend":
            yield Call(f"Rte_Send_{name}", "Std_ReturnType", given, "Send", *ends)
        elif access.kind == "ExplicitWrite":
            yield Call(f"Rte_Write_{name}", "Std_ReturnType", given, "Write", *ends)
        else:
            yield Call(f"Rte_Read_{name}", "Std_ReturnType", filled, "Read", *ends)
            if _element(port, access).update:
                yield Call(f"Rte_IsUpdated_{name}", "boolean", (), "IsUpdated", *ends)

    def _implicit(self, access: Access, runnable: Runnable) -> Iterator[Call]:
        port = self.ports[access.port or ""]
        type_ = self._type(self.data[port.interface, access.element])
        name = f"{runnable.name}_{port.name}_{access.element}"
        yield Call(f"Rte_IRead_{name}", _returned(type_), (), "IRead", port.name, access.element, runnable.name)
        if _element(port, access).never_received:
            yield Call(f"Rte_IStatus_{name}", "Std_ReturnType", (), "IStatus", port.name, access.element, runnable.name)

    def _operation(self, access: Access, port: Port) -> Call:
        interface: ClientServerInterface = self.services[port.interface]
        operation = next(each for each in interface.operations if each.name == access.element)
        wanted = {"SynchronousCall": ("IN", "INOUT", "OUT"), "AsynchronousCall": ("IN", "INOUT"), "Result": ("OUT",)}
        parameters = tuple(
            Parameter(argument(self._type(each.type), each.name, is_out=each.direction != "IN"), each.name)
            for each in operation.arguments if each.direction in wanted[access.kind]
        )  # fmt: skip
        kind = "Result" if access.kind == "Result" else "Call"
        name = f"Rte_{kind}_{port.name}_{access.element}"
        return Call(name, "Std_ReturnType", parameters, kind, port.name, access.element)


def _element(port: Port, access: Access) -> Element:
    return next(each for each in port.elements if each.name == access.element)


def _transformer_error(port: Port) -> Iterator[Parameter]:
    """The argument that PORT-API-OPTION adds to the functions that read a port (SWS_Rte, error handling of transformers)."""
    if port.reports_transformer_errors:
        yield Parameter("Std_TransformerError *transformerError", "transformerError")


def _returned(type_: RteType) -> str:
    """Numbers as they are, what is large by its address."""
    if type_.element is not None:
        return f"const {type_.element.name} *"
    return f"const {type_.name} *" if type_.members else type_.name
