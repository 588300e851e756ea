"""Processes of a component: its own, and further ones of the same executable that offer or use other instances of services."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.integration.autosar_adaptive.deployment.identifiers import INSTANCES
from sigcat.integration.autosar_adaptive.model import Component, FurtherProcess, ProcessInstance, ServiceInterface
from sigcat.integration.autosar_names import distinct, short_name


class Process(NamedTuple):
    """A process, and the instances of services that its ports mean."""

    name: str
    stem: str
    """Prefix of the names of its elements: the component's name, or that of a further process."""
    component: Component
    services: tuple[ServiceInterface, ...]

    @property
    def is_further(self) -> bool:
        """Whether it is not the component's own."""
        return self.stem != self.component.name


def processes(components: Sequence[Component]) -> tuple[Process, ...]:
    """The processes of all components; those of the components themselves come first."""
    names = distinct({component.name: short_name(f"{component.name}Process") for component in components})
    own = [Process(names[each.name], each.name, each, each.services) for each in components]
    return (*own, *(_further(process, each) for each in components for process in each.processes or ()))


def _further(process: FurtherProcess, component: Component) -> Process:
    ids = {each.service: each.instance_id for each in process.instances}
    services = (
        each.model_copy(update={"instance_id": ids.get(each.name, each.instance_id)}) for each in component.services
    )
    return Process(process.name, process.name, component, tuple(services))


def further_processes(stated: Mapping[str, Mapping[str, int]]) -> tuple[FurtherProcess, ...]:
    """The further processes that a deployment names."""
    return tuple(
        FurtherProcess(
            name=name,
            instances=tuple(ProcessInstance(service=service, instance_id=ids[service]) for service in sorted(ids)),
        )
        for name, ids in sorted(stated.items())
    )


class ProcessProblem(NamedTuple):
    """Why a further process cannot be."""

    process: str
    message: str
    fix: str


def process_problems(components: Sequence[Component]) -> Iterator[tuple[Component, ProcessProblem]]:
    """Yield problems of further processes, with their components."""
    taken: dict[str, str] = {}
    offered: dict[tuple[str, int | None], str] = {}
    for each in processes(components):
        stems = {name.lower() for name in (each.name, each.stem)}
        if stems & taken.keys():
            message = (
                f"The process {each.name} must have a unique name, unlike those of components and other processes."
            )
            yield each.component, ProcessProblem(each.name, message, "Rename it.")
        taken |= dict.fromkeys(stems, each.name)
        for problem in (*_wrong_ids(each), *_offered_twice(each, offered)):
            yield each.component, problem


def _wrong_ids(process: Process) -> Iterator[ProcessProblem]:
    stated = next((each for each in process.component.processes or () if each.name == process.stem), None)
    known = {interface.name for interface in process.services}
    for each in stated.instances if stated else ():
        if each.service not in known:
            message = (
                f"The component of process {process.name} must offer or use {each.service}, which the process names."
            )
            yield ProcessProblem(process.name, message, f"Use one of {', '.join(sorted(known))}.")
        elif not INSTANCES.first <= each.instance_id <= INSTANCES.last:
            message = f"The instance of {each.service} in process {process.name} must be from {INSTANCES.first} to {INSTANCES.last}, not {each.instance_id}."
            yield ProcessProblem(process.name, message, "Use another one.")


def _offered_twice(process: Process, offered: dict[tuple[str, int | None], str]) -> Iterator[ProcessProblem]:
    for interface in process.services:
        if interface.role == "Provider":
            other = offered.setdefault((interface.name, interface.instance_id), process.name)
            if other != process.name:
                message = f"Process {process.name} must offer its own instance of {interface.name}, not {interface.instance_id} as {other} does."
                yield ProcessProblem(process.name, message, f"Give it the id of an instance: `{interface.name}`.")
