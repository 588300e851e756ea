"""Serialization of values, by every setting of the transformation, as in PRS_SOMEIPProtocol."""

import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.needs import c_compiler

pytestmark = c_compiler
MALFORMED = "malformed"


class Settings(NamedTuple):
    """As in a deployment file; lengths and alignment in bytes."""

    big_endian: bool = True
    alignment: int = 1
    array_length: int = 4
    string_length: int = 4
    struct_length: int = 0
    utf16: bool = False


def run(program: Path, settings: Settings, name: str, lines: Sequence[str] = ()) -> Sequence[str]:
    """Return the bytes of the track of a name, and the values that the bytes of the lines have."""
    arguments = [str(int(setting)) for setting in settings]
    done = subprocess.run(
        [program, *arguments, name],
        input="".join(f"{line}\n" for line in lines),
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    return done.stdout.splitlines()


def bytes_of(*parts: str) -> str:
    """Bytes, written apart so that one sees what each part is."""
    return "".join(parts).replace(" ", "")


MARK, END = "efbbbf", "00"
MODE, DISTANCE = "01", "3fe0000000000000"
CORNERS, FLAGS = "0001 fffe 0003 fffc", "01 00"


@pytest.mark.parametrize(
    ("settings", "expected"),
    [
        (Settings(), bytes_of("00000006", MARK, "6162", END, MODE, "00000008", CORNERS, "00000002", FLAGS, DISTANCE)),
        (
            Settings(big_endian=False),
            bytes_of("06000000", MARK, "6162", END, MODE, "08000000", "0100 feff 0300 fcff", "02000000", FLAGS)
            + "000000000000e03f",
        ),
        (
            Settings(array_length=2, string_length=1),
            bytes_of("06", MARK, "6162", END, MODE, "0008", CORNERS, "0002", FLAGS, DISTANCE),
        ),
        (
            Settings(struct_length=2),
            bytes_of("0025", "00000006", MARK, "6162", END, MODE, "00000008", CORNERS, "00000002", FLAGS, DISTANCE),
        ),
        (
            Settings(alignment=4),
            bytes_of("00000006", MARK, "6162", END, "0000", MODE, "00000008", CORNERS, "00000002", FLAGS, "00")
            + DISTANCE,
        ),
        (
            Settings(alignment=32),  # counted from the beginning of the message, whose header has 16 bytes
            bytes_of("00000006", MARK, "6162", END, "000000000000", MODE, "00000008", CORNERS, "00000002", FLAGS)
            + "00" * 13
            + DISTANCE,
        ),
        (
            Settings(utf16=True),
            bytes_of("00000008", "feff 0061 0062 0000", MODE, "00000008", CORNERS, "00000002", FLAGS, DISTANCE),
        ),
        (
            Settings(utf16=True, big_endian=False),
            bytes_of("08000000", "fffe 6100 6200 0000", MODE, "08000000", "0100 feff 0300 fcff", "02000000", FLAGS)
            + "000000000000e03f",
        ),
    ],
    ids=[
        "default", "little endian", "short lengths", "length of a struct", "aligned", "aligned beyond the header",
        "UTF-16", "UTF-16, little endian",
    ],
)  # fmt: skip
def test_a_track_as_bytes_and_back(built: Mapping[str, Path], settings: Settings, expected: str) -> None:
    written, read = run(built["serialization"], settings, "ab", [expected])
    assert written == expected
    assert read == "ab 1 1 -2 3 -4 yes no 0.5"


@pytest.mark.parametrize("name", ["", "Nürburg", "日本", "🚗", "ab\x7f"])
@pytest.mark.parametrize("utf16", [False, True])
def test_texts_of_every_alphabet_come_back(built: Mapping[str, Path], name: str, utf16: bool) -> None:
    settings = Settings(utf16=utf16)
    written = run(built["serialization"], settings, name)[0]
    assert run(built["serialization"], settings, name, [written])[1] == f"{name} 1 1 -2 3 -4 yes no 0.5"


GOOD = ("00000006", MARK, "6162", END, MODE, "00000008", CORNERS, "00000002", FLAGS, DISTANCE)


def spoilt(part: int, value: str) -> str:
    """The bytes of the default settings with another part."""
    parts = list(GOOD)
    parts[part] = value
    return bytes_of(*parts)


@pytest.mark.parametrize(
    ("settings", "received", "said"),
    [
        (Settings(), "", MALFORMED),
        (Settings(), bytes_of(*GOOD)[:-2], MALFORMED),
        (Settings(), spoilt(0, "ffffffff"), MALFORMED),
        (Settings(), spoilt(5, "00000006"), MALFORMED),
        (Settings(), spoilt(7, "00000fff"), MALFORMED),
        (Settings(), bytes_of(*GOOD) + "0102", "ab 1 1 -2 3 -4 yes no 0.5"),
        (Settings(), spoilt(8, "03 fe"), "ab 1 1 -2 3 -4 yes no 0.5"),
        (Settings(), bytes_of("00000002", "6162", *GOOD[4:]), "ab 1 1 -2 3 -4 yes no 0.5"),
        (
            Settings(struct_length=2),
            bytes_of("0027", *GOOD, "abcd"),
            "ab 1 1 -2 3 -4 yes no 0.5",
        ),
        (Settings(struct_length=2), bytes_of("0024", *GOOD), MALFORMED),
        (
            Settings(),
            bytes_of(*GOOD[:5], "0000000a", CORNERS, "7fff", *GOOD[7:]),
            "ab 1 1 -2 3 -4 yes no 0.5",
        ),
    ],
    ids=[
        "nothing", "cut", "endless text", "array too short", "open array too long", "more at the end",
        "lowest bit of a boolean", "text without mark and end", "newer struct", "struct too short", "longer array",
    ],
)  # fmt: skip
def test_what_others_send_is_read_or_refused(
    built: Mapping[str, Path], settings: Settings, received: str, said: str
) -> None:
    assert run(built["serialization"], settings, "", [received])[1] == said
