"""SAE J1939: messages by PGN, and those that are longer than a frame."""

import can
import pytest

from sigcat.cli import main
from sigcat.gateway.frames import Frame
from sigcat.gateway.j1939 import assembled, pgn

DBC = """\
VERSION ""
BU_: Engine
BO_ 2565866238 EEC1: 8 Engine
 SG_ EngineSpeed : 24|16@1+ (0.125,0) [0|8031.875] "rpm" Engine
BO_ 2566843134 Long: 10 Engine
 SG_ Last : 72|8@1+ (1,0) [0|250] "" Engine
"""
SAYS_SO = """\
BA_DEF_ BO_ "VFrameFormat" ENUM "StandardCAN","ExtendedCAN","reserved","J1939PG";
BA_DEF_DEF_ "VFrameFormat" "J1939PG";
BA_ "VFrameFormat" BO_ 2565866238 3;
BA_ "VFrameFormat" BO_ 2566843134 3;
"""
SPEED = bytes([0xFF, 0xFF, 0xFF, 0x68, 0x13, 0xFF, 0xFF, 0xFF])


@pytest.fixture
def run(tmp_path, capsys):
    def running(frames, *options, dbc=DBC + SAYS_SO, status=0):
        (tmp_path / "bus.dbc").write_text(dbc)
        (tmp_path / "can.vspec").write_text(
            "Vehicle.Speed: {type: sensor, datatype: float, dbc2vss: {signal: EngineSpeed, interval_ms: 0}}\n"
            "Vehicle.Width: {type: sensor, datatype: uint8, dbc2vss: {signal: Last, interval_ms: 0}}\n"
        )
        log = tmp_path / "drive.log"
        with can.Logger(str(log)) as logger:
            for index, (identifier, data) in enumerate(frames):
                logger.on_message_received(can.Message(timestamp=index, arbitration_id=identifier, data=data))
        given = [log, "--dbc", tmp_path / "bus.dbc", "-s", "vss", "-l", tmp_path / "can.vspec", *options]
        assert main(["gateway", *map(str, given)]) == status
        told = capsys.readouterr()
        return told.out.splitlines()[1:], told.err

    return running


IDENTIFIER = 2565866238 & 0x1FFFFFFF
OTHER = IDENTIFIER & 0x3FFFF00 | 7 << 26 | 0x21
"""The same PGN with another priority and source."""


@pytest.mark.parametrize(("dbc", "options"), [(DBC + SAYS_SO, ()), (DBC, ("--j1939",))])
def test_source_and_priority_do_not_matter(run, dbc, options):
    rows, _ = run([(IDENTIFIER, SPEED), (OTHER, SPEED)], *options, dbc=dbc)
    assert [row.split(",")[1] for row in rows] == ["621.0", "621.0"]


def test_without_j1939_the_identifier_counts(run):
    rows, told = run([(IDENTIFIER, SPEED), (OTHER, SPEED)], dbc=DBC)
    assert len(rows) == 1
    assert "1 with an identifier that the database does not have" in told


def test_messages_of_one_pgn_are_found_by_their_identifiers(run):
    """The database has one for each source, with other signals."""
    other = f'BO_ {OTHER | 1 << 31} EEC1b: 8 Engine\n SG_ Last : 24|8@1+ (1,0) [0|250] "" Engine\n'
    third = OTHER + 1
    rows, told = run(
        [(IDENTIFIER, SPEED), (OTHER, SPEED), (third, SPEED)], "--j1939", dbc=DBC.partition("BO_ 2566843134")[0] + other
    )
    assert [row.split(",")[1:] for row in rows] == [["621.0", ""], ["", "104"]]
    assert "1 with an identifier that the database does not have" in told


def test_a_message_of_a_destination_has_the_same_pgn_for_all():
    assert {pgn(0x18EAFF00), pgn(0x0CEA2100)} == {0xEA00}
    assert pgn(0x0CF00400) == 0xF004


def parts(group: int, *numbers: int, first: int = 32, size: int = 10) -> list[tuple[int, bytes]]:
    begin = bytes([first, size, 0, 2, 0xFF, *group.to_bytes(3, "little")])
    frames = [(0x18ECFF21, begin)]
    return frames + [(0x18EBFF21, bytes([n, *range(n * 10, n * 10 + 7)])) for n in numbers]


def test_a_long_message_is_put_together(run):
    rows, told = run(parts(pgn(2566843134), 1, 2))
    assert [row.split(",") for row in rows] == [["2.000000000", "", "22"]]
    assert "1 decoded, 3 of the transport protocol" in told


@pytest.mark.parametrize("numbers", [(1,), (2, 1), (1, 3)])
def test_a_long_message_with_a_part_missing_is_none(numbers):
    group = pgn(2566843134)
    frames = [Frame(0, identifier, True, data, "") for identifier, data in parts(group, *numbers)]
    assert not [each for each in assembled(frames) if isinstance(each, Frame)]
