"""FMUs with a CAN bus: what they decode and encode is what the gateway and cantools do."""

import math
import random
import struct
import zipfile

import pytest

from sigcat.adapter.host.shapes import Number
from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import source_of_tree
from sigcat.gateway.frames import Frame
from sigcat.gateway.prepare import prepare
from sigcat.gateway.sending import Sender
from sigcat.gateway.translation import Translation
from sigcat.runs.recording.cells import cell_of
from tests.adapter.fmi.bus.made import DBC, TREE, made
from tests.adapter.fmi.bus.operations import (
    CAN,
    CAN_FD,
    FORMAT_ERROR,
    Instance,
    operation,
    operations,
    transmit,
)
from tests.needs import cmake

pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
cantools = pytest.importorskip("cantools", reason="cantools: pip install 'sigcat[can]'")
from fmpy.fmi1 import FMICallException  # noqa: E402 -- where it is there
from fmpy.validation import validate_fmu  # noqa: E402

pytestmark = cmake
STEP = 0.01
NAMES = ("Speed", "Temperature", "Gear", "IsOn", "Force", "Turn", "First", "Second", "Exact", "Wide")


@pytest.fixture(scope="module")
def mirror(tmp_path_factory):
    return made(tmp_path_factory.mktemp("bus"))


@pytest.fixture(scope="module")
def prepared():
    return prepare(load(source_of_tree(str(TREE))), [DBC])


@pytest.fixture
def instance(mirror):
    found = Instance(mirror)
    yield found
    found.close()


def test_fmpy_finds_nothing_wrong(mirror):
    assert not validate_fmu(str(mirror))


def test_an_fmu_has_the_files_of_the_layered_standard(mirror):
    with zipfile.ZipFile(mirror) as file:
        names = file.namelist()
        terminals = file.read("terminalsAndIcons/terminalsAndIcons.xml").decode()
        manifest = file.read("extra/org.fmi-standard.fmi-ls-bus/fmi-ls-manifest.xml").decode()
    assert "sources/sigcat_bus.c" in names
    for member in ("Rx_Clock", "Rx_Data", "Tx_Clock", "Tx_Data"):
        assert f'variableName="Powertrain.{member}" memberName="{member}"' in terminals
    assert 'fmi-ls:fmi-ls-name="org.fmi-standard.fmi-ls-bus"' in manifest


# -- received ----------------------------------------------------------------------------------------------------


def random_frames(prepared, prefix, count, chance):
    """Frames of the messages with random data; some are shorter than their message."""
    messages = [each for each in prepared.database.messages if each.name.startswith(prefix)]
    for index in range(count):
        message = chance.choice(messages)
        data = bytearray(chance.randbytes(message.length))
        if message.name == "RxParts":
            data[0] = data[0] & 0xF0 | chance.choice((0, 1, 2, 2, 1))
        if message.name == "RxBasic" and chance.random() < 0.7:
            data[1] = chance.randrange(0x76)  # within the limits of the speed
        if message.name == "RxLarge" and chance.random() < 0.1:
            data[6:8] = b"\xf8\x7f"  # no number
        short = chance.randrange(message.length) if chance.random() < 0.1 else message.length
        yield Frame(
            (index + 1) * 10_000_000, message.frame_id, bool(message.is_extended_frame), bytes(data[:short]), ""
        )


def test_received_values_are_those_of_the_gateway(instance, prepared):
    frames = list(random_frames(prepared, "Rx", 3000, random.Random(5)))
    moments = iter(Translation(prepared.database, prepared.mapped).moments(frames, "frames"))
    moment = next(moments, None)
    paths = [each.path for each in prepared.mapped if each.path in instance.variables]
    known = {path: instance.get(path) for path in paths}
    count = 0
    instance.settle()
    for frame in frames:
        instance.step(frame.time / 1e9)
        instance.fmu.enterEventMode()
        is_fd = len(frame.data) > 8
        instance.settle(transmit(frame.identifier, frame.data, is_extended=frame.is_extended, is_fd=is_fd))
        while moment is not None and moment.time <= frame.time:
            known |= {prepared.mapped[each.number].path: each.value for each in moment.values}
            count += len(moment.values)
            moment = next(moments, None)
        for path, value in known.items():
            got = instance.get(path)
            assert got == value or (math.isnan(got) and math.isnan(value)), (frame, path)
    assert count > 3000


def test_received_values_are_those_of_cantools(instance):
    """Signals without a transform have the number in their unit."""
    database = cantools.database.load_file(str(DBC))
    chance = random.Random(6)
    instance.settle()
    for index in range(1, 300):
        instance.step(index * STEP)
        instance.fmu.enterEventMode()
        large, extended = chance.randbytes(16), chance.randbytes(8)
        expected = database.decode_message("RxLarge", large) | database.decode_message("RxExtended", extended)
        identifier = database.get_message_by_name("RxExtended").frame_id
        instance.settle(transmit(301, large, is_fd=True) + transmit(identifier, extended, is_extended=True))
        for name in ("Exact", "Wide", "Force"):
            value, got = expected[f"Rx{name}"], instance.get(f"Vehicle.In.{name}In")
            assert got == value or (math.isnan(got) and math.isnan(value))


# -- sent ---------------------------------------------------------------------------------------------------------


def wish(chance):
    return {
        "Speed": struct.unpack("f", struct.pack("f", chance.uniform(-10, 310)))[0],
        "Temperature": chance.randint(-1200, 1200),
        "Gear": chance.randint(-2, 3),
        "IsOn": chance.random() < 0.5,
        "Force": struct.unpack("f", struct.pack("f", chance.uniform(-1e30, 1e30)))[0],
        "Turn": chance.randint(-(2**31), 2**31 - 1) if chance.random() < 0.3 else chance.randint(-1_000_100, 1_000_100),
        "First": chance.randrange(2**16),
        "Second": chance.randint(-2100, 2100),
        "Exact": chance.choice((chance.uniform(-1e300, 1e300), math.nan, math.inf)),
        "Wide": chance.randrange(2**53),
    }


def events(instance, count):
    """Times at which the FMU is in event mode, in ns."""
    for index in range(count):
        if index > 0:
            instance.step(index * STEP)
            instance.fmu.enterEventMode()
        yield round(index * STEP * 1e9)


def test_sent_frames_are_those_of_the_gateway(instance, prepared):
    """Outputs go to CAN by the rules of `sigcat gateway --send`: their intervals, their changes, and one frame of each message."""
    sender = Sender(prepared.database, prepared.outgoing)
    chance = random.Random(7)
    frames = 0
    for time in events(instance, 400):
        if chance.random() < 0.8:
            for name, value in wish(chance).items():
                instance.set(f"Vehicle.Wish.{name}Wish", value)
        sent = [each.frame for each in operations(instance.settle())]
        for each in prepared.outgoing:
            if each.path.startswith("Vehicle.Out."):
                sender.take(each.name, cell_of(instance.get(each.path), Number(each.datatype)))
        expected = [(each.identifier, each.is_extended, each.data) for each in sender.due(time)]
        assert sorted(sent) == sorted(expected), time
        frames += len(sent)
    assert frames > 1000


def test_sent_frames_are_decoded_by_cantools(instance):
    database = cantools.database.load_file(str(DBC))
    for _ in events(instance, 2):
        values = {
            "Speed": 12.5,
            "Temperature": -55,
            "Gear": 1,
            "IsOn": True,
            "Force": -2.5,
            "Turn": 299_999,
            "Exact": 0.1,
            "Wide": 2**52 - 1,
        }
        for name, value in values.items():
            instance.set(f"Vehicle.Wish.{name}Wish", value)
        data = instance.settle()
    found: dict[str, object] = {}
    for each in operations(data):
        identifier, _, content = each.frame
        found |= database.decode_message(identifier, content)
    assert (found["TxSpeed"], found["TxTemperature"], found["TxGear"], found["TxIsOn"]) == (12.5, -55, "DRIVE", 1)
    assert (found["TxForce"], found["TxExact"], found["TxWide"]) == (-2.5, 0.1, 2**52 - 1)


# -- damaged operations -------------------------------------------------------------------------------------------


def test_a_damaged_operation_is_answered_with_a_format_error(instance):
    damaged = operation(CAN, b"\1\1\0\0\0\0\x09\0" + bytes(9))
    unknown = operation(0x77, b"abc")
    rest = b"\x10\0\0\0\xff\0\0\0"
    good = transmit(300, b"\x02\x7f\xf0\0")
    sent = [each for each in operations(instance.settle(damaged + good + unknown + rest)) if each.code == FORMAT_ERROR]
    assert [each.arguments[2:] for each in sent] == [damaged, unknown, rest]
    assert instance.get("Vehicle.In.SecondIn") == 0x7FF


@pytest.mark.parametrize(
    "ignored",
    [
        operation(FORMAT_ERROR, b"\2\0ab"), operation(0x20, bytes(4)), operation(0x30, bytes(4)), operation(0x31, bytes(7)),
        operation(0x40, b"\1" + bytes(4)), operation(0x41, b"\1"), operation(0x42, b""), operation(0x12, bytes(14)),
        transmit(0x7FF, bytes(8)), operation(CAN, b"\x01\x01\0\0\0\1\0\0"),
    ],
)  # fmt: skip
def test_operations_without_a_meaning_for_an_fmu_are_ignored(instance, ignored):
    assert not [each for each in operations(instance.settle(ignored)) if each.code not in (CAN, CAN_FD)]


def test_too_many_bytes_are_refused(instance):
    with pytest.raises(FMICallException):
        instance.give(bytes(2**16 + 1))
    instance.settle(bytes(2**16))


def test_the_bus_is_for_event_mode(mirror):
    without = Instance(mirror, has_events=False)
    assert not without.step(1.0)
    with pytest.raises(FMICallException):
        without.take()
    without.close()


def test_frames_that_do_not_fit_are_a_warning(instance, capfd):
    instance.fmu.setDebugLogging(True, [])
    instance.settle()
    instance.step(30.0)  # 3,000 calls, each with frames of eight messages
    instance.fmu.enterEventMode()
    assert len(instance.take()) <= 2**16
    instance.update()
    assert "frames are lost" in "".join(capfd.readouterr())


def test_the_state_has_the_values_that_wait(instance):
    chance = random.Random(8)
    for name, value in wish(chance).items():
        instance.set(f"Vehicle.Wish.{name}Wish", value)
    instance.settle()
    state = instance.fmu.getFMUState()
    runs = []
    for _ in range(2):
        instance.fmu.setFMUState(state)
        instance.now = 0.0
        sent = b""
        for index in range(1, 6):
            instance.step(index * STEP)
            instance.fmu.enterEventMode()
            sent += instance.settle()
        runs.append(sent)
    instance.fmu.freeFMUState(state)
    assert runs[0]
    assert runs[0] == runs[1]
