"""Catalogues and nodes as HTML for notebooks. Every text is escaped."""

from collections import Counter
from collections.abc import Iterable
from html import escape
from typing import Any

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.reading.statement import Origin

_MOST_CHILDREN = 50
"""Children that are listed; of more, their number is given."""


def catalogue_html(catalogue: Catalogue, title: str) -> str:
    """Return title, counts of nodes by type, and the branches below the roots."""
    counts = Counter(node.type for node in catalogue.nodes.values())
    facts = ", ".join(f"{count:,} × {_text(kind)}" for kind, count in counts.most_common())
    found = f"<p>{len(catalogue.findings):,} findings, in <code>findings</code></p>" if catalogue.findings else ""
    children = [child for root in catalogue.roots for child in root.children]
    return f"<div><strong>{_text(title)}</strong><p>{facts}</p>{found}{_nodes(children)}</div>"


def node_html(node: Node) -> str:
    """Return every attribute with its value and origin, and the nodes below."""
    rows = ((name, _text(value), _origin(node.definition.origin(name))) for name, value in node.values.items())
    heading = f"<strong>{_text(node.path)}</strong>"
    return f"<div>{heading}{_table(('attribute', 'value', 'written in'), rows)}{_nodes(node.children)}</div>"


def _nodes(nodes: Iterable[Node]) -> str:
    listed = list(nodes)
    more = f"<p>… and {len(listed) - _MOST_CHILDREN:,} more</p>" if len(listed) > _MOST_CHILDREN else ""
    rows = [(node.path, _facts(node), _text(node.values.get("description") or "")) for node in listed[:_MOST_CHILDREN]]
    return f"{_table(('node', 'type', 'description'), rows)}{more}" if rows else ""


def _facts(node: Node) -> str:
    facts = (node.type, node.values.get("datatype"), node.values.get("unit"))
    return _text(" ".join(str(fact) for fact in facts if fact))


def _table(titles: Iterable[str], rows: Iterable[tuple[str, str, str]]) -> str:
    head = "".join(f"<th>{title}</th>" for title in titles)
    body = "".join(f"<tr><th>{_text(name)}</th><td>{first}</td><td>{second}</td></tr>" for name, first, second in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _origin(origin: Origin) -> str:
    overlay = f" ({origin.overlay})" if origin.overlay else ""
    return f"<code>{_text(f'{origin.file}:{origin.line}')}</code>{_text(overlay)}"


def _text(value: Any) -> str:
    """Return a value as escaped text that can be sent as UTF-8."""
    return escape(str(value).encode("utf-8", "replace").decode())
