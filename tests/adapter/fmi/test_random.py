"""Functions at random as FMUs: they send what a simulation sends, at steps that meet their cycles and at others.

`make fuzz` tries many more, other ones each time.
"""

import json
import random
from pathlib import Path
from tempfile import mkdtemp

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from sigcat.adapter.core.plan import CLASS, GLOBALS
from sigcat.adapter.fmi.fmi_integration import derive
from sigcat.adapter.fmi.fmu_files import generate
from sigcat.adapter.host.shapes import Array, Number, packing
from sigcat.adapter.toolchain import toolchain
from sigcat.function.document.read_json import read_json
from sigcat.function.function_json.model import FunctionJson, to_json
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.wire import written
from sigcat.limits import DEFAULT_LIMITS
from sigcat.runs.prepare import prepare
from sigcat.runs.recording.trace_file import open_trace
from sigcat.runs.simulate import Collected, Settings, simulate
from tests.adapter.core.core_side import write_headers
from tests.adapter.core.driver import CLASS_NAME, OBJECT, head_of
from tests.adapter.core.functions import functions
from tests.adapter.core.subject import C_NAMES, subject
from tests.adapter.fmi.fmus import NAME, compare, packed
from tests.integration.autosar_adaptive.sets import deployed
from tests.needs import cmake
from tests.properties import IS_SEARCH, examples

pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
pytestmark = cmake
MILLISECOND = 10**6
END = 350 * MILLISECOND
WORK = """#include "{function}_adapter.h"
#include <string.h>

{own}
static inline uint32_t mixed(uint32_t number, const void *value, size_t size)
{{
    const unsigned char *const bytes = (const unsigned char *)value;
    for (size_t i = 0; i < size; i++) {{
        number = (number ^ bytes[i]) * 16777619U;
    }}
    return number ^ (number >> 13);
}}

static inline void work({parameter})
{{
    uint32_t number = 2166136261U;
{reads}
{writes}
    (void)number;
{used}
}}

{calls}
{hooks}"""
NEXT = {
    "bool": "((number & 1U) != 0U)",
    "float": "(((float)(number % 2000U) / 8.0F) - 100.0F)",
    "double": "(((double)(number % 2000U) / 8.0) - 100.0)",
}


def code_of(made):
    """The code of a function: each call gives every variable a number that follows from all of them."""
    is_global = made.signature == GLOBALS
    owner = CLASS_NAME if made.signature == CLASS else "F_Io"
    leaves = [
        (_place(item.c, is_global=is_global) + leaf.place, C_NAMES[leaf.format.name])
        for item in made.variables
        for leaf in item.leaves
    ]
    return WORK.format(
        function=made.plan.function,
        own="".join(f"{item.declared};\n" for item in made.own_variables) if is_global else "",
        parameter="void" if is_global else f"{owner} *{OBJECT}",
        used="" if is_global else f"    (void){OBJECT};\n",
        reads="\n".join(f"    number = mixed(number, &{place}, sizeof({place}));" for place, _ in leaves),
        writes="\n".join(_write(place, type_) for place, type_ in leaves),
        calls="\n".join(_call(made, name) for name in made.symbols),
        hooks="".join(_hook(made, name) for name in made.hooks),
    )


def _place(variable, *, is_global):
    return variable if is_global else f"{OBJECT}->{variable.removeprefix(f'{OBJECT}.')}"


def _write(place, type_):
    chosen = NEXT.get(type_, f"({type_})(number % 97U)")
    return f"    {{ const {type_} next = {chosen}; (void)memcpy(&{place}, &next, sizeof(next)); }}\n    number = (number * 1664525U) + 1013904223U;"


def _call(made, name):
    head = head_of(made, name, f"{CLASS_NAME}::" if made.signature == CLASS else "")
    given_ = {GLOBALS: "", CLASS: "this"}.get(made.signature, OBJECT)
    result = "    return 0;\n" if head.startswith("int32_t") else ""
    return f"{head}\n{{\n    work({given_});\n{result}}}\n"


def _hook(made, name):
    linkage = 'extern "C" ' if made.signature == CLASS else ""
    return f"{linkage}void {name}({made.plan.type_name} *hooked)\n{{\n    (void)hooked;\n}}\n"


def function_in(folder, document):
    """The function, whose code is written into a folder."""
    made = subject(document)
    source = "f.cpp" if made.signature == CLASS else "f.c"
    (folder / source).write_text(code_of(made))
    write_headers(made, folder)
    whole = json.loads(to_json(document))
    whole["Code"]["Sources"] = [source]
    function = FunctionJson.model_validate(whole, by_name=False)
    return ResolvedFunction(function, read_json(to_json(function), str(folder / "f.json")))


def fmu_of(functions, folder):
    """The FMU of functions that the linter need not accept."""
    deployment = deployed(name=NAME, fmi={"fmus": "set"})
    model = derive(functions, deployment, deployment.fmi).model
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sigcat.adapter.fmi.fmu_files.read_integration", lambda *_: model)
        files = generate(written(model), "fmi.json", DEFAULT_LIMITS)
    for each in files:
        path = folder / "made" / each.name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(each.data)
    return packed(functions, folder)


def simulated_by(prepared):
    """A simulation of functions that the linter need not accept."""

    def sent(made, trace, out, end):
        del made, out
        collected = Collected(prepared)
        simulate(prepared, open_trace(trace, prepared.known_columns(())), Settings(end), toolchain(), collected)
        packings = {name: packing(shape) for name, shape in prepared.columns.items()}
        return [(row.time, name, packings[name].pack(value)) for row in collected.rows for name, value in row.values]

    return sent


def value_of(shape, chance):
    """A value, most often within its range."""
    if isinstance(shape, Number):
        if shape.symbols:
            return chance.choice(shape.symbols)[1]
        if shape.datatype == "boolean":
            return chance.random() < 0.5
        return chance.choice((0, 1, 2, 5, 9, 60)) if shape.is_whole else float(chance.choice((0, 0.25, 3, -2.5, 8, 70)))
    if isinstance(shape, Array):
        return [value_of(shape.element, chance) for _ in range(shape.length)]
    return {name: value_of(field, chance) for name, field in shape.fields}


def points_of(made, step, chance):
    """What is set at each communication point."""
    names = sorted(set(made.connections.first_names.values()))
    shapes = made.connections.received
    for point in range(0, END, step):
        yield point, {name: value_of(shapes[name], chance) for name in names if chance.random() < 0.6}


@given(functions().map(to_json), st.integers(0, 2**32))
@settings(
    examples(3),
    suppress_health_check=list(HealthCheck),
    phases=[Phase.explicit, Phase.generate, *([Phase.shrink] if IS_SEARCH else [])],
)
def test_an_fmu_of_a_random_function_sends_what_a_simulation_sends(tmp_path, document, seed):
    folder = Path(mkdtemp(dir=tmp_path))
    functions = [function_in(folder, FunctionJson.model_validate_json(document))]
    made, sent_by = fmu_of(functions, folder), simulated_by(prepare(functions))
    for step in (1, 10, 50, 70):
        points = list(points_of(made, step * MILLISECOND, random.Random(seed)))
        compare(made, points, step * MILLISECOND, END, folder, sent_by)
