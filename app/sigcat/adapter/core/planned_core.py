"""From a resolved function to the plan of its core, and the obstacles."""

from collections.abc import Iterator
from pathlib import PurePath
from typing import NamedTuple, TypeVar

from pydantic import BaseModel

from sigcat.adapter.core.code import planned_code
from sigcat.adapter.core.core_calls import in_order_of_due, logical_graph, planned_call, short_name
from sigcat.adapter.core.errors import (
    Resets,
    causes_of,
    errors_of,
    foreign_errors,
    reactions_of,
    short_names,
    status_items,
)
from sigcat.adapter.core.identifiers import identifier, unique
from sigcat.adapter.core.interfaces import inputs_of, outputs_of, ports_of, received
from sigcat.adapter.core.methods import methods_of
from sigcat.adapter.core.modes import mode_in, mode_out
from sigcat.adapter.core.numbers import DOUBLE, NumberType
from sigcat.adapter.core.parameters import parameters_of
from sigcat.adapter.core.plan import Call, CorePlan, Error, ModeIn, Parameter, Provenance, Reaction
from sigcat.adapter.core.planning import INIT, TERMINATE, Context, ListedCall, context_of
from sigcat.adapter.core.structs import wire_structs
from sigcat.asil import level_of
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors
from sigcat.function.checks.datatype_checks import circular_types
from sigcat.function.document.text import Text
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.walk import data, methods, parameters, parts, runnables

T = TypeVar("T")


class Planned(NamedTuple):
    """The plan of a core, and warnings about it."""

    plan: CorePlan
    findings: tuple[Finding, ...]


def derive(function: ResolvedFunction, arithmetic: NumberType = DOUBLE) -> Planned:
    """The plan of the core. Raises InputRefused with all obstacles."""
    circular = function.findings(circular_types(function.function.datatypes, may_be_lists=False))
    if circular:
        raise InputRefused(f"The core of {function.name} cannot be generated.", circular)
    context = context_of(function.function, arithmetic)
    plan = _planned(context)._replace(provenance=_provenance(function))
    findings = function.findings(context.problems)
    if has_errors(findings):
        raise InputRefused(f"The core of {function.name} cannot be generated.", findings)
    return Planned(plan, findings)


def _provenance(function: ResolvedFunction) -> Provenance:
    document = PurePath(function.document.name).name
    given = function.function.provenance
    declaration = given.declaration if given else Text(document)
    digest = given.declaration_digest if given else function.document.digest
    lines = {pointer: _line(function.position(pointer).line, item) for pointer, item in parts(function.function)}
    return Provenance(declaration, digest, document, lines)


def _line(line: int, item: BaseModel) -> str:
    level = level_of(getattr(item, "asil_level", None))
    asil = f", ASIL {level}" if level not in (None, "QM") else f", {level}" if level else ""
    return f"line {line}{asil}"


def _planned(context: Context) -> CorePlan:
    function = context.function
    listed = [ListedCall(short_name(each.runnable.name, context.name), each.pointer, each.runnable)
              for each in runnables(function)]  # fmt: skip
    mode = mode_in(context)
    out = mode_out(context)
    values = parameters_of(listed, context)
    called = methods_of(listed, context)
    calls = _calls(listed, context)
    steps = tuple(call for call, each in zip(calls, listed, strict=True) if each.is_step)
    errors, reactions = _status(listed, calls, mode, values, context)
    return CorePlan(
        function=identifier(context.name),
        version=function.info.version,
        description=function.info.description,
        code=planned_code(context),
        structs=wire_structs(_references(function), context),
        ports=received(calls, frozenset(step.name for step in steps)),
        parameters=values,
        errors=errors,
        foreign_errors=foreign_errors(errors, reactions),
        reactions=reactions,
        mode_in=mode,
        mode_out=out,
        methods=called,
        inits=_of_type(INIT, calls, listed),
        steps=steps,
        due=in_order_of_due(steps),
        terminates=_of_type(TERMINATE, calls, listed),
        arithmetic=context.arithmetic,
    )


def _references(function: FunctionJson) -> Iterator[str]:
    """Datatypes of everything that is received and sent."""
    yield from (item.datatype for walk in (data(function), parameters(function)) for _, _, item in walk)
    yield from (each.datatype for _, _, item in methods(function) for each in (*item.inputs, *item.outputs))


def _status(
    listed: list[ListedCall], calls: list[Call], mode: ModeIn | None, values: tuple[Parameter, ...], context: Context
) -> tuple[tuple[Error, ...], tuple[Reaction, ...]]:
    steps = [call for call, each in zip(calls, listed, strict=True) if each.is_step]
    declared, reacting = status_items(listed)
    taken = {output.named.name for step in steps for output in step.outputs} | {"Mode_In", "Mode_Out"}
    taken |= {item.port for call in calls for item in call.inputs if not item.is_absent}
    own = short_names(declared, context.name, "_ErrorSts", taken)
    names = short_names(reacting, context.name, "_SftyCondSts", taken)
    causes = causes_of(steps, calls, mode, values)
    errors = errors_of(declared, causes, _resets(steps), own, context)
    return errors, reactions_of(reacting, own, names, context)


def _resets(steps: list[Call]) -> Resets:
    """Places where it is known whether an input that resets errors is not 0."""
    found: dict[str, dict[str, str]] = {}
    for step in steps:
        for item in step.inputs:
            for name in item.names if item.is_reset else ():
                found.setdefault(name, {}).setdefault(step.name, f"{step.name}.in.{item.named.name}.is_set")
    return found


def _calls(listed: list[ListedCall], context: Context) -> list[Call]:
    """The calls, in the order of the file."""
    ports = ports_of([(each.at, each.call) for each in listed])
    graph = logical_graph([each.call for each in listed])
    declared, _ = status_items(listed)
    resets = frozenset(reset for each in declared if (reset := getattr(each.item, "reset", None)))
    taken: set[str] = set()
    made: list[Call] = []
    for each in listed:
        inputs = inputs_of(each.call, each.at, ports, resets, context)
        outputs = outputs_of(each.call, each.at, taken, context)
        call = planned_call(each, inputs, outputs, graph, ports, context)
        made.append(call._replace(name=unique(call.name, [other.name for other in made])))
    return made


def _of_type(run_type: str, calls: list[Call], listed: list[ListedCall]) -> tuple[Call, ...]:
    return tuple(call for call, each in zip(calls, listed, strict=True) if each.call.run_type == run_type)
