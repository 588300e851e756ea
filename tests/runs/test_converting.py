"""The library in C converts to the same bytes as Python."""

import io
import random
import struct
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from scripts.cases import ROOT, RUNS
from sigcat.adapter.host.shapes import SECONDS, Array, Number, Record, Shape, packing
from sigcat.adapter.toolchain import toolchain
from sigcat.cli import main
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.runs import simulate
from sigcat.runs.building.library import convert_library
from sigcat.runs.converting.layout import csv_tables, mcap_tables
from sigcat.runs.converting.library import Writer
from sigcat.runs.driver.tables import Target
from sigcat.runs.recording.cells import cell_of
from sigcat.runs.recording.mcap_file import message_text
from sigcat.runs.recording.outside import OutsideValues
from sigcat.runs.recording.trace_file import Known, moments, open_trace
from sigcat.runs.running.converted_input import convert_csv
from sigcat.runs.running.written_input import moment_bytes

MODE = Number("uint8", (("OFF", 0), ("ON", 7)))
SHAPES: dict[str, Shape] = {
    **{name: Number(name) for name in (
        "boolean", "uint8", "int8", "uint16", "int16", "uint32", "int32", "uint64", "int64", "float", "double",
    )},
    "mode": MODE,
    "call": SECONDS,
    "levels": Array(Number("float"), 2),
}  # fmt: skip
WRITTEN: dict[str, Shape] = {
    **{name: shape for name, shape in SHAPES.items() if shape != SECONDS},
    "modes": Array(MODE, 2),
    "one": Array(Number("int8"), 1),
    "point": Record((("X", Number("float")), ("Y", Record((("Z", MODE),))))),
}


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    found = convert_library(tmp_path_factory.mktemp("library"), toolchain())
    assert found is not None
    return found


# -- traces -------------------------------------------------------------------------------------------------------


def _both(text, folder, library):
    """The input of the driver and the findings about a trace, of Python and of the library."""
    file = folder / "trace.csv"
    file.write_bytes(text)
    trace = open_trace(file, Known(SHAPES, ("other",)))
    targets = [Target("VALUE", 0, index, packing(shape)) for index, shape in enumerate(SHAPES.values())]
    by_column = {name: [index, index] if name == "int8" else [index] for index, name in enumerate(SHAPES)}

    def by_python(written):
        found: list[Finding] = []
        rows = list(_until_refused(moments(trace), found))
        written.write(b"".join(moment_bytes(row, by_column, targets) for row in rows))
        return found, [(row.time, row.line) for row in rows][-1:]

    def by_library(written):
        try:
            span = convert_csv(written, trace, by_column, targets, library, OutsideValues({}))
        except InputRefused as refused:
            return list(refused.findings), None
        return [], [(span.last, span.line)] if span.last is not None else []

    python, other = io.BytesIO(), io.BytesIO()
    return (by_python(python), python.getvalue()), (by_library(other), other.getvalue())


def _until_refused(rows, found):
    try:
        yield from rows
    except InputRefused as refused:
        found += refused.findings


def _assert_same(text, folder, library):
    ((found, last), data), ((other_found, other_last), other) = _both(text, folder, library)
    assert other_found == found
    assert _plain(other) == _plain(data)
    assert found or other_last == last


def _plain(data):
    """NaN has many bit patterns."""
    return data.replace(struct.pack("<f", -float("nan")), struct.pack("<f", float("nan")))


NUMBERS = (
    st.floats().map(repr) | st.floats(width=32).map(repr) | st.integers(-(2**65), 2**65).map(str)
    | st.decimals(allow_nan=False, allow_infinity=False, places=9).map(str) | st.from_regex(r"[+-]?[0-9]{1,30}(\.[0-9]{0,40})?(e[+-]?[0-9]{1,3})?", fullmatch=True)
)  # fmt: skip
WORDS = st.sampled_from(
    ["", "true", "FALSE", "0", "1", "ON", "off", "2", "nan", "-inf", " 1", "1 ", "0x10", "1_0", "1.0", '"[1,2]"', '"1"', "é", "1e400"]
)  # fmt: skip


@example(("float",), ["1.00000005960464477539062500001"])
@example(("float",), ["16777217"])
@example(("float",), ["7.006492321624085354618647916449580656401309709382578858785341419448955413429304e-46"])
@example(("float",), ["340282356779733661637539395458142568447"])
@example(("double",), ["123456789012345678901234567890e-10"])
@given(
    st.lists(st.sampled_from(list(SHAPES)), min_size=1, max_size=3, unique=True), st.lists(NUMBERS | WORDS, max_size=12)
)
def test_a_trace_is_read_alike(library, tmp_path_factory, columns, cells):
    rows = [cells[at : at + len(columns)] for at in range(0, len(cells), len(columns))]
    lines = [",".join(["time", *columns])]
    lines += [f"{index / 4},{','.join([*row, *[''] * (len(columns) - len(row))])}" for index, row in enumerate(rows)]
    _assert_same("\n".join([*lines, ""]).encode(), tmp_path_factory.mktemp("trace"), library)


@pytest.mark.parametrize(
    "text",
    [
        b"time,int8\n0,1\n1,2",
        b"time,int8\r\n0,1\r\n\r\n1,2\r\n",
        b"\xef\xbb\xbf\n\ntime,other,int8\n0,x,1\n",
        b"time,int8\n1,1\n0,2\n2,3\n",
        b"time,int8\n0,1,2\n1,2\n",
        b"time,int8\n0,\xff\n1,2\n",
        b'time,int8\n0,"1\n1,2\n',
        b"time,int8\n" + b"0,x\n" * 200,
        b"time\n0\n9999999999\n1e1\n",
        b"time,int8\n0," + b"1" * (5 << 20) + b"\n",
        b"time,int8\n",
    ],
)
def test_what_is_wrong_with_a_trace_is_told_alike(library, tmp_path, text):
    _assert_same(text, tmp_path, library)


def test_pieces_of_a_trace_fit_together(library, tmp_path):
    numbers = random.Random(1)
    lines = [f"{index / 100},{numbers.uniform(-1e3, 1e3):.{index % 17}f},{index % 128}" for index in range(100_000)]
    _assert_same("\n".join(["time,double,int8", *lines]).encode(), tmp_path, library)


# -- results ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", WRITTEN)
@given(data=st.data())
def test_a_value_is_written_alike(library, name, data):
    shape = WRITTEN[name]
    form = packing(shape)
    drawn = data.draw(st.binary(min_size=form.struct.size, max_size=form.struct.size) | _nice(shape))
    value = form.unpack(drawn)
    row = b"S" + bytes(12) + drawn + b"E" + (2**32 - 1).to_bytes(4, "little") + bytes(16)
    used, text, is_left = Writer(library, csv_tables([(shape, 0)], [], [], 1)).csv(row, 0)
    cell = cell_of(value, shape)
    quoted = '"' + cell.replace('"', '""') + '"' if "," in cell or '"' in cell else cell
    if not is_left:
        assert (used, text.decode()) == (len(row), f"0.000000000,,{quoted}\n")
    used, text, is_left = Writer(library, mcap_tables([(shape, 1)], [], [])).mcap(row, 0)
    if not is_left:
        assert text[31:].decode() == message_text(value, shape).replace(", ", ",")


def _nice(shape):
    """Bytes of numbers as people write them."""
    if shape not in (Number("float"), Number("double")):
        return st.nothing()
    return st.decimals(-(10**7), 10**7, places=4).map(lambda number: packing(shape).pack(float(number)))


def test_powers_of_two_are_written_alike(library):
    for number in (
        factor * base**power for power in range(-300, 300, 7) for factor, base in ((1, 2.0), (3, 2.0), (1, 10.0))
    ):
        row = b"S" + bytes(12) + struct.pack("<d", number) + b"E" + (2**32 - 1).to_bytes(4, "little") + bytes(16)
        _, text, is_left = Writer(library, csv_tables([(Number("double"), 0)], [], [], 1)).csv(row, 0)
        assert is_left or text.decode() == f"0.000000000,,{number!r}\n", number


# -- whole runs ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", RUNS.names)
def test_a_run_is_written_alike(name, tmp_path, monkeypatch):
    """All forms of each case; its MCAP is read again, too."""
    pytest.importorskip("mcap", reason="MCAP: pip install mcap")
    monkeypatch.chdir(ROOT / RUNS.folder / name)
    words = Path("options").read_text().split()
    made = {}
    for limit in (0, 1 << 40):
        monkeypatch.setattr(simulate, "LONG_BYTES", limit)
        monkeypatch.setattr(simulate, "LONG_CALLS", limit)
        first, again = ([tmp_path / f"{kind}{limit}{end}" for end in (".csv", ".mcap")] for kind in ("first", "again"))
        assert main(["simulate", *words, *_outputs(first)]) == 0
        mcap = [str(first[1]) if word == "trace.csv" else word for word in words]
        assert main(["simulate", *mcap, *_outputs(again)]) == 0
        made[limit] = [path.read_bytes() for path in (*first, *again)]
    assert made[0] == made[1 << 40]
    assert made[0][0].decode() == RUNS.text(name)


def _outputs(paths):
    return [word for path in paths for word in ("-o", str(path))]
