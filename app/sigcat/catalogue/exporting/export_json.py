"""The tree as JSON: the same data as `vspec export json` of vss-tools 6.1 writes."""

import json
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from sigcat.catalogue.composing.attribute_values import is_finite
from sigcat.catalogue.composing.compose import unexpanded
from sigcat.catalogue.exporting.exporter import Job
from sigcat.catalogue.exporting.files import Export, ExportedFile
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import CORE_ATTRIBUTES, instances_of

_NOT_EXPORTED = frozenset(
    ("delete", "instantiate", "fqn", "arraysize", "aggregate", "is_instance", "instances_relation")
)


def exported_json(job: Job) -> Export:
    """The file, and with the option `types-output` a second one for the struct types."""
    options = job.options
    data = tree_data(
        job.catalogue if options.get("expand", True) else unexpanded(job.catalogue),
        options.get("extended-attributes", ()),
        all_extended=options.get("extend-all-attributes", False),
        keep_instances=options.get("keep-instances", False),
    )
    pretty = options.get("pretty", False)
    types = data.pop("ComplexDataTypes", None) if "types-output" in options else None
    files = [ExportedFile(job.output_name, tree_json(data, pretty=pretty).encode())]
    if types is not None:
        text = tree_json(types, pretty=pretty)
        files.append(ExportedFile(options["types-output"], text.encode(), "types-output"))
    return Export(tuple(files))


def tree_data(
    catalogue: Catalogue,
    extended_attributes: Iterable[str] = (),
    *,
    all_extended: bool = False,
    keep_instances: bool = False,
) -> dict[str, Any]:
    """Roots by name, each with attributes and `children`; struct types under `ComplexDataTypes`.

    Like vss-tools, it filters extended attributes at the root only. With `keep_instances`, branches that were expanded
    have their `instances` too, which vss-tools drops.
    """
    data: dict[str, Any] = {}
    wanted = frozenset(extended_attributes)
    instances = kept_instances(catalogue) if keep_instances else {}
    for position, root in enumerate(catalogue.roots):
        tree = _node_data(root, instances)
        if not all_extended:
            tree = {k: v for k, v in tree.items() if k in CORE_ATTRIBUTES or k in wanted or k == "children"}
        if position == 0:
            data[root.name] = tree
        else:
            data["ComplexDataTypes"] = {root.name: tree}
    return data


def tree_json(data: dict[str, Any], *, pretty: bool = False) -> str:
    """The text of the export: keys sorted, one line or indented by two."""
    return json.dumps(data, indent=2 if pretty else None, sort_keys=True, default=_json_value)


def kept_instances(catalogue: Catalogue) -> dict[str, list[Any]]:
    """Instances by path of the branch, for branches that were expanded."""
    return {
        path: instances
        for path, node in catalogue.nodes.items()
        if not node.definition.is_instance and "instances" not in node.values
        for instances in _written_instances(node)
    }


def _written_instances(node: Node) -> Iterator[list[Any]]:
    for statement in reversed(node.definition.statements):
        if "instances" in statement.values:
            instances = instances_of(statement.values)
            if instances:
                yield instances
            return


def _node_data(node: Node, instances: Mapping[str, list[Any]]) -> dict[str, Any]:
    data = {
        name: value
        for name, value in _finite_values(node.definition.values).items()
        if value is not None and value != [] and name not in _NOT_EXPORTED
    }
    if "instances" in data and isinstance(data["instances"], str):
        data["instances"] = [data["instances"]]
    if node.path in instances:
        data["instances"] = instances[node.path]
    if node.children:
        data["children"] = {child.name: _node_data(child, instances) for child in node.children}
    return data


def _finite_values(values: Mapping[str, Any]) -> Mapping[str, Any]:
    """The values as vss-tools has them in JSON: `null` is in the place of each number that is not finite, but for limits."""
    if all(map(is_finite, values.values())):
        return values
    return {name: value if name in _INFINITE else _finite(value) for name, value in values.items()}


_INFINITE = frozenset(("min", "max", "allowed"))


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_finite(item) for item in value]
    return value if is_finite(value) else None


def _json_value(value: Any) -> Any:
    return value.isoformat() if hasattr(value, "isoformat") else str(value)
