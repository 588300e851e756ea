"""The code of a function on its page: its calls, and the adapter's use of each variable."""

from collections.abc import Iterator
from typing import NamedTuple

from sigcat.function.function_json.code import CLASS, POINTERS, CodeInterface
from sigcat.function.function_json.conversion import as_text, of_text
from sigcat.function.function_json.error_fields import errors_set_by
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.walk import declared_data, errors, methods, parameters, runnables, safety_reactions


class CallRow(NamedTuple):
    """A call in C."""

    name: str
    symbol: str
    """With its arguments: `Acc_step(Acc_M)`."""
    notes: tuple[str, ...]


class VariableRow(NamedTuple):
    """An interface in C."""

    name: str
    path: str
    variables: tuple[str, ...]
    notes: tuple[str, ...]


class CodeView(NamedTuple):
    """The code of a function."""

    facts: tuple[tuple[str, tuple[str, ...]], ...]
    """Words with a value of the code section."""
    calls: tuple[CallRow, ...]
    variables: tuple[VariableRow, ...]


def code_view(function: FunctionJson) -> CodeView | None:
    """The code of a function; None if its document says nothing of it."""
    calls = tuple(_call(located.runnable) for located in runnables(function))
    variables = tuple(dict.fromkeys(row for row in _variables(function) if row.variables or row.notes))
    is_told = function.code is not None or variables or any(call.notes for call in calls)
    return CodeView(_facts(function.code) if function.code else (), calls, variables) if is_told else None


# -- the code as a whole ------------------------------------------------------------------------------------------

_SIGNATURES = {POINTERS: "functions that take pointers to the objects of an instance", CLASS: "members of a class"}


def _facts(code: CodeInterface) -> tuple[tuple[str, tuple[str, ...]], ...]:
    objects = [f"{each.declaration}{f' ← {each.member}' if each.member else ''}" for each in code.objects or ()]
    named = {
        "Calls": (_SIGNATURES.get(code.signature, "functions over global variables"),),
        "Class": (code.class_name,) if code.class_name else (),
        "Sources": code.sources or (),
        "Headers": code.headers or (),
        "Include folders": code.include_folders or (),
        "Definitions": tuple(each.as_option for each in code.definitions or ()),
        "Objects": tuple(objects),
        "Storage": (code.storage,) if code.storage else (),
    }
    return tuple((word, values) for word, values in named.items() if values)


def _call(call: Runnable) -> CallRow:
    checkpoint = call.checkpoint
    notes = [
        f"{call.success_value} means success" if call.success_value is not None else "",
        f"before it {', '.join(call.pre_processing)}" if call.pre_processing else "",
        f"after it {', '.join(call.post_processing)}" if call.post_processing else "",
        "begins a sequence" if checkpoint and checkpoint.initial else "",
        f"followed by {', '.join(checkpoint.next)}" if checkpoint and checkpoint.next else "",
        "may end a sequence" if checkpoint and checkpoint.final else "",
        f"missed: sets {call.overrun_error}" if call.overrun_error else "",
    ]
    return CallRow(call.name, f"{call.symbol or call.name}({', '.join(call.arguments or ())})", _said(notes))


# -- variables ----------------------------------------------------------------------------------------------------


def _variables(function: FunctionJson) -> Iterator[VariableRow]:
    for _, _, item in declared_data(function):
        count = item.count_variable if isinstance(item, DataQueue) else None
        yield _row(item.name, item.vss_path, (item.variable, count), _of_data(item))
    for _, _, parameter in parameters(function):
        yield _row(parameter.name, parameter.vss_path, (parameter.variable,), _of_parameter(parameter))
    for _, _, error in errors(function):
        yield _row(error.name, error.vss_path, (error.variable, error.status_variable), _of_error(error))
    for _, _, reaction in safety_reactions(function):
        yield _row(reaction.name, reaction.vss_path, (reaction.variable,), _of_reaction(reaction))
    for mode in function.mode_interfaces or ():
        yield _row(mode.name, mode.vss_path, (mode.variable,), _of_mode(mode))
    for _, _, method in methods(function):
        yield _row(method.name, None, _of_arguments(method), _of_method(method))


def _row(name: str, path: str | None, variables: tuple[str | None, ...], notes: list[str]) -> VariableRow:
    return VariableRow(name, path or "", tuple(filter(None, variables)), _said(notes))


def _said(notes: list[str]) -> tuple[str, ...]:
    return tuple(filter(None, notes))


def _of_data(item: Signal | DataQueue) -> list[str]:
    return [
        _defined(item),
        _scaled(item),
        _optional(item),
        f"starts with {item.init_elements.raw}" if item.init_elements else "",
        _late(item),
        _out_of_range(item.range_error_action, item.range_error),
        *(f"{each.mark.cause}: sets {each.error}" for each in errors_set_by(item) if each.mark.cause),
        _queued(item) if isinstance(item, DataQueue) else "",
        _members(item),
    ]


def _scaled(item: Signal | DataQueue | ParameterInterface) -> str:
    """The meaning of a stored number that is not the physical value itself."""
    factor, offset = str(item.factor or 1), str(item.offset or 0)
    if of_text(factor) in (1, None) and of_text(offset) in (0, None):
        return ""
    shift = of_text(offset)
    added = f" {'-' if shift < 0 else '+'} {as_text(abs(shift))}" if shift else ""
    return f"number × {factor}{added}{f' {item.units}' if item.units else ''}"


def _optional(item: Signal | DataQueue) -> str:
    sets = f": without the signal, sets {item.absent_error}" if item.absent_error else ""
    return f"optional{sets}" if item.is_optional else ""


def _late(item: Signal | DataQueue) -> str:
    if item.timeout is None:
        return ""
    late = f"late after {item.timeout} ms{' from the first value on' if item.timeout_start == 'First' else ''}"
    said = [
        {"Default": "takes the default", "Init": "takes the start value"}.get(
            item.timeout_value or "", "keeps the last"
        ),
        f"until {item.timeout_recovery} values came" if (item.timeout_recovery or 1) > 1 else "",
        f"sets {item.timeout_error}" if item.timeout_error else "",
    ]
    return f"{late}: {', '.join(filter(None, said))}"


def _out_of_range(action: str | None, error: str | None) -> str:
    replaced = {"Default": "takes the default", "Init": "takes the start value"}.get(action or "", "")
    said = ", ".join(filter(None, (replaced, f"sets {error}" if error else "")))
    return f"out of range: {said}" if said else ""


def _queued(item: DataQueue) -> str:
    said = [
        f"queue of {item.queue_length}",
        f"{item.values_per_step} at once" if (item.values_per_step or 1) > 1 else "",
        f"full: drops the {'newest' if item.overflow == 'DropNewest' else 'oldest'}",
        f"sets {item.overflow_error}" if item.overflow_error else "",
    ]
    return ", ".join(filter(None, said))


def _members(item: Signal | DataQueue | ParameterInterface) -> str:
    names = ", ".join(f"{each.name} is {each.member}" for each in item.members or ())
    return f"members: {names}" if names else ""


def _defined(item: Signal | DataQueue | ParameterInterface | ErrorInterface | SafetyReaction | ModeInterface) -> str:
    as_type = f" as {item.c_type}" if item.c_type else ""
    return f"defined by the adapter{as_type}" if item.defined_by == "Adapter" else ""


def _of_parameter(parameter: ParameterInterface) -> list[str]:
    key = f"key {parameter.key}" if parameter.key else ""
    stored = " ".join(filter(None, (key, f"in {parameter.storage}" if parameter.storage else "")))
    return [
        _defined(parameter),
        _scaled(parameter),
        f"starts with {parameter.init_elements.raw}" if parameter.init_elements else "",
        _out_of_range(parameter.range_error_action, parameter.range_error),
        f"stored under {stored}" if key else f"stored {stored}" if stored else "",
        _members(parameter),
    ]


def _of_error(error: ErrorInterface) -> list[str]:
    reset = "a restart" if error.reset == "Restart" else error.reset
    return [_defined(error), f"reset by {reset}" if reset else ""]


def _of_reaction(reaction: SafetyReaction) -> list[str]:
    initial = f"initially {reaction.initial}" if reaction.initial else ""
    silent = f"ACTIVE after {reaction.timeout} ms without a value" if reaction.timeout else ""
    return [_defined(reaction), initial, silent]


def _of_mode(mode: ModeInterface) -> list[str]:
    unknown = {"Keep": "keeps the last", "Initial": "takes the initial one"}.get(mode.unknown_action or "", "")
    said = ", ".join(filter(None, (unknown, f"sets {mode.unknown_error}" if mode.unknown_error else "")))
    return [
        _defined(mode),
        f"initially {mode.initial}" if mode.initial else "",
        f"unknown: {said}" if said else "",
        ", ".join(f"{each.symbol} is {each.value}" for each in mode.values or ()),
    ]


def _of_arguments(method: MethodInterface) -> tuple[str | None, ...]:
    arguments = (each.variable for each in (*method.inputs, *method.outputs))
    return (method.request_variable, *arguments, method.status_variable)


def _of_method(method: MethodInterface) -> list[str]:
    done = f"done by {method.symbol or method.name}" if method.role == PROVIDER and method.symbol else ""
    return [done, f"answered within {method.timeout} ms" if method.timeout else ""]
