"""Tables of the test RTE: inputs from outside, the events in the order of their tasks, data of services."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.c_text import c_lines
from sigcat.adapter.autosar_classic.code.plan import MethodEnd, RteType, SwcPlan
from sigcat.adapter.autosar_classic.test_rte.plan import Scheduled, TestRte
from sigcat.adapter.autosar_classic.test_rte.shapes import Shape, Symbols
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.integration.autosar_classic.model import Port

_ECU = "EcuManager"


class _Input(NamedTuple):
    """A column of a trace; `checked` is the function that takes error codes, if there is one."""

    column: str
    shape: str
    function: str
    checked: str = ""


class _Event(NamedTuple):
    """An event of a task; `run` is empty for a method, which is called. Times are in ns."""

    task: str
    name: str
    component: int
    run: str
    period: int
    offset: int
    is_init: bool


class _Switch(NamedTuple):
    """A mode that the state manager of the ECU switches to."""

    swc: str
    port: str
    group: str
    value: int


def data_header(rte: TestRte) -> Lines:
    """rte_data.h: how the parts of the RTE reach each other."""
    swcs = rte.plan.swcs
    shapes = {swc.name: [each.name for each in _shapes(swc, rte)] for swc in swcs}
    return c_lines("test_rte/rte_data.h.j2", swcs=swcs, shapes=shapes)


def tables(rte: TestRte) -> Lines:
    """rte_tables.c."""
    swcs = rte.plan.swcs
    shapes = [each for swc in swcs for each in _shapes(swc, rte)]
    return c_lines(
        "test_rte/rte_tables.c.j2",
        symbols={name: table for each in shapes for name, table in each.tables().items()},
        shapes=shapes,
        inputs=[*_inputs(rte)],
        events=[_event(each, rte) for each in rte.scheduled],
        swcs=swcs,
        block_count=sum(len(swc.component.nv_blocks) for swc in swcs),
        inhibitions=_inhibitions(rte),
        batches=rte.batches,
        startup=[*_switches("RUN", rte)],
        shutdown=[*_switches("SHUTDOWN", rte)],
    )


def _shapes(swc: SwcPlan, rte: TestRte) -> Iterator[Shape]:
    named = {
        each.name: tuple((symbol.symbol, symbol.value) for symbol in method.symbols or ())
        for each in rte.model.implementation_types
        for method in rte.model.compu_methods if method.name == each.compu_method and method.symbols
    }  # fmt: skip
    for end in (*swc.received, *swc.sent):
        yield Shape(f"{swc.name}_{end.name}", end.type, named, end.wire.symbols)
    for port in swc.required_modes:
        yield Shape(f"{swc.name}_{port.name}_mode", *_mode_type(port, rte))
    if swc.mode_out:
        port = next(each for each in swc.component.ports if each.name == swc.mode_out.port)
        yield Shape(f"{swc.name}_{swc.mode_out.name}", *_mode_type(port, rte))
    for method in swc.requests:
        yield Shape(f"{swc.name}_{method.name}_answer", _answer_type(method, swc), named)


def _answer_type(method: MethodEnd, swc: SwcPlan) -> RteType:
    """Results as one value; of a method without results whether it is done."""
    members = tuple((each.place, each.type) for each in method.results)
    if not members:
        return RteType("boolean", "boolean")
    return RteType(f"TestRte_Answer_{swc.name}_{method.name}", members=members)


def _mode_type(port: Port, rte: TestRte) -> tuple[RteType, Mapping[str, Symbols], Symbols]:
    group = rte.group(port)
    base = rte.plan.types[group.type].base if group.type in rte.plan.types else group.type
    return RteType(f"Rte_ModeType_{group.name}", base), {}, tuple((mode.name, mode.value) for mode in group.modes)


def _inputs(rte: TestRte) -> Iterator[_Input]:
    """Elements that no other component provides."""
    for swc in rte.plan.swcs:
        for end in swc.received:
            name = f"{swc.name}_{end.name}"
            if rte.provider(swc, end.port) is None:
                checked = f"DeliverChecked_{name}" if end.has_transformer_errors else ""
                yield from (_Input(column, name, f"Deliver_{name}", checked) for column in end.columns)
        for port in swc.required_modes:
            name = f"{swc.name}_{port.name}"
            if rte.provider(swc, port.name) is None and port.service != _ECU and swc.mode_in:
                yield from (_Input(column, f"{name}_mode", f"SwitchTo_{name}") for column in swc.mode_in.columns)
        for method in swc.requests:
            name = f"{swc.name}_{method.name}"
            if rte.provider(swc, method.port) is None:
                yield from (_Input(column, f"{name}_answer", f"DeliverAnswer_{name}") for column in method.columns)


def _event(each: Scheduled, rte: TestRte) -> _Event:
    event, swc = each.event, each.swc
    runnable = next(one for one in swc.component.runnables if one.name == event.runnable)
    run = f"{swc.name}_{runnable.name}" if runnable.role != "Method" else ""
    period, offset = (round((value or 0) * 10**9) for value in (event.period, event.offset))
    return _Event(
        each.task, f"{swc.name}.{event.name}", rte.index(swc), run,
        period if event.kind == "Timing" else 0, offset, event.kind == "Init",
    )  # fmt: skip


def _inhibitions(rte: TestRte) -> list[tuple[str, Sequence[str]]]:
    """Names of inhibitions, and events that they depend on."""
    names = {event.error: event.name for swc in rte.plan.swcs for event in swc.component.diagnostic_events}
    return [
        (each.name, [names.get(event, event) for event in each.events])
        for swc in rte.plan.swcs for each in swc.component.inhibitions
    ]  # fmt: skip


def _switches(mode: str, rte: TestRte) -> Iterator[_Switch]:
    for swc in rte.plan.swcs:
        for port in swc.required_modes:
            if port.service == _ECU:
                group = rte.group(port)
                value = next((each.value for each in group.modes if each.name == mode), None)
                if value is not None:
                    yield _Switch(swc.name, port.name, group.name, value)
