"""Code that was generated again is merged into its function.yaml: what a person wrote stays."""

import pytest

from sigcat.cli import main

HEADER = """\
#pragma once
typedef unsigned char boolean_T;
typedef enum { OFF_M, ON_M } md_t;
extern boolean_T Enabled;          /* '<Root>/Enabled' */
extern short Pressure;             /* '<Root>/Pressure' [kPa] */
extern volatile unsigned char Vol; /* '<Root>/Vol' [percent] */
extern md_t Md;                    /* '<Root>/Md' */
extern float Gain;                 /* Variable: Gain */
extern float Duty;                 /* '<S1>/Duty' [%] [0,100] */
void Pump_initialize(void);
void Pump_step(void);              /* Sample time: [0.01s, 0.0s] */
"""
SOURCE = """\
#include "Pump.h"
float Duty;
float Gain = 2.5F;
void Pump_initialize(void) {}
void Pump_step(void) { Duty = Gain * (Enabled + Vol + Md + Pressure); }
"""
NEXT = (
    HEADER.replace("extern short Pressure;             /* '<Root>/Pressure' [kPa] */\n", "")
    .replace("extern boolean_T Enabled;", "extern float Flow;                 /* '<Root>/Flow' Flow of the coolant */\nextern boolean_T Enabled;")
    .replace("volatile unsigned char Vol", "unsigned short Vol")
    .replace("OFF_M, ON_M", "OFF_M, STANDBY_M, ON_M")
    .replace("extern float Gain;                 /* Variable: Gain */", "extern float Limit;                /* Variable: Limit */")
    .replace("[0,100]", "[0,90]")
)  # fmt: skip
NEXT_SOURCE = SOURCE.replace("Gain = 2.5F", "Limit = 7.0F").replace("Gain *", "Limit *").replace("Pressure", "Flow")


@pytest.fixture
def folder(tmp_path):
    write(tmp_path, HEADER, SOURCE)
    assert main(["function", "new", "Pump", "--from-c", str(tmp_path), "--define-under", "Vehicle.Pump"]) == 0
    return tmp_path


def write(folder, header, source):
    (folder / "Pump.h").write_text(header)
    (folder / "Pump.c").write_text(source)


def update(folder, *options):
    return main(["function", "update", str(folder / "function.yaml"), "--from-c", str(folder), *options])


def test_code_that_is_the_same_changes_nothing(folder, capsys):
    before = (folder / "function.yaml").read_bytes()
    capsys.readouterr()
    assert update(folder) == 0
    assert capsys.readouterr().out == "nothing changed\n"
    assert (folder / "function.yaml").read_bytes() == before


def test_new_gone_and_changed_variables_are_listed_and_applied(folder, capsys):
    write(folder, NEXT, NEXT_SOURCE)
    capsys.readouterr()
    assert update(folder, "--define-under", "Vehicle.Pump") == 0
    assert capsys.readouterr().out.splitlines() == [
        "gone: Pressure (Vehicle.Pump.Pressure)",
        "gone: Gain (Gain)",
        "changed: Vol: cType volatile unsigned char → unsigned short",
        "changed: Vol: datatype uint8 → uint16",
        "changed: Md: allowed [OFF_M, ON_M] → [OFF_M, STANDBY_M, ON_M]",
        "changed: Md: values {OFF_M: 0, ON_M: 1} → {OFF_M: 0, STANDBY_M: 1, ON_M: 2}",
        "kept: Duty: max 100; the code has 90",
        "new: Flow (Vehicle.Pump.Flow)",
        "new: Limit (Limit)",
    ]
    text = (folder / "function.yaml").read_text()
    assert "Pressure" not in text
    assert "Gain" not in text
    assert (
        "    Vehicle.Pump.Flow:\n      datatype: float\n      asil: QM\n      description: Flow of the coolant.\n"
        in text
    )
    assert "          # Pump.h:4 float Flow of the coolant\n          - path: Vehicle.Pump.Flow\n" in text
    assert "default: 7" in text
    assert main(["lint", str(folder / "function.yaml")]) == 0
    assert main(["simulate", str(folder / "function.yaml"), "--duration", "0.05"]) == 0
    capsys.readouterr()
    update(folder)
    assert capsys.readouterr().out == "kept: Duty: max 100; the code has 90\n"


def test_what_a_person_wrote_stays(folder):
    file = folder / "function.yaml"
    mine = (
        file.read_text()
        .replace("responsible: Name of a team", 'responsible: "Pump team"  # ask them, äöü')
        .replace("            variable: Vol\n", "            variable: Vol  # of the tank\n            provider: Tank\n\n            timeout: 0.5\n")
        .replace("          # Pump.h:6", "          # A remark of mine.\n          # Pump.h:6")
        .replace("path: Vehicle.Pump.IsEnabled", "path: Vehicle.Speed")
    )  # fmt: skip
    file.write_text(mine)
    write(folder, NEXT, NEXT_SOURCE)
    update(folder)
    text = file.read_text()
    for each in (
        'responsible: "Pump team"  # ask them, äöü\n',
        "            variable: Vol  # of the tank\n            provider: Tank\n\n            timeout: 0.5\n",
        "          # A remark of mine.\n          # Pump.h:6 unsigned short",
        "path: Vehicle.Speed\n",
        "path: Vehicle.TODO.Flow\n",
    ):
        assert each in text
    removed = {line for line in mine.splitlines() if line not in text.splitlines()}
    assert not any(word in line for line in removed for word in ("mine", "tank", "team", "Speed", "Tank"))


def test_an_optional_signal_that_the_catalogue_lacks_stays(folder, capsys):
    file = folder / "function.yaml"
    entry = "path: Vehicle.Gone.IsEnabled\n            optional: true\n            datatype: boolean\n            init: true"
    file.write_text(file.read_text().replace("path: Vehicle.Pump.IsEnabled", entry))
    write(folder, NEXT, NEXT_SOURCE)
    capsys.readouterr()
    assert update(folder) == 0
    assert "Enabled" not in capsys.readouterr().out
    assert entry in file.read_text()


def test_entries_in_braces_and_other_line_ends_stay_so(folder, capsys):
    file = folder / "function.yaml"
    file.write_bytes(
        b"""function: Pump
description: Pumps.
responsible: Pump team
code: {signature: globals, headers: [Pump.h], sources: [Pump.c]}
components:
  - name: Pump
    runnables:
      - {interface: Init, symbol: Pump_initialize}
      - {interface: Step, symbol: Pump_step, data: [
          {path: Vehicle.Pump.Pressure, role: consumed, variable: Pressure, datatype: int16},  # mine
          {path: Vehicle.Pump.Duty, role: provided, variable: Duty}]}
      - Terminate
define:
  data: {Vehicle.Pump: {type: branch, description: Signals.}, Vehicle.Pump.Pressure: {datatype: int16, asil: QM, description: Pressure.},
    Vehicle.Pump.Duty: {datatype: float, asil: QM, description: Duty.}}
  scheduling: {Init: {description: Prepares., asil: QM}, Step: {description: Works., asil: QM, cycleTime: 10}, Terminate: {description: Ends., asil: QM}}
""".replace(b"\n", b"\r\n")
    )
    write(folder, NEXT, NEXT_SOURCE)
    assert update(folder, "--define-under", "Vehicle.Pump") == 0
    data = file.read_bytes()
    assert data.count(b"\n") == data.count(b"\r\n")
    assert b"Pressure" not in data
    assert (
        b"{path: Vehicle.Pump.Duty, role: provided, variable: Duty}, {path: Vehicle.Pump.Flow, role: consumed" in data
    )
    capsys.readouterr()
    main(["lint", str(file)])
    assert "F00" not in capsys.readouterr().out
    update(folder)
    assert "new" not in capsys.readouterr().out


def test_variables_of_errors_and_expressions_by_hand_are_left_alone(folder, capsys):
    file = folder / "function.yaml"
    text = file.read_text()
    step = "      - interface: Pump_Step\n"
    assert step in text
    file.write_text(
        text.replace(step, f"{step}        errors: [{{interface: Late, variable: Enabled}}]\n")
        .replace("variable: Pressure\n", "variable: '*(&Pressure)'\n")
        .replace("define:\n", "define:\n  errors:\n    Late: {description: It is late., maturationTime: 0, resetTime: 0, resetCondition: It is over., severity: Off., asil: QM}\n")
    )  # fmt: skip
    write(folder, NEXT, NEXT_SOURCE)
    capsys.readouterr()
    assert update(folder) == 0
    said = capsys.readouterr().out
    assert "Pressure" not in said
    assert "Enabled" not in said


@pytest.mark.parametrize("text", ["function: [", "- a list\n", "function: Pump\ncomponents: 3\n"])
def test_a_file_with_errors_is_told_and_stays(text, folder, capsys):
    (folder / "function.yaml").write_text(text)
    assert update(folder) == 1
    assert "function.yaml:" in capsys.readouterr().err
    assert (folder / "function.yaml").read_text() == text


def test_the_folder_has_to_be_named(folder, capsys):
    assert main(["function", "update", str(folder / "function.yaml")]) == 2
    assert "--from-c" in capsys.readouterr().err


WATCH = """\
      - interface: Pump_WatchStep
        symbol: watch
        data:
          - {path: Vehicle.Pump.Seen, role: consumed, variable: seen, datatype: float, asil: QM}
          - {path: Vehicle.Pump.Raw, role: provided, variable: raw, datatype: 'int16[]', asil: QM}
"""
DEFINED = """\
    Vehicle.Pump.Seen: {datatype: float, asil: QM, description: Seen.}
    Vehicle.Pump.Raw: {datatype: 'int16[]', arraysize: 4, asil: QM, description: Raw values.}
"""
SCHEDULED = """\
  scheduling:
    WatchStep: {description: Watches., asil: QM, cycleTime: 10, priority: 1, scheduling: Preemptive}
"""


def test_variables_of_calls_by_hand_have_the_types_and_lengths_of_the_code(folder, capsys):
    file = folder / "function.yaml"
    text = file.read_text().replace("  scheduling:\n", SCHEDULED, 1)
    file.write_text(text.replace("  data:\n", f"  data:\n{DEFINED}", 1) + WATCH)
    own = "extern double seen;\nextern int raw[6];\nvoid watch(void);\n"
    write(folder, HEADER + own, SOURCE + "double seen;\nint raw[6];\nvoid watch(void) { raw[0] = seen; }\n")
    capsys.readouterr()
    assert update(folder) == 0
    assert (
        capsys.readouterr().out.splitlines()
        == [
            "changed: seen: datatype float → double",
            "changed: raw: datatype int16[] → int32[]",
            "changed: raw: arraysize 4 → 6",
            "kept: the source Pump.c is not among `sources`",
        ][: -1 if "sources: [Pump.c]" in file.read_text() else None]
    )
    assert "Raw: {datatype: int32[], arraysize: 6," in file.read_text().replace("'", "").replace('"', "")
    assert main(["lint", str(file)]) == 0


def test_an_array_of_structs_has_the_length_of_the_code(tmp_path, capsys):
    before = "typedef struct { float level; } Tank;\nextern Tank tanks[2];\nextern float Duty;\nvoid Pump_init(void);\nvoid Pump_step(void);\n"
    write(
        tmp_path,
        before,
        '#include "Pump.h"\nfloat Duty;\nvoid Pump_init(void) {}\nvoid Pump_step(void) { Duty = tanks[0].level; }\n',
    )
    assert main(["function", "new", "Pump", "--from-c", str(tmp_path), "--define-under", "Vehicle.Pump"]) == 0
    (tmp_path / "Pump.h").write_text(before.replace("[2]", "[3]").replace("Tank", "Bus"))
    capsys.readouterr()
    assert update(tmp_path, "--define-under", "Vehicle.Pump") == 0
    said = capsys.readouterr().out.splitlines()
    assert said[:2] == ["changed: tanks: type Tank → Bus", "changed: tanks: length 2 → 3"]
    assert all(each.startswith("new: tanks[") for each in said[2:])
    assert main(["lint", str(tmp_path / "function.yaml")]) == 0


def test_members_of_a_struct_that_the_file_names_as_a_whole_are_not_new(tmp_path, capsys):
    header = "typedef struct { float level; float flow; } Tank;\nextern Tank tank;\nextern float Duty;\nvoid Pump_init(void);\nvoid Pump_step(void);\n"
    source = '#include "Pump.h"\nTank tank;\nfloat Duty;\nvoid Pump_init(void) {}\nvoid Pump_step(void) { Duty = tank.level + tank.flow; }\n'
    write(tmp_path, header, source)
    assert main(["function", "new", "Pump", "--from-c", str(tmp_path), "--define-under", "Vehicle.Pump"]) == 0
    file = tmp_path / "function.yaml"
    lines = file.read_text().splitlines(keepends=True)
    (second,) = (number for number, line in enumerate(lines) if "variable: tank.flow" in line)
    first = max(number for number, line in enumerate(lines[:second]) if line.lstrip().startswith("- path:"))
    last = next(
        number for number, line in enumerate(lines) if number > second and line.lstrip().startswith(("- ", "#"))
    )
    file.write_text("".join([*lines[:first], *lines[last:]]).replace("variable: tank.level", "variable: tank"))
    capsys.readouterr()
    assert update(tmp_path, "--define-under", "Vehicle.Pump") == 0
    assert "new:" not in capsys.readouterr().out


REENTRANT = """\
#pragma once
typedef struct { float temp; unsigned kind : 3; float list[4]; } Fan_In;
typedef struct { float flow; } Fan_Out;
typedef struct { int counter; union { int a; float b; } shared; } Fan_State;
void Fan_Init(Fan_State *s);
void Fan_Step(Fan_State *s, const Fan_In *in, Fan_Out *out);
"""
REENTRANT_SOURCE = """\
#include "Fan.h"
void Fan_Init(Fan_State *s) { s->counter = 0; }
void Fan_Step(Fan_State *s, const Fan_In *in, Fan_Out *out) { s->counter++; out->flow = in->temp * in->kind * in->list[0]; }
"""


@pytest.fixture
def reentrant(tmp_path):
    (tmp_path / "Fan.h").write_text(REENTRANT)
    (tmp_path / "Fan.c").write_text(REENTRANT_SOURCE)
    assert main(["function", "new", "Fan", "--from-c", str(tmp_path), "--define-under", "Vehicle.Fan"]) == 0
    return tmp_path


def test_objects_keep_the_names_that_a_person_gave_them(reentrant, capsys):
    file = reentrant / "function.yaml"
    text = file.read_text()
    for before, now in (("name: in,", "name: sensors,"), ("arguments: [s, in, out]", "arguments: [s, sensors, out]"),
                        ("variable: in.", "variable: sensors.")):  # fmt: skip
        assert before in text
        text = text.replace(before, now)
    file.write_text(text)
    capsys.readouterr()
    assert update(reentrant) == 0
    assert capsys.readouterr().out == "nothing changed\n"
    assert file.read_text() == text
    (reentrant / "Fan.h").write_text(REENTRANT.replace("float temp;", "float speed;"))
    (reentrant / "Fan.c").write_text(REENTRANT_SOURCE.replace("in->temp", "in->speed"))
    assert update(reentrant) == 0
    assert capsys.readouterr().out.splitlines()[0] == "gone: sensors.temp (Vehicle.Fan.Temp)"
    assert "variable: sensors.speed" in file.read_text()


@pytest.mark.parametrize("variable", ["s.counter", "s.shared.a", "'in.list[2]'"])
def test_what_a_person_took_from_the_code_is_not_gone(reentrant, capsys, variable):
    file = reentrant / "function.yaml"
    text = file.read_text().replace("variable: in.temp", f"variable: {variable}")
    file.write_text(text)
    capsys.readouterr()
    update(reentrant)
    assert "gone" not in capsys.readouterr().out
    assert f"variable: {variable}" in file.read_text()


def test_what_was_typed_at_an_entry_stays_when_its_variable_is_renamed(reentrant, capsys):
    file = reentrant / "function.yaml"
    text = file.read_text().replace("name: temp\n", "name: temp  # ticket 77\n            timeout: 100\n")
    assert "ticket 77" in text
    file.write_text(text)
    (reentrant / "Fan.h").write_text(REENTRANT.replace("float temp;", "float temperature;"))
    (reentrant / "Fan.c").write_text(REENTRANT_SOURCE.replace("in->temp", "in->temperature"))
    capsys.readouterr()
    assert update(reentrant) == 0
    assert capsys.readouterr().out == "renamed: in.temp → in.temperature; check that it is the same signal\n"
    assert file.read_text() == text.replace("variable: in.temp\n", "variable: in.temperature\n")


@pytest.mark.parametrize("variable", ["'in.list[2]'", "(in.list[0])", "read(in.list)"])
def test_what_the_file_names_in_part_or_in_an_expression_is_not_new(reentrant, capsys, variable):
    file = reentrant / "function.yaml"
    text = file.read_text().replace("variable: in.list\n", f"variable: {variable}\n")
    assert text != file.read_text()
    file.write_text(text)
    capsys.readouterr()
    update(reentrant)
    assert "new:" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("(Fan_State *s) { s->counter = 0; }", "(Fan_State *s) { s->counter = 0; "),
        ("Fan_Step(Fan_State", "Fan_Step(Fan_State Fan_State"),
    ],
)
def test_code_that_does_not_compile_changes_nothing(reentrant, capsys, before, after):
    file = reentrant / "function.yaml"
    text = file.read_text()
    (reentrant / "Fan.c").write_text(REENTRANT_SOURCE.replace(before, after))
    capsys.readouterr()
    assert update(reentrant) == 1
    said = capsys.readouterr().err
    assert "Fan.c" in said
    assert "S007 The code must compile to be read right" in said
    assert "cannot be updated: the code does not compile" in said
    assert file.read_text() == text


def test_an_object_that_the_code_does_not_have_is_kept(reentrant, capsys):
    file = reentrant / "function.yaml"
    text = file.read_text().replace("variable: in.temp", "variable: extra.temp")
    file.write_text(text)
    capsys.readouterr()
    update(reentrant)
    assert "kept: extra.temp is not in the code; remove it by hand" in capsys.readouterr().out
    assert "variable: extra.temp" in file.read_text()
