"""Describe what is under the cursor: a node, a unit or a rule, in Markdown."""

from collections.abc import Iterable, Iterator
from pathlib import Path

from sigcat.catalogue.model.definition import Definition
from sigcat.catalogue.model.vocabulary import Unit, Vocabulary
from sigcat.catalogue.reading.statement import Origin
from sigcat.lsp.places import Word, key_of, node_at, references_in
from sigcat.lsp.warm_project import WarmProject
from sigcat.rules.linting.selection import rules_for
from sigcat.rules.pages import rule_page
from sigcat.rules.tree import Tree

_MOST_USERS = 20


def hover_text(project: WarmProject, path: Path, lines: list[str], line: int, word: Word) -> str:
    """Return what is known of the word at a place; empty if nothing is."""
    tree = project.tree(path)
    if key_of(lines[line]) == "unit" and (unit := tree.catalogue.vocabulary.unit(word.text)) is not None:
        return _unit_text(unit)
    node = node_at(tree, path, line, word)
    if node is not None:
        return "\n\n".join(_node_parts(node, tree, project.functions(path), word.text))
    rules = {rule.id: rule for rule in rules_for(project.chosen(path).options)}
    return rule_page(rules[word.text]) if word.text in rules else ""


def _node_parts(node: Definition, tree: Tree, functions: Iterable[Path], named: str) -> Iterator[str]:
    instance = f" (`{named}`)" if named != node.path and tree.is_instance(named) else ""
    yield f"**{node.path}**{instance} · {node.type}"
    if facts := " · ".join(_facts(node, tree.catalogue.vocabulary)):
        yield facts
    if description := node.values.get("description"):
        yield str(description).strip()
    if deprecation := node.values.get("deprecation"):
        yield f"Deprecated: {str(deprecation).strip()}"
    yield "\n".join(("Written in:", *(f"- {_origin_text(statement.origin())}" for statement in node.statements)))
    users = [*dict.fromkeys(_users(node, tree, functions))]
    if users:
        more = [f"- {len(users) - _MOST_USERS} more"] if len(users) > _MOST_USERS else []
        yield "\n".join(("Used by:", *(f"- {user}" for user in users[:_MOST_USERS]), *more))


def _facts(node: Definition, vocabulary: Vocabulary) -> Iterator[str]:
    values = node.values
    if "datatype" in values:
        yield f"`{values['datatype']}`"
    if isinstance(key := values.get("unit"), str):
        unit = vocabulary.unit(key)
        yield f"{key} ({unit.name})" if unit is not None and unit.name and unit.name != key else key
    if "min" in values or "max" in values:
        yield f"{values.get('min', '…')} … {values.get('max', '…')}"
    for name in ("allowed", "default", "instances"):
        if name in values:
            yield f"{name}: {values[name]}"


def _origin_text(origin: Origin) -> str:
    return f"{origin.file}:{origin.line}{' (overlay)' if origin.overlay else ''}"


def _users(node: Definition, tree: Tree, functions: Iterable[Path]) -> Iterator[str]:
    for file in functions:
        for reference in references_in(file, tree):
            found = tree.resolve(reference.text) or tree.interfaces.get(reference.text)
            if found is not None and found.path == node.path:
                role = f" ({reference.role})" if reference.role else ""
                yield f"{file}:{reference.place.line + 1}{role}"


def _unit_text(unit: Unit) -> str:
    parts = (f"**{unit.key}** · {unit.name}", unit.definition, f"Quantity: {unit.quantity}")
    return "\n\n".join((*parts, f"Defined in: {_origin_text(unit.origin)}"))
