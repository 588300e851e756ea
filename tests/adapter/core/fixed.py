"""Functions that are always tried: one for each subject of docs/reference/adapter.md, with all that it can say of it."""

from collections.abc import Callable

from sigcat.function.function_json.model import FunctionJson
from tests.adapter.core.functions import DATATYPES, OTHER_NUMBERS, with_objects
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
    call,
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
    symbols,
    watchdog,
)

GLOBALS: Json = {"Code": {"Signature": "Globals", "Headers": ["f.h"]}}
KMH: Json = {"ConversionFactor": "18/5", "ConversionOffset": "0"}
FAHRENHEIT: Json = {"ConversionFactor": "9/5", "ConversionOffset": "32"}
SCALED: Json = {"Factor": "0.01", "Offset": "-100"}
LIMITED: Json = {"Min": -10, "Max": 69.44444444444444, "Default": 2.5, "InitValue": 3}
DEFAULT: Json = {"RangeErrorAction": "Default"}
INIT: Json = {"RangeErrorAction": "Init"}


def conversions() -> FunctionJson:
    """Every kind of number, from and to every other one."""
    pairs = [
        (FLOAT, "double"), (FLOAT, "uint8"), (FLOAT, "int64"), (DOUBLE, "float"), (DOUBLE, "uint32"), (DOUBLE, "boolean"),
        (U8, "float"), (U8, "double"), (U8, "uint16"), (U8, "int8"), (S8, "uint8"), (S8, "uint64"), (U16, "int32"),
        (S16, "float"), (U32, "uint64"), (S32, "int64"), (U64, "double"), (U64, "int8"), (S64, "uint64"), (S64, "float"),
        (BOOL, "float"), (BOOL, "uint8"), (FLOAT, "boolean"), (U64, "boolean"),
    ]  # fmt: skip
    inputs = [signal(f"In{n}", code, VssDatatype=wire, InitValue=1) for n, (code, wire) in enumerate(pairs)]
    outputs = [output(f"Out{n}", code, VssDatatype=wire, Default=2) for n, (code, wire) in enumerate(pairs)]
    scaled = [
        signal("Speed", FLOAT, VssDatatype="float", **KMH),
        signal("Rounded", U8, VssDatatype="double", **KMH, Default=7),
        signal("Stored", U16, VssDatatype="float", **SCALED, InitValue=-50),
        signal("Both", S16, VssDatatype="double", **SCALED, **FAHRENHEIT, Default=20),
        signal("Turned", S32, VssDatatype="int16", Factor="-2", Offset="7"),
        signal("Shifted", FLOAT, VssDatatype="float", Factor="1", Offset="40"),
        signal("Sensitive", DOUBLE, VssDatatype="double", Factor="0.01", Offset="123.45"),
        output("Sent", U16, VssDatatype="float", **SCALED),
        output("SentSpeed", FLOAT, VssDatatype="uint8", **KMH, Default=5),
        output("SentBack", DOUBLE, VssDatatype="float", **FAHRENHEIT),
        output("SentTurned", S32, VssDatatype="int16", Factor="-2", Offset="7"),
    ]
    return function(step(*inputs, *outputs, *scaled, signal("Value", FLOAT, Min=0, **DEFAULT)), datatypes=DATATYPES)


def ranges() -> FunctionJson:
    """Limits, and what happens beyond them."""
    error_of: Json = {"RangeError": "E0"}
    return function(
        step(
            signal("Plain", FLOAT, **LIMITED, **DEFAULT),
            signal("Start", DOUBLE, **LIMITED, **INIT, **error_of, VssDatatype="double", **KMH),
            signal("Passing", U8, **LIMITED, **error_of, VssDatatype="float"),
            signal("Inward", S16, Min=1.5, Max=3.5, **DEFAULT),
            signal("Turned", S16, Min=-5, Max=5, **DEFAULT, VssDatatype="int8", Factor="-1", Offset="0"),
            signal("Open", FLOAT, **DEFAULT, Default=1),
            signal("Nothing", U8, Min=300, Max=400, **DEFAULT, Default=9),
            signal("Late", FLOAT, **LIMITED, **DEFAULT, RangeError="E1", Access="Immediate"),
            signal("Gear", "DT_Gear", VssDatatype="string", VssSymbols=OTHER_NUMBERS["DT_Gear"], **error_of),
            signal("Level", "DT_Level", **DEFAULT, Default=300),
            signal("Gears", "DT_Gears", InitElements="[5, 2]"),
            signal(
                "Floats", "DT_Floats", **LIMITED, **DEFAULT, DefaultElements="[1, 2.5]", VssDatatype="float[]", **KMH
            ),
            signal("Point", "DT_Point", **INIT, InitElements='{"x": 0.5, "y": 7}'),
            signal("Mixed", "DT_Mixed", RangeError="E1"),
            signal("Points", "DT_Points", **DEFAULT, DefaultElements='[{"x": 1, "y": 2}, {"x": -1, "y": 3}]'),
            output("OutPlain", FLOAT, **LIMITED, **DEFAULT, RangeError="E2"),
            output("OutStart", U8, Min=1, Max=9, **INIT, InitValue=4, VssDatatype="float"),
            output("OutPassing", S16, Min=1, Max=9, RangeError="E2", VssDatatype="int8"),
            output("OutGear", "DT_Gear", VssDatatype="uint16", VssSymbols=OTHER_NUMBERS["DT_Gear"]),
            output("OutMixed", "DT_Mixed", RangeError="E2"),
            output("OutOuter", "DT_Outer", **DEFAULT, DefaultElements='{"inner": {"x": 0.25, "y": -3}, "count": 2}'),
            error("E0"),
            error("E1"),
            error("E2"),
        ),
        datatypes=DATATYPES,
        **GLOBALS,
    )


def queues() -> FunctionJson:
    """Values that wait, and calls that they trigger."""
    return function(
        step(
            queue("Oldest", 3, FLOAT, ValuesPerStep=2, CountVariable="oldest_n", OverflowError="E0"),
            queue("Newest", 2, U16, VssDatatype="float", Overflow="DropNewest", OverflowError="E1", InitValue=7),
            queue("Immediate", 5, S16, Access="Immediate", ValuesPerStep=4, OverflowError="E0", CountVariable="imm_n"),
            queue("Checked", 4, U8, Min=1, Max=9, **DEFAULT, Default=5, RangeError="E2", ValuesPerStep=3),
            queue("Passing", 2, FLOAT, Min=1, Max=9, RangeError="E2"),
            queue("Gears", 3, "DT_Gear", ValuesPerStep=2),
            queue(
                "Hidden",
                3,
                U8,
                Timeout="20",
                TimeoutValue="Default",
                Default=9,
                TimeoutRecovery=2,
                CountVariable="hid_n",
            ),
            queue("Started", 3, U8, Timeout="20", TimeoutValue="Init", InitValue=4, TimeoutError="E0"),
            queue("Rows", 2, "DT_Bytes"),
            signal("I"),
            queue("Given", 3, U8, "Provider", CountVariable="given_n", OverflowError="E3", VssDatatype="float"),
            queue("Single", 3, FLOAT, "Provider", Min=0, Max=5, **DEFAULT, Default=1, RangeError="E3"),
            *(error(f"E{number}") for number in range(4)),
            signal("Same", VssPath="Same", VssDatatype="float"),
        ),
        on_event(queue("Trigger", 3, U8, OverflowError="E4"), error("E4"), name="Event", DebounceDelay="5"),
        on_event(
            signal("Other", U8, VssPath="Same", Variable="event_same", VssDatatype="float"),
            signal("Ignored"),
            name="Merge",
            EventList="Same",
        ),
        on_event(
            queue("Burst", 5, U8, ValuesPerStep=3, CountVariable="burst_n"),
            queue("Bursts", 4, U8, ValuesPerStep=2, CountVariable="bursts_n"),
            name="Several",
        ),
        datatypes=DATATYPES,
        active={"ON": ["Step", "Event", "Merge", "Several"], "OFF": ["Step"]},
        modes=(mode_interface("In", "ON", "OFF"),),
        **GLOBALS,
    )


def time_outs() -> FunctionJson:
    """Values that are late, and the reactions to silence."""
    late: Json = {"Timeout": "20", "Default": 2, "InitValue": 1}
    return function(
        step(
            signal("Last", **late, TimeoutError="E0"),
            signal("Standing", **late, TimeoutError="E1", TimeoutValue="Default", TimeoutRecovery=3),
            signal("Init", U8, **late, TimeoutError="E2", TimeoutValue="Init", TimeoutStart="First"),
            signal("Immediate", **late, TimeoutError="E3", TimeoutValue="Default", Access="Immediate"),
            signal("Checked", **{**late, "Timeout": "7.5"}, **LIMITED_AGAIN, TimeoutValue="Init"),
            signal("Shared", VssPath="Shared", **late, TimeoutError="E0"),
            *(error(f"E{number}") for number in range(4)),
            reaction("Silent", Timeout="20"),
            reaction("Silence", "E1", Timeout="10", Initial="ACTIVE"),
        ),
        step(
            signal("SharedToo", VssPath="Shared", Timeout="35", TimeoutValue="Default", Default=8, TimeoutRecovery=2),
            reaction("Silent", Timeout="20"),
            name="Second",
            cycle=25,
        ),
        active={"ON": ["Step", "Second"], "OFF": ["Second"], "STOP": []},
        modes=(mode_interface("In", "ON", "OFF", "STOP"),),
        **GLOBALS,
    )


LIMITED_AGAIN: Json = {"Min": 0, "Max": 10, "RangeErrorAction": "Default"}


def rejections() -> FunctionJson:
    """Messages that are not accepted, of signals and queues, for one call or two."""
    late: Json = {"Timeout": "20", "TimeoutError": "E3"}
    return function(
        step(
            signal("Plain", E2eError="E0"),
            signal("Immediate", **late, Access="Immediate", E2eError="E1"),
            queue("Row", 3, U8, ValuesPerStep=2, CountVariable="row_n", OverflowError="E3", E2eError="E1"),
            signal("Shared", VssPath="Shared", E2eError="E2"),
            *(error(f"E{number}", StatusVariable=f"e{number}_sts") for number in range(4)),
        ),
        step(signal("SharedToo", VssPath="Shared", E2eError="Other"), error("Other"), name="Second", cycle=25),
        on_event(queue("Trigger", 2, U8, E2eError="E4"), error("E4"), name="Event"),
        active={"ON": ["Step", "Second", "Event"], "OFF": ["Second"]},
        modes=(mode_interface("In", "ON", "OFF"),),
        **GLOBALS,
    )


def optional() -> FunctionJson:
    """Optional signals that the vehicle has, and those that it does not have."""
    return function(
        step(
            signal("There", Optional=True, AbsentError="E0", Min=0, Max=5, RangeError="E0"),
            absent(signal("Plain", InitValue=7, AbsentError="E1")),
            absent(signal("Scaled", U8, Default=3, Factor="0.5", VssDatatype="float", Access="Immediate")),
            absent(
                signal(
                    "Watched",
                    FLOAT,
                    InitValue=2,
                    Min=5,
                    Max=9,
                    **DEFAULT,
                    RangeError="E2",
                    Timeout="20",
                    TimeoutError="E2",
                )
            ),
            absent(signal("Gear", "DT_Gear", InitValue=5)),
            absent(signal("Floats", "DT_Floats", InitElements="[1, 2.5, 3]")),
            absent(signal("Point", "DT_Point", InitElements='{"x": 0.5, "y": 7}')),
            absent(queue("Row", 3, U8, ValuesPerStep=2, CountVariable="row_n", InitValue=4, OverflowError="E2")),
            absent(signal("Heal", U8, InitValue=1)),
            absent(signal("Never", U8)),
            absent(output("Out", Min=0, Max=1, RangeError="E2")),
            error("E0", StatusVariable="e0_sts"),
            error("E1", StatusVariable="e1_sts", MaturationTime=20),
            error("E2"),
            error("Heals", Variable="heals", Reset="Heal", ResetTime=10),
            error("Stays", Variable="stays", Reset="Never"),
            reaction("Any", "E1"),
        ),
        step(absent(signal("Plain", Variable="second_plain", InitValue=8)), output("Given"), name="Second", cycle=25),
        on_event(absent(signal("Trigger", U8)), signal("Other", U8), name="Event", EventList="Trigger"),
        on_event(absent(signal("Merged", U8)), signal("Some", U8), name="Merge"),
        active={"ON": ["Step", "Second", "Event", "Merge"], "OFF": ["Second"]},
        modes=(mode_interface("In", "ON", "OFF"),),
        datatypes=DATATYPES,
        **GLOBALS,
    )


def errors() -> FunctionJson:
    """States of errors, with every cause."""
    return function(
        step(
            signal("Heal", U8),
            signal("T"),
            signal("Range", Min=0, Max=10, RangeError="Early"),
            output("Out", Min=0, Max=10, RangeError="Mature"),
            error("Mature", Variable="mature", MaturationTime=20, ResetTime=15, StatusVariable="mature_sts"),
            error("Plain", Variable="plain", OccurenceCountLimit=3, IgnitionCountLimit=1),
            error("Restart", Variable="restart", Reset="Restart", OccurenceCountLimit=2),
            error("Heals", Variable="heals", Reset="Heal", ResetTime=10, IgnitionCountLimit=2),
            error("Early", StatusVariable="early_sts", MaturationTime=10),
            error("Depends", "Plain", "Foreign", Variable="depends", MaturationTime=30, ResetTime=5),
            error("Chain", "Depends", StatusVariable="chain_sts"),
            reaction("Any", "Mature", "Plain"),
            reaction("Outside"),
            reaction("First", Initial="ACTIVE"),
            reaction("Strange", "Stranger", "Heals"),
        ),
        step(error("Plain", Variable="plain", StatusVariable="plain_sts"), reaction("Any"), name="Second", cycle=25),
        active={"ON": ["Step", "Second"], "OFF": []},
        modes=(mode_interface("In", "ON", "OFF", UnknownError="Plain", UnknownAction="Keep"),),
        **GLOBALS,
    )


def schedules() -> FunctionJson:
    """Calls of several cycles, in modes."""
    return function(
        call("Init", "Init", PreProcessing=["before_init"]),
        step(error("Missed", MaturationTime=0), OverrunError="Missed", Priority="1", PostProcessing=["after_step"]),
        step(name="Fast", cycle=4, Priority="9", PrevRunnable="F_Step", ExecOffset="3"),
        step(name="Slow", cycle=25, DebounceDelay="30", ExecOffset="12.5", PrevRunnable="F_Fast, F_Init"),
        on_event(signal("Event"), error("Unknown"), name="Event", DebounceDelay="7", PreProcessing=["before_event"]),
        step(name="Alone", cycle=10, ExecOffset="1", ParallelProcessing=False),
        active={"ALL": ["Step", "Fast", "Slow", "Event"], "FEW": ["Slow", "Fast"], "NONE": []},
        modes=(
            mode_interface("In", "NONE", "ALL", "FEW", "MORE", Initial="ALL", UnknownAction="Initial", UnknownError="Unknown",
                           Values=symbols(NONE=0, ALL=-1, FEW=70000, MORE=3)),
            mode_interface("Out", "OFF", "ON", Values=symbols(OFF=5, ON=6)),
        ),
        **GLOBALS,
    )  # fmt: skip


def supervision() -> FunctionJson:
    """Alive, deadline and logical supervision."""
    return function(
        call("Init", "Init", Checkpoint={"BeginsSequence": True, "Next": ["F_Step"]}),
        step(
            error("Alive"),
            error("Deadline", MaturationTime=5),
            error("Order"),
            error("All", "Order", Variable="all"),
            Watchdog=watchdog((2, 3, 3, "Alive"), (2, 5, "Deadline"), "Order"),
            Checkpoint={"Next": ["F_Step", "F_Second"]},
        ),
        step(
            error("Other", Variable="other"),
            name="Second",
            cycle=25,
            ExecOffset="5",
            Watchdog=watchdog((1, 1, 1, "Alive"), (0, 8.25, "All"), "Order"),
            Checkpoint={"BeginsSequence": True, "EndsSequence": True, "Next": ["F_Step"]},
        ),
        call("Terminate", "Shutdown", Checkpoint={"EndsSequence": True}),
        active={"ON": ["Step", "Second"], "OFF": ["Second"]},
        modes=(mode_interface("In", "ON", "OFF"),),
        **GLOBALS,
    )


def life() -> FunctionJson:
    """Parameters, methods, and what init and terminate have to do with them."""
    kept: Json = {"Attribute": "LearningParameter"}
    signature: Json = {"Signature": "Pointers", "Headers": ["f.h"], "Objects": [{"Name": "io", "Type": "F_Io"}]}
    gain = parameter("Gain", FLOAT, -5, 5, InitValue=1, Default=2, RangeError="E0", VssDatatype="double", **KMH)
    contents = step(
        gain,
        parameter("Size", U16, 300, 1500, InitValue=650, RangeErrorAction="Init", VssDatatype="float", **SCALED),
        parameter("Mass", U16, 0, 3000, InitValue=1000, **kept, VssDatatype="float", ConversionFactor="1/1000"),
        parameter("Learned", "DT_Floats", -1, 1, **kept, DefaultText="[0.5, 0.25, 1]"),
        parameter("Gear", "DT_Gear", **kept, VssDatatype="uint16", VssSymbols=OTHER_NUMBERS["DT_Gear"]),
        parameter("Point", "DT_Point", 0, 0, InitElements='{"x": 0.5, "y": 7}'),
        parameter("Bytes", "DT_Bytes", 0, 0, DefaultText="[1, 2]", VssDatatype="float[]"),
        error("E0"),
        reaction("Stop", "E0"),
        method("Offer", "Provider", {"Gear1": "DT_Gear", "Row1": "DT_Floats"}, {"Res1": DOUBLE, "Res2": "DT_Bytes"}, Symbol="offer"),
        method("Fetch", "Consumer", {"Key": U8, "Row2": "DT_Bytes"}, {"Value": "DT_Gear", "Row3": "DT_Floats"},
               RequestVariable="ask", StatusVariable="status", Timeout="20"),
        method("Tell", "Consumer", {"What": DOUBLE}, {}, RequestVariable="tell", StatusVariable="told"),
        method("Move", "Provider", {"Whole": "DT_Mixed"}, {"Moved": "DT_Outer"}, Symbol="move"),
    )  # fmt: skip
    calls = [
        call("Init", "Init", gain, SuccessValue=0),
        contents,
        call("Terminate", "Shutdown", PreProcessing=["before_terminate"]),
    ]
    return function(
        *with_objects(calls),
        datatypes=DATATYPES,
        active={"ON": ["Step"], "OFF": []},
        modes=(mode_interface("In", "ON", "OFF", Variable="io.mode_in"),),
        Code=signature,
    )


def classes() -> FunctionJson:
    """A class of C++, whose enumerations no number turns into by itself."""
    other: Json = {"VssDatatype": "string", "VssSymbols": OTHER_NUMBERS["DT_Gear"]}
    return function(
        step(
            signal("Gear", "DT_Gear", **other, Timeout="20", TimeoutValue="Default", Default=5),
            signal("Heal", "DT_Gear"),
            signal("Gears", "DT_Gears", InitElements="[5, 2]"),
            signal("Mixed", "DT_Mixed", **DEFAULT, DefaultElements='{"gear": 2, "values": [1], "flag": 1, "big": 3}'),
            queue("Row", 3, "DT_Gear", ValuesPerStep=2, CountVariable="row_n"),
            output("OutGear", "DT_Gear", **other),
            output("OutLevel", "DT_Level", RangeErrorAction="Default", Default=300),
            output("OutMixed", "DT_Mixed"),
            parameter("Kind", "DT_Gear", Attribute="LearningParameter", VssDatatype="uint16", VssSymbols=OTHER_NUMBERS["DT_Gear"]),
            parameter("Level", "DT_Level", InitValue=300),
            error("E0", Variable="e0", StatusVariable="e0_sts", Reset="Heal", ResetTime=5),
            reaction("Stop", "E0"),
            method("Offer", "Provider", {"Gear1": "DT_Gear"}, {"Level1": "DT_Level"}, Symbol="offer"),
            method("Fetch", "Consumer", {"Gear2": "DT_Gear", "Gears2": "DT_Gears"}, {"Level2": "DT_Level"},
                   RequestVariable="ask", StatusVariable="status", Timeout="20"),
        ),
        datatypes=DATATYPES,
        active={"ON": ["Step"], "OFF": []},
        modes=(mode_interface("In", "ON", "OFF"), mode_interface("Out", "OFF", "ON", Values=symbols(OFF=5, ON=6))),
        Code={"Signature": "Class", "Headers": ["f.h"], "ClassName": "F_Code"},
    )  # fmt: skip


FIXED: dict[str, Callable[[], FunctionJson]] = {
    made.__name__: made
    for made in (
        conversions,
        ranges,
        queues,
        time_outs,
        rejections,
        optional,
        errors,
        schedules,
        supervision,
        life,
        classes,
    )
}
