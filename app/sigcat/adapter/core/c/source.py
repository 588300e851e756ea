"""The source: every function in the order of a reader."""

from collections.abc import Iterable, Iterator

from sigcat.adapter.core.c.calls.call_functions import CallPlan, call_plan
from sigcat.adapter.core.c.calls.methods import STATUS, MethodPlan, method_plan
from sigcat.adapter.core.c.data.inputs import received_init
from sigcat.adapter.core.c.data.parameters import ParameterPlan, parameter_plan
from sigcat.adapter.core.c.errors.errors import activations, error_plan
from sigcat.adapter.core.c.header import about
from sigcat.adapter.core.c.life import cleared_members, initial_values
from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.schedule.clock import cyclic_calls, kept_times
from sigcat.adapter.core.c.text.layout import c_lines
from sigcat.adapter.core.c.text.lines import Line, Lines
from sigcat.adapter.core.c.values.c_values import Transfer
from sigcat.adapter.core.c.values.sizes import checks, needs_self


def source(scope: Scope) -> Lines:
    """The whole source."""
    functions = _functions(scope)
    plan, found = scope.plan, checks(scope)
    return (
        *c_lines(
            "adapter/core/c/source.c.j2",
            p=scope.prefix,
            m=scope.macro,
            plan=plan,
            about=about(plan),
            is_cpp=scope.is_cpp,
            prototypes=() if plan.code.headers else plan.calls,
            checks=found,
            needs_self=needs_self(found, scope),  # whether a check is about a member of the adapter
        ),
        Line(""),
        *functions,
    )


def _functions(scope: Scope) -> Lines:
    plan = scope.plan
    inits, calls, terminates = (
        [call_plan(call, scope) for call in each] for each in (plan.inits, plan.steps, plan.terminates)
    )
    parameters = [parameter_plan(each, scope) for each in plan.parameters]
    methods = [method_plan(each, scope) for each in plan.methods]
    received = {port.name: received_init(port) for port in plan.ports}
    values = _transfers([*inits, *calls, *terminates], parameters, methods)
    return c_lines(
        "adapter/core/c/functions.c.j2",
        p=scope.prefix,
        m=scope.macro,
        plan=plan,
        is_cpp=scope.is_cpp,
        put=scope.put,  # puts a number into a variable that may be an enumeration; empty where `=` does
        inits=inits,
        calls=calls,
        due=[each for call in plan.due for each in calls if each.call.name == call.name],
        terminates=terminates,
        parameters=parameters,
        methods=methods,
        status=STATUS,
        constants=[*dict.fromkeys(each for value in values for each in value.constants)],
        errors=[error_plan(each) for each in plan.errors if each.call],
        activations=activations,
        received_inits=received,
        initial=initial_values(plan, [*inits, *calls, *terminates], [*received.values()]),
        cleared=cleared_members(plan),
        class_name=(plan.code.class_name or "").rpartition("::")[2],
        can_fail=any(init.success is not None for init in plan.inits),
        kept=kept_times(plan),
        cyclic=cyclic_calls(plan),
    )


def _transfers(
    calls: Iterable[CallPlan], parameters: Iterable[ParameterPlan], methods: Iterable[MethodPlan]
) -> Iterator[Transfer]:
    for call in calls:
        yield from (value for each in call.inputs for value in (each.received, each.taken))
        yield from (each.given for each in call.outputs)
    for parameter in parameters:
        yield from (value for value in (parameter.checked, parameter.written, parameter.learned) if value)
    for method in methods:
        yield from (each.value for each in (*method.received, *method.given))
