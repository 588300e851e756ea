"""Ports of components and of the composition, with the attributes of each element."""

from collections.abc import Iterable
from typing import Literal

from sigcat.adapter.arxml import tree
from sigcat.adapter.arxml.tree import Child, Tag, description, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.library import INTERFACE, Library
from sigcat.adapter.autosar_classic.arxml.paths import MODE_PROTOTYPE, OPERATION, PARAMETER, VARIABLE
from sigcat.adapter.autosar_classic.arxml.releases import Release
from sigcat.adapter.autosar_classic.arxml.value_specifications import init_value
from sigcat.integration.autosar_classic.model import E2eWindows, Element, OuterPort, Port


def side_of(direction: str) -> Literal["P", "R"]:
    """Word for a direction in the names of elements."""
    return "P" if direction == "Provided" else "R"


def port_reference(tag_name: str, path: str, direction: str) -> Tag:
    """Reference to a port."""
    return reference(tag_name, path, f"{side_of(direction)}-PORT-PROTOTYPE")


def port(each: Port, known: Library) -> Tag:
    """A port of a component."""
    return _port(each, known, description(each.description), trace(_facts(each)))


def outer_port(each: OuterPort, known: Library) -> Tag:
    """A port of the composition. Values before the first one are those of the data elements of the components."""
    names = [name for interface, name in known.element_types if interface == each.interface]
    elements = tuple(Element(name=name, init=each.init) for name in names) if each.init is not None else ()
    as_port = Port(
        name=each.name, direction=each.direction, kind=each.kind, interface=each.interface, elements=elements
    )
    return _port(as_port, known, trace([("ExternalProvider", each.provider)]))


def _port(each: Port, known: Library, *about: Tag | None) -> Tag:
    """A port, with what the RTE does with each element."""
    side = side_of(each.direction)
    specification, word = (_provided, "PROVIDED") if side == "P" else (_required, "REQUIRED")
    specifications = listed(f"{word}-COM-SPECS", (specification(each, element, known) for element in each.elements))
    path = known.interface_path(each)
    return tree.port(side, path, INTERFACE[each.kind], *about, specifications, name=each.name)


def _facts(each: Port) -> Iterable[tuple[str, object]]:
    """Interfaces of the function for the elements."""
    for element in each.elements:
        for use in element.uses or ():
            yield f"{element.name}.{use.call or use.function}", use


def _provided(each: Port, element: Element, known: Library) -> Tag | None:
    path = known.interface_path(each, element.name)
    length = {"QUEUE-LENGTH": element.queue_length or 1}
    if each.kind == "ClientServer":
        return tag("SERVER-COM-SPEC", reference("OPERATION-REF", path, OPERATION), length)
    if each.kind == "ModeSwitch":
        group = reference("MODE-GROUP-REF", path, MODE_PROTOTYPE)
        return tag("MODE-SWITCH-SENDER-COM-SPEC", {"ENHANCED-MODE-API": False}, group, length)
    init = _init(each, element, known)
    if each.kind == "Parameter":
        return tag("PARAMETER-PROVIDE-COM-SPEC", init, reference("PARAMETER-REF", path, PARAMETER))
    if element.queue_length is not None:
        return tag("QUEUED-SENDER-COM-SPEC", *_of_data(path))
    return tag("NONQUEUED-SENDER-COM-SPEC", *_of_data(path), init)


def _of_data(path: str) -> Iterable[Child]:
    yield reference("DATA-ELEMENT-REF", path, VARIABLE)
    yield {"HANDLE-OUT-OF-RANGE": "NONE", "USES-END-TO-END-PROTECTION": False}


def _required(each: Port, element: Element, known: Library) -> Tag | None:
    path = known.interface_path(each, element.name)
    if each.kind == "ClientServer":
        return tag("CLIENT-COM-SPEC", reference("OPERATION-REF", path, OPERATION))
    if each.kind == "ModeSwitch":
        group = reference("MODE-GROUP-REF", path, MODE_PROTOTYPE)
        flags = {"ENHANCED-MODE-API": False, "SUPPORTS-ASYNCHRONOUS-MODE-SWITCH": False}
        return tag("MODE-SWITCH-RECEIVER-COM-SPEC", group, flags)
    init = _init(each, element, known)
    if each.kind == "Parameter":
        return tag("PARAMETER-REQUIRE-COM-SPEC", init, reference("PARAMETER-REF", path, PARAMETER)) if init else None
    common = (*_of_data(path), _windows(element.windows, known.release) if element.windows else None)
    if element.queue_length is not None:
        return tag("QUEUED-RECEIVER-COM-SPEC", *common, {"QUEUE-LENGTH": element.queue_length})
    return tag(
        "NONQUEUED-RECEIVER-COM-SPEC",
        *common,
        {"ALIVE-TIMEOUT": element.alive_timeout or 0, "HANDLE-TIMEOUT-TYPE": "NONE"},
        {"ENABLE-UPDATE": bool(element.update), "HANDLE-NEVER-RECEIVED": bool(element.never_received)},
        init,
    )


def _windows(windows: E2eWindows, release: Release) -> Tag:
    """Windows of the state machine of the end-to-end transformer, which go before those of the transformer itself."""
    states = {"INIT": windows.init, "INVALID": windows.invalid, "VALID": windows.valid}
    by_state = {f"WINDOW-SIZE-{state}": each.size for state, each in states.items()}
    properties = tag(
        "END-TO-END-TRANSFORMATION-COM-SPEC-PROPS",
        {f"MAX-ERROR-STATE-{state}": each.max_error for state, each in states.items()},
        {f"MIN-OK-STATE-{state}": each.min_ok for state, each in states.items()},
        by_state if release.has_windows_by_state else {"WINDOW-SIZE": windows.valid.size},
    )
    return tag("TRANSFORMATION-COM-SPEC-PROPSS", properties)


def _init(each: Port, element: Element, known: Library) -> Tag | None:
    return init_value(element.init, known.element_types.get((each.interface, element.name), ""), known)
