"""Bags of ROS 2 as traces: written in CDR by the package of MCAP's authors, with the definitions that sigcat generates."""

import csv
import json
import sqlite3
import struct
from contextlib import closing
from functools import cache
from pathlib import Path

import pytest
import zstandard
from mcap.reader import make_reader
from mcap.writer import CompressionType
from mcap.writer import Writer as RawWriter
from mcap_ros2.writer import Writer

from sigcat.adapter.host.shapes import Array, Number, Record
from sigcat.adapter.ros2.ros2_workspace import generate
from sigcat.cli import main
from sigcat.errors import InputRefused
from sigcat.function.function_json.conversion import IDENTITY, between
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.integrate import integrate
from sigcat.platforms.table import PLATFORMS
from sigcat.runs.recording.ros2_bag import Column, bag_as_csv, is_bag
from sigcat.runs.recording.trace_file import Known
from sigcat.runs.recording.traces import moments, open_trace
from tests.comparison.ecocontrol import EXAMPLES, subject

START = 1_764_000_000_000_000_000
SECOND = 10**9
FUNCTIONS = [str(EXAMPLES / name / "function.yaml") for name in ("core_acc", "eco_control_mpc")]
TIME = f"\n{'=' * 80}\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n"
SPEED = f"builtin_interfaces/Time stamp\n\n# Speed.\n# Vehicle.Speed [km/h]\nfloat32 speed{TIME}"
TWIST = (
    f"geometry_msgs/Vector3 linear\nuint8 gear\n{'=' * 80}\nMSG: geometry_msgs/Vector3\n"
    "float64 x\nfloat64 y\nfloat64 z\n"
)
STATUS = f"uint8 FAILED=1\nbuiltin_interfaces/Time stamp\n\n# PASSED or FAILED.\nuint8 status{TIME}"
KNOWN = Known(
    {
        "Vehicle.Speed": Number("float"),
        "Vehicle.Gear": Number("uint8", (("PARK", 0), ("DRIVE", 1))),
        "Hmi_LampFault_ErrorSts": Number("uint8", (("PASSED", 0), ("FAILED", 1))),
        "Vehicle.Pose": Record((("X", Number("float")), ("Marks", Array(Number("uint8"), 2)))),
    },
    None,
    units={"Vehicle.Speed": "km/h"},
)


def bag(path, *messages, schemas):
    """Write messages of topic, time in s and content."""
    with path.open("wb") as file:
        writer = Writer(file)
        known = {name: writer.register_msgdef(f"x_interfaces/msg/{name}", text) for name, text in schemas.items()}
        for topic, kind, time, content in messages:
            at = START + round(time * SECOND)
            writer.write_message(topic, known[kind], content, log_time=at, publish_time=at)
        writer.finish()
    return path


def stamped(**content):
    return {"stamp": {"sec": 0, "nanosec": 0}, **content}


def rows(path, tmp_path, known=KNOWN, **mapped):
    target = tmp_path / "bag.csv"
    notes = bag_as_csv(path, target, known, mapped)
    return target.read_text(), [note.message for note in notes]


def test_a_field_whose_comment_has_a_path_is_a_column_and_times_begin_with_the_first_message(tmp_path):
    path = bag(
        tmp_path / "a.mcap",
        ("/vehicle/speed", "Speed", 0, stamped(speed=36.5)),
        ("/rosout", "Other", 0.5, {"text": "hello"}),
        ("/vehicle/speed", "Speed", 1.25, stamped(speed=0.1)),
        schemas={"Speed": SPEED, "Other": "string text\n"},
    )
    assert is_bag(path)
    text, notes = rows(path, tmp_path)
    assert text == "time,Vehicle.Speed\n0.000000000,36.5\n1.250000000,0.1\n"
    assert notes == ["Topics without signals of the functions are skipped: /rosout."]


def test_the_status_of_an_error_has_its_name_in_the_topic_in_any_namespace(tmp_path):
    path = bag(
        tmp_path / "a.mcap", ("/car/hmi/lamp_fault", "ErrorStatus", 0, stamped(status=1)),
        ("/car/hmi/other_fault", "ErrorStatus", 0, stamped(status=1)), schemas={"ErrorStatus": STATUS},
    )  # fmt: skip
    text, notes = rows(path, tmp_path)
    assert text == "time,Hmi_LampFault_ErrorSts\n0.000000000,FAILED\n"
    assert "other_fault" in notes[0]


def test_members_of_a_struct_are_taken_in_their_order(tmp_path):
    pose = f"# Vehicle.Pose\nx_interfaces/Pose pose\n{'=' * 80}\nMSG: x_interfaces/Pose\nfloat32 x\nuint8[2] marks\n"
    content = {"pose": {"x": 1.5, "marks": [3, 4]}}
    text, _ = rows(bag(tmp_path / "a.mcap", ("/pose", "Holder", 0, content), schemas={"Holder": pose}), tmp_path)
    assert list(csv.reader(text.splitlines()))[1] == ["0.000000000", '{"X":1.5,"Marks":[3,4]}']


def test_existing_messages_are_mapped_with_their_unit_and_their_numbers(tmp_path):
    columns = (
        Column("linear.x", "Vehicle.Speed", between("m/s", "km/h") or IDENTITY),
        Column("gear", "Vehicle.Gear", symbols={22: "DRIVE"}),
    )
    content = {"linear": {"x": 10.0, "y": 0.0, "z": 0.0}, "gear": 22}
    path = bag(tmp_path / "a.mcap", ("/odom", "Twist", 0, content), schemas={"Twist": TWIST})
    text, _ = rows(path, tmp_path, **{"/odom": columns})
    assert text == "time,Vehicle.Speed,Vehicle.Gear\n0.000000000,36.0,DRIVE\n"


def test_a_field_that_the_messages_lack_is_reported(tmp_path, capsys):
    deployment = tmp_path / "deployment.yaml"
    deployment.write_text(
        "ros2:\n  messages:\n    /odom:\n      type: geometry_msgs/Twist\n"
        "      fields: {linear.q: {signal: Vehicle.Speed, unit: m/s}}\n"
    )
    content = {"linear": {"x": 10.0, "y": 0.0, "z": 0.0}, "gear": 22}
    path = bag(tmp_path / "a.mcap", ("/odom", "Twist", 0, content), schemas={"Twist": TWIST})
    assert (
        main(
            [
                "simulate",
                *FUNCTIONS,
                "--trace",
                str(path),
                "--deployment",
                str(deployment),
                "-o",
                str(tmp_path / "o.csv"),
            ]
        )
        == 1
    )
    assert "The messages of /odom must have the field linear.q" in capsys.readouterr().err
    assert not (tmp_path / "o.csv").exists()


@pytest.fixture(scope="module")
def drive(tmp_path_factory):
    """Eight seconds of EcoControl's drive as CSV, and as a bag in two files with the generated definitions."""
    folder = tmp_path_factory.mktemp("bag")
    lines = (EXAMPLES / "ecocontrol/drive.csv").read_text().splitlines()
    kept = [line for line in lines[1:] if float(line.partition(",")[0]) <= 8]
    (folder / "drive.csv").write_text("\n".join([lines[0], *kept, ""]))
    topics = _generated_topics()
    messages = []
    for row in csv.DictReader([lines[0], *kept]):
        for path, text in row.items():
            if text and path in topics:
                topic, kind, field = topics[path]
                messages.append((topic, kind, float(row["time"]), stamped(**_content(kind, field, text))))
    schemas = {kind: text for _, kind, _ in topics.values() for text in [_definitions()[kind]]}
    (folder / "record").mkdir()
    half = len(messages) // 2
    bag(folder / "record/record_0.mcap", *messages[:half], schemas=schemas)
    bag(folder / "record/record_1.mcap", *messages[half:], schemas=schemas)
    (folder / "record/metadata.yaml").write_text(json.dumps({"rosbag2_bagfile_information": {
        "version": 9, "storage_identifier": "mcap", "relative_file_paths": ["record_0.mcap", "record_1.mcap"],
    }}))  # fmt: skip
    return folder


@cache
def _definitions():
    found = subject()
    document = integrate(PLATFORMS["ros2"], found.functions, found.deployment).document
    files = {Path(file.name): file.data.decode() for file in generate(document, "ros2.json", DEFAULT_LIMITS, None)}
    return {path.stem: text + TIME for path, text in files.items() if path.suffix == ".msg"}


def test_a_bag_gives_the_same_bits_as_the_drive(drive, tmp_path):
    outputs = {}
    for trace, seconds in (("drive.csv", 8), ("record", 8), ("record/record_0.mcap", 1)):
        out = tmp_path / "out.csv"
        assert (
            main(["simulate", *FUNCTIONS, "--trace", str(drive / trace), "--duration", str(seconds), "-o", str(out)])
            == 0
        )
        outputs[trace] = out.read_bytes()
    assert outputs["drive.csv"] == outputs["record"]
    assert outputs["drive.csv"].count(b"CoreAcc_Step") > 50


@pytest.mark.parametrize("cut", [10, 200, 1000, -5])
def test_a_damaged_bag_is_reported_and_nothing_is_written(drive, tmp_path, cut, capsys):
    data = (drive / "record/record_0.mcap").read_bytes()
    (tmp_path / "record").mkdir()
    (tmp_path / "record/record_0.mcap").write_bytes(data[:cut])
    metadata = {"storage_identifier": "mcap", "relative_file_paths": ["record_0.mcap"]}
    (tmp_path / "record/metadata.yaml").write_text(json.dumps({"rosbag2_bagfile_information": metadata}))
    assert main(["simulate", *FUNCTIONS, "--trace", str(tmp_path / "record"), "-o", str(tmp_path / "o.csv")]) == 1
    assert "T001" in capsys.readouterr().err
    assert not (tmp_path / "o.csv").exists()


@pytest.mark.parametrize(
    ("metadata", "status", "said"),
    [
        ("a: [", 1, "must be that of a bag"),
        ("rosbag2_bagfile_information: 3", 1, "must be that of a bag"),
        ("rosbag2_bagfile_information: {storage_identifier: sqlite3, relative_file_paths: []}", 1, "has no topic"),
        ("rosbag2_bagfile_information: {storage_identifier: tape, relative_file_paths: []}", 2, "MCAP or SQLite"),
        (
            "rosbag2_bagfile_information: {storage_identifier: mcap, relative_file_paths: [], compression_format: lz4}",
            2, "by zstd, not 'lz4'",
        ),
        (
            "rosbag2_bagfile_information: {storage_identifier: mcap, relative_file_paths: [], topics_with_message_count: [3]}",
            1, "must be that of a bag",
        ),
        ("rosbag2_bagfile_information: {storage_identifier: mcap, relative_file_paths: [x]}", 2, "must be in the folder"),
        ("rosbag2_bagfile_information: {storage_identifier: mcap, relative_file_paths: [/etc/passwd]}", 2, "/etc/passwd"),
    ],
)  # fmt: skip
def test_metadata_that_cannot_be_used_is_reported(tmp_path, metadata, status, said, capsys):
    (tmp_path / "metadata.yaml").write_text(metadata)
    assert main(["simulate", *FUNCTIONS, "--trace", str(tmp_path)]) == status
    assert said in capsys.readouterr().err


def _generated_topics():
    """Topic, message and field of each column of the drive."""
    from sigcat.runs.recording.ros2_bag import _fields

    aliases = {name: each.names for each in subject().prepared.connections.entries for name in each.names}
    found = {}
    for kind, text in _definitions().items():
        for field in _fields(text):
            for name in aliases.get(field.path, ()) if field.path else ():
                found[name] = (f"/{kind.lower()}", kind, field.name)
    return found


def _content(kind, field, text):
    definition = _definitions()[kind]
    constants = dict(
        line.removeprefix("uint8 ").split("=")
        for line in definition.splitlines()
        if line.startswith("uint8 ") and "=" in line
    )
    if f"string {field}" in definition:
        return {field: text, f"{field}_number": int(constants[text])}
    if text in constants:
        return {field: int(constants[text])}
    return {field: text == "true" if text in ("true", "false") else json.loads(text)}


def test_a_bag_whose_recording_was_cut_off_is_reported(drive, tmp_path, capsys):
    """Without its end, as after a crash of the recorder: no summary names the topics."""
    data = (drive / "record/record_0.mcap").read_bytes()
    (tmp_path / "a.mcap").write_bytes(data[: data.index(b"\x89MCAP0\r\n", 8) - 200])
    metadata = {"storage_identifier": "mcap", "relative_file_paths": ["a.mcap"]}
    (tmp_path / "metadata.yaml").write_text(json.dumps({"rosbag2_bagfile_information": metadata}))
    assert main(["simulate", *FUNCTIONS, "--trace", str(tmp_path)]) == 1
    assert "T001" in capsys.readouterr().err


def test_files_of_a_bag_that_overlap_in_time_are_one_trace(tmp_path):
    """A recorder splits by size, and stores messages of several topics almost in order."""
    for name, times in (("a", (2, 4)), ("b", (1, 3))):
        written = [("/vehicle/speed", "Speed", time, stamped(speed=time)) for time in times]
        bag(tmp_path / f"{name}.mcap", *written, schemas={"Speed": SPEED})
    described(tmp_path, "mcap", "a.mcap", "b.mcap")
    text, _ = rows(tmp_path, tmp_path)
    assert [row.split(",")[1] for row in text.splitlines()[1:]] == ["1.0", "2.0", "3.0", "4.0"]


def test_each_message_of_a_burst_has_its_own_time(tmp_path):
    """A node may have taken several with one call: no time says so, and none of them is joined."""
    burst = [("/vehicle/speed", "Speed", 1 + number / 10**6, stamped(speed=number)) for number in range(3)]
    text, _ = rows(bag(tmp_path / "a.mcap", *burst, schemas={"Speed": SPEED}), tmp_path)
    assert text.splitlines()[1:] == ["0.000000000,0.0", "0.000001000,1.0", "0.000002000,2.0"]


# -- the forms in which `ros2 bag record` stores a bag ------------------------------------------------------------

SCHEMA = """
CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format TEXT NOT NULL,
  offered_qos_profiles TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, data BLOB NOT NULL);
"""
DEFINED = """
CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT NULL,
  encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);
"""


def described(folder, storage, *names, **compression):
    """Write metadata.yaml."""
    content = {"version": 9, "storage_identifier": storage, "relative_file_paths": list(names), **compression}
    (folder / "metadata.yaml").write_text(json.dumps({"rosbag2_bagfile_information": content}))


def in_sqlite(source, target, is_defined=True, packed=bytes):
    """Write the messages of a file in MCAP as the plugin of rosbag2 for SQLite does; without definitions, that of Humble."""
    with closing(sqlite3.connect(target)) as database, source.open("rb") as file:
        database.executescript(SCHEMA + (DEFINED if is_defined else ""))
        topics: dict[str, int] = {}
        for schema, channel, message in make_reader(file).iter_messages(log_time_order=False):
            assert schema is not None
            if channel.topic not in topics:
                topics[channel.topic] = len(topics) + 1
                number = topics[channel.topic]
                database.execute("INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')", (number, channel.topic, schema.name))
                if is_defined:
                    definition = (number, schema.name, "ros2msg", schema.data.decode(), "")
                    database.execute("INSERT INTO message_definitions VALUES (?, ?, ?, ?, ?)", definition)
            row = (topics[channel.topic], message.log_time, packed(message.data))
            database.execute("INSERT INTO messages (topic_id, timestamp, data) VALUES (?, ?, ?)", row)
        database.commit()
    return target


def packed_by_message(source, target):
    """Write a file in MCAP with each message compressed."""
    with source.open("rb") as file, target.open("wb") as out:
        writer = RawWriter(out)
        writer.start()
        channels = {}
        for schema, channel, message in make_reader(file).iter_messages():
            assert schema is not None
            if channel.topic not in channels:
                number = writer.register_schema(schema.name, schema.encoding, schema.data)
                channels[channel.topic] = writer.register_channel(channel.topic, "cdr", number)
            time, data = message.log_time, zstandard.compress(message.data)
            writer.add_message(channels[channel.topic], time, data, time)
        writer.finish()


@pytest.fixture
def recorded(tmp_path):
    """A file in MCAP with two topics, and its trace."""
    path = bag(
        tmp_path / "recorded.mcap",
        ("/speed", "Speed", 0, stamped(speed=36.5)), ("/hmi/lamp_fault", "ErrorStatus", 0.5, stamped(status=1)),
        ("/speed", "Speed", 1.25, stamped(speed=0.1)), schemas={"Speed": SPEED, "ErrorStatus": STATUS},
    )  # fmt: skip
    return path, rows(path, tmp_path)


@pytest.mark.parametrize("storage", ["mcap", "sqlite3"])
@pytest.mark.parametrize("compression", ["none", "file", "message"])
def test_each_storage_and_compression_gives_the_same_trace(recorded, tmp_path, storage, compression):
    source, expected = recorded
    folder = tmp_path / "bag"
    folder.mkdir()
    file = folder / {"mcap": "bag_0.mcap", "sqlite3": "bag_0.db3"}[storage]
    if storage == "sqlite3":
        in_sqlite(source, file, packed=zstandard.compress if compression == "message" else bytes)
    elif compression == "message":
        packed_by_message(source, file)
    else:
        file.write_bytes(source.read_bytes())
    if compression == "file":
        packed = file.with_name(f"{file.name}.zstd")
        packed.write_bytes(zstandard.compress(file.read_bytes()))
        file.unlink()
        file = packed
    form = {} if compression == "none" else {"compression_format": "zstd", "compression_mode": compression.upper()}
    described(folder, storage, file.name, **form)
    assert is_bag(folder)
    assert rows(folder, tmp_path) == expected
    assert is_bag(file)
    assert rows(file, tmp_path) == expected


@pytest.mark.parametrize("storage", ["mcap", "sqlite3"])
def test_a_topic_that_is_counted_and_absent_is_reported(recorded, tmp_path, storage):
    source, expected = recorded
    folder = tmp_path / "bag"
    folder.mkdir()
    file = folder / {"mcap": "bag_0.mcap", "sqlite3": "bag_0.db3"}[storage]
    file.write_bytes(source.read_bytes()) if storage == "mcap" else in_sqlite(source, file)
    counts = {"/speed": 2, "/hmi/lamp_fault": 1, "/never_sent": 0, "/lost": 3}
    topics = [
        {"topic_metadata": {"name": name, "type": "x/msg/Y", "serialization_format": "cdr"}, "message_count": count}
        for name, count in counts.items()
    ]
    described(folder, storage, file.name, topics_with_message_count=topics)
    with pytest.raises(InputRefused) as refused:
        rows(folder, tmp_path)
    (finding,) = refused.value.findings
    assert (finding.message, finding.file) == (
        "metadata.yaml counts messages of '/lost', and no file of the bag has this topic.", str(folder / "metadata.yaml")
    )  # fmt: skip
    described(folder, storage, file.name, topics_with_message_count=topics[:3])
    assert rows(folder, tmp_path) == expected


@pytest.mark.parametrize("cut", [1, 8, 20])
def test_a_bag_without_its_last_bytes_is_reported_as_cut(recorded, tmp_path, cut):
    cut_bag = tmp_path / "cut.mcap"
    cut_bag.write_bytes(recorded[0].read_bytes()[:-cut])
    with pytest.raises(InputRefused) as refused:
        open_trace(cut_bag, KNOWN)
    assert [each.message for each in refused.value.findings] == [
        "The file must be in MCAP: it ends in the middle, or is damaged."
    ]


def test_a_file_without_chunks_is_read(recorded, tmp_path):
    """The preset `fastwrite` of the recorder."""
    source, expected = recorded
    with source.open("rb") as file, (tmp_path / "fast.mcap").open("wb") as out:
        writer = RawWriter(out, use_chunking=False)
        writer.start()
        for schema, channel, message in make_reader(file).iter_messages():
            assert schema is not None
            number = writer.register_channel(
                channel.topic, "cdr", writer.register_schema(schema.name, schema.encoding, schema.data)
            )
            writer.add_message(number, message.log_time, message.data, message.log_time)
        writer.finish()
    assert rows(tmp_path / "fast.mcap", tmp_path) == expected


@pytest.mark.parametrize("mapped", [{}, {"/speed": (Column("speed", "Vehicle.Speed"),)}])
def test_a_bag_without_definitions_says_how_to_get_them(recorded, tmp_path, mapped):
    path = in_sqlite(recorded[0], tmp_path / "humble.db3", is_defined=False)
    with pytest.raises(InputRefused) as refusal:
        rows(path, tmp_path, **mapped)
    (finding,) = refusal.value.findings
    assert "no definition of the messages of /speed" in finding.message
    assert "ros2 bag convert" in finding.fix


@pytest.mark.parametrize("content", [b"", b"text", b"SQLite format 3\0", b"\x28\xb5\x2f\xfd123", "cut"])
@pytest.mark.parametrize("name", ["a.db3", "a.mcap.zstd"])
def test_a_file_that_cannot_be_read_is_reported(recorded, tmp_path, name, content, capsys):
    whole = in_sqlite(recorded[0], tmp_path / "whole.db3").read_bytes()
    (tmp_path / name).write_bytes(whole[:5000] if content == "cut" else content)
    assert main(["simulate", *FUNCTIONS, "--trace", str(tmp_path / name)]) == 1
    assert "T001" in capsys.readouterr().err


def test_messages_that_are_damaged_are_reported(recorded, tmp_path):
    path = in_sqlite(recorded[0], tmp_path / "a.db3", packed=lambda data: data[:5])
    with pytest.raises(InputRefused) as refusal:
        rows(path, tmp_path)
    (finding,) = refusal.value.findings
    assert finding.message == (
        "The message of /speed at 1764000000.000000000 s does not fit its definition, or is damaged."
    )


@pytest.mark.parametrize("change", ["timestamp = 'abc'", "data = 'abc'"])
def test_a_row_of_another_type_is_reported(recorded, tmp_path, change):
    path = in_sqlite(recorded[0], tmp_path / "a.db3")
    with closing(sqlite3.connect(path)) as database:
        database.execute(f"UPDATE messages SET {change}")
        database.commit()
    with pytest.raises(InputRefused) as refusal:
        rows(path, tmp_path)
    assert "mcap" not in refusal.value.findings[0].fix


def test_a_changed_byte_in_a_chunk_is_found_by_its_checksum(tmp_path):
    path = tmp_path / "a.mcap"
    with path.open("wb") as file:
        writer = Writer(file, compression=CompressionType.NONE)
        schema = writer.register_msgdef("x_interfaces/msg/Speed", SPEED)
        writer.write_message("/speed", schema, stamped(speed=36.5), log_time=START, publish_time=START)
        writer.finish()
    speed = struct.pack("<f", 36.5)
    data = path.read_bytes()
    assert data.count(speed) == 1
    path.write_bytes(data.replace(speed, struct.pack("<f", 36.0)))
    with pytest.raises(InputRefused, match=r"crc validation failed") as refusal:
        rows(path, tmp_path)
    assert refusal.value.findings[0].rule == "T001"


@pytest.mark.parametrize(("unit", "expected"), [("m/s", "36.0"), ("km/h", "10.0")])
def test_a_unit_of_the_definition_is_converted_to_that_of_the_signal(tmp_path, unit, expected):
    """The unit of a signal may have changed since the recording."""
    schemas = {"Speed": SPEED.replace("[km/h]", f"[{unit}]")}
    path = bag(tmp_path / "a.mcap", ("/speed", "Speed", 0, stamped(speed=10.0)), schemas=schemas)
    assert rows(path, tmp_path)[0].endswith(f",{expected}\n")


def test_a_unit_that_cannot_be_converted_is_refused(tmp_path):
    schemas = {"Speed": SPEED.replace("[km/h]", "[kg]")}
    path = bag(tmp_path / "a.mcap", ("/speed", "Speed", 0, stamped(speed=10.0)), schemas=schemas)
    with pytest.raises(InputRefused) as refusal:
        rows(path, tmp_path)
    assert "Vehicle.Speed cannot be converted from kg, as the bag has it, to km/h." in str(refusal.value.findings[0])


def test_a_signal_of_two_topics_is_refused(tmp_path):
    written = [(topic, "Speed", time, stamped(speed=time)) for time, topic in enumerate(("/a/speed", "/b/speed"))]
    with pytest.raises(InputRefused) as refusal:
        rows(bag(tmp_path / "a.mcap", *written, schemas={"Speed": SPEED}), tmp_path)
    assert "and has /a/speed and /b/speed." in refusal.value.findings[0].message


def test_findings_of_values_are_about_the_bag(tmp_path):
    """Its file in CSV is removed."""
    written = [("/speed", "Speed", time, stamped(speed=1)) for time in (0, 300 * 365 * 86_400)]
    path = bag(tmp_path / "a.mcap", *written, schemas={"Speed": SPEED})
    trace = open_trace(path, KNOWN)
    with pytest.raises(InputRefused) as refusal:
        list(moments(trace))
    (finding,) = refusal.value.findings
    assert (finding.file, finding.line) == (str(path), 0)
    assert str(path) in str(refusal.value)


def test_a_definition_that_cannot_be_parsed_is_reported(recorded, tmp_path):
    """That of the events of a service has two parts, each with fields."""
    path = in_sqlite(recorded[0], tmp_path / "a.db3")
    with closing(sqlite3.connect(path)) as database:
        database.execute(
            "UPDATE message_definitions SET encoded_message_definition = ? WHERE topic_type LIKE '%Speed'",
            (f"---\n{SPEED}",),
        )
        database.commit()
    with pytest.raises(InputRefused) as refusal:
        rows(path, tmp_path)
    assert "The definition of /speed is invalid" in refusal.value.findings[0].message


def test_a_folder_without_metadata_is_reported(recorded, tmp_path, capsys):
    """A recorder that was killed writes none."""
    assert main(["simulate", *FUNCTIONS, "--trace", str(tmp_path)]) == 2
    assert "has no metadata.yaml. Run `ros2 bag reindex`." in capsys.readouterr().err
