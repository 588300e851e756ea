"""Verdicts of real tools on two trees: whether what is exported of the new one breaks software that was made with the old one."""

import json
import os
import re
import subprocess
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import yaml
from graphql import build_schema, find_breaking_changes

from scripts import ros2_environment
from sigcat.catalogue.comparing.bindings import Binding
from sigcat.catalogue.exporting.export import export
from sigcat.catalogue.model.catalogue import Catalogue
from tests.needs import BUF

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


def ids_break(old: Files, new: Files, _: Path) -> bool:
    """Lookups by static id."""
    ids = [{n["staticUID"] for data in files.values() for n in yaml.safe_load(data).values()} for files in (old, new)]
    return not ids[0] <= ids[1]


def dds_breaks(old: Files, new: Files, _: Path) -> bool:
    """Declarations of the IDL: each type still has its members, and an enumeration its values at their places."""
    before, after = (declarations(files["tree"].decode()) for files in (old, new))
    return any(name not in after or not _reads(body, after[name]) for name, body in before.items())


def _reads(old: Sequence[str], new: Sequence[str]) -> bool:
    return list(new[: len(old)]) == list(old) if old[0] == "enum" else new == old


def declarations(idl: str) -> Mapping[str, Sequence[str]]:
    """Bodies of structs and enumerations by their scoped name."""
    found: dict[str, Sequence[str]] = {}
    scope: list[str] = []
    text = re.sub(r"//[^\n]*", "", idl)
    for kind, name, body in re.findall(r"(module|struct|enum)\s+(\w+)\s*(\{[^{}]*\};|\{)|\};", text):
        if kind in ("struct", "enum"):
            found["::".join((*scope, name))] = [kind, *re.findall(r"[^\s{},;]+", body)]
        elif kind:
            scope.append(name)
        else:
            scope.pop()
    return found


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
    "protobuf": ("protobuf", protobuf_breaks),
    "graphql": ("s2dm", graphql_breaks),
    "ids": ("id", ids_break),
    "dds": ("ddsidl", dds_breaks),
}
"""By binding, the export and its tool."""
