"""Verdicts of real tools on two trees: whether what is exported of the new one breaks software that was made with the old one."""

import json
import os
import re
import shutil
import subprocess
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
import yaml
from graphql import build_schema, find_breaking_changes
from jsonschema import Draft202012Validator

from scripts import ros2_environment
from sigcat.catalogue.comparing.bindings import Binding
from sigcat.catalogue.exporting.export import export
from sigcat.catalogue.model.catalogue import Catalogue
from tests.needs import BUF, CPP_COMPILERS, IDLC, buf, cpp_compiler, idlc

Files = Mapping[str, bytes]
Verdict = Callable[[Files, Files, Path], bool]


def exported(catalogue: Catalogue, format_name: str, **options: object) -> Files:
    """The files of an export, by name."""
    return {file.name: file.data for file in export(catalogue, format_name, options, output_name="tree")}


def protobuf_breaks(old: Files, new: Files, folder: Path) -> bool:
    """`buf breaking`, which compares numbers, names and types of fields on the wire and in JSON."""
    return bool(_buf_breaking(old, new, folder))


def buf_messages(old: str, new: str, folder: Path) -> set[str]:
    """Messages in which `buf breaking` finds something."""
    files = [{"tree": text.encode()} for text in (old, new)]
    return set(re.findall(r'on message "(\w+)"', _buf_breaking(files[0], files[1], folder)))


def _buf_breaking(old: Files, new: Files, folder: Path) -> str:
    """Return what `buf breaking` reports of two files that compile; nothing if they are compatible."""
    sides = [folder / "new", folder / "old"]
    for side, files in zip(sides, (new, old), strict=True):
        for name in (name for name in files if not name.endswith(".json")):
            file = (side / name).with_suffix(".proto")
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(files[name])
        (side / "buf.yaml").write_text("version: v2\nbreaking: {use: [WIRE_JSON]}\n")
        assert _buf(folder, "build", str(side)) == ""
    return _buf(folder, "breaking", str(sides[0]), "--against", str(sides[1]))


def _buf(folder: Path, *arguments: str) -> str:
    environment = {**os.environ, "HOME": str(folder)}
    result = subprocess.run([str(BUF), *arguments], capture_output=True, text=True, env=environment, check=False)
    assert result.returncode in (0, 100), result.stderr
    return result.stdout + result.stderr if result.returncode else ""


def graphql_breaks(old: Files, new: Files, _: Path) -> bool:
    """`find_breaking_changes` of graphql-core, as GraphQL Inspector has it."""
    schemas = [build_schema(files["tree.graphql"].decode()) for files in (old, new)]
    return bool(find_breaking_changes(*schemas))


_INSPECTOR = ("@graphql-inspector/core@8.0.0", "graphql@16")
_INSPECT = """
const { diff } = require('@graphql-inspector/core'), { buildSchema } = require('graphql');
(async () => {
  const pairs = JSON.parse(require('fs').readFileSync(0, 'utf8'));
  const changes = await Promise.all(pairs.map(pair => diff(...pair.map(each => buildSchema(each)))));
  console.log(JSON.stringify(changes.map(each => each.some(one => one.criticality.level === 'BREAKING'))));
})();
"""


def schemas_break(schemas: Sequence[str], folder: Path) -> Sequence[bool]:
    """GraphQL Inspector on neighbouring schemas."""
    node, npm = shutil.which("node"), shutil.which("npm")
    if node is None or npm is None:
        pytest.skip("Node: install it with npm")
    install = [npm, "install", "--no-audit", "--no-fund", "--ignore-scripts", *_INSPECTOR]
    if subprocess.run(install, cwd=folder, capture_output=True, check=False, timeout=300).returncode:
        pytest.skip(f"{_INSPECTOR[0]}: npm could not install it")
    pairs = json.dumps(list(pairwise(schemas)))
    done = subprocess.run([node, "-e", _INSPECT], cwd=folder, input=pairs, capture_output=True, text=True, check=True)
    return list(json.loads(done.stdout))


def ids_break(old: Files, new: Files, _: Path) -> bool:
    """Lookups by static id."""
    ids = [{n["staticUID"] for data in files.values() for n in yaml.safe_load(data).values()} for files in (old, new)]
    return not ids[0] <= ids[1]


def path_breaks(old: Files, new: Files, _: Path) -> bool:
    """Lookups of signals by path, which take the datatype of the value."""
    return not _has(signals(new), {path: {"datatype": node["datatype"]} for path, node in signals(old).items()})


def json_breaks(old: Files, new: Files, _: Path) -> bool:
    """A reader of the exported JSON that expects nodes with their datatypes and identifiers."""
    kept = {
        path: {key: node[key] for key in ("datatype", "constUID") if key in node} for path, node in nodes(old).items()
    }
    return not _has(nodes(new), kept)


def _has(document: Mapping[str, object], expected: Mapping[str, Mapping[str, object]]) -> bool:
    """Whether a validator of JSON Schema finds the expected members."""
    properties = {
        path: {"required": list(members), "properties": {key: {"const": value} for key, value in members.items()}}
        for path, members in expected.items()
    }
    return bool(Draft202012Validator({"required": list(expected), "properties": properties}).is_valid(document))


def signals(files: Files) -> Mapping[str, Mapping[str, Any]]:
    return {path: node for path, node in nodes(files).items() if "datatype" in node}


def nodes(files: Files) -> Mapping[str, Mapping[str, Any]]:
    """Nodes of an exported JSON by path."""
    found, waiting = (
        dict[str, Mapping[str, Any]](),
        [each for data in files.values() for each in json.loads(data).items()],
    )
    while waiting:
        path, node = waiting.pop()
        found[path] = node
        waiting += [(f"{path}.{name}", child) for name, child in node.get("children", {}).items()]
    return found


def dds_breaks(old: Files, new: Files, folder: Path) -> bool:
    """Whether a program with the types that `idlc` makes of the old IDL compiles with those of the new one."""
    return bool(dds_types(old, new, folder))


def dds_types(old: Files, new: Files, folder: Path) -> set[str]:
    """Types that `idlc` makes of the old IDL, and whose uses do not compile with those of the new one.

    C++ compiles them: in C an enumeration is a number.
    """
    headers = [_idlc(files["tree"], folder / name) for name, files in (("old", old), ("new", new))]
    uses = [(name, use.replace("\n", " ")) for name, use in _uses_of_types(headers[0].read_text())]
    consumer = folder / "consumer.cpp"
    consumer.write_text("\n".join([f'#include "{headers[1]}"', *(use for _, use in uses), ""]))
    compiler = CPP_COMPILERS[0]
    without_limit = () if compiler == ("g++",) else ("-ferror-limit=0",)
    command = [*compiler, "-fsyntax-only", *without_limit, str(consumer)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    found = re.findall(r"consumer\.cpp:(\d+):\d+: error", done.stderr)
    assert bool(found) is (done.returncode != 0), done.stderr
    return {uses[int(line) - 2][0] for line in found}


def _idlc(idl: bytes, folder: Path) -> Path:
    """The header that Cyclone DDS generates, without that of its library."""
    folder.mkdir(parents=True)
    (folder / "tree.idl").write_bytes(idl)
    subprocess.run([str(IDLC), "-l", "c", "tree.idl"], cwd=folder, capture_output=True, check=True)
    header = folder / "tree.h"
    library = "#include <stdbool.h>\n#include <stdint.h>\ntypedef struct dds_topic_descriptor dds_topic_descriptor_t;"
    header.write_text(header.read_text().replace('#include "dds/ddsc/dds_public_impl.h"', library))
    return header


_OFFSET = "__builtin_offsetof"


def _uses_of_types(header: str) -> Iterator[tuple[str, str]]:
    """Types with declarations that agree with a header in which each struct has these members, and each enumeration these values."""
    types = re.findall(r"^typedef (?:struct|enum) \w+\s*\{([^}]*)\} (\w+);", header, re.MULTILINE)
    for body, name in dict.fromkeys(types):  # a header repeats types of sequences
        members = [each.strip() for each in body.split(";") if each.strip()]
        if ";" not in body:
            yield from (
                (name, f'static_assert({value} == {number}, "");')
                for number, value in enumerate(re.findall(r"\w+", body))
            )
            continue
        yield name, f"typedef struct {{{body}}} Old_{name};"
        for member in members:
            found = re.fullmatch(r"(.*?)(\w+)((?:\[\d+\])*)", member, re.DOTALL)
            assert found is not None, member
            kind, called, size = found.groups()
            use = f"{name}_{called}"
            yield name, f"extern {kind} {use}{size}; extern __typeof__((({name} *)0)->{called}) {use};"
            yield name, f'static_assert({_OFFSET}({name}, {called}) == {_OFFSET}(Old_{name}, {called}), "");'
        yield name, f'static_assert(sizeof({name}) == sizeof(Old_{name}), "");'


def hashes(folders: Sequence[Path]) -> Sequence[Mapping[str, str]]:
    """The hash of each message of packages, by rosidl."""
    script = Path(__file__).with_name("ros2_hashes.py")
    result = subprocess.run(
        [str(ros2_environment.PYTHON), str(script), *map(str, folders)],
        capture_output=True, text=True, check=True, env=dict(ros2_environment.variables()),
    )  # fmt: skip
    return list(json.loads(result.stdout.splitlines()[-1]))


def messages_break(old: Mapping[str, str], new: Mapping[str, str]) -> bool:
    """Whether a subscriber of the old messages gets none any more: ROS 2 connects equal hashes only."""
    return any(new.get(name) != value for name, value in old.items())


VERDICTS: Mapping[Binding, tuple[str, Verdict]] = {
    "path": ("json", path_breaks),
    "json": ("json", json_breaks),
    "protobuf": ("protobuf", protobuf_breaks),
    "graphql": ("s2dm", graphql_breaks),
    "ids": ("id", ids_break),
    "dds": ("ddsidl", dds_breaks),
}
"""By binding, the export and its tool."""
NEEDS: Mapping[Binding, Sequence[pytest.MarkDecorator]] = {"protobuf": [buf], "dds": [idlc, cpp_compiler]}
EACH_BINDING = [pytest.param(name, marks=NEEDS.get(name, ())) for name in VERDICTS]
"""The bindings for `parametrize`."""
