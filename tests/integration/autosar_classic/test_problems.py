"""What an RTE generator would refuse is a finding first, where it stands in the document."""

import json

import pytest

from sigcat.errors import InputRefused
from sigcat.integration.autosar_classic.document import read_integration
from sigcat.integration.autosar_classic.model import to_json
from tests.integration.autosar_adaptive.sets import examples
from tests.integration.autosar_classic.classic import derive


@pytest.fixture(scope="module")
def written():
    return to_json(derive(examples()).model)


def problems(written, change):
    """Pointers and messages of what is found after a change; none if the document is accepted."""
    document = json.loads(written)
    change(document)
    try:
        read_integration(json.dumps(document, indent=1).encode(), "integration.json")
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


CHANGES = {
    "two ports of one name": (lambda d: copied(first(d)["Ports"]), "is one already"),
    "two names that differ in case": (lambda d: first(d)["Runnables"][0].update(Name="STEP"), "is one already"),
    "a name that is no identifier": (lambda d: d["ClassicDeployment"].update(Package="Eco Control"), "identifier of C"),
    "a name that is a word of C++": (lambda d: d["ClassicDeployment"].update(Package="class"), "identifier of C"),
    "a name that is too long": (lambda d: d["ClassicDeployment"].update(Package="A" * 129), "128 characters"),
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
    "what is no init event before the tasks run": (
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
    "a period of 0": (lambda d: of(first(d)["Events"], "Step_50ms").update(Period=0), "period above 0"),
    "no initial value": (lambda d: of(first(d)["Ports"], "Vehicle_Speed")["Elements"][0].pop("InitValue"), "initial value"),
    "a queue of nothing": (lambda d: first(d)["Ports"][0]["Elements"][0].update(QueueLength=0), "hold at least 1"),
    "an interface that is not there": (lambda d: first(d)["Ports"][0].update(Interface="Other"), "known SenderReceiver interface"),
    "an element that is not there": (lambda d: first(d)["Ports"][0]["Elements"][0].update(Name="Other"), "known element"),
    "an access to no port": (lambda d: first(d)["Runnables"][1]["Accesses"][0].update(Port="Other"), "of a port"),
    "an access against the direction": (
        lambda d: of(first(d)["Runnables"], "Step")["Accesses"][3].update(Kind="ExplicitWrite"), "must be of a port that is",
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
}  # fmt: skip


def test_what_was_derived_has_none(written):
    assert problems(written, lambda document: None) == {}


@pytest.mark.parametrize(("change", "said"), CHANGES.values(), ids=CHANGES)
def test_a_document_is_refused_for(written, change, said):
    found = problems(written, change)
    assert {rule for rule, _ in found} == {"K011"}
    assert any(said in finding.message and finding.fix and finding.line for finding in found.values()), found
