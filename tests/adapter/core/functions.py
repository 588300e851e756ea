"""Functions that Hypothesis makes: small, and with every combination of the keys of a declaration."""

import json
import re
from collections.abc import Callable, Iterable
from typing import Any

from hypothesis import strategies as st

from sigcat.function.function_json.error_fields import error_fields
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.model import FunctionJson
from sigcat.names import camel_case
from tests.adapter.core.driver import CLASS_NAME, OBJECT
from tests.adapter.written import (
    BOOL,
    DOUBLE,
    FLOAT,
    S8,
    S16,
    S32,
    S64,
    U8,
    U16,
    U32,
    U64,
    Json,
    absent,
    array,
    call,
    enumeration,
    error,
    function,
    method,
    mode_interface,
    on_event,
    output,
    parameter,
    queue,
    reaction,
    signal,
    step,
    structure,
    symbols,
    watchdog,
)

NARROW = (FLOAT, U8, U16, S16, S32, DOUBLE, S8, U32, BOOL)
WIDE = (U64, S64)
WIRES = ("float", "double", "uint8", "int16", "uint16", "int32", "uint32", "int8", "boolean")
ENUMERATIONS = ("DT_Gear", "DT_Level")
STRUCTS = ("DT_Point", "DT_Mixed", "DT_Outer", "DT_Points")
ARRAYS = ("DT_Floats", "DT_Bytes", "DT_Gears", "DT_Doubles")

DATATYPES = (
    enumeration("DT_Gear", PARK=0, DRIVE=5, REVERSE=2),
    enumeration("DT_Level", "int16_t", LOW=-300, HIGH=300),
    array("DT_Floats", FLOAT, 3),
    array("DT_Doubles", DOUBLE, 2),
    array("DT_Bytes", U8, 2),
    array("DT_Gears", "DT_Gear", 2),
    structure("DT_Point", x=(FLOAT, -1, 1), y=(S16, None, 100)),
    structure("DT_Mixed", gear="DT_Gear", values="DT_Floats", flag=BOOL, big=U64),
    structure("DT_Outer", inner="DT_Point", count=(U8, 1, 3)),
    array("DT_Points", "DT_Point", 2),
)
OTHER_NUMBERS = {
    "DT_Gear": symbols(PARK=10, DRIVE=11, REVERSE=300),
    "DT_Level": symbols(LOW=1, HIGH=2),
    "DT_Gears": symbols(PARK=7, DRIVE=8, NEUTRAL=9, REVERSE=10),
}
SCALES = (("0.01", "-100"), ("0.5", "0"), ("-2", "7"), ("1", "40"), ("3", "0"))
CONVERSIONS = (("18/5", "0"), ("1/1000", "0"), ("9/5", "32"), ("134029745180/2339260349", "0"), ("-1", "0"))
LIMITS = ((0, 10), (-100, 250.5), (0.1, 69.44444444444444), (5, 5), (-1e30, 1e30), (None, 3), (-3, None))
NUMBERS = (0, 1, 3, -2.5, 0.1, 100, 69.44444444444444, 1e9)
TIMES = ("10", "0", "25", "7.5", "0.000001")


SIGNATURES: dict[str, Json] = {
    "Globals": {},
    "Pointers": {"Objects": [{"Name": OBJECT, "Type": "F_Io"}]},
    "Class": {"ClassName": CLASS_NAME},
}
_VARIABLE = re.compile(r'("(?:\w*Variable)": ")')


class Choice:
    """Choices of Hypothesis: the first of a list is the simplest."""

    def __init__(self, draw: Callable[..., Any]) -> None:
        self._draw = draw

    def one(self, *options: Any) -> Any:
        """One of these."""
        return self._draw(st.sampled_from(options))

    def some(self, options: tuple[str, ...], most: int) -> list[str]:
        """Some of these, each once."""
        return list(self._draw(st.lists(st.sampled_from(options), unique=True, max_size=most))) if options else []

    def maybe(self, **fields: Callable[[], Any]) -> Json:
        """Some of these fields."""
        return {name: made() for name, made in fields.items() if self._draw(st.booleans())}

    def count(self, least: int, most: int) -> int:
        """A number."""
        return int(self._draw(st.integers(least, most)))

    def is_so(self) -> bool:
        """Yes or no."""
        return bool(self._draw(st.booleans()))


@st.composite
def functions(draw: Callable[..., Any]) -> FunctionJson:
    """A function."""
    choice = Choice(draw)
    errors = tuple(f"E{number}" for number in range(choice.count(0, 4)))
    names = ["Step", "Fast", "Event"][: choice.count(1, 3)]
    kinds = {name: "event" if name == "Event" else choice.one("cyclic", "cyclic", "event") for name in names}
    modes = ("OFF", "ON", "SERVICE") if choice.is_so() else ()
    contents = {name: _contents(choice, name, errors) for name in names}
    _add_errors(choice, contents, errors)
    calls = [_call(choice, name, kinds[name], contents[name], names, errors) for name in names]
    calls += [call("Terminate", "Shutdown", **_checkpoint(choice, names))] if choice.is_so() else []
    interfaces = _modes(choice, modes, errors)
    signature = choice.one("Globals", "Globals", "Pointers", "Class")
    calls = [*_init(choice), *calls]
    return function(
        *(with_objects(calls) if signature == "Pointers" else calls),
        datatypes=DATATYPES,
        active={mode: choice.some(tuple(names), 3) for mode in modes[: choice.count(0, 3)]} if modes else None,
        modes=tuple(with_objects(interfaces) if signature == "Pointers" else interfaces),
        Code={"Signature": signature, "Headers": ["f.h"], **SIGNATURES[signature]},
    )


def with_objects(items: Iterable[Json]) -> list[Json]:
    """The same with all variables in one object, to which calls take a pointer."""
    text = _VARIABLE.sub(rf"\1{OBJECT}.", json.dumps(list(items)))
    return [{**item, "Arguments": [OBJECT]} if "Runtype" in item else item for item in json.loads(text)]


def _init(choice: Choice) -> list[Json]:
    if not choice.is_so():
        return []
    hooks = choice.maybe(PreProcessing=lambda: ["before_init"], SuccessValue=lambda: choice.one(0, 3))
    return [call("Init", "Init", **hooks, **_checkpoint(choice, ["Step"]))]


# -- calls --------------------------------------------------------------------------------------------------------


def _call(
    choice: Choice, name: str, kind: str, contents: list[Json], names: list[str], errors: tuple[str, ...]
) -> Json:
    others = [other for other in names if other < name]
    fields = choice.maybe(
        Priority=lambda: choice.one("1", "9", "high"),
        DebounceDelay=lambda: choice.one("5", "12", "0"),
        ParallelProcessing=choice.is_so,
        PrevRunnable=lambda: f"F_{choice.one(*others, 'Init')}",
        PreProcessing=lambda: [f"before_{name.lower()}"],
        PostProcessing=lambda: [f"after_{name.lower()}"],
    )
    if errors:
        fields |= choice.maybe(Watchdog=lambda: _watchdog(choice, errors, kind))
    fields |= _checkpoint(choice, names)
    if kind == "event":
        return on_event(*contents, name=name, **fields)
    fields |= choice.maybe(ExecOffset=lambda: choice.one("3", "12.5"))
    fields |= choice.maybe(OverrunError=lambda: choice.one(*errors)) if errors else {}
    return step(*contents, name=name, cycle=choice.one(10, 4, 25), **fields)


def _watchdog(choice: Choice, errors: tuple[str, ...], kind: str) -> Json:
    alive = (
        (choice.one(2, 0, 3), choice.one(3, 4), 3, choice.one(*errors)) if kind == "cyclic" and choice.is_so() else None
    )
    deadline = (choice.one(0, 2), choice.one(5, 8.25), choice.one(*errors)) if choice.is_so() else None
    return watchdog(alive, deadline, choice.one(*errors) if choice.is_so() else None)


def _checkpoint(choice: Choice, names: list[str]) -> Json:
    if not choice.is_so():
        return {}
    following = [f"F_{name}" for name in choice.some(tuple(names), 2)]
    return {"Checkpoint": {"BeginsSequence": choice.is_so(), "EndsSequence": choice.is_so(), "Next": following}}


def _contents(choice: Choice, name: str, errors: tuple[str, ...]) -> list[Json]:
    """Variables that a call reads and writes. Names say to what they belong."""
    letter = name[0]
    found = [_input(choice, f"{letter}In{number}", errors) for number in range(choice.count(0, 3))]
    found += [_queue(choice, f"{letter}Queue{number}", errors) for number in range(choice.count(0, 1))]
    found = [_maybe_absent(choice, item, errors) for item in found]
    found += [_output(choice, f"{letter}Out{number}", errors) for number in range(choice.count(0, 2))]
    found += [_output_queue(choice, f"{letter}Given{number}", errors) for number in range(choice.count(0, 1))]
    found += [_parameter(choice, f"{letter}Par{number}", errors) for number in range(choice.count(0, 2))]
    found += [_reaction(choice, f"React{number}", errors) for number in range(choice.count(0, 1))]
    found += _methods(choice, letter) if choice.is_so() else []
    if name == "Event" and not any("Role" in item and item["Role"] == "Consumer" for item in found):
        found.append(signal("EIn"))
    if name != "Step" and choice.is_so():
        shared = signal(
            "Same", choice.one(FLOAT, U16), Variable=f"{letter.lower()}same", VssPath="Shared", VssDatatype="float"
        )
        return [*found, {**shared, **_time_out(choice, errors)}]
    return found


def _add_errors(choice: Choice, contents: dict[str, list[Json]], errors: tuple[str, ...]) -> None:
    """Every error belongs to a call, and may be listed by another one."""
    inputs = tuple(item["Name"] for items in contents.values() for item in items if item.get("Role") == "Consumer")
    for index, name in enumerate(errors):
        made = error(name, *choice.some((*errors[:index], "Foreign"), 2), **_error_fields(choice, name, inputs))
        for step_name in choice.some(tuple(contents), 2) or [next(iter(contents))]:
            contents[step_name].append(made)


def _error_fields(choice: Choice, name: str, inputs: tuple[str, ...]) -> Json:
    return choice.maybe(
        Variable=lambda: f"var_{name.lower()}",
        StatusVariable=lambda: f"sts_{name.lower()}",
        MaturationTime=lambda: choice.one(10, 25),
        ResetTime=lambda: choice.one(15, 7.5),
        Reset=lambda: choice.one("Restart", *inputs),
        OccurenceCountLimit=lambda: choice.one(1, 3),
        IgnitionCountLimit=lambda: choice.one(1, 2),
    )


# -- values -------------------------------------------------------------------------------------------------------


def _datatype(choice: Choice) -> str:
    kind = choice.one("number", "number", "wide", "enumeration", "array", "struct")
    pools = {"number": NARROW, "wide": WIDE, "enumeration": ENUMERATIONS, "array": ARRAYS, "struct": STRUCTS}
    return str(choice.one(*pools[kind]))


def _value(choice: Choice, datatype: str) -> Json:
    """Datatype, limits and substitute of a value."""
    fields: Json = {}
    if datatype in OTHER_NUMBERS and choice.is_so():
        fields = {"VssDatatype": choice.one("string", "uint16"), "VssSymbols": OTHER_NUMBERS[datatype]}
    elif datatype in (*NARROW, "DT_Floats", "DT_Bytes", "DT_Doubles"):
        fields = _scaled(choice, datatype)
    elif datatype in WIDE:
        fields = choice.maybe(VssDatatype=lambda: choice.one(*WIRES, "uint64", "int64"))
    if datatype not in ENUMERATIONS:
        low, high = choice.one(*LIMITS)
        fields |= (
            {name: end for name, end in (("Min", low), ("Max", high)) if end is not None} if choice.is_so() else {}
        )
    return fields | _substitutes(choice, datatype)


def _scaled(choice: Choice, datatype: str) -> Json:
    fields: Json = {}
    ending = "" if datatype in NARROW else "[]"
    if choice.is_so():
        fields["VssDatatype"] = choice.one(*WIRES) + ending
        if choice.is_so():
            fields["ConversionFactor"], fields["ConversionOffset"] = choice.one(*CONVERSIONS)
    if choice.is_so():
        fields["Factor"], fields["Offset"] = choice.one(*SCALES)
    return fields


def _substitutes(choice: Choice, datatype: str) -> Json:
    if datatype in ENUMERATIONS:
        number = 5 if datatype == "DT_Gear" else 300
        return choice.maybe(Default=lambda: number, InitValue=lambda: number)
    numbers = (5, 2) if datatype == "DT_Gears" else NUMBERS
    fields = choice.maybe(Default=lambda: choice.one(*numbers), InitValue=lambda: choice.one(*numbers))
    elements = {
        "DT_Floats": "[1, 2.5]", "DT_Bytes": "[1, 2]", "DT_Gears": "[5, 2]", "DT_Point": '{"x": 0.5, "y": 7}',
        "DT_Mixed": '{"gear": "DRIVE", "values": [1, 2, 3], "flag": true, "big": 18446744073709551615}',
        "DT_Outer": '{"inner": {"x": 0.25, "y": -3}, "count": 2}', "DT_Points": '[{"x": 1, "y": 2}, {"x": -1, "y": 3}]',
    }.get(datatype)  # fmt: skip
    if elements is not None:
        fields |= choice.maybe(DefaultElements=lambda: elements, InitElements=lambda: elements)
    return fields


def _checked(choice: Choice, errors: tuple[str, ...]) -> Json:
    fields = choice.maybe(RangeErrorAction=lambda: choice.one("Default", "Init"))
    return fields | (choice.maybe(RangeError=lambda: choice.one(*errors)) if errors else {})


def _time_out(choice: Choice, errors: tuple[str, ...]) -> Json:
    if not choice.is_so():
        return {}
    fields = choice.maybe(
        TimeoutStart=lambda: choice.one("Init", "First"),
        TimeoutValue=lambda: choice.one("Last", "Default", "Init"),
        TimeoutRecovery=lambda: choice.one(1, 3),
        TimeoutError=lambda: choice.one(*(errors or ("Nobody",))),
    )
    return {"Timeout": choice.one("20", "10", "35.5", "0"), **fields}


DATA_ERRORS = error_fields(Signal, DataQueue)
"""Fields of data that name an error which the core sets."""
_FOUND_BY_CONSUMERS = tuple(camel_case(field) for field, mark in DATA_ERRORS.items() if mark.is_of_consumer)


def _found(choice: Choice, errors: tuple[str, ...]) -> Json:
    """Errors of conditions that only a consumer finds."""
    return choice.maybe(**dict.fromkeys(_FOUND_BY_CONSUMERS, lambda: choice.one(*errors))) if errors else {}


def _maybe_absent(choice: Choice, item: Json, errors: tuple[str, ...]) -> Json:
    """The same, often optional, and sometimes absent."""
    item |= choice.maybe(AbsentError=lambda: choice.one(*errors)) if errors else {}
    return absent(item) if choice.count(0, 4) == 4 else item


def _input(choice: Choice, name: str, errors: tuple[str, ...]) -> Json:
    datatype = _datatype(choice)
    fields = _value(choice, datatype) | _checked(choice, errors) | _time_out(choice, errors)
    fields |= _found(choice, errors)
    fields |= choice.maybe(Access=lambda: choice.one("Buffered", "Immediate"))
    return signal(name, datatype, **fields)


def _queue(choice: Choice, name: str, errors: tuple[str, ...]) -> Json:
    datatype = choice.one(*NARROW, "DT_Gear", "DT_Bytes", "DT_Point")
    fields = _value(choice, datatype) | _checked(choice, errors) | _time_out(choice, errors)
    fields |= _found(choice, errors)
    fields |= choice.maybe(
        Access=lambda: choice.one("Buffered", "Immediate"),
        Overflow=lambda: choice.one("DropOldest", "DropNewest"),
        CountVariable=lambda: f"{name.lower()}_n",
    )
    fields |= choice.maybe(OverflowError=lambda: choice.one(*errors)) if errors else {}
    length = choice.one(2, 1, 5)
    if datatype not in ("DT_Bytes", "DT_Point"):
        fields["ValuesPerStep"] = choice.one(1, 2, length)
        fields["ValuesPerStep"] = min(fields["ValuesPerStep"], length)
    scale = {"Factor": float(fields.pop("Factor", 1)), "Offset": float(fields.pop("Offset", 0))}
    return queue(name, length, datatype, **{**fields, **scale})


def _output(choice: Choice, name: str, errors: tuple[str, ...]) -> Json:
    datatype = _datatype(choice)
    return output(name, datatype, **_value(choice, datatype), **_checked(choice, errors))


def _output_queue(choice: Choice, name: str, errors: tuple[str, ...]) -> Json:
    datatype = choice.one(*NARROW, "DT_Gear")
    fields = _value(choice, datatype) | _checked(choice, errors)
    fields |= choice.maybe(CountVariable=lambda: f"{name.lower()}_n")
    fields |= choice.maybe(OverflowError=lambda: choice.one(*errors)) if errors else {}
    scale = {"Factor": float(fields.pop("Factor", 1)), "Offset": float(fields.pop("Offset", 0))}
    return queue(name, choice.one(3, 1), datatype, "Provider", **{**fields, **scale})


def _parameter(choice: Choice, name: str, errors: tuple[str, ...]) -> Json:
    datatype = _datatype(choice)
    fields = _value(choice, datatype)
    elements = fields.pop("DefaultElements", None)
    fields |= {"DefaultText": elements} if elements else {}
    low, high = fields.pop("Min", 0), fields.pop("Max", 0 if datatype in (*ARRAYS, *STRUCTS) else 100)
    fields |= choice.maybe(RangeError=lambda: choice.one(*errors)) if errors else {}
    fields |= choice.maybe(
        RangeErrorAction=lambda: choice.one("Init", "Default"), Attribute=lambda: "LearningParameter"
    )
    return parameter(name, datatype, low, high, **fields)


def _reaction(choice: Choice, name: str, errors: tuple[str, ...]) -> Json:
    listed = choice.some((*errors, "Strange"), 3)
    fields = choice.maybe(Initial=lambda: choice.one("INACTIVE", "ACTIVE"), Timeout=lambda: choice.one("20", "10"))
    return reaction(name, *listed, **fields)


def _methods(choice: Choice, letter: str) -> list[Json]:
    inputs = choice.one({}, {f"{letter}Arg": U8}, {f"{letter}Arg": "DT_Gear", f"{letter}More": "DT_Floats"})
    outputs = choice.one({}, {f"{letter}Res": DOUBLE}, {f"{letter}Res": "DT_Gear", f"{letter}Also": "DT_Bytes"})
    if choice.is_so():
        return [method(f"{letter}Offer", "Provider", inputs, outputs, Symbol=f"{letter.lower()}_offer")]
    known = {"RequestVariable": f"{letter.lower()}_ask", "StatusVariable": f"{letter.lower()}_status"}
    fields = choice.maybe(Timeout=lambda: choice.one("20", "10"))
    return [method(f"{letter}Use", "Consumer", inputs, outputs, **known, **fields)]


# -- modes --------------------------------------------------------------------------------------------------------


def _modes(choice: Choice, modes: tuple[str, ...], errors: tuple[str, ...]) -> tuple[Json, ...]:
    found = []
    if modes:
        fields = choice.maybe(
            Initial=lambda: choice.one(*modes),
            UnknownAction=lambda: choice.one("Keep", "Initial"),
            Values=lambda: symbols(OFF=0, ON=-1, SERVICE=70000),
        )
        fields |= choice.maybe(UnknownError=lambda: choice.one(*errors)) if errors else {}
        found.append(mode_interface("In", *modes, **fields))
    if choice.is_so():
        found.append(mode_interface("Out", "OFF", "ON", **choice.maybe(Values=lambda: symbols(OFF=5, ON=6))))
    return tuple(found)
