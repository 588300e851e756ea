"""Ports of components and of the composition, with the attributes of each element."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import Tag, description, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.library import INTERFACE, Library
from sigcat.adapter.autosar_classic.arxml.paths import MODE_PROTOTYPE, OPERATION, PARAMETER, VARIABLE
from sigcat.adapter.autosar_classic.arxml.releases import Release
from sigcat.adapter.autosar_classic.arxml.values import init_value
from sigcat.integration.autosar_classic.model import E2eWindows, Element, OuterPort, Port


def port_tag(direction: str) -> str:
    """Element of a port."""
    return "P-PORT-PROTOTYPE" if direction == "Provided" else "R-PORT-PROTOTYPE"


def port(each: Port, known: Library) -> Tag:
    """A port of a component."""
    return tag(
        port_tag(each.direction),
        description(each.description),
        trace(list(_facts(each))),
        _specifications(each, known),
        _interface(each, known),
        name=each.name,
    )


def outer_port(each: OuterPort, known: Library) -> Tag:
    """A port of the composition. Values before the first one are those of the data elements of the components."""
    names = [name for interface, name in known.element_types if interface == each.interface]
    elements = tuple(Element(name=name, init=each.init) for name in names) if each.init is not None else ()
    as_port = Port(
        name=each.name, direction=each.direction, kind=each.kind, interface=each.interface, elements=elements
    )
    return tag(
        port_tag(each.direction),
        trace([("ExternalProvider", each.provider)]),
        _specifications(as_port, known),
        _interface(as_port, known),
        name=each.name,
    )


def _facts(each: Port) -> Iterable[tuple[str, object]]:
    """Interfaces of the function for the elements."""
    for element in each.elements:
        for use in element.uses or ():
            yield f"{element.name}.{use.call or use.function}", use.model_dump(mode="json", exclude_none=True)


def _interface(each: Port, known: Library) -> Tag:
    name = "PROVIDED-INTERFACE-TREF" if each.direction == "Provided" else "REQUIRED-INTERFACE-TREF"
    return reference(name, known.interface_path(each), INTERFACE[each.kind])


def _specifications(each: Port, known: Library) -> Tag | None:
    """COM-SPECS: what the RTE does with each element."""
    if each.direction == "Provided":
        return listed("PROVIDED-COM-SPECS", _some(_provided(each, element, known) for element in each.elements))
    return listed("REQUIRED-COM-SPECS", _some(_required(each, element, known) for element in each.elements))


def _some(found: Iterable[Tag | None]) -> Iterable[Tag]:
    return (item for item in found if item is not None)


def _provided(each: Port, element: Element, known: Library) -> Tag | None:
    path = known.interface_path(each, element.name)
    if each.kind == "ClientServer":
        length = tag("QUEUE-LENGTH", text=element.queue_length or 1)
        return tag("SERVER-COM-SPEC", reference("OPERATION-REF", path, OPERATION), length)
    if each.kind == "ModeSwitch":
        return tag(
            "MODE-SWITCH-SENDER-COM-SPEC",
            tag("ENHANCED-MODE-API", text="false"),
            reference("MODE-GROUP-REF", path, MODE_PROTOTYPE),
            tag("QUEUE-LENGTH", text=element.queue_length or 1),
        )
    init = _init(each, element, known)
    if each.kind == "Parameter":
        return tag("PARAMETER-PROVIDE-COM-SPEC", init, reference("PARAMETER-REF", path, PARAMETER))
    name = "NONQUEUED-SENDER-COM-SPEC" if element.queue_length is None else "QUEUED-SENDER-COM-SPEC"
    return tag(
        name,
        reference("DATA-ELEMENT-REF", path, VARIABLE),
        tag("HANDLE-OUT-OF-RANGE", text="NONE"),
        tag("USES-END-TO-END-PROTECTION", text="false"),
        init if element.queue_length is None else None,
    )


def _required(each: Port, element: Element, known: Library) -> Tag | None:
    path = known.interface_path(each, element.name)
    if each.kind == "ClientServer":
        return tag("CLIENT-COM-SPEC", reference("OPERATION-REF", path, OPERATION))
    if each.kind == "ModeSwitch":
        return tag(
            "MODE-SWITCH-RECEIVER-COM-SPEC",
            tag("ENHANCED-MODE-API", text="false"),
            reference("MODE-GROUP-REF", path, MODE_PROTOTYPE),
            tag("SUPPORTS-ASYNCHRONOUS-MODE-SWITCH", text="false"),
        )
    init = _init(each, element, known)
    if each.kind == "Parameter":
        return tag("PARAMETER-REQUIRE-COM-SPEC", init, reference("PARAMETER-REF", path, PARAMETER)) if init else None
    common = (
        reference("DATA-ELEMENT-REF", path, VARIABLE),
        tag("HANDLE-OUT-OF-RANGE", text="NONE"),
        _windows(element.windows, known.release) if element.windows else None,
        tag("USES-END-TO-END-PROTECTION", text="false"),
    )
    if element.queue_length is not None:
        return tag("QUEUED-RECEIVER-COM-SPEC", *common, tag("QUEUE-LENGTH", text=element.queue_length))
    return tag(
        "NONQUEUED-RECEIVER-COM-SPEC",
        *common,
        tag("ALIVE-TIMEOUT", text=element.alive_timeout or 0),
        tag("ENABLE-UPDATE", text=str(bool(element.update)).lower()),
        tag("HANDLE-NEVER-RECEIVED", text=str(bool(element.never_received)).lower()),
        tag("HANDLE-TIMEOUT-TYPE", text="NONE"),
        init,
    )


def _windows(windows: E2eWindows, release: Release) -> Tag:
    """Windows of the state machine of the end-to-end transformer, which go before those of the transformer itself."""
    states = {"INIT": windows.init, "INVALID": windows.invalid, "VALID": windows.valid}
    sizes = (
        [tag(f"WINDOW-SIZE-{state}", text=each.size) for state, each in states.items()]
        if release.has_windows_by_state
        else [tag("WINDOW-SIZE", text=windows.valid.size)]
    )
    properties = tag(
        "END-TO-END-TRANSFORMATION-COM-SPEC-PROPS",
        *(tag(f"MAX-ERROR-STATE-{state}", text=each.max_error) for state, each in states.items()),
        *(tag(f"MIN-OK-STATE-{state}", text=each.min_ok) for state, each in states.items()),
        *sizes,
    )
    return tag("TRANSFORMATION-COM-SPEC-PROPSS", properties)


def _init(each: Port, element: Element, known: Library) -> Tag | None:
    return init_value(element.init, known.element_types.get((each.interface, element.name), ""), known)
