"""JSON Schemas of sigcat.toml, of trees and overlays and of rules. Editors use them without a server."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, get_args

from sigcat.catalogue.model.datatypes import DATATYPES
from sigcat.catalogue.model.definition import CORE_ATTRIBUTES, TYPES
from sigcat.catalogue.model.interfaces import CATEGORIES
from sigcat.data import INTERFACE_RULES
from sigcat.findings import SEVERITIES
from sigcat.project.read_project import CATALOGUE_KEYS, REGISTRY_KEYS, TOP_KEYS
from sigcat.project.read_vehicles import STATE_KEYS, VEHICLE_KEYS
from sigcat.rules.checks import CHECKS
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.linting.configuration import FIELDS
from sigcat.rules.linting.severity import OFF
from sigcat.rules.record_faults import KEYS, REQUIRED, Scope

Schema = dict[str, Any]
_DIALECT = "https://json-schema.org/draft/2020-12/schema"
_TEXT: Schema = {"type": "string"}
_TEXTS: Schema = {"type": "array", "items": _TEXT}
_OF_KIND: Mapping[type, Schema] = {str: _TEXT, bool: {"type": "boolean"}, list: _TEXTS, dict: {"type": "object"}}
_SEVERITIES: Schema = {"type": "object", "additionalProperties": {"enum": [*SEVERITIES, OFF]}}
_OF_LINT: Mapping[str, Schema] = {
    "severity": _SEVERITIES,
    "per-file": {"type": "object", "additionalProperties": _SEVERITIES},
    "options": {"type": "object", "additionalProperties": {"type": "object"}},
    "base": _TEXT,
    "baseline": _TEXT,
}
_NUMBER: Schema = {"type": "number"}
_INSTANCES: Schema = {"anyOf": [_TEXT, {"type": "array", "items": {"anyOf": [_TEXT, _TEXTS]}}]}
_ATTRIBUTES: Mapping[str, Schema] = {
    "type": {"enum": [*TYPES], "description": "Kind of the node."},
    "datatype": {"anyOf": [{"enum": sorted(DATATYPES)}, _TEXT], "description": "Primitive type, or path of a struct."},
    "description": {**_TEXT, "description": "Meaning of the node, as a sentence."},
    "unit": {**_TEXT, "description": "Key of a unit, such as `km/h`; `sigcat units` lists them."},
    "min": {**_NUMBER, "description": "Smallest value."},
    "max": {**_NUMBER, "description": "Largest value."},
    "allowed": {"type": "array", "description": "All values that the signal may have."},
    "default": {"description": "Value as long as no other is known."},
    "instances": {**_INSTANCES, "description": "Names of the instances of a branch, or a range such as `Row[1,2]`."},
    "arraysize": {"type": "integer", "minimum": 1, "description": "Number of values of an array."},
    "comment": {**_TEXT, "description": "More about the node."},
    "deprecation": {**_TEXT, "description": "Release and reason, such as `v6.1 moved to Vehicle.Other`."},
    "delete": {"type": "boolean", "description": "In an overlay: remove the node."},
    "instantiate": {"type": "boolean", "description": "Whether the node is below each instance of its branch."},
    "aggregate": {"type": "boolean"},
    "pattern": {**_TEXT, "description": "Regular expression that texts match."},
    "fka": {"anyOf": [_TEXT, _TEXTS], "description": "Earlier paths of the node."},
    "constUID": _TEXT,
}
_FACT: Schema = {"type": ["string", "number", "boolean"]}
_VEHICLE: Mapping[str, Schema] = {
    "catalogue": {**_TEXT, "description": "Id of the catalogue that the vehicle is composed of (default: the first)."},
    "without": {**_TEXTS, "description": "Paths and wildcards of nodes that the vehicle does not have."},
    "with": {**_TEXTS, "description": "Overlays that the vehicle adds, in order."},
    "instances": {
        "type": "object",
        "description": "Instances of branches by path: a number of rows, or a list as in VSS.",
        "additionalProperties": {
            "anyOf": [{"type": "integer", "minimum": 1}, *_INSTANCES["anyOf"], {"type": "object"}]
        },
    },
    "attributes": {
        "type": "object",
        "description": "Facts such as `steering`, and values of attributes of the tree by path.",
    },
    "sop": {**_FACT, "description": "Start of production."},
    "year": {**_FACT, "description": "Model year."},
    "release": {**_FACT, "description": "Release over the air."},
}


def project_schema() -> Schema:
    """Schema of sigcat.toml."""
    catalogue = _table("A catalogue: a tree with its overlays.", _kinds(CATALOGUE_KEYS))
    catalogue["required"] = ["id"]
    catalogue["oneOf"] = [{"required": ["spec"]}, {"required": ["release"]}]
    state = _table("A vehicle in one state of its life.", _of_vehicle(STATE_KEYS)) | {"required": ["id"]}
    states: Schema = {"type": "array", "items": state}
    vehicle = _table("A vehicle, composed of a catalogue.", _of_vehicle(VEHICLE_KEYS) | {"state": states})
    vehicle["required"] = ["id"]
    lint = _table("Settings of `sigcat lint`.", {key: _OF_LINT.get(key, _TEXTS) for key in FIELDS})
    registry = _table("The registry of published versions.", _kinds(REGISTRY_KEYS))
    registry["oneOf"] = [{"required": ["database"]}, {"required": ["server"]}]
    lists = {"catalogue": {"type": "array", "items": catalogue}, "vehicle": {"type": "array", "items": vehicle}}
    properties = _kinds(TOP_KEYS) | lists | {"lint": lint, "registry": registry}
    return {"$schema": _DIALECT, "title": "sigcat.toml", **_table("A project of sigcat.", properties)}


def overlay_schema() -> Schema:
    """Schema of a tree or an overlay of the Vehicle Signal Specification."""
    core = {name: _ATTRIBUTES.get(name, {}) for name in sorted(CORE_ATTRIBUTES)}
    extended = {name: text for name, text in _extended_attributes() if name not in core}
    node = {"type": "object", "properties": core | extended}
    return {
        "$schema": _DIALECT, "title": "Tree or overlay", "description": "Nodes by path.", "type": "object",
        "propertyNames": {"pattern": r"^[A-Za-z*][A-Za-z0-9_.*]*$"}, "additionalProperties": node,
    }  # fmt: skip


def rules_schema() -> Schema:
    """Schema of a file of rules."""
    nodes = {
        "types": {"type": "array", "items": {"enum": [*TYPES, "signals"]}},
        "datatypes": {"type": "array", "items": {"enum": sorted(DATATYPES)}},
        "interfaces": {"type": "array", "items": {"enum": [*CATEGORIES]}},
        "path": {**_TEXT, "description": "A glob of paths."},
        "overlay": {"type": "boolean", "description": "Only nodes that an overlay adds."},
    }
    known: Mapping[str, Schema] = {
        "severity": {"enum": [*SEVERITIES]},
        "check": {"enum": sorted(CHECKS)},
        "default": {"type": "boolean", "description": "Whether the rule runs unless it is deselected."},
        "scope": {"enum": [*get_args(Scope)]},
        "nodes": _table("Nodes that the check sees.", nodes),
        "options": {"type": "object", "description": "Options of the check."},
        "name": {**_TEXT, "pattern": "^[a-z0-9]+(-[a-z0-9]+)*$"},
    }
    free: Schema = {}
    examples = ("good", "bad", "example")
    properties = {key: known.get(key, free if key in examples else _TEXT) for key in KEYS}
    record = _table("A rule.", properties) | {"required": [*REQUIRED]}
    return {
        "$schema": _DIALECT, "title": "Rules", "description": "Rules by code.", "type": "object",
        "patternProperties": {"^[A-Z]+[0-9]{3}$": record}, "additionalProperties": False,
    }  # fmt: skip


def _table(description: str, properties: Mapping[str, Schema]) -> Schema:
    return {
        "description": description, "type": "object", "properties": dict(properties), "additionalProperties": False,
    }  # fmt: skip


def _kinds(keys: Mapping[str, type]) -> dict[str, Schema]:
    return {key: _OF_KIND[kind] for key, kind in keys.items()}


def _of_vehicle(keys: Mapping[str, type]) -> dict[str, Schema]:
    return {key: _VEHICLE.get(key) or _OF_KIND[kind] for key, kind in keys.items()}


def _extended_attributes() -> Iterator[tuple[str, Schema]]:
    """Attributes of the tables of shipped rules, with their descriptions."""
    for fields in _tables(rule.options.get("fields") for rule in compiled_rules(INTERFACE_RULES)):
        for name, field in fields.items():
            if isinstance(field, dict):
                yield name, {"description": str(field.get("description", ""))}


def _tables(values: Iterable[Any]) -> Iterator[Mapping[str, Any]]:
    return (value for value in values if isinstance(value, dict))
