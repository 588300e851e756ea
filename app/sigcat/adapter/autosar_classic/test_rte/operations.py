"""Operations that components call: services of the base software, methods of others, answers that a trace has."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.component.methods import head
from sigcat.adapter.autosar_classic.code.plan import MethodEnd, SwcPlan
from sigcat.adapter.autosar_classic.code.rte_headers.api import Call
from sigcat.adapter.autosar_classic.test_rte.plan import TestRte, server
from sigcat.function.document.text_filters import c_string

_SERVICES = {
    "GetTime": "TestRte_GetTime", "GetCycle": "TestRte_GetCycle", "SetEventStatus": "Dem_SetEventStatus",
    "CheckpointReached": "WdgM_CheckpointReached", "GetErrorStatus": "NvM_GetErrorStatus",
    "SetRamBlockStatus": "NvM_SetRamBlockStatus",
}  # fmt: skip


class Service(NamedTuple):
    """A service of the base software; of one that the test RTE lacks, `function` is empty."""

    function: str
    arguments: Sequence[str]


class _Server(NamedTuple):
    """The runnable that answers a request; `component` is the number of its component."""

    head: str
    symbol: str
    component: int
    arguments: Sequence[str]


class Request(NamedTuple):
    """A request to a method, with numbers of the events that its answer raises. Without a server, a trace answers."""

    method: MethodEnd
    activated: Sequence[int]
    server: _Server | None


def service(call: Call, swc: SwcPlan) -> Service:
    """The service of a call, which has more arguments than the port: event, checkpoint of an entity, or block."""
    component = swc.component
    found = {each.port: [each.name] for each in component.diagnostic_events}
    found.update((each.port, [each.name]) for each in component.nv_blocks)
    for entity in component.supervised_entities:
        found.update((each.port, [entity.name, each.name]) for each in entity.checkpoints)
    bound = [c_string(name) for name in found.get(call.port, [])]
    return Service(_SERVICES.get(call.element, ""), [*bound, *(each.name for each in call.parameters)])


def request(method: MethodEnd, call: Call, swc: SwcPlan, rte: TestRte) -> Request:
    """The request of a call."""
    activated = [*rte.events(swc, "CallReturns", port=method.port, element=method.operation)]
    return Request(method, activated, _server(method, call, swc, rte))


def _server(method: MethodEnd, call: Call, swc: SwcPlan, rte: TestRte) -> _Server | None:
    provider = rte.provider(swc, method.port)
    found = server(provider, method.operation) if provider else None
    if provider is None or found is None:
        return None
    runnable, answered = found
    value = f"answer_{swc.name}_{method.name}.value"
    results = [f"{'' if each.type.is_array else '&'}{value}.{each.place}" for each in method.results]
    given = [each.name for each in call.parameters]
    return _Server(head(runnable, answered), runnable.symbol, rte.index(provider.swc), [*given, *results])
