"""The state of an FMU is saved, restored and written as bytes; instances are independent; misuse is refused."""

import random
from pathlib import Path

import pytest

from tests.adapter.fmi.fmus import built
from tests.needs import cmake

fmpy = pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
from fmpy.fmi1 import FMICallException  # noqa: E402 -- where it is there
from fmpy.fmi3 import FMU3Slave  # noqa: E402

pytestmark = cmake
STEP = 0.01
AVERAGING = Path(__file__).with_name("averaging") / "function.yaml"


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory):
    """An FMU whose code has no global variables."""
    made = built([AVERAGING], tmp_path_factory.mktemp("fmu"))
    return fmpy.read_model_description(str(made.file)), fmpy.extract(str(made.file))


class Instance:
    """One instance, in step mode."""

    def __init__(self, unpacked):
        self.description, folder = unpacked
        self.fmu = FMU3Slave(
            guid=self.description.instantiationToken, modelIdentifier=self.description.coSimulation.modelIdentifier,
            unzipDirectory=folder, instanceName="tested",
        )  # fmt: skip
        self.fmu.instantiate()
        self.fmu.enterInitializationMode(startTime=0.0)
        self.fmu.exitInitializationMode()
        self.now = 0

    def numbers(self, causality):
        known = [each for each in self.description.modelVariables if each.causality == causality]
        found = [each for each in known if each.type in ("Float32", "Float64")]
        assert found
        return found

    def step(self, seed):
        """Set random inputs, step, and return all outputs."""
        chosen = random.Random(seed)
        for each in self.numbers("input"):
            if chosen.random() < 0.5:
                getattr(self.fmu, f"set{each.type}")([each.valueReference], [chosen.uniform(-100, 100)])
        self.fmu.doStep(currentCommunicationPoint=self.now * STEP, communicationStepSize=STEP)
        self.now += 1
        return [self.read(each) for each in self.description.modelVariables if each.causality == "output"]

    def read(self, variable):
        count = 1
        for dimension in variable.dimensions:
            count *= int(dimension.start)
        kind = {"Enumeration": "Int64"}.get(variable.type, variable.type)
        many = {"nValues": count} if count > 1 else {}
        return repr(list(getattr(self.fmu, f"get{kind}")([variable.valueReference], **many)))

    def end(self):
        self.fmu.terminate()
        self.fmu.freeInstance()


@pytest.fixture
def instance(unpacked):
    made = Instance(unpacked)
    yield made
    made.end()


def test_a_restored_state_goes_on_as_before(instance):
    for point in range(100):
        state, at = instance.fmu.getFMUState(), instance.now
        data = instance.fmu.serializeFMUState(state)
        first = [instance.step(1000 * point + k) for k in range(4)]
        instance.fmu.setFMUState(state)
        instance.now = at
        assert [instance.step(1000 * point + k) for k in range(4)] == first
        again = instance.fmu.deserializeFMUState(data)
        instance.fmu.setFMUState(again)
        instance.now = at
        assert [instance.step(1000 * point + k) for k in range(4)] == first
        for each in (state, again):
            instance.fmu.freeFMUState(each)


def test_two_instances_do_not_know_of_each_other(unpacked):
    alone, one, other = Instance(unpacked), Instance(unpacked), Instance(unpacked)
    expected = [alone.step(k) for k in range(50)]
    found = []
    for k in range(50):
        found.append(one.step(k))
        other.step(-k - 1)
    assert found == expected
    for each in (alone, one, other):
        each.end()


def test_damaged_bytes_of_a_state_are_refused(instance):
    state = instance.fmu.getFMUState()
    data = bytearray(instance.fmu.serializeFMUState(state))
    data[len(data) // 2] ^= 1
    with pytest.raises(FMICallException):
        instance.fmu.deserializeFMUState(bytes(data))
    instance.fmu.freeFMUState(state)


def test_misuse_is_refused_and_changes_nothing(instance):
    refused = FMICallException
    before = instance.step(1)
    with pytest.raises(refused):
        instance.fmu.doStep(currentCommunicationPoint=5.0, communicationStepSize=STEP)
    with pytest.raises(refused):
        instance.fmu.doStep(currentCommunicationPoint=instance.now * STEP, communicationStepSize=-1.0)
    with pytest.raises(refused):
        instance.fmu.setFloat64([4_000_000_000], [1.0])
    with pytest.raises(refused):
        instance.fmu.enterEventMode()
    output = next(each for each in instance.description.modelVariables if each.causality == "output")
    kind = {"Enumeration": "Int64"}.get(output.type, output.type)
    with pytest.raises(refused):
        getattr(instance.fmu, f"set{kind}")([output.valueReference], [1])
    assert [instance.read(each) for each in instance.description.modelVariables if each.causality == "output"] == before
