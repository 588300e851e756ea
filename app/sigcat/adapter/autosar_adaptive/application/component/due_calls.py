"""The calls of a component: due times, supervision, and reported overruns."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.application.names import checkpoint
from sigcat.adapter.autosar_adaptive.application.plan import ComponentPlan
from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.plan import Call
from sigcat.function.document.text import composed
from sigcat.function.document.text_filters import AnyText


class AdapterThread(NamedTuple):
    """The member that is a thread of calls, how much less urgent than the first one, and the calls."""

    name: str
    about: str
    rank: int
    calls: Sequence[str]


class AdapterCall(NamedTuple):
    """A call: its name in the core, its constant there, and the thread that runs it, by its number there."""

    name: str
    interface: str
    constant: str
    about: AnyText
    is_cyclic: bool
    thread: str
    number: int
    longest: int | None
    """Nanoseconds that it may run; None without a deadline."""
    watch: str
    """The member that watches its deadline: that of one call at a time."""
    checkpoint: str
    """The constant of its end, if that is reported."""


def adapter_threads(component: ComponentPlan) -> Sequence[AdapterThread]:
    """Threads that run the calls; none if the thread that finds them due does."""
    if not component.is_threaded:
        return ()
    most = component.threads[0].priority
    return [
        AdapterThread(
            _thread_name(number),
            f"Priority {thread.priority}: {', '.join(call.interface for call in thread.calls)}",
            most - thread.priority,
            [call.name for call in thread.calls],
        )
        for number, thread in enumerate(component.threads)
    ]


def adapter_calls(component: ComponentPlan) -> Sequence[AdapterCall]:
    """The calls of a component, in the order of its core."""
    return [_call(step, component) for step in component.core.steps]


def watches(component: ComponentPlan) -> Sequence[str]:
    """Members that watch deadlines."""
    return list(dict.fromkeys(_watch(step, component) for step in component.core.steps if step.deadline))


def _call(step: Call, component: ComponentPlan) -> AdapterCall:
    thread = _thread(step, component)
    return AdapterCall(
        step.name,
        step.interface,
        Scope(component.core).call(step.name),
        composed(step.interface, ": ", step.description) if step.description else step.interface,
        step.cycle is not None,
        _thread_name(thread),
        component.threads[thread].calls.index(step),
        None if step.deadline is None else step.deadline.most,
        _watch(step, component),
        checkpoint(step.interface) if step.interface in component.checkpoints else "",
    )


def _thread(step: Call, component: ComponentPlan) -> int:
    return next(number for number, thread in enumerate(component.threads) if step in thread.calls)


def _thread_name(number: int) -> str:
    return f"calls_{number}_"


def _watch(step: Call, component: ComponentPlan) -> str:
    return f"watch_{_thread(step, component)}_" if component.is_threaded else "watch_"
