"""A catalogue as files that vss-tools reads: the merged tree before expansion, its struct types, units and quantities.

vss-tools then expands, refines and deletes as it would with the original files, since it sees the same statements; it
gets no chance to stumble over layouts of other releases, or over two units with one name.
"""

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from pathlib import Path
from typing import Any, NamedTuple

import yaml

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import BRANCH, Definition, Problem
from sigcat.catalogue.model.vocabulary import Unit, Vocabulary
from sigcat.digest import digest_of

_DUMPER: Any = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
_TEXT = "tag:yaml.org,2002:str"
_ESSENTIAL = frozenset(("type", "datatype", "description", "instances"))
"""Attributes without which a node is not the same."""


class Files(NamedTuple):
    """Files with the parts of a catalogue."""

    tree: Path
    overlays: tuple[Path, ...]
    types: tuple[Path, ...]
    units: tuple[Path, ...]
    quantities: tuple[Path, ...]


def write_catalogue(catalogue: Catalogue, folder: Path, *, copy_unit_files: bool = False) -> Files:
    """Write a catalogue into a folder that is empty so far.

    With `copy_unit_files`, files of units and quantities are copied byte for byte where vss-tools takes them.
    """
    tree = _write(folder / "tree.vspec", tree_statements(catalogue.definitions))
    late = late_statements(catalogue.definitions)
    overlays = (_write(folder / "late.vspec", late),) if late else ()
    types = tuple(
        _write(folder / f"types{number}.vspec", type_statements(root))
        for number, root in enumerate(catalogue.roots[1:], 1)
    )
    vocabulary = catalogue.vocabulary
    units, quantities = (copy_unit_files and _copied(catalogue, folder)) or _unit_files(vocabulary, folder)
    return Files(tree, overlays, types, units, quantities)


def tree_statements(definitions: Mapping[str, Definition]) -> dict[str, Any]:
    """The merged tree as one flat file, in the order in which its paths were first written."""
    return {path: _statement(definition) for path, definition in definitions.items()}


def _statement(definition: Definition) -> dict[str, Any]:
    """Return a definition as vss-tools reads it. A description that is a number, as in old trees, becomes text."""
    refused = {problem.attribute for problem in refused_attributes(definition)}
    kept = {
        name: value
        for name, value in definition.values.items()
        if name not in refused and not _is_include(name, definition)
    }
    if isinstance(kept.get("description"), int | float):
        kept["description"] = str(kept["description"])
    return kept


def refused_attributes(definition: Definition) -> tuple[Problem, ...]:
    """Problems of attributes that the tools of an older release accepted and that today's vss-tools refuses.

    A catalogue with such errors is only exported if they count as warnings; what can be left out is left out.
    """
    return tuple(
        problem
        for problem in definition.problems
        if problem.rule.severity == "error"
        and problem.attribute in definition.values
        and problem.attribute not in _ESSENTIAL
    )


def late_statements(definitions: Mapping[str, Definition]) -> dict[str, Any]:
    """Return the attributes that must not be in the flat file: `includes` of a branch that did not request a file."""
    return {
        path: {name: value for name, value in d.values.items() if _is_include(name, d)}
        for path, d in definitions.items()
        if d.type == BRANCH and "includes" in d.values
    }


def type_statements(root: Node) -> dict[str, Any]:
    """A tree of struct types as one flat file."""
    return {node.path: dict(node.values) for node in root.walk()}


def unit_entries(vocabulary: Vocabulary) -> dict[str, Any]:
    """Units in today's layout, each with a unique name."""
    by_name: defaultdict[str, list[Unit]] = defaultdict(list)
    for unit in vocabulary.distinct_units:
        by_name[unit.name].append(unit)
    return {unit.key: _unit_entry(unit, by_name[unit.name]) for unit in vocabulary.distinct_units}


def quantity_entries(vocabulary: Vocabulary) -> dict[str, Any]:
    """Quantities in today's layout, and those that units measure though an older release defined none."""
    measured = {unit.quantity.lower(): {"definition": unit.quantity} for unit in vocabulary.distinct_units}
    return measured | {
        key: {"definition": quantity.definition, **({"remark": quantity.remark} if quantity.remark else {})}
        for key, quantity in vocabulary.quantities.items()
    }


class _Dumper(_DUMPER):  # type: ignore[misc]
    """Writes every text in double quotes, on one line: no line of a text can be taken for an `#include`."""

    def ignore_aliases(self, _: Any) -> bool:
        """Anchors are not needed to write a tree."""
        return True


def _quoted(dumper: Any, text: str) -> Any:
    return dumper.represent_scalar(_TEXT, text, style='"')


_Dumper.add_representer(str, _quoted)


def _write(file: Path, entries: Mapping[str, Any]) -> Path:
    text = yaml.dump(dict(entries), Dumper=_Dumper, sort_keys=False, width=-1, allow_unicode=True)
    file.write_text(text, encoding="utf-8", newline="\n")
    return file


def _is_include(name: str, definition: Definition) -> bool:
    return name == "includes" and definition.type == BRANCH


def _unit_entry(unit: Unit, same_name: Sequence[Unit]) -> dict[str, Any]:
    entry: dict[str, Any] = {
        "definition": unit.definition,
        "unit": _own_name(unit, same_name),
        "quantity": unit.quantity.lower(),
    }
    if unit.allowed_datatypes:
        entry["allowed-datatypes"] = list(unit.allowed_datatypes)
    return entry


def _own_name(unit: Unit, same_name: Sequence[Unit]) -> str | None:
    """The name of a unit; where several share it, all but one get another, as VSS 6.1 does for `mpg`."""
    if len(same_name) == 1 or not unit.name:
        return unit.name or None
    deprecated = [other for other in same_name if other.deprecation]
    if unit is [*deprecated, *(other for other in same_name if not other.deprecation)][-1]:
        return unit.name
    return f"{unit.name} (deprecated)" if deprecated == [unit] else f"{unit.name} ({unit.key})"


def _unit_files(vocabulary: Vocabulary, folder: Path) -> tuple[tuple[Path, ...], tuple[Path, ...]]:
    return (
        (_write(folder / "units.yaml", unit_entries(vocabulary)),) if vocabulary.units else (),
        (_write(folder / "quantities.yaml", quantity_entries(vocabulary)),) if vocabulary.units else (),
    )


def _copied(catalogue: Catalogue, folder: Path) -> tuple[tuple[Path, ...], tuple[Path, ...]] | None:
    """Copies of the files of units and quantities; None where vss-tools does not take them, or they do not suffice."""
    vocabulary = catalogue.vocabulary
    if vocabulary.findings:
        return None
    named = (node.values.get("unit") for node in catalogue.nodes.values())
    used = {unit.origin.file for name in named if isinstance(name, str) and (unit := vocabulary.unit(name))}
    units = _as_given({unit.origin.file for unit in vocabulary.units.values()}, used, vocabulary)
    measured = {unit.quantity.lower() for unit in vocabulary.units.values() if unit.origin.file in units}
    needed = {vocabulary.quantities[key].origin.file for key in measured if key in vocabulary.quantities}
    quantities = _as_given({each.origin.file for each in vocabulary.quantities.values()}, needed, vocabulary)
    copies = _copies(units, vocabulary, folder), _copies(quantities, vocabulary, folder)
    return copies if all(copies) else None


def _as_given(files: AbstractSet[str], needed: AbstractSet[str], vocabulary: Vocabulary) -> AbstractSet[str]:
    """The files that vss-tools reads with the same options: those given alone, where the tree needs no others."""
    given = files & vocabulary.given
    return given if given and needed <= given else files


def _copies(names: Iterable[str], vocabulary: Vocabulary, folder: Path) -> tuple[Path, ...]:
    """Copies of the files with these names, or nothing if one of them is no longer what was read."""
    wanted = set(names)
    copies: list[Path] = []
    if not wanted <= {source.name for source in vocabulary.files}:
        return ()
    for number, source in enumerate(vocabulary.files, 1):
        if source.name not in wanted:
            continue
        try:
            data = Path(source.name).read_bytes()
        except OSError:
            return ()
        if digest_of(data) != source.digest:
            return ()
        copies.append(folder / f"original{number}.yaml")
        copies[-1].write_bytes(data)
    return tuple(copies)
