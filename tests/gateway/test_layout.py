"""Bits of signals are the numbers that cantools takes out of a frame: whatever order, length, sign and place they have."""

import math
import random
from typing import Any

import cantools
import pytest

from sigcat.gateway.layout import bits, numbers, width

FLOATS = {32: 1, 64: 2}


def random_database(chance: random.Random, size: int) -> Any:
    """A database of messages with one signal each."""
    lines, floats = ['VERSION ""', "BU_: Gateway"], []
    for number in range(1, 200):
        is_float = chance.random() < 0.2
        length = chance.choice([32, 64]) if is_float else chance.randint(1, 64)
        first = chance.randint(0, size * 8 - length)
        is_big = chance.random() < 0.5
        start = first // 8 * 8 + 7 - first % 8 if is_big else first
        sign = "-" if is_float or chance.random() < 0.5 else "+"
        lines.append(f"BO_ {number} M{number}: {size} Gateway")
        lines.append(f' SG_ S : {start}|{length}@{"0" if is_big else "1"}{sign} (1,0) [0|0] "" Gateway')
        if is_float:
            floats.append(f"SIG_VALTYPE_ {number} S : {FLOATS[length]};")
    return cantools.database.load_string("\n".join([*lines, *floats]), "dbc")


@pytest.mark.parametrize("size", [8, 64])
def test_numbers_are_those_of_cantools(size):
    chance = random.Random(size)
    for message in random_database(chance, size).messages:
        (signal,) = message.signals
        where, number = bits(signal, width(message)), numbers(signal)
        for _ in range(5):
            data = chance.randbytes(size)
            word = int.from_bytes(data[: width(message)], "big" if where.is_big else "little")
            found = number(word >> where.shift & where.mask)
            expected = message.decode(data, scaling=False, decode_choices=False)["S"]
            assert found == expected or (math.isnan(found) and math.isnan(expected))


def test_a_signal_needs_the_bytes_that_cantools_needs():
    chance = random.Random(3)
    for message in random_database(chance, 8).messages:
        (signal,) = message.signals
        for count in range(9):
            given = message.decode(chance.randbytes(count), scaling=False, decode_choices=False, allow_truncated=True)
            assert (bits(signal, width(message)).size <= count) == ("S" in given)
