"""Errors that an RTE generator would report are findings first, at their place in the document."""

import json
from itertools import pairwise

import pytest

from sigcat.errors import InputRefused
from sigcat.function.function_json.wire import written as to_json
from sigcat.integration.autosar_classic.document import read_integration
from sigcat.integration.autosar_classic.problems.names_table import NAMESPACES, REFERENCES
from sigcat.integration.references import places
from tests.integration.autosar_adaptive.sets import examples
from tests.integration.autosar_classic.classic import derive


@pytest.fixture(scope="module")
def written():
    return to_json(derive(examples()[::2]).model)


def problems(written, change):
    """Pointers and messages of the findings after a change; none if the document is accepted."""
    document = json.loads(written)
    change(document)
    try:
        read_integration(json.dumps(document).encode(), "integration.json")
    except InputRefused as refused:
        return {(finding.rule, finding.pointer): finding for finding in refused.findings}
    return {}


def first(document):
    """Its first component."""
    return document["Components"][0]


def copied(listed, **changed):
    """Add the first element once more."""
    listed.append({**listed[0], **changed})


def of(listed, name):
    """The element of a name."""
    return next(each for each in listed if each["Name"] == name)


def supervised(document, component=0):
    """The supervised entity of a component."""
    return document["Components"][component]["SupervisedEntities"][0]


def element(document, port):
    """The element of a port of the first component."""
    return of(first(document)["Ports"], port)["Elements"][0]


def typed(document, kind):
    """The element of a port, with a datatype of the code."""
    three = {"Name": "Three", "Category": "ARRAY", "ElementType": "uint8", "Length": 3}
    members = [{"Name": name, "Type": "uint8"} for name in ("A", "B")]
    pair = {"Name": "Pair", "Category": "STRUCTURE", "Members": members}
    small = {"Name": "sint8", "Category": "VALUE", "Base": "sint8"}
    known = {each["Name"] for each in document["ImplementationTypes"]}
    document["ImplementationTypes"] += [each for each in (three, pair, small) if each["Name"] not in known]
    of(document["SenderReceiverInterfaces"], "Vehicle_Speed")["Elements"][0].update(Type=kind)
    return element(document, "Vehicle_Speed")


def meaning(document, kind, **form):
    """Another application type of a datatype of the code."""
    typed(document, "Three")
    document["ApplicationTypes"].append({"Name": "Meaning", "ImplementationType": kind, **form})


def literals(document):
    """Names and numbers of an enumeration."""
    return next(each["Symbols"] for each in document["CompuMethods"] if len(each.get("Symbols", ())) > 1)


def bus_signals(document):
    """Signals of a bus for two ports of the composition."""
    pairs = (("Vehicle_Speed", "Speed"), ("Chassis_Brake_CylP", "CylP"))
    document["Ecu"]["Signals"] = [
        {"Port": port, "Element": name, "SystemSignal": signal}
        for (port, name), signal in zip(pairs, ("Spd", "Mass"), strict=True)
    ]
    return document["Ecu"]["Signals"]


def enumerated(document):
    """Name of a datatype that is an enumeration."""
    return next(each["Name"] for each in document["ImplementationTypes"] if "CompuMethod" in each)


def ranged(document):
    """Name of an application type that has limits."""
    return next(each["Name"] for each in document["ApplicationTypes"] if each.get("DataConstraint"))


def value_called_as_a_limit(document):
    """A value of an enumeration whose name in the code, behind its prefix, is that of a limit."""
    kind = of(document["ImplementationTypes"], enumerated(document))
    kind["LiteralPrefix"] = f"{ranged(document)}_"
    of(document["CompuMethods"], kind["CompuMethod"])["Symbols"][0]["Symbol"] = "UpperLimit"


def two_enumerations(document, prefix=""):
    """Two enumerations that a component exchanges, whose values have one name and two numbers."""
    for name, port in (("A", "Vehicle_Speed"), ("B", "Chassis_Brake_CylP")):
        symbols = [{"Symbol": "ON", "Value": ord(name)}]
        document["CompuMethods"].append({"Name": name, "Category": "TEXTTABLE", "Symbols": symbols})
        kind = {"Name": name, "Category": "TYPE_REFERENCE", "Base": "uint8", "CompuMethod": name}
        document["ImplementationTypes"].append({**kind, **({"LiteralPrefix": f"{name}_"} if prefix else {})})
        of(document["SenderReceiverInterfaces"], port)["Elements"][0].update(Type=name)


CHANGES = {
    "two ports of one name": (lambda d: copied(first(d)["Ports"]), "is one already"),
    "two names that differ in case": (lambda d: first(d)["Runnables"][0].update(Name="STEP"), "is one already"),
    "a name that is not an identifier": (lambda d: d["ClassicDeployment"].update(Package="Eco Control"), "short name"),
    "a name that is a word of C++": (lambda d: d["ClassicDeployment"].update(Package="class"), "identifier of C"),
    "a name that is too long": (lambda d: d["ClassicDeployment"].update(Package="A" * 129), "at most 128 characters"),
    "one C function for two runnables": (
        lambda d: first(d)["Runnables"][0].update(Symbol=first(d)["Runnables"][1]["Symbol"]), "function of one runnable",
    ),
    "a runnable without an event": (
        lambda d: first(d).update(Events=[e for e in first(d)["Events"] if e["Runnable"] != "Step"]), "started by an event",
    ),
    "an event without a task": (lambda d: d["Ecu"]["Tasks"][1]["Events"].pop(), "must be in a task"),
    "an event in two tasks": (
        lambda d: d["Ecu"]["Tasks"][0]["Events"].append(d["Ecu"]["Tasks"][1]["Events"][0]), "must be in one task",
    ),
    "an event that is not an init event before the tasks run": (
        lambda d: d["Ecu"]["InitBatches"][0]["Events"].append(d["Ecu"]["Tasks"][0]["Events"].pop()), "must be an init event",
    ),
    "two init events at one position": (
        lambda d: d["Ecu"]["InitBatches"][0]["Events"][1].update(Position=1), "must be that of one event",
    ),
    "two batches of one name": (lambda d: copied(d["Ecu"]["InitBatches"], Events=[]), "is one already"),
    "an init event in a batch and in a task": (
        lambda d: d["Ecu"]["Tasks"][0]["Events"].append({**d["Ecu"]["InitBatches"][0]["Events"][0], "Position": 99}),
        "must be in one task",
    ),
    "a period longer than any number of ticks": (
        lambda d: of(first(d)["Events"], "Step_50ms").update(Period=1e308), "whole ticks of 1000 µs, not 1e+308 s",
    ),
    "a period of 0": (lambda d: of(first(d)["Events"], "Step_50ms").update(Period=0), "period above 0"),
    "no initial value": (lambda d: of(first(d)["Ports"], "Vehicle_Speed")["Elements"][0].pop("InitValue"), "initial value"),
    "a queue of nothing": (lambda d: first(d)["Ports"][0]["Elements"][0].update(QueueLength=0), "hold at least 1"),
    "an interface that is not there": (lambda d: first(d)["Ports"][0].update(Interface="Other"), "known SenderReceiver interface"),
    "an element that is not there": (lambda d: first(d)["Ports"][0]["Elements"][0].update(Name="Other"), "known element"),
    "an access to no port": (lambda d: first(d)["Runnables"][1]["Accesses"][0].update(Port="Other"), "of a port"),
    "an access against the direction": (
        lambda d: of(first(d)["Runnables"], "Step")["Accesses"][3].update(Kind="ExplicitWrite"), "must be of a port that is",
    ),
    "an array of more elements than in the code": (
        lambda d: meaning(d, "Three", Category="ARRAY", Length=4, ElementType=d["ApplicationTypes"][0]["Name"]),
        "must be 3 values, as Three is in the code, not 4 values",
    ),
    "a structure that is one value in the code": (
        lambda d: meaning(d, "uint8", Category="STRUCTURE", Members=[{"Name": "A", "Type": d["ApplicationTypes"][0]["Name"]}]),
        "must be one value, as uint8 is in the code, not a structure of A",
    ),
    "a datatype that is not there": (lambda d: d["ApplicationTypes"][0].update(ImplementationType="Other"), "implementation type"),
    "a datatype that comes later": (lambda d: d["ImplementationTypes"].reverse(), "implementation type before it"),
    "a required port that is open": (lambda d: d["Composition"]["Delegations"].pop(0), "must be connected"),
    "two providers of one port": (lambda d: copied(d["Composition"]["Assemblies"], Name="Other"), "with one provider"),
    "ports of different interfaces": (
        lambda d: d["Composition"]["Assemblies"][0]["Requester"].update(Port="Vehicle_Speed"), "of the interface of",
    ),
    "a counter that stands still": (lambda d: d["ClassicDeployment"].update(Tick=0), "at least 1 µs"),
    "a section that is not there": (lambda d: first(d)["Runnables"][0].update(Section="OTHER"), "memory section"),
    "a checkpoint that is not there": (
        lambda d: first(d)["SupervisedEntities"][0]["Alive"][0].update(Checkpoint="Other"), "known checkpoint",
    ),
    "a block of no memory": (lambda d: first(d)["NvBlocks"][0].update(PerInstanceMemory="Other"), "per-instance memory"),
    "a block of another service": (lambda d: first(d)["NvBlocks"][0].update(Port="Clock"), "operation of the NvRamManager"),
    "a count of an error that is not there": (lambda d: first(d)["NvBlocks"][0]["Errors"].append("Other"), "must be an error"),
    "a diagnostic event of another service": (
        lambda d: first(d)["DiagnosticEvents"][0].update(Port="Clock"), "operation of the DiagnosticEventManager",
    ),
    "more occurrences than are counted": (
        lambda d: first(d)["DiagnosticEvents"][0].update(OccurrenceCountLimit=256), "from 0 to 255",
    ),
    "two diagnostic events of one name": (lambda d: copied(first(d)["DiagnosticEvents"]), "is one already"),
    "an inhibition by an error that is not there": (
        lambda d: first(d)["Inhibitions"][0]["Events"].append("Other"), "must be an error",
    ),
    "a checkpoint of another service": (
        lambda d: supervised(d)["Checkpoints"][0].update(Port="Clock"), "operation of the WatchdogManager",
    ),
    "one number for two checkpoints": (lambda d: supervised(d)["Checkpoints"][1].update(Number=0), "of one checkpoint"),
    "a number that no checkpoint has": (lambda d: supervised(d)["Checkpoints"][1].update(Number=-1), "from 0 to 65,535"),
    "an indication that is never expected": (
        lambda d: supervised(d)["Alive"][0].update(ExpectedIndications=0), "At least 1 indication",
    ),
    "more missing than expected": (lambda d: supervised(d)["Alive"][0].update(MinMargin=11), "No more than the 10"),
    "a cycle of no time": (lambda d: supervised(d)["Alive"][0].update(ReferenceCycle=0), "longer than 0 s"),
    "a supervision of an error that is not there": (
        lambda d: supervised(d)["Alive"][0].update(Error="Other"), "must be an error",
    ),
    "a deadline between one checkpoint": (
        lambda d: supervised(d, 1)["Deadline"][0].update(End="Step_Begin"), "another checkpoint",
    ),
    "a deadline that ends before it begins": (
        lambda d: supervised(d, 1)["Deadline"][0].update(Min=1, Max=0.5), "from 0 to the longest",
    ),
    "a queue without end": (lambda d: element(d, "Vehicle_Speed").update(QueueLength=65_536), "65,535 at most"),
    "a text where a number is": (lambda d: element(d, "Vehicle_Speed").update(InitValue="fast"), "number for float32, not 'fast'"),
    "a truth where a number is": (lambda d: element(d, "Vehicle_Speed").update(InitValue=True), "number for float32"),
    "a number that no float holds": (lambda d: element(d, "Vehicle_Speed").update(InitValue=1e39), "for float32"),
    "a number above its datatype": (lambda d: typed(d, "uint8").update(InitValue=256), "from 0 to 255 for uint8"),
    "a number below its datatype": (lambda d: typed(d, "sint8").update(InitValue=-129), "from -128 to 127 for sint8"),
    "a datatype with a huge range": (
        lambda d: of(d["ImplementationTypes"], "uint8").update(Base="uint999999999"), "'uint999999999' must be a known platform type",
    ),
    "a datatype that is misspelled": (
        lambda d: of(d["ImplementationTypes"], "uint8").update(Base="uint8x"), "'uint8x' must be a known platform type",
    ),
    "part of a number": (lambda d: typed(d, "uint8").update(InitValue=0.5), "whole number for uint8"),
    "an array that is too short": (lambda d: typed(d, "Three").update(InitValue=[0, 1]), "must have 3 elements"),
    "an array with a text in it": (lambda d: typed(d, "Three").update(InitValue=[0, 1, "2"]), "must be a number"),
    "an array with too large a number": (lambda d: typed(d, "Three").update(InitValue=[0, 1, 256]), "from 0 to 255"),
    "a struct without a member": (lambda d: typed(d, "Pair").update(InitValue={"A": 0}), "B is missing"),
    "a struct with one member more": (lambda d: typed(d, "Pair").update(InitValue={"A": 0, "B": 1, "C": 2}), "C is not one"),
    "a value of the composition": (
        lambda d: of(d["Composition"]["Ports"], "Vehicle_Speed").update(InitValue="fast"), "must be a number",
    ),
    "a parameter that is too large": (
        lambda d: d["ParameterComponents"][0]["Ports"][0]["Elements"][0].update(InitValue=1e39), "must be from",
    ),
    "one name for two numbers": (lambda d: literals(d)[1].update(Symbol=literals(d)[0]["Symbol"]), "name of one value"),
    "one number for two names": (lambda d: literals(d)[1].update(Value=literals(d)[0]["Value"]), "number of one value"),
    "a name that is a word of C": (lambda d: literals(d)[0].update(Symbol="switch"), "not a keyword"),
    "a name that is a piece of C": (lambda d: literals(d)[0].update(Symbol="A 1\n#define B"), "short name"),
    "one name for two enumerations of a component": (two_enumerations, "one number in the code of CoreAcc"),
    "a datatype that is called as a limit": (
        lambda d: copied(d["ImplementationTypes"], Name=f"{ranged(d)}_LowerLimit"), "the RTE calls a limit of",
    ),
    "a value that is called as a limit": (value_called_as_a_limit, "the RTE calls a limit of"),
    "a prefix that is a piece of C": (
        lambda d: of(d["ImplementationTypes"], enumerated(d)).update(LiteralPrefix="A B"), "C identifier",
    ),
    "an enumeration of nothing": (lambda d: literals(d).clear(), "must have a value"),
    "a range upside down": (lambda d: d["DataConstraints"][0].update(Min=2, Max=1), "must be 1 or less"),
    "a function of the core": (
        lambda d: first(d)["Runnables"][0].update(Symbol="CoreAcc_Adapter_Init"), "those of the core of CoreAcc",
    ),
    "a function of the source around it": (
        lambda d: first(d)["Runnables"][0].update(Symbol="CoreAcc_Swc_Now"), "those of the source of CoreAcc",
    ),
    "a function of the code": (
        lambda d: first(d)["Runnables"][0].update(Symbol="CoreAcc_Step"), "that of the function CoreAcc too",
    ),
    "a function of the RTE": (lambda d: first(d)["Runnables"][0].update(Symbol="Rte_Start"), "of the base software"),
    "a memory with code for a type": (
        lambda d: first(d)["PerInstanceMemories"][0].update(Type="int; int evil"), "C identifier",
    ),
    "a memory with code for its definition": (
        lambda d: first(d)["PerInstanceMemories"][0].update(TypeDefinition="int x; typedef int"), "C identifier",
    ),
    "a memory with code for a header": (
        lambda d: first(d)["PerInstanceMemories"][0].update(Header='a.h"\n#define A'), "relative file name",
    ),
    "one type for two memories": (
        lambda d: copied(first(d)["PerInstanceMemories"], Name="Other", TypeDefinition="Other"), "must be defined once",
    ),
    "an ECU that is a word of C++": (lambda d: d["Ecu"].update(Name="class"), "identifier of C"),
    "a signal of no port": (lambda d: bus_signals(d)[0].update(Port="Other"), "port of the composition"),
    "one signal for two ports": (lambda d: bus_signals(d)[0].update(SystemSignal="Mass"), "must carry one data element"),
    "two signals for one port": (lambda d: copied(bus_signals(d), SystemSignal="Other"), "must have one signal"),
    "a signal of no length": (lambda d: bus_signals(d)[0].update(Length=0), "1 to 512 bits"),
    "a signal that a float does not fit into": (lambda d: bus_signals(d)[0].update(Length=16), "at least 32 bits"),
    "a signal that is a piece of C": (lambda d: bus_signals(d)[0].update(SystemSignal="A B"), "short name"),
    "a runnable below the ASIL of the memory that it writes": (
        lambda d: of(first(d)["MemorySections"], "VAR_CLEARED_UNSPECIFIED").update(AsilLevel="B"), "must have ASIL B",
    ),
    "one section for code and variables": (
        lambda d: first(d)["MemorySections"][1].update(Name="CODE_ASIL_B"), "must be of kind",
    ),
}  # fmt: skip


def test_what_was_derived_has_none(written):
    assert problems(written, lambda document: None) == {}


def test_enumerations_may_share_names_behind_prefixes(written):
    assert problems(written, lambda document: two_enumerations(document, prefix="each")) == {}


@pytest.mark.parametrize(("change", "said"), CHANGES.values(), ids=CHANGES)
def test_a_document_is_refused_for(written, change, said):
    found = problems(written, change)
    assert {rule for rule, _ in found} == {"K011"}
    assert any(said in finding.message and finding.fix and finding.line for finding in found.values()), found


@pytest.mark.parametrize("uses", [None, [], "Renamed"])
@pytest.mark.parametrize("kind", ["SenderReceiver", "Parameter"])
def test_uses_have_to_lead_to_interfaces_of_the_function(written, kind, uses):
    def change(document):
        (port, *_) = (each for each in first(document)["Ports"] if each["Kind"] == kind)
        if isinstance(uses, str):
            port["Elements"][0]["Uses"][0]["Interface"] = uses
        elif uses is None:
            del port["Elements"][0]["Uses"]
        else:
            port["Elements"][0]["Uses"] = uses

    (finding,) = problems(written, change).values()
    assert "/Ports/" in finding.pointer
    assert finding.line
    assert "Renamed" in finding.message or "must have the interface of the function" in finding.message


def _window(size=1, least=1, most=0):
    return {"WindowSize": size, "MinOkState": least, "MaxErrorState": most}


@pytest.mark.parametrize(
    ("valid", "release", "below"),
    [
        (_window(least=2), "R23-11", "/Valid/MinOkState"),
        (_window(most=2), "R23-11", "/Valid/MaxErrorState"),
        (_window(size=0), "R23-11", "/Valid/WindowSize"),
        (_window(size=256), "R23-11", "/Valid/WindowSize"),
        (_window(size=3), "4.4.0", ""),
    ],
)
def test_windows_of_end_to_end_protection_that_a_release_does_not_have_are_refused(valid, release, below, written):
    def change(document):
        document["ClassicDeployment"]["Release"] = release
        windows = {"Init": _window(), "Valid": valid, "Invalid": _window()}
        element(document, "Vehicle_Speed").update(E2eWindows=windows)

    (found,) = problems(written, change)
    assert found[1].endswith(f"/Elements/0/E2eWindows{below}")


# -- names and references, by their table -----------------------------------------------------------------------------


def _put(document, pointer, value):
    for key in pointer[:-1]:
        document = document[key]
    document[pointer[-1]] = value


def _at(pointer):
    return "/" + "/".join(map(str, pointer))


@pytest.mark.parametrize("reference", REFERENCES, ids=lambda each: each.at)
def test_a_reference_to_nothing_is_found_at_its_field_with_a_near_name(written, reference):
    (pointer, name), *_ = places(read_integration(written, "i.json"), reference.at)
    findings = problems(written, lambda document: _put(document, pointer, f"{name}X"))
    assert name in findings["K011", _at(pointer)].fix


@pytest.mark.parametrize("space", NAMESPACES, ids=lambda each: each[0])
def test_two_names_of_one_space_differ_in_more_than_case(written, space):
    model = read_integration(written, "i.json")
    found = [place for path in space for place in places(model, f"{path}/*/Name")]
    twins = [(one, other) for one, other in pairwise(found) if one[0][:-3] == other[0][:-3]]
    for (_, name), (pointer, _) in twins[:1]:
        findings = problems(written, lambda document: _put(document, pointer, name.swapcase()))  # noqa: B023
        assert "must be the name of one thing here" in findings["K011", _at(pointer)].message
