"""Published functions, their owners and what they exchange as entities of Backstage's software catalog."""

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

import yaml
from sqlalchemy import Connection

from sigcat.digest import digest_of
from sigcat.registry.published import Published, all_versions, lines_by_version
from sigcat.registry.reference import DEPLOYABLE
from sigcat.registry.storing.content import content_of
from sigcat.registry.use import Use, from_json

Entity = Mapping[str, Any]
_LONGEST = 63
"""Characters of a name of Backstage."""
_KINDS = {
    "provides": "signal", "consumes": "signal", "offers": "method", "calls": "method", "reports": "error",
    "depends on": "error", "sends": "mode", "receives": "mode",
}  # fmt: skip
_UNKNOWN = "No published function provides it"
"""Title of the owner of signals that no function provides."""


class _Function(NamedTuple):
    published: Published
    description: str
    uses: tuple[Use, ...]
    lines: tuple[str, ...]

    @property
    def lifecycle(self) -> str:
        if self.published.state == "deprecated":
            return "deprecated"
        return "production" if self.lines else "experimental"


def backstage_entities(connection: Connection) -> Iterator[Entity]:
    """Yield a Group for each owner, an API for each element that is exchanged, and a Component for each function."""
    functions = tuple(_functions(connection))
    providers = {
        use.element: each for each in reversed(functions) for use in each.uses if use.provides
    }  # the first ones
    elements = {use.element: use for each in functions for use in each.uses}
    owners = {each.published.owner for each in functions}
    if elements.keys() - providers.keys():
        owners.add(_UNKNOWN)
    groups, apis, components = map(_names, (owners, elements, (each.published.name for each in functions)))
    for owner in sorted(owners):
        yield _entity("Group", groups[owner], owner or "No owner", {"type": "team", "children": []})
    for element in sorted(elements):
        provider = providers.get(element)
        owner = groups[provider.published.owner if provider else _UNKNOWN]
        yield _api(elements[element], apis[element], owner, provider.lifecycle if provider else "production")
    for each in functions:
        yield _component(each, components[each.published.name], groups[each.published.owner], apis)


def _functions(connection: Connection) -> Iterator[_Function]:
    """The newest published version of each function."""
    lines = lines_by_version(connection)
    newest = {each.name: each for each in all_versions(connection, "function") if each.state in DEPLOYABLE}
    for each in newest.values():
        info = json.loads(content_of(connection, each.resolved))["FunctionInfo"]
        uses = from_json(content_of(connection, each.uses))
        exchanged = tuple(use for use in uses if use.verb in _KINDS and not use.via)
        yield _Function(each, " ".join(str(info["Description"]).split()), exchanged, lines.get(each.id, ()))


def _entity(kind: str, name: str, title: str, spec: Entity, **metadata: Any) -> Entity:
    return {
        "apiVersion": "backstage.io/v1alpha1", "kind": kind,
        "metadata": {"name": name, "title": title, **{key: value for key, value in metadata.items() if value}},
        "spec": spec,
    }  # fmt: skip


def _api(use: Use, name: str, owner: str, lifecycle: str) -> Entity:
    kind = _KINDS[use.verb]
    definition = written([{kind: use.element, **dict(use.values)}], is_stream=False)
    spec = {"type": f"sigcat-{kind}", "lifecycle": lifecycle, "owner": owner, "definition": definition}
    return _entity("API", name, use.element, spec)


def _component(function: _Function, name: str, owner: str, apis: Mapping[str, str]) -> Entity:
    published = function.published
    spec = {
        "type": "vehicle-function", "lifecycle": function.lifecycle, "owner": owner,
        "providesApis": _used(function, apis, provides=True), "consumesApis": _used(function, apis, provides=False),
    }  # fmt: skip
    annotations = {"sigcat.io/version": published.version, "sigcat.io/sha256": published.content}
    if function.lines:
        annotations["sigcat.io/lines"] = ", ".join(function.lines)
    description = function.description
    return _entity("Component", name, published.name, spec, description=description, annotations=annotations)


def _used(function: _Function, apis: Mapping[str, str], *, provides: bool) -> list[str]:
    return sorted({apis[use.element] for use in function.uses if use.provides is provides})


def _names(texts: Iterable[str]) -> Mapping[str, str]:
    """Names of entities, which Backstage compares without case. A text that does not fit gets the hash of it."""
    names: dict[str, str] = {}
    taken = set[str]()
    for text in sorted(set(texts)):
        name = re.sub(r"[-_.]*[^A-Za-z0-9_.-]+[-_.]*|[-_.]{2,}", "-", text).strip("-_.")
        if not name or len(name) > _LONGEST or name.lower() in taken:
            kept = name[-(_LONGEST - 9) :].strip("-_.")
            name = "-".join(filter(None, (kept, digest_of(text.encode())[:8])))
        taken.add(name.lower())
        names[text] = name
    return names


class _Dumper(yaml.SafeDumper):
    """Texts that YAML 1.2 would read as a number are quoted, too: PyYAML knows those of YAML 1.1."""

    def ignore_aliases(self, _data: Any) -> bool:
        return True


def _text(dumper: yaml.SafeDumper, text: str) -> yaml.ScalarNode:
    style = '"' if re.match(r"[-+.0-9]", text) else "|" if text.endswith("\n") else None
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style=style)


_Dumper.add_representer(str, _text)


def written(entities: Iterable[Entity], *, is_stream: bool = True) -> str:
    """The entities as documents of YAML."""
    text: str = yaml.dump_all(
        entities, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=1000, explicit_start=is_stream
    )
    return text
