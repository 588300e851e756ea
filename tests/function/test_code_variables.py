"""Lint compares variables with the headers that declare them, by kind, sign and size."""

import pytest

from sigcat.cli import main

FUNCTION = """\
function: Demo
description: A demonstration.
responsible: Demo team
code: {{signature: globals, headers: [Demo.h], includeFolders: [code]}}
components:
  - name: Demo
    runnables:
      - interface: Step
        data:
          - {{path: Vehicle.Demo.In, role: {role}, provider: Bench, variable: {variable}{more}}}
define:
  data:
    Vehicle.Demo: {{type: branch, description: Signals of the test.}}
    Vehicle.Demo.In: {{datatype: {datatype}, asil: QM, description: A signal of the test.}}
  scheduling:
    Step: {{description: Works., asil: QM, cycleTime: 20, priority: 1}}
"""
HEADER = """\
#pragma once
#include <math.h>
#include "types.h"
extern int32_t sum;
extern uint32_t count;
extern float ratio;
extern boolean_T flag;
extern volatile unsigned char level;
typedef enum { M_OFF, M_ON } md_t;
extern md_t mode;
extern struct Bus { short a; unsigned b : 3, wide : 12, flag : 1; int sign : 1; struct { unsigned deep : 2; }; } bus;
extern struct Bus *way;
extern _Complex float phase;
extern __int128 huge;
extern _Atomic int shared;
extern char letter;
extern const float fixed;
extern struct Const { const float a; float *at; } rest;
extern const float *behind;
extern void *whatever;
static float apart;
enum small { S0, S1 };
extern enum small chosen;
float computed(void);
void Demo_Step(void);
#define LIMIT 3.0f
"""
CASES = {
    "the same": ("uint32", "consumed", "count", "", ""),
    "signed": ("uint32", "consumed", "sum", "", "'sum' must be uint32_t; the header has int."),
    "unsigned": ("int32", "provided", "count", "", "'count' must be int32_t"),
    "unsigned and wider than what it is read from": ("int16", "consumed", "count", "", "'count' must be int16_t"),
    "an integer for a float": ("float", "consumed", "sum", "", "'sum' must be float"),
    "a float for an integer": ("int32", "consumed", "ratio", "", "Give `datatype: float`"),
    "a float for a flag": ("boolean", "consumed", "ratio", "", "'ratio' must be an integer"),
    "a narrower member": ("int32", "consumed", "bus.a", "", "'bus.a' must be int32_t; the header has short"),
    "a narrower output": ("int32", "provided", "bus.a", "", ""),
    "a bit field": ("uint8", "consumed", "bus.b", ", min: 0, max: 7, rangeErrorAction: Default, default: 1", ""),
    "a bit field with limits that nothing enforces": ("uint8", "consumed", "bus.b", ", min: 0, max: 7", "limit the value with `min`, `max` and `rangeErrorAction`"),
    "a signed bit field for a flag": ("boolean", "consumed", "bus.sign", "", "Widen the bit field, or make it unsigned."),
    "a bit field of too few bits": ("uint8", "consumed", "bus.b", "", "'bus.b' must hold 0 to 255; the header has a bit field of 3 bits (unsigned int)."),
    "a bit field of too few bits for a limit": ("uint8", "consumed", "bus.b", ", min: 0, max: 8, rangeErrorAction: Init, init: 1", "'bus.b' must hold 0 to 8; the header has a bit field of 3 bits"),
    "a bit field of scaled values": ("uint8", "consumed", "bus.b", ", factor: 0.5, offset: 1, min: 1, max: 4.5, rangeErrorAction: Init, init: 1", ""),
    "a bit field of too few bits for scaled values": ("uint8", "consumed", "bus.b", ", factor: 0.5, min: 0, max: 4, rangeErrorAction: Init, init: 1", "'bus.b' must hold 0 to 8; the header has a bit field of 3 bits"),
    "a bit field that is read": ("uint8", "provided", "bus.b", "", ""),
    "a wider bit field that is read": ("uint8", "provided", "bus.wide", "", "'bus.wide' must be uint8_t; the header has a bit field of 12 bits"),
    "a bit field behind a pointer": ("uint8", "consumed", "way->b", "", "'way->b' must hold 0 to 255; the header has a bit field of 3 bits"),
    "a bit field of a struct without a name": ("uint8", "consumed", "bus.deep", "", "'bus.deep' must hold 0 to 255; the header has a bit field of 2 bits"),
    "a flag of one bit": ("boolean", "consumed", "bus.flag", "", ""),
    "a flag of one bit with a sign": ("boolean", "consumed", "bus.sign", "", "'bus.sign' must hold 0 to 1; the header has a bit field of 1 bit (int)."),
    "a complex number": ("float", "provided", "phase", "", "'phase' must be float; the header has _Complex float."),
    "an integer of 128 bits": ("int64", "consumed", "huge", "", "'huge' must be int64_t; the header has __int128."),
    "an atomic number": ("int32", "consumed", "shared", "", "'shared' must be int32_t; the header has _Atomic(int)."),
    "a character": ("uint8", "consumed", "letter", "", ""),
    "a variable that no header has": ("uint8", "consumed", "nothing", "", ""),
    "defined with its type": ("uint8", "consumed", "level", ", definedBy: adapter, cType: volatile unsigned char", ""),
    "defined without its qualifier": ("uint8", "consumed", "level", ", definedBy: adapter, cType: unsigned char", "clang says"),
    "defined with another type": ("boolean", "consumed", "flag", ", definedBy: adapter", "Give the type of the header as `cType`"),
    "a constant": ("float", "consumed", "fixed", "", "'fixed' must be a variable that the adapter can write; clang says: "),
    "a constant that is read": ("float", "provided", "fixed", "", ""),
    "a constant member": ("float", "consumed", "rest.a", "", "'rest.a' must be a variable that the adapter can write"),
    "behind a pointer that only reads": ("float", "consumed", "'*behind'", "", "'*behind' must be a variable that the adapter can write"),
    "a number of a macro": ("float", "consumed", "LIMIT", "", "'LIMIT' must be a variable that the adapter can write"),
    "a cast": ("float", "consumed", "(float)sum", "", "'(float)sum' must be a variable that the adapter can write"),
    "a cast that is read": ("float", "provided", "(float)sum", "", ""),
    "a pointer": ("float", "provided", "behind", "", "'behind' must be one value; the header has a pointer."),
    "a pointer of a struct": ("float", "consumed", "rest.at", "", "'rest.at' must be one value; the header has a pointer."),
    "a pointer to anything": ("float", "consumed", "whatever", "", "'whatever' must be one value; the header has a pointer."),
    "an address": ("float", "provided", "'&ratio'", "", "'&ratio' must be one value; the header has a pointer."),
    "a static variable": ("float", "consumed", "apart", "", "'apart' must not be static: each file that includes the header has its own."),
    "an enumeration for a float": ("float", "consumed", "chosen", "", "'chosen' must be float; the header has an enumeration of 32 bits."),
    "an enumeration that is read as a byte": ("uint8", "provided", "chosen", "", "'chosen' must be uint8_t; the header has an enumeration of 32 bits."),
    "an enumeration that takes a byte": ("uint8", "consumed", "chosen", "", ""),
    "a function": ("float", "provided", "computed", "", "'computed' must be one value; the header has a function."),
    "a bit field for a float": ("float", "consumed", "bus.b", "", "'bus.b' must be float; the header has a bit field."),
    "a type that is not there": ("boolean", "consumed", "flag", ", definedBy: adapter, cType: bolean_T", "unknown type name 'bolean_T'"),
}  # fmt: skip


@pytest.mark.parametrize(("datatype", "role", "variable", "more", "expected"), CASES.values(), ids=CASES)
def test_a_type_that_is_not_that_of_the_header_is_found(datatype, role, variable, more, expected, tmp_path, capsys):
    file = project(tmp_path, HEADER)
    file.write_text(FUNCTION.format(datatype=datatype, role=role, variable=variable, more=more))
    main(["lint", str(file)])
    out = capsys.readouterr().out
    assert ("F211" in out) is (expected != ""), out
    assert expected in out
    if expected:
        assert "function.yaml:10:" in out


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ("{'OFF': 0, 'ON': 1}", ""),
        ("{'F': 2, 'N': 3}", ""),
        ("{'OFF': 0, 'ON': 2}", "'mode' must have ON as 1, the number of M_ON in the header, not as 2."),
        ("{'OFF': 1, 'ON': 0}", "'mode' must have OFF as 0, the number of M_OFF in the header, not as 1."),
    ],
)
def test_numbers_of_an_enumeration_are_those_of_the_header(values, said, tmp_path, capsys):
    file = project(tmp_path, HEADER)
    names = ", ".join(each.partition(":")[0] for each in values.strip("{}").split(", "))
    datatype = f"string, allowed: [{names}]"
    more = f", values: {values}"
    file.write_text(FUNCTION.format(datatype=datatype, role="provided", variable="mode", more=more))
    main(["lint", str(file)])
    out = capsys.readouterr().out
    assert ("F211" in out) is (said != ""), out
    assert said in out


def test_headers_that_are_incomplete_are_not_compared(tmp_path, capsys):
    file = project(tmp_path, f'#include "missing.h"\n{HEADER}')
    file.write_text(FUNCTION.format(datatype="uint32", role="consumed", variable="sum", more=""))
    main(["lint", str(file)])
    assert "F211" not in capsys.readouterr().out


def test_a_header_that_does_not_compile_is_found_where_it_is_wrong(tmp_path, capsys):
    file = project(tmp_path, HEADER.replace("extern float ratio;", "extern unsigned shrt ratio;"))
    file.write_text(FUNCTION.format(datatype="uint32", role="consumed", variable="count", more=""))
    assert main(["lint", str(file)]) == 1
    out = capsys.readouterr().out
    assert (
        "code/Demo.h:6:21: error T010 The headers must compile to be compared with the declaration; clang says: " in out
    )


@pytest.mark.parametrize("variable", ["nothing", "bus.c"])
@pytest.mark.parametrize("is_complete", [True, False], ids=["complete", "without a header of the system"])
def test_a_variable_that_no_header_declares_is_found_where_all_headers_are_there(
    variable, is_complete, tmp_path, capsys
):
    file = project(tmp_path, HEADER if not is_complete else HEADER.replace("#include <math.h>\n", ""))
    file.write_text(FUNCTION.format(datatype="int32", role="consumed", variable=variable, more=""))
    assert main(["lint", str(file)]) == is_complete
    out = capsys.readouterr().out
    assert (
        f"function.yaml:10:80: error T010 The headers must declare '{variable}'; clang says: " in out
    ) is is_complete


def project(folder, header):
    (folder / "code").mkdir()
    (folder / "code" / "Demo.h").write_text(header)
    (folder / "code" / "types.h").write_text("#include <stdint.h>\ntypedef unsigned char boolean_T;\n")
    return folder / "function.yaml"


SHAPES = """\
#pragma once
#include "types.h"
typedef struct { float x; float y[2]; } point_T;
typedef struct { point_T Start; point_T Ends[3]; unsigned kind : 3; } track_T;
extern float list[5];
extern float grid[2][5];
extern point_T point;
extern track_T track;
extern track_T tracks[4];
extern float *pointed;
extern point_T *far;
typedef struct { const float x; float *y; } fixed_T;
extern fixed_T fixed;
extern float (*at)[5];
"""
FLOATS = "'float[]', arraysize: "
SHAPED = {
    "as many elements": (FLOATS + "5", "list", "", ""),
    "fewer elements": (FLOATS + "4", "list", "", "'list' must have 4 elements; the header has 5."),
    "an array without a length": ("'float[]'", "list", "", "The length of 'list' must be known; the datatype has none, and the header 5. Set `arraysize: 5` of the signal."),
    "one value": (FLOATS + "4", "point.x", "", "'point.x' must be an array of 4; the header has float."),
    "an array for one value": ("float", "list", "", "'list' must be one value; the header has an array of 5."),
    "a struct for one value": ("float", "point", "", "'point' must be one value; the header has the struct point_T."),
    "a row": (FLOATS + "5", "grid[1]", "", ""),
    "an array that a pointer has": (FLOATS + "5", "pointed", "", "'pointed' must be an array of 5; the header has a pointer."),
    "an array of the size of a pointer": (FLOATS + "2", "pointed", "", "'pointed' must be an array of 2; the header has a pointer."),
    "the array that a pointer points at": (FLOATS + "5", "'*at'", "", ""),
    "a bit field": ("uint8", "track.kind", ", max: 7, rangeErrorAction: Init, init: 1", ""),
    "the last element": ("float", "'list[4]'", "", ""),
    "an element beyond the array": ("float", "'list[5]'", "", "'list[5]' must be within its array; the header has 5 elements, and 5 is the index."),
    "an element before the array": ("float", "'list[-1]'", "", "'list[-1]' must be within its array"),
    "an element beyond a row": ("float", "'grid[1][5]'", "", "'grid[1][5]' must be within its array"),
    "a member of an element beyond the array": ("float", "'tracks[4].Start.x'", "", "'tracks[4].Start.x' must be within its array"),
    "members of other names": ("Types.Point", "point", "", "'point' must have the member 'X'; the struct of the header has x, y."),
    "members": ("Types.Point", "point", ", members: {X: x, Y: y}", ""),
    "a member that is not there": ("Types.Point", "point", ", members: {X: x, Y: z}", "'point' must have the member 'z'"),
    "a constant member": ("Types.Point", "fixed", ", members: {X: x, Y: x}", "'fixed.x' must be a member that the adapter can write; the header has a constant."),
    "a member that is a pointer": ("Types.Point", "fixed", ", members: {X: y, Y: y}", "'fixed.y' must be one value; the header has a pointer."),
    "a pointer to a struct": ("Types.Point", "far", ", members: {X: x, Y: z}", "'far' must be a struct; the header has a pointer."),
    "an array as a struct": ("Types.Point", "list", "", "'list' must be a struct; the header has an array of 5."),
    "members within members": ("Types.Track", "track", ", rangeErrorAction: Init, members: {Start.X: x, Start.Y: y, Ends.X: x, Ends.Y: y, Kind: kind}", ""),
    "members of elements": ("Types.Track", "track", ", members: {Start.X: x, Start.Y: y, Ends.X: x}", "'track.Ends[0]' must have the member 'Y'"),
    "a member that is a bit field of too few bits": (
        "Types.Kinds", "track", ", members: {Kind: kind}", "'track.kind' must hold 0 to 255; the header has a bit field of 3 bits (unsigned int)."
    ),
    "elements of a member": (
        "Types.Longer", "track", ", members: {Ends.X: x, Ends.Y: y}", "'track.Ends' must have 4 elements; the header has 3."
    ),
    "a narrower member": ("Types.Wide", "point", ", members: {X: x}", "'point.x' must be double; the header has float."),
}  # fmt: skip
TYPES = """\
  types:
    Types.Point: {description: A point., fields: {X: {datatype: float, description: X.}, Y: {datatype: 'float[]', arraysize: 2, description: Y.}}}
    Types.Wide: {description: A wide point., fields: {X: {datatype: double, description: X.}}}
    Types.Longer: {description: A long track., fields: {Ends: {datatype: 'Types.Point[]', arraysize: 4, description: Ends.}}}
    Types.Track:
      description: A track.
      fields:
        Start: {datatype: Types.Point, description: Its start.}
        Ends: {datatype: 'Types.Point[]', arraysize: 3, description: Its ends.}
        Kind: {datatype: uint8, description: Its kind., max: 7}
    Types.Kinds: {description: Kinds., fields: {Kind: {datatype: uint8, description: Its kind.}}}
"""


@pytest.mark.parametrize(("datatype", "variable", "more", "expected"), SHAPED.values(), ids=SHAPED)
def test_an_array_or_struct_that_is_not_that_of_the_header_is_found(
    datatype, variable, more, expected, tmp_path, capsys
):
    file = project(tmp_path, SHAPES)
    text = FUNCTION.format(datatype=datatype, role="consumed", variable=variable, more=more)
    file.write_text(text + TYPES)
    main(["lint", str(file)])
    out = capsys.readouterr().out
    assert "F003" not in out
    assert ("F211" in out) is (expected != ""), out
    assert expected in out
    if expected:
        assert "function.yaml:10:" in out


def test_a_queue_has_room_for_the_values_of_a_call(tmp_path, capsys):
    more = ", access: Buffered, queueLength: 8, valuesPerStep: 6, countVariable: number"
    file = project(tmp_path, f"{SHAPES}extern unsigned number;\n")
    file.write_text(FUNCTION.format(datatype="float", role="consumed", variable="list", more=more))
    main(["lint", str(file)])
    assert "'list' must have at least 6 elements; the header has 5." in capsys.readouterr().out


CALLED = {
    "the function": ("symbol: work", "", ""),
    "a function of an enumeration": ("symbol: state, success: 0", "", ""),
    "a macro": ("symbol: MACRO", "", ""),
    "a function that is not there": ("symbol: wrok", "9:17", "The headers must declare the function 'wrok'; clang says: use of undeclared identifier 'wrok'. Did you mean 'work'?"),
    "no function of the name of the call": ("arguments: []", "8:9", "The headers must declare the function 'Demo_Step'"),
    "a variable": ("symbol: ratio", "9:17", "The function 'ratio' must take no arguments."),
    "a function that takes a number": ("symbol: takes", "9:17", "The function 'takes' must take no arguments; the header has int, float *."),
    "a function that returns a float": ("symbol: gives, success: 0", "", ""),
    "a function that returns nothing": ("symbol: work, success: 0", "9:17", "'work' must return a number, as `success` is compared with it; the header has void."),
}  # fmt: skip


@pytest.mark.parametrize(("call", "place", "expected"), CALLED.values(), ids=CALLED)
def test_a_function_that_is_not_that_of_the_header_is_found(call, place, expected, tmp_path, capsys):
    file = project(tmp_path, HEADER.replace("void Demo_Step(void);\n", FUNCTIONS))
    text = FUNCTION.format(datatype="float", role="consumed", variable="ratio", more="")
    file.write_text(
        text.replace("interface: Step\n", f"interface: Step\n        {call.replace(', ', chr(10) + '        ')}\n")
    )
    main(["lint", str(file)])
    out = capsys.readouterr().out
    assert ("T010" in out) is (expected != ""), out
    assert expected in out
    assert not place or f"function.yaml:{place}: error T010" in out


FUNCTIONS = """\
void work(void);
enum small state(void);
void takes(int number, float *ratio);
float gives(void);
#define MACRO() work()
"""


def test_a_header_that_defines_something_is_found_at_its_line(tmp_path, capsys):
    header = "#pragma once\nextern float ratio;\nfloat speed;\nconst int most = 3;\nvoid Demo_Step(void) {}\n"
    fine = (
        "static inline int least(void) { return 1; }\ninline int some(void) { return 2; }\nextern float declared[2];\n"
    )
    file = project(tmp_path, header + fine)
    file.write_text(FUNCTION.format(datatype="float", role="consumed", variable="ratio", more=""))
    assert main(["lint", str(file)]) == 1
    found = [line.partition(" Declare it")[0] for line in capsys.readouterr().out.splitlines() if "F213" in line]
    again = "not define it: each file that includes the header defines it again."
    place = tmp_path / "code" / "Demo.h"
    assert found == [
        f"{place}:3: error F213 The header must declare the variable 'speed', {again}",
        f"{place}:4: error F213 The header must declare the variable 'most', {again}",
        f"{place}:5: error F213 The header must declare the function 'Demo_Step', {again}",
    ]
