"""The reader of players: each row of a normalized trace is its values, and a damaged one ends the player at its line."""

import subprocess
from pathlib import Path

import pytest

from sigcat.adapter.autosar_adaptive.application.player import player_source
from sigcat.adapter.host.shapes import Array, Number, Shape
from sigcat.adapter.toolchain import toolchain
from sigcat.runs.recording.cells import plain_text
from tests.needs import c_compiler

pytestmark = c_compiler
PLAYER = Path(player_source.__file__).with_name("cpp")
ARRAY = (
    "#include <array>\nnamespace ara::core { template <typename T, std::size_t n> using Array = std::array<T, n>; }\n"
)
MAIN = """
#include <cstdio>
#include <exception>

#include "player/cell.h"
#include "player/trace.h"

enum class Gear : std::int8_t { kP = 0, kLow = -2 };

namespace player {
template <>
const Symbols<Gear>::Names& Symbols<Gear>::All() {
    static const Names names{{"P", 0}, {"LOW, D", -2}};
    return names;
}
}  // namespace player

template <typename T>
void Print(const std::string& cell) { std::printf("%s\\n", player::Text(player::ReadAll<T>(cell)).c_str()); }

bool Take(const std::string& name, const std::string& cell) {
    if (name == "bool") { Print<bool>(cell); }
    if (name == "uint8") { Print<std::uint8_t>(cell); }
    if (name == "int16") { Print<std::int16_t>(cell); }
    if (name == "uint64") { Print<std::uint64_t>(cell); }
    if (name == "int64") { Print<std::int64_t>(cell); }
    if (name == "float") { Print<float>(cell); }
    if (name == "double") { Print<double>(cell); }
    if (name == "gear") { Print<Gear>(cell); }
    if (name == "gears") { Print<ara::core::Array<Gear, 2>>(cell); }
    if (name == "floats") { Print<ara::core::Array<float, 2>>(cell); }
    return true;
}

int main() {
    try {
        const player::Trace trace = player::ReadTrace("trace.tsv");
        for (const auto& row : trace.rows) {
            static_cast<void>(player::SendCells(trace.columns, row, Take));
        }
        return 0;
    } catch (const std::exception& error) {
        std::printf("%s\\n", error.what());
        return 1;
    }
}
"""


@pytest.fixture(scope="module")
def read(tmp_path_factory):
    """What the reader makes of the text of a normalized trace."""
    folder = tmp_path_factory.mktemp("reader")
    (folder / "player").symlink_to(PLAYER)
    (folder / "ara/core").mkdir(parents=True)
    (folder / "ara/core/array.h").write_text(ARRAY)
    (folder / "main.cpp").write_text(MAIN)
    options = ["-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror", f"-I{folder}"]
    sources = [folder / "main.cpp", folder / "player/trace.cpp"]
    subprocess.run(list(map(str, (*toolchain().cpp, *options, *sources, "-o", folder / "main"))), check=True)

    def reading(text: str) -> list[str]:
        (folder / "trace.tsv").write_text(text)
        return subprocess.run(
            [folder / "main"], cwd=folder, capture_output=True, text=True, check=False
        ).stdout.splitlines()

    return reading


VALUES: list[tuple[str, Shape, object, str]] = [
    ("bool", Number("boolean"), True, "true"),
    ("uint8", Number("uint8"), 255, "255"),
    ("int16", Number("int16"), -32768, "-32768"),
    ("uint64", Number("uint64"), 2**64 - 1, "18446744073709551615"),
    ("int64", Number("int64"), -(2**63), "-9223372036854775808"),
    ("float", Number("float"), 0.1, "0.100000001"),
    ("float", Number("float"), 1.401298464324817e-45, "1.40129846e-45"),
    ("double", Number("double"), 5e-324, "4.9406564584124654e-324"),
    ("double", Number("double"), float("-inf"), "-inf"),
    ("float", Number("float"), float("nan"), "nan"),
    ("gear", Number("int8", (("P", 0), ("LOW, D", -2))), -2, "LOW, D"),
    ("gear", Number("int8", (("P", 0), ("LOW, D", -2))), 7, "7"),
    ("gears", Array(Number("int8", (("P", 0), ("LOW, D", -2))), 2), [-2, 7], '["LOW, D",7]'),
    ("floats", Array(Number("float"), 2), [float("nan"), float("inf")], "[NaN,Infinity]"),
]


def test_every_value_is_read_and_recorded(read):
    rows = [(name, plain_text(value, shape)) for name, shape, value, _ in VALUES]
    columns = list(dict.fromkeys(name for name, _ in rows))
    lines = ["\t".join(["0", *(cell if name == each else "" for each in columns)]) for name, cell in rows]
    assert read("\n".join(["\t".join(["time_ns", *columns]), *lines, ""])) == [text for *_, text in VALUES]


DAMAGED = {
    "nothing": ("", "line 1: the trace must be normalized"),
    "a trace that is not normalized": ("time,uint8\n0,1\n", "line 1: the trace must be normalized"),
    "a time in seconds": ("time_ns\tuint8\n0.5\t1\n", 'line 2: "0.5" is not a value'),
    "a time that goes back": ("time_ns\tuint8\n1\t1\n0\t1\n", "line 3: it must have all cells, and a time"),
    "a cell too few": ("time_ns\tuint8\n0\n", "line 2: it must have all cells"),
    "a cell too many": ("time_ns\tuint8\n0\t1\t1\n", "line 2: it must have all cells"),
    "an empty line": ("time_ns\tuint8\n\n", "line 2: a value is missing."),
    "a row that was cut": ("time_ns\tuint8\n0\t12", "line 2: it must end with a line break."),
    "a word": ("time_ns\tuint8\n0\t1\n0\tone\n", 'line 3: uint8: "one" is not a value'),
    "a number too large": ("time_ns\tuint8\n0\t256\n", 'line 2: uint8: "256" is not a value'),
    "a number below 0": ("time_ns\tuint64\n0\t-1\n", 'line 2: uint64: "-1" is not a value'),
    "a number too large for any": ("time_ns\tint64\n0\t9223372036854775808\n", "line 2: int64: "),
    "a number that no float holds": ("time_ns\tfloat\n0\t1e39\n", 'line 2: float: "1e39" is not a value'),
    "a space": ("time_ns\tfloat\n0\t 1\n", 'line 2: float: " 1" is not a value'),
    "a boolean that is none": ("time_ns\tbool\n0\t2\n", 'line 2: bool: "2" is not true or false.'),
    "an unknown name": ("time_ns\tgear\n0\tR\n", 'line 2: gear: "R" is not a value'),
    "an element too few": ("time_ns\tfloats\n0\t1\n", "line 2: floats: a value is missing."),
    "an element too many": ("time_ns\tfloats\n0\t1;2;3\n", 'line 2: floats: "1;2;3" has too many values.'),
    "a list of JSON": ("time_ns\tfloats\n0\t[1, 2]\n", 'line 2: floats: "[1, 2]" is not a value'),
}


@pytest.mark.parametrize("name", DAMAGED)
def test_a_damaged_row_is_refused_at_its_line(read, name):
    text, told = DAMAGED[name]
    assert told in read(text)[-1]
