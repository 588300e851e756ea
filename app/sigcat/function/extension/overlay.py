"""Definitions of a function.yaml, written as an overlay."""

import re
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import yaml

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors, in_order
from sigcat.function.declaration.declaration import read_declaration
from sigcat.function.extension.defined_nodes import DefinedNode
from sigcat.function.extension.definition_findings import definition_findings
from sigcat.function.extension.extended_catalogue import extended

_WIDTH = 116
_ROOM_OF_KEY = 24
_UNSAFE = re.compile("^\\s*#|[\x85\u2028\u2029]", re.MULTILINE)
"""Lines that a text may not make: comments, which vspec reads as includes, and breaks that are not breaks elsewhere."""


class Overlay(NamedTuple):
    """An overlay as text, the struct types as a separate text (empty if there are none), and warnings."""

    text: str
    types: str
    findings: tuple[Finding, ...]


def overlay_of(data: bytes, name: str, catalogue: Catalogue) -> Overlay:
    """The overlay of the definitions in a `function.yaml`. Raises InputRefused with every finding."""
    declared = read_declaration(data, name)
    if declared.declaration is None:
        raise InputRefused(f"{name} cannot be read.", in_order(declared.findings))
    catalogue, (definitions,) = extended(catalogue, [declared])
    if not definitions:
        message = f"{name} defines no interfaces: all of them are the catalogue's."
        raise InputRefused(message, in_order(declared.findings))
    findings = in_order([*declared.findings, *definition_findings(definitions, declared.document, catalogue).findings])
    if has_errors(findings):
        raise InputRefused(f"The interfaces that {name} defines have errors.", findings)
    text, types = overlay_text(definitions.nodes, "Interfaces"), overlay_text(definitions.types, "Struct types")
    return Overlay(text, types, findings)


# -- text ---------------------------------------------------------------------------------------------------------


def overlay_text(nodes: Iterable[DefinedNode], title: str) -> str:
    """Nodes as vspec, one paragraph for each; nothing if there are none."""
    paragraphs = [statement_text(node.path, node.values) for node in nodes]
    made = "# Made by `sigcat function overlay` from what a function.yaml defines: change it there."
    return "\n".join([f"# {title} of a function\n#\n{made}\n", *paragraphs]) if paragraphs else ""


def statement_text(path: str, values: Mapping[str, Any]) -> str:
    """One node as vspec."""
    text = _dumped({path: dict(values)}, _WIDTH)
    return text if not _UNSAFE.search(text) else _dumped({path: dict(values)}, _ENDLESS, quoted=True)


_ENDLESS = 1 << 30
"""A text that is broken into lines could make `#include`, which vspec reads wherever a line starts with it."""


class _Dumper(yaml.SafeDumper):
    """Short lists on one line, no aliases, words such as OFF in quotes as PyYAML has it."""

    def ignore_aliases(self, _data: Any) -> bool:
        """Every value is written in full."""
        return True


class _Quoted(_Dumper):
    """Every text in double quotes."""


def _flow(dumper: yaml.SafeDumper, items: list[Any]) -> yaml.Node:
    is_short = sum(len(str(item)) + len("'', ") for item in items) < _WIDTH - _ROOM_OF_KEY
    return dumper.represent_sequence("tag:yaml.org,2002:seq", items, flow_style=is_short)


def _in_quotes(dumper: yaml.SafeDumper, text: str) -> yaml.Node:
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style='"')


_Dumper.add_representer(list, _flow)
_Quoted.add_representer(list, _flow)
_Quoted.add_representer(str, _in_quotes)


def _dumped(value: Any, width: int, *, quoted: bool = False) -> str:
    dumper = _Quoted if quoted else _Dumper
    return str(
        yaml.dump(value, Dumper=dumper, sort_keys=False, allow_unicode=True, width=width, default_flow_style=False)
    )
