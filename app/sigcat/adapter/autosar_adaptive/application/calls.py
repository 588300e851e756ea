"""What runs the calls of a component: when they are due, under supervision, with overruns told."""

from sigcat.adapter.autosar_adaptive.application.adapter_header import has_offered
from sigcat.adapter.autosar_adaptive.application.names import (
    LOCK,
    braces,
    checkpoint,
    commented,
    locked,
    repeating,
    watch_name,
)
from sigcat.adapter.autosar_adaptive.application.plan import ComponentPlan
from sigcat.adapter.core.c.lines import Lines, block, indented, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Call
from sigcat.function.document.text import composed
from sigcat.function.document.text_filters import c_string

_ONE_CALL = "const std::lock_guard<std::mutex> call{call_mutex_};"
_SHARED_CALL = "const std::shared_lock<application::CallMutex> call{call_mutex_};"


def call_functions(component: ComponentPlan) -> list[Lines]:
    """Definitions of the functions of the adapter."""
    return [
        _run(component),
        _run_due(component),
        *(_run_call(step, component) for step in component.core.steps),
        _supervise(component),
    ]


def _run(component: ComponentPlan) -> Lines:
    core = component.core.type_name
    return block(f"void {component.type}::Run()", [
        lines("std::uint64_t next = 0;"),
        block("while (clock_->WaitUntil(next))", [
            lines("RunDueCalls();\nSupervise();"),
            lines(f"{LOCK}\nnext = {core}_NextTime(&core_);"),
        ]),
    ])  # fmt: skip


def _run_due(component: ComponentPlan) -> Lines:
    core, scope = component.core.type_name, Scope(component.core)
    polls = [lines(f"Poll{each.member}();") for service in component.required for each in service.methods]
    cases = [
        joined([lines(f"case {scope.call(step.name)}:"), indented(lines(f"{_run_of(step, component)}\nbreak;"))])
        for step in component.core.steps
    ]
    none = joined([lines(f"case {scope.constant('NO_CALL')}:\ndefault:"), indented(lines("return;"))])
    return block(f"void {component.type}::RunDueCalls()", [
        block("for (;;)", [
            lines(_ONE_CALL) if has_offered(component) and not component.is_threaded else (),
            *polls,
            lines(f"{core}_Call due = {scope.constant('NO_CALL')};"),
            braces([
                lines(_SHARED_CALL) if has_offered(component) and component.is_threaded else (),
                lines(f"{LOCK}\ndue = {core}_NextCall(&core_, clock_->Now());"),
            ]),
            block("switch (due)", [*cases, none]),
            _in_turns(component),
        ]),
    ])  # fmt: skip


def _run_of(call: Call, component: ComponentPlan) -> str:
    if not component.is_threaded:
        return f"Run{call.name}();"
    number, thread = next((n, each) for n, each in enumerate(component.threads) if call in each.calls)
    return f"{thread_name(number)}->Request({thread.calls.index(call)}U);"


def thread_name(number: int) -> str:
    """The member that is a thread of calls."""
    return f"calls_{number}_"


def _in_turns(component: ComponentPlan) -> Lines:
    if not component.is_threaded:
        return ()
    rest = "\n".join(f"{thread_name(number)}->AwaitRest();" for number in range(len(component.threads)))
    return block("if (clock_->IsInTurns())", [lines(rest)])


def _run_call(call: Call, component: ComponentPlan) -> Lines:
    core, name = component.core.type_name, call.name
    begins, ends = _watched(call, component)
    overrun = lines(f"""
        if (core_.{name}.missed != missed_{name}_) {{
            logger_.LogWarn() << {c_string(f"{call.interface} has missed releases: ")} << (core_.{name}.missed - missed_{name}_);
            missed_{name}_ = core_.{name}.missed;
        }}
    """) if call.cycle is not None else ()  # fmt: skip
    return joined([
        commented(composed(call.interface, ": ", call.description) if call.description else call.interface),
        block(f"void {component.type}::Run{name}()", [
            lines(_SHARED_CALL) if has_offered(component) and component.is_threaded else (),
            braces([
                lines(LOCK),
                lines(f"{core}_SetInput_{name}(&core_, clock_->Now());\n{core}_Begin_{name}(&core_, clock_->Now());"),
                overrun,
            ]),
            lines("Publish();"),
            begins,
            lines(f"{core}_Run_{name}(&core_);"),
            ends,
            locked(f"{core}_GetOutput_{name}(&core_, clock_->Now());"),
            _reported(call, component),
            lines("Publish();"),
            lines(f"Repeat{name}();") if name in repeating(component) else (),
            lines("clock_->Wake();  // others may wait for its end") if component.is_threaded else (),
        ]),
    ])  # fmt: skip


def _reported(call: Call, component: ComponentPlan) -> Lines:
    """The end of a call, for the health management: what it counts is what the core counts."""
    if call.interface not in component.checkpoints:
        return ()
    return lines(f"supervision_.ReportCheckpoint(Checkpoint::{checkpoint(call.interface)});")


def _watched(call: Call, component: ComponentPlan) -> tuple[Lines, Lines]:
    if call.deadline is None:
        return (), ()
    name = watch_name(component, call)
    begins = lines(f"{name}->Begin(std::chrono::nanoseconds{{{call.deadline.most}}});")
    return begins, lines(f"{name}->End();")


def _supervise(component: ComponentPlan) -> Lines:
    core = component.core.type_name
    return block(f"void {component.type}::Supervise()", [
        locked(f"{core}_Supervise(&core_, clock_->Now());"),
        lines("Publish();"),
    ])  # fmt: skip
