"""Memory of each function's core: its context, and its stack as far as the compiler tells it."""

import re
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.host.connections import Member
from sigcat.adapter.templates import rendered
from sigcat.adapter.toolchain import Toolchain
from sigcat.runs.building.commands import Compilation, compilations

_USAGE = re.compile(r"[^\t]*:\d+:\d+:(?P<name>[^\t]*)\t(?P<bytes>\d+)\t")
_DEFINITION = re.compile(r"^\w[^;{}()=]*?\b(?P<name>\w+)\([^;{}]*\)\n\{\n(?P<body>.*?)^\}", re.MULTILINE | re.DOTALL)
_CALL = re.compile(r"\b(\w+)\(")


class Memory(NamedTuple):
    """Memory of a core, in bytes."""

    function: str
    state: int
    """Size of one context, with the function's data if the context holds it."""
    stack: int | None
    """Size of the deepest chain of calls within the core; None if the compiler does not tell it."""
    deepest: str
    """Function in which that chain begins."""

    @property
    def text(self) -> str:
        """For people."""
        stack = f"{self.stack} bytes of stack in {self.deepest}" if self.stack is not None else "stack unknown"
        return f"{self.function}: {self.state} bytes of state, {stack}"


def memory_of(members: Sequence[Member], folder: Path, tools: Toolchain) -> tuple[Memory, ...]:
    """Return the memory of each function, from a folder with the files that were generated for them and built."""
    cores = [one for one in compilations(members, folder, tools) if one.source.stem.endswith("_adapter")]
    return tuple(_memory(members[one.member], one) for one in cores if one.member is not None)


def _memory(member: Member, core: Compilation) -> Memory:
    state = _size(member.plan.type_name, core)
    found = _deepest(_frames(core), _callees(core.source.read_text()))
    return Memory(member.name, state, *(found or (None, "")))


def _size(type_name: str, core: Compilation) -> int:
    """The size of a type, as a program prints it."""
    source = core.source.with_name(f"{core.source.stem}_memory{core.source.suffix}")
    source.write_text(
        rendered("runs/building/size.c.j2", header=core.source.with_suffix(".h").name, type_name=type_name)
    )
    program = source.with_suffix(".exe")
    flags = [each for each in core.command[:-3] if each != "-c"]
    _run([*flags, "-o", str(program), str(source)])
    return int(_run([str(program)]))


def _frames(core: Compilation) -> dict[str, int]:
    """Bytes of stack of each function that is not part of another one."""
    output = core.output.with_suffix(".stack.o")
    try:
        _run([*core.command[:-3], "-fstack-usage", "-o", str(output), str(core.source)])
    except subprocess.CalledProcessError:
        return {}
    texts = [path.read_text() for path in core.output.parent.glob("*.su")]
    found = [match for text in texts for match in _USAGE.finditer(text)]
    names = (re.findall(r"\w+(?=\(|$)", match["name"]) for match in found)  # C++ has the whole head
    return {name[0]: int(match["bytes"]) for name, match in zip(names, found, strict=True) if name}


def _run(command: list[str]) -> str:
    return subprocess.run(command, capture_output=True, check=True, text=True).stdout  # noqa: S603 — no shell


def _callees(text: str) -> dict[str, frozenset[str]]:
    """Functions that each function of a source calls."""
    bodies = {match["name"]: match["body"] for match in _DEFINITION.finditer(text)}
    return {name: frozenset(_CALL.findall(body)) & bodies.keys() for name, body in bodies.items()}


def _deepest(frames: Mapping[str, int], callees: Mapping[str, frozenset[str]]) -> tuple[int, str] | None:
    depths: dict[str, int] = {}
    for name in callees:
        _depth(name, frames, callees, depths)
    known = [(depths[name], name) for name in frames if name in depths]
    return max(known) if known else None


def _depth(
    name: str, frames: Mapping[str, int], callees: Mapping[str, frozenset[str]], depths: dict[str, int]
) -> int:  # fmt: skip
    """A core has no recursion."""
    if name not in depths:
        below = [_depth(each, frames, callees, depths) for each in sorted(callees[name])]
        depths[name] = frames.get(name, 0) + max(below, default=0)
    return depths[name]
