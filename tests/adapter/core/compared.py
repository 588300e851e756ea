"""A script, done by the model and by the generated core, compared line by line."""

from pathlib import Path

from sigcat.adapter.core.numbers import DOUBLE, NumberType
from sigcat.adapter.core.plan import NANOSECONDS, Clock
from sigcat.function.function_json.model import FunctionJson, to_json
from tests.adapter.core import core_side, model_side
from tests.adapter.core.script import Line, Script
from tests.adapter.core.subject import Subject, subject
from tests.adapter.core.traces import Tracer


def disagreement(
    document: FunctionJson,
    seed: int,
    lines: int,
    folder: Path,
    flags: tuple[str, ...],
    arithmetic: NumberType = DOUBLE,
    clock: Clock = NANOSECONDS,
) -> str:
    """Return where the two differ, and in which values: empty if they do not."""
    made = subject(document, arithmetic, clock)
    (folder / "function.json").write_bytes(to_json(document))
    script = Tracer(made, seed).script(lines)
    (folder / "script.txt").write_text("\n".join(str(readable(made, line)) for line in script))
    return difference(made, script, core_side.run(core_side.compiled(made, folder, flags), script))


def difference(made: Subject, script: Script, printed: list[str]) -> str:
    """The first line after which a core has printed something else than the model."""
    start = 0
    for number, expected in enumerate(model_side.ModelSide(made).run(script)):
        found = printed[start : start + len(expected)]
        if found != expected:
            return f"line {number}, {readable(made, script[number])}:\n" + "\n".join(_parts(found, expected))
        start += len(expected)
    return "" if start == len(printed) else f"more than expected: {printed[start]}"


def _parts(found: list[str], expected: list[str]) -> list[str]:
    """List the differences, piece by piece."""
    pairs = zip(" ".join(found).split(), " ".join(expected).split(), strict=False)
    return [f"core {core}, model {model}" for core, model in pairs if core != model][:8] or [
        f"core {found}, model {expected}"
    ]


def readable(made: Subject, line: Line) -> Line:
    """A line with names in place of numbers."""
    word, *rest = line
    names = {
        "receive": [item.name for item in made.ports],
        "reject": [item.name for item in made.ports],
        "lose": [item.name for item in made.ports],
        "set": [item.name for item in made.variables],
        "then": [item.name for item in made.variables],
        "advance": [name for name, _ in made.calls],
        "finish": [name for name, _ in made.calls],
        "store": [item.name for item in made.parameters],
    }.get(str(word))
    return (word, names[int(rest[0])], *rest[1:]) if names else line
