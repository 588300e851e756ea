"""A function of an old official release: C code and SOME/IP of a signal break if, and only if, the table says so."""

import json
import re
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from random import Random
from typing import NamedTuple

import pytest

from sigcat.catalogue.comparing.bindings import Binding
from sigcat.catalogue.model.catalogue import Node
from sigcat.cli import main
from tests.catalogue.comparing.witnesses.test_functions import found
from tests.catalogue.comparing.witnesses.test_official_pairs import PAIRS, broken, changes, old_paths, side
from tests.needs import C_COMPILERS, OFFICIAL, c_compiler

UNCHANGED = 40
"""Signals of each pair that no change concerns."""
FUNCTION = """\
function: Echo
description: Receives.
responsible: Demo team
components:
  - name: Echo
    runnables:
      - Init
      - interface: Step
        data:
{data}      - Terminate
define:
  scheduling:
    Init: {{description: Prepares., asil: QM, priority: 1, scheduling: Preemptive}}
    Step: {{description: Works., asil: QM, cycleTime: 20, priority: 10, scheduling: Preemptive}}
    Terminate: {{description: Ends., asil: QM, priority: 1, scheduling: Preemptive}}
"""


class Generated(NamedTuple):
    """What is generated for a function of some signals."""

    folder: Path
    events: Mapping[str, tuple[int, str]]
    """Id and datatype of the event of each path."""
    numbers: Mapping[str, Mapping[str, int]]
    """Numbers of texts, by path."""


def generated(folder: Path, release: str, names: Mapping[str, str]) -> Generated:
    """Generate the function with a release. `names` are by path."""
    folder.mkdir()
    data = (
        f"          - {{path: {path}, role: consumed, name: {name}, variable: in_{name}, provider: Trace, asil: QM}}\n"
        for path, name in names.items()
    )
    (folder / "function.yaml").write_text(FUNCTION.format(data="".join(data)))
    common = (str(folder / "function.yaml"), "-s", str(OFFICIAL / release), "-o")
    assert main(["generate", "core", *common, str(folder / "core")]) == 0
    assert main(["integrate", "autosar-adaptive", *common, str(folder / "integration.json")]) == 0
    document = json.loads((folder / "integration.json").read_text())
    types = {each["typeRef"]: each["Symbols"] for each in found(document, "Symbols")}
    events = {each["VssPath"]: (each["EventID"], each["DataType"]) for each in found(document, "EventID")}
    numbers = {
        path: {one["Symbol"]: one["Value"] for one in types.get(datatype, ())} for path, (_, datatype) in events.items()
    }
    return Generated(folder / "core", events, numbers)


def unlike_in_c(old: Generated, new: Generated) -> set[str]:
    """Names whose declarations in the old header do not agree with the new one."""
    header = (old.folder / "Echo_adapter.h").read_text()
    received = re.findall(r"^(void Echo_Adapter_Receive_(\w+)\(.*\);)$", header, re.MULTILINE)
    members = re.findall(r"struct \{ (\w+) value((?:\[\d+\])*); Sigcat_Reception reception; \} (\w+);", header)
    uses = [(name, line) for line, name in received]
    for kind, size, name in members:
        member = f"__typeof__(((Echo_Adapter *)0)->received.{name}.value)"
        uses.append((name, f"extern {kind} use_{name}{size}; extern {member} use_{name};"))
    assert len(uses) == 2 * len(old.events)
    consumer = new.folder / "consumer.c"
    consumer.write_text("\n".join(['#include "Echo_adapter.h"', *(use for _, use in uses), ""]))
    done = subprocess.run(
        [*C_COMPILERS[0], "-fsyntax-only", str(consumer)], capture_output=True, text=True, check=False
    )
    return {uses[int(line) - 2][0] for line in re.findall(r"consumer\.c:(\d+):\d+: error", done.stderr)}


def chosen(old: str, new: str) -> Sequence[str]:
    """Changed signals that both releases have, and some that are unchanged."""
    trees = side(old), side(new)
    usable = [path for path in trees[0].nodes if all(may_be_sent(tree.get(path)) for tree in trees)]
    tops = tuple(f"{path}." for change in changes(old, new) for path in old_paths(change))
    changed = [path for path in usable if f"{path}.".startswith(tops)]
    others = sorted(set(usable).difference(changed))
    return *changed, *Random(1).sample(others, min(UNCHANGED, len(others)))


def may_be_sent(node: Node | None) -> bool:
    """Whether a node has a datatype of limited length."""
    if node is None or not node.is_leaf:
        return False
    datatype = str(node.values["datatype"])
    is_limited = not datatype.endswith("[]") or "arraysize" in node.values
    return is_limited and (not datatype.startswith("string") or "allowed" in node.values)


def are_other_numbers(old: Mapping[str, int], new: Mapping[str, int]) -> bool:
    """Whether a text has another number, or the numbers got names: an adapter refuses those without one."""
    return not old.items() <= new.items() or bool(old) is not bool(new)


@c_compiler
@pytest.mark.parametrize(("old", "new"), PAIRS)
def test_what_a_function_uses_breaks_where_the_table_says_so(old, new, tmp_path):
    names = {path: f"s{number}" for number, path in enumerate(chosen(old, new))}
    before, after = (generated(tmp_path / release, release, names) for release in (old, new))
    unlike = unlike_in_c(before, after)
    renumbered = {path for path in names if are_other_numbers(before.numbers[path], after.numbers[path])}
    failing: dict[Binding, set[str]] = {
        "c": {path for path, name in names.items() if name in unlike} | renumbered,
        "someip": {path for path in names if before.events[path] != after.events[path]} | renumbered,
    }
    for binding, paths in failing.items():
        tops = tuple(f"{path}." for change in broken(old, new, binding) for path in old_paths(change))
        assert paths == {path for path in names if f"{path}.".startswith(tops)}
