"""End-to-end protection: byte for byte what autosar-e2e says, both ways, and the order of counters."""

import subprocess
from pathlib import Path
from random import Random

import pytest
from e2e import p04, p05, p06, p07

from sigcat.adapter.autosar_adaptive.bench.runtime_files import runtime_files
from sigcat.adapter.toolchain import toolchain
from tests.needs import c_compiler
from tests.reference_tools import checked_with

pytestmark = c_compiler

HERE = Path(__file__).parent
OFFSET = 8
HEADERS = {4: 12, 5: 3, 6: 5, 7: 20}
LAST = {4: 0xFFFF, 5: 0xFF, 6: 0xFF, 7: 0xFFFFFFFF}
REFERENCES = {
    4: (p04.e2e_p04_protect, p04.e2e_p04_check),
    5: (p05.e2e_p05_protect, p05.e2e_p05_check),
    6: (p06.e2e_p06_protect, p06.e2e_p06_check),
    7: (p07.e2e_p07_protect, p07.e2e_p07_check),
}
COUNTERS = {4: (2, 2, "big"), 5: (2, 1, "little"), 6: (4, 1, "big"), 7: (12, 4, "big")}
"""Offset of the counter in the header, its number of bytes, and their order."""
OK, REPEATED, WRONG_SEQUENCE, ERROR = 0, 1, 2, 3


@pytest.fixture(scope="session")
def program(tmp_path_factory):
    folder = tmp_path_factory.mktemp("e2e")
    for file in runtime_files():
        (folder / file.name).parent.mkdir(parents=True, exist_ok=True)
        (folder / file.name).write_bytes(file.data)
    sources = [HERE / "protect.cpp", *sorted((folder / "src/e2e").glob("*.cpp"))]
    flags = ["-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"]
    places = [f"-I{folder / name}" for name in ("include", "src")]
    subprocess.run([*toolchain().cpp, *flags, *places, *sources, "-o", folder / "protect"], check=True)
    return folder / "protect"


def answers(program, lines):
    run = subprocess.run([program], input="\n".join(lines), capture_output=True, text=True, check=True, timeout=60)
    return run.stdout.splitlines()


def data_id(random, profile):
    return random.randrange(2**32 if profile in (4, 7) else 2**16)


def reference(profile, number, counter, header, values):
    """The protected message as the other implementation makes it: it counts up before it protects."""
    protect, _ = REFERENCES[profile]
    message = bytearray(header + bytes(HEADERS[profile]) + values)
    at, width, order = COUNTERS[profile]
    message[OFFSET + at : OFFSET + at + width] = counter.to_bytes(width, order)
    protect(message, number, offset=OFFSET, increment_counter=False)
    return bytes(message)


@checked_with(
    "autosar-e2e", "Messages are protected with the same bytes by profiles 4 to 7, and the same ones are rejected"
)
@pytest.mark.parametrize("profile", REFERENCES)
def test_a_sender_adds_what_the_other_implementation_adds(profile, program):
    random = Random(profile)
    made, lines = [], []
    for length in (0, 1, 2, 7, 64, 1380, *(random.randrange(500) for _ in range(100))):
        header, values, number = random.randbytes(8), random.randbytes(length), data_id(random, profile)
        counter = random.choice((0, 1, LAST[profile] - 1, LAST[profile]))
        made.append((number, counter, header, values))
        lines.append(f"protect {profile} {number} {counter} {header.hex()} .{values.hex()}")
    for (number, counter, header, values), line in zip(made, answers(program, lines), strict=True):
        payload, following = line.split(" ")
        assert header + bytes.fromhex(payload) == reference(profile, number, counter, header, values)
        assert int(following) == (counter + 1) % (LAST[profile] + 1)
        assert REFERENCES[profile][1](header + bytes.fromhex(payload), number, offset=OFFSET)


def check(profile, number, most, message):
    return f"check {profile} {number} {most} {message[:OFFSET].hex()} .{message[OFFSET:].hex()}"


@checked_with(
    "autosar-e2e", "Messages are protected with the same bytes by profiles 4 to 7, and the same ones are rejected"
)
@pytest.mark.parametrize("profile", REFERENCES)
def test_a_receiver_accepts_what_the_other_implementation_accepts_and_nothing_else(profile, program):
    random, number = Random(profile), 0x1234
    lines, expected = [], []
    for counter in range(200):
        message = reference(profile, number, counter, random.randbytes(8), random.randbytes(random.randrange(40)))
        broken = bytearray(message)
        broken[random.randrange(len(message))] ^= 1 << random.randrange(8)
        for each in (bytes(broken), message[: random.randrange(OFFSET, len(message))], message):
            is_good = len(each) >= OFFSET + HEADERS[profile] and REFERENCES[profile][1](each, number, offset=OFFSET)
            lines.append(check(profile, number, 1, each))
            expected.append(OK if is_good else ERROR)
    assert [int(line) for line in answers(program, lines)] == expected
    assert expected.count(OK) == 200


@pytest.mark.parametrize("profile", REFERENCES)
def test_a_message_of_another_sender_is_broken(profile, program):
    message = reference(profile, 0x1234, 0, bytes(8), b"values")
    assert answers(program, [check(profile, 0x1235, 1, message)]) == [str(ERROR)]


@pytest.mark.parametrize("profile", REFERENCES)
@pytest.mark.parametrize(
    ("counters", "statuses"),
    [
        ((0, 1, 2), (OK, OK, OK)),
        ((0, 0, 1), (OK, REPEATED, OK)),
        ((0, 3, 6, 10, 11), (OK, OK, OK, WRONG_SEQUENCE, OK)),
        ((0, 1, 0, 1), (OK, OK, WRONG_SEQUENCE, OK)),
        ((9, 10), (WRONG_SEQUENCE, OK)),
        ((-2, -1, 0, 1), (WRONG_SEQUENCE, OK, OK, OK)),
    ],
    ids=["in order", "repeated", "lost", "begun again", "heard late", "wrapped"],
)
def test_counters_of_up_to_two_lost_messages(profile, counters, statuses, program):
    wrapped = (counter % (LAST[profile] + 1) for counter in counters)
    lines = [check(profile, 7, 3, reference(profile, 7, counter, bytes(8), b"values")) for counter in wrapped]
    assert tuple(map(int, answers(program, lines))) == statuses
