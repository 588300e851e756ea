"""The plan of the test RTE: components, connections, and the position of each event in its task."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.plan import ClassicPlan, DataEnd, MethodEnd, SwcPlan
from sigcat.adapter.autosar_classic.code.rte_headers.api import Apis, Call
from sigcat.integration.autosar_classic.model import (
    ClassicIntegration,
    Event,
    InitBatch,
    ModeGroup,
    Port,
    Runnable,
    Task,
)


class Scheduled(NamedTuple):
    """An event, as it is mapped to a task or to a batch before them."""

    task: str
    swc: SwcPlan
    event: Event


class End(NamedTuple):
    """A port of a component."""

    swc: SwcPlan
    port: Port


class TestRte:
    """The integration, asked for what the files need."""

    __test__ = False

    def __init__(self, model: ClassicIntegration, plan: ClassicPlan) -> None:
        self.model, self.plan = model, plan
        self.prototypes = {each.name: each.type for each in model.composition.prototypes}
        self._by_name = {swc.name: swc for swc in plan.swcs}
        self.scheduled: Sequence[Scheduled] = [each for task in model.ecu.tasks for each in self._listed(task)]
        self.batches: Mapping[str, Sequence[Scheduled]] = {
            batch.name: tuple(self._listed(batch)) for batch in model.ecu.init_batches
        }
        self.groups = {group.name: group for group in model.mode_groups}
        self.mode_interfaces = {each.name: each for each in model.mode_switch_interfaces}

    def _listed(self, place: InitBatch | Task) -> Iterator[Scheduled]:
        for each in sorted(place.events, key=lambda one: one.position):
            swc = self._by_name[self.prototypes[each.component]]
            for event in swc.component.events:
                if event.name == each.event:
                    yield Scheduled(place.name, swc, event)

    def group(self, port: Port) -> ModeGroup:
        """The modes of a port."""
        return self.groups[self.mode_interfaces[port.interface].group]

    def index(self, swc: SwcPlan) -> int:
        """The number of a component."""
        return self.plan.swcs.index(swc)

    def calls(self, swc: SwcPlan) -> tuple[Call, ...]:
        """The functions of the RTE for a component."""
        return Apis(swc, self.model, dict(self.plan.types)).all()

    def events(self, swc: SwcPlan, kind: str, **wanted: str) -> Iterator[int]:
        """Numbers of the events of a component that something raises."""
        for number, each in enumerate(self.scheduled):
            event = each.event
            if each.swc is swc and event.kind == kind and all(getattr(event, k) == v for k, v in wanted.items()):
                yield number

    def receivers(self, swc: SwcPlan, port: str) -> Iterator[End]:
        """The ports that a provided port of a component is connected to."""
        for each in self.model.composition.assemblies:
            if self.prototypes[each.provider.component] == swc.name and each.provider.port == port:
                yield self._end(each.requester.component, each.requester.port)

    def provider(self, swc: SwcPlan, port: str) -> End | None:
        """The port of another function's component that a required port of a component is connected to."""
        for each in self.model.composition.assemblies:
            is_this = self.prototypes[each.requester.component] == swc.name and each.requester.port == port
            if is_this and self.prototypes[each.provider.component] in self._by_name:
                return self._end(each.provider.component, each.provider.port)
        return None

    def _end(self, prototype: str, port: str) -> End:
        swc = self._by_name[self.prototypes[prototype]]
        return End(swc, next(each for each in swc.component.ports if each.name == port))


def received_at(end: End, element: str) -> DataEnd | None:
    """The end that receives an element of a port, or the only one of the port."""
    own = [each for each in end.swc.received if each.port == end.port.name]
    return next((each for each in own if each.element == element), own[0] if len(own) == 1 else None)


def server(end: End, operation: str) -> tuple[Runnable, MethodEnd] | None:
    """The runnable that answers an operation of a provided port."""
    for method in end.swc.methods:
        if (method.port, method.operation) == (end.port.name, operation):
            for each in end.swc.component.runnables:
                if each.role == "Method" and each.method in method.columns:
                    return each, method
    return None
