"""Calls, modes and parameters of a component."""

from collections.abc import Mapping, Sequence
from typing import TypeVar

from sigcat import codes
from sigcat.function.document.text import Text
from sigcat.function.exchange import Part
from sigcat.function.function_json.conversion import as_number, of_text
from sigcat.function.function_json.interfaces.data_interfaces import ParameterInterface
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.triggers import EVENT_TRIGGERED, triggers
from sigcat.integration.autosar_adaptive import model
from sigcat.integration.autosar_adaptive.code import CallCode, ParameterCode, code_of
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_names import distinct_names, short_name
from sigcat.integration.autosar_parts import parameter_uses

T = TypeVar("T", str, None)
_RUN_TYPES = {
    "Init": "Init",
    "Cyclic": "Cyclic",
    "EventTriggered": "Cyclic",
    "Shutdown": "Terminate",
    "Terminate": "Terminate",
}
_SCHEDULING = {"preemptive": "Preemptive", "nonpreemptive": "Non-preemptive", "rr": "RR", "fifo": "FIFO"}


def calls(part: Part, events: Mapping[int, str], context: Context) -> tuple[model.Call, ...]:
    """The calls of a component, in the order of the document. `events` are those of signals, by identity."""
    return tuple(_call(call, part, events, context) for call in part.component.runnables)


def _call(call: Runnable, part: Part, events: Mapping[int, str], context: Context) -> model.Call:
    run_type, of_group = _run_type(call, part, context), context.settings.modes
    group_mode = {"Init": of_group.init, "Terminate": of_group.terminate}.get(run_type, of_group.step)
    is_triggered = call.run_type == EVENT_TRIGGERED
    modes = tuple(mode.name for mode in part.function.modes or () if call.name in mode.runnables)
    return model.Call(
        name=call.name,
        modes=(group_mode,),
        run_type=run_type,
        cycle_time=call.cycle_time,
        scheduling=_scheduling(call, part, context),
        function=part.function_name,
        description=call.description,
        trigger="Event" if is_triggered else None,
        events=call.events,
        triggers=tuple(events[id(item)] for item in triggers(call)) or None if is_triggered else None,
        function_modes=modes or None,
        previous_runnable=call.previous_runnable,
        execution_offset=call.execution_offset,
        debounce_delay=call.debounce_delay,
        priority=call.priority,
        parallel_processing=call.parallel_processing,
        stack_size=call.stack_size,
        asil_level=call.asil_level,
        supervision_types=call.supervision_types or None,
        watchdog=call.watchdog,
        contracts=tuple(contract.type for contract in call.contracts or () if contract.type) or None,
        code=code_of(call, CallCode),
        vss_path=call.vss_path,
    )


def _run_type(call: Runnable, part: Part, context: Context) -> str:
    run_type = _RUN_TYPES.get(call.run_type)
    if call.run_type == "EventTriggered":
        message = (
            f"{call.name} runs on events, which the published schema has no run type for: it is written as Cyclic."
        )
        context.findings.report(codes.CALL_ON_EVENTS, message, call, "Read `Trigger`, which says Event.", key="Runtype")
    if run_type is None:
        message = f"The run type of {call.name} of {part.function_name} must be Init, Cyclic, EventTriggered or Shutdown, not {call.run_type!r}: it is written as Cyclic."
        context.findings.report(codes.RUN_TYPE_UNKNOWN, message, call, "Correct it in the function.", key="Runtype")
    return run_type or "Cyclic"


def _scheduling(call: Runnable, part: Part, context: Context) -> str | None:
    """None if the function leaves it open, which it may."""
    plain = "".join(character for character in call.scheduling.lower() if character.isalpha())
    if call.scheduling and plain not in _SCHEDULING:
        message = f"The scheduling of {call.name} of {part.function_name} must be Preemptive or Non-Preemptive, not {call.scheduling!r}: none is written."
        fix = "Correct it in the function."
        context.findings.report(codes.SCHEDULING_UNKNOWN, message, call, fix, key="Scheduling")
    return _SCHEDULING.get(plain)


def function_modes(part: Part) -> tuple[model.FunctionMode, ...] | None:
    """Modes of the function, with those of the calls that are this component's."""
    mine = {call.name for call in part.component.runnables}
    made = (
        model.FunctionMode(
            function=part.function_name,
            name=mode.name,
            description=mode.description,
            calls=tuple(name for name in mode.runnables if name in mine),
        )
        for mode in part.function.modes or ()
    )
    return tuple(made) or None


def parameters(part: Part, context: Context) -> tuple[model.ParameterEntry, ...] | None:
    """Parameters of a component; one that several calls use stands once, unless they describe it differently."""
    users: dict[tuple[str, bytes], list[str]] = {}
    found: dict[tuple[str, bytes], ParameterInterface] = {}
    for call, parameter in parameter_uses(part):
        key = (parameter.name, parameter.model_dump_json().encode())
        found[key] = parameter
        users.setdefault(key, []).append(call.name)
    names = distinct_names([short_name(name) for name, _ in found])
    made = (
        _parameter(name, found[key], tuple(dict.fromkeys(users[key])), part, context)
        for name, key in zip(names, found, strict=True)
    )
    return tuple(made) or None


_STORAGES = ("Calibration", "Measurement", "PersistanceMemory")
_ATTRIBUTES = ("NA", "Normal", "LearningParameter")


def _parameter(
    name: str, parameter: ParameterInterface, users: Sequence[str], part: Part, context: Context
) -> model.ParameterEntry:
    stored = {"PersistenceMemory": "PersistanceMemory"}.get(parameter.interface_type, parameter.interface_type)

    def known(word: str | None, words: Sequence[str], otherwise: T, key: str) -> str | T:
        """The word, if the published schema has it; a word of another spelling is reported, not written."""
        if word is None or word in words:
            return word or otherwise
        near = {known.lower(): known for known in words}.get(word.lower())
        message = f"{parameter.name} of {part.function_name} must be one of {', '.join(words)}, not {word!r}: {near or otherwise or 'nothing'} is written."
        context.findings.report(codes.WORD_NOT_IN_SCHEMA, message, parameter, key=key)
        return near or otherwise

    symbols = (model.Symbol(symbol=each.symbol, value=each.value) for each in parameter.vss_symbols or ())
    return model.ParameterEntry(
        name=name,
        description=parameter.description,
        datatype=_parameter_type(parameter, part, context),
        range_error_action=known(parameter.range_error_action or None, ("Default", "Init"), None, "RangeErrorAction"),
        interface_type=known(stored, _STORAGES, _STORAGES[0], "Interfacetype"),
        attribute=known(parameter.attribute, _ATTRIBUTES, _ATTRIBUTES[0], "Attribute"),
        function=part.function_name,
        calls=tuple(users),
        asil_level=parameter.asil_level,
        code_datatype=context.types.c_definition(part.function, parameter.datatype),
        variable=parameter.variable,
        vss_path=parameter.vss_path,
        vss_datatype=parameter.vss_datatype,
        vss_unit=parameter.vss_unit,
        vss_symbols=tuple(symbols) or None,
        conversion_factor=parameter.conversion_factor,
        conversion_offset=parameter.conversion_offset,
        code=code_of(parameter, ParameterCode),
    )


def _parameter_type(parameter: ParameterInterface, part: Part, context: Context) -> model.ParameterType:
    """A parameter stays inside its component and so keeps the datatype and unit of the code."""
    word = context.types.word(part.function, parameter.datatype)
    entry = context.types.entry(word)
    if entry is not None and entry.kind != "enumeration":
        fields = entry.fields or (model.StructField(name="Element", type=entry.element),)
        return model.ParameterType(
            name=word, kind="structure", fields=fields, reference=word, min=parameter.min, max=parameter.max,
            unit=parameter.units, default=parameter.default_elements or parameter.default,
            init_value=parameter.init_elements or parameter.default_elements or parameter.init_value,
        )  # fmt: skip
    if word == "string":
        text = parameter.default_text or Text("")
        return model.ParameterType(text_datatype="string", default=text, init_value=text)
    if word == "bool":
        return model.ParameterType(
            datatype="boolean", default=bool(parameter.default), init_value=bool(parameter.init_value)
        )
    return model.ParameterType(
        datatype=(entry.storage if entry else word), reference=word if entry else None,
        min=parameter.min, max=parameter.max, offset=_number(parameter.offset, 0), scaling=_number(parameter.factor, 1), unit=parameter.units,
        default=parameter.default, init_value=parameter.init_value,
    )  # fmt: skip


def _number(text: str | None, otherwise: int) -> float:
    """A number of the scaling; one that is none is left to the checks of the function."""
    number = of_text(text) if text else None
    return otherwise if number is None else as_number(number)
