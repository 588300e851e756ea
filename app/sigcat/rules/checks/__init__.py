"""A rule and a tree in; problems out, from one check for each concern.

The table has the checks by the names that rules call them by. To add one: write it in its file and name it here.
"""

from collections.abc import Callable, Mapping
from importlib import import_module

from sigcat.catalogue.model.definition import TYPES
from sigcat.catalogue.model.interfaces import CATEGORIES
from sigcat.catalogue.network import mapping_attributes
from sigcat.rules.checks import (
    attributes,
    fields,
    groups,
    naming,
    overlays,
    portable,
    references,
    signals,
    text,
)
from sigcat.rules.checks.kind import (
    ATTRIBUTE,
    ATTRIBUTES,
    COUNT,
    NAME,
    NAMES,
    TEXT,
    TEXTS,
    VALUES,
    Check,
    LineCheck,
    NodeCheck,
    NodeTest,
    Options,
    TreeCheck,
    TreeTest,
    one_of,
)
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree

_PORTABLE: Options = {"case": one_of(portable.CASES), "target": TEXT}
_SCREAMING = one_of(("screaming",))
_NAME_OR_PATH = one_of(("name", "path"))
_ANY_MAPPING = f"={'|'.join(mapping_attributes.ATTRIBUTES)}"


def _of_mappings(name: str) -> Callable[[Rule, Tree], NodeTest]:
    """Return a check whose code is loaded with the first mapping: few trees have one."""

    def prepare(rule: Rule, tree: Tree) -> NodeTest:
        test: NodeTest = getattr(import_module("sigcat.rules.checks.network"), name)(rule, tree)
        return test

    prepare.__name__ = name
    return prepare


def sent_once(rule: Rule, tree: Tree) -> TreeTest:
    """Require that only one of several signals or instances is sent as a signal of the network."""
    if not any(mapping_attributes.KUKSA_TARGET in definition.values for definition in tree.judged):
        return lambda: ()
    from sigcat.rules.checks import network

    return network.sent_once(rule, tree)


CHECKS: Mapping[str, Check] = {
    "name": NodeCheck(
        naming.name, {"pattern": TEXT, "prefixes": NAMES, "exempt": NAMES, "endings": NAMES, "case": _SCREAMING}
    ),
    "instance-name": NodeCheck(naming.instance_name, {"pattern": TEXT}, ("pattern",), "=instances"),
    "path": NodeCheck(signals.path, {"pattern": TEXT}, ("pattern",)),
    "path-depth": NodeCheck(signals.path_depth, {"most": COUNT}, ("most",)),
    "text": NodeCheck(
        text.text,
        {
            "attribute": ATTRIBUTE,
            "pattern": TEXT,
            "forbidden": TEXT,
            "each": one_of(("key", "value")),
            "case": _SCREAMING,
            "repair": one_of(text.REPAIRS),
            "except": TEXT,
        },
        ("attribute",),
        "attribute",
    ),
    "line-length": LineCheck(text.line_length, {"most": COUNT}, ("most",)),
    "required": NodeCheck(attributes.required, {"attributes": ATTRIBUTES}, ("attributes",)),
    "filled": NodeCheck(attributes.filled, {"except": NAMES}),
    "forbidden": NodeCheck(attributes.forbidden, {"attributes": ATTRIBUTES}, ("attributes",)),
    "exclusive": NodeCheck(attributes.exclusive, {"attributes": ATTRIBUTES}, ("attributes",)),
    "implied": NodeCheck(
        attributes.implied,
        {"attribute": ATTRIBUTE, "values": VALUES, "then": NAMES, "never": NAMES},
        ("attribute",),
        "attribute",
    ),
    "backed": NodeCheck(
        attributes.backed,
        {"attribute": ATTRIBUTE, "by": ATTRIBUTE, "value": TEXT},
        ("attribute", "by", "value"),
        "attribute",
    ),
    "ordered": NodeCheck(attributes.ordered, {"attributes": NAMES}, ("attributes",)),
    "default-first": NodeCheck(attributes.default_first, {}, (), "=default"),
    "distinct-items": NodeCheck(attributes.distinct_items, {"attribute": ATTRIBUTE}, ("attribute",), "attribute"),
    "distinct-from-siblings": NodeCheck(
        attributes.distinct_from_siblings, {"attribute": ATTRIBUTE, "except": TEXT}, ("attribute",), "attribute"
    ),
    "known-attributes": NodeCheck(attributes.known_attributes, {"attributes": ATTRIBUTES}),
    "required-fields": NodeCheck(fields.required_fields, {"fields": fields.FIELDS}, ("fields",)),
    "field-values": NodeCheck(fields.field_values, {"fields": fields.FIELDS}, ("fields",)),
    "reference": NodeCheck(
        references.reference,
        {"attribute": NAME, "to": one_of(CATEGORIES), "external": TEXT},
        ("attribute", "to"),
        "attribute",
        needs_whole_tree=True,
    ),
    "reference-cycle": TreeCheck(references.cycle, {"attribute": NAME}, ("attribute",), needs_whole_tree=True),
    "companions": NodeCheck(groups.companions, {"required": TEXTS}, ("required",), needs_whole_tree=True),
    "node-type": NodeCheck(groups.type_of, {"types": one_of(TYPES, is_list=True)}, ("types",)),
    "asil-of-step": NodeCheck(
        groups.asil_of_step, {"provides": one_of(CATEGORIES, is_list=True)}, ("provides",), needs_whole_tree=True
    ),
    "deprecated-unit": NodeCheck(signals.deprecated_unit, {}, (), "=unit"),
    "unit-spelling": NodeCheck(signals.unit_spelling, {}, (), "=unit"),
    "deprecation-target": NodeCheck(signals.deprecation_target, {}, (), "=deprecation", needs_whole_tree=True),
    "instance-start": NodeCheck(signals.instance_start, {"first": COUNT}, ("first",), "=instances"),
    "instance-duplicates": NodeCheck(signals.instance_duplicates, {}, (), "=instances"),
    "unique-path": TreeCheck(signals.unique_path, {}),
    "twice-written": TreeCheck(signals.twice_written, {"ignored": ATTRIBUTES}),
    "overlay-unknown-node": NodeCheck(overlays.unknown_node, {}, of_overlays=True),
    "overlay-deletes-nothing": NodeCheck(overlays.deletes_nothing, {}, (), "=delete", of_overlays=True),
    "overlay-changes": NodeCheck(
        overlays.changes, {"attributes": ATTRIBUTES, "given": ATTRIBUTES}, ("attributes",), of_overlays=True
    ),
    "overlay-narrows": NodeCheck(overlays.narrows, {}, of_overlays=True),
    "overlay-conflict": NodeCheck(overlays.conflict, {"ignored": ATTRIBUTES}, of_overlays=True, of_stacks=True),
    "overlay-instances": NodeCheck(overlays.keeps_instances, {}, of_overlays=True),
    "overlay-below-deleted": TreeCheck(overlays.below_deleted, {}),
    "overlay-no-effect": TreeCheck(overlays.no_effect, {}, of_stacks=True),
    "mapping-transform": NodeCheck(_of_mappings("transform"), {}, (), _ANY_MAPPING),
    "mapping-listed-once": NodeCheck(_of_mappings("listed_once"), {}, (), _ANY_MAPPING),
    "mapping-values": NodeCheck(_of_mappings("values_fit"), {}, (), _ANY_MAPPING),
    "mapping-sent-once": TreeCheck(sent_once, {}),
    "can-signal": NodeCheck(_of_mappings("in_database"), {}, (), _ANY_MAPPING),
    "can-message": NodeCheck(_of_mappings("unambiguous"), {}, (), _ANY_MAPPING),
    "can-names": NodeCheck(_of_mappings("names_in_database"), {}, (), _ANY_MAPPING),
    "can-no-value": NodeCheck(_of_mappings("no_value_handled"), {}, (), _ANY_MAPPING),
    "can-unit": NodeCheck(_of_mappings("unit_converted"), {}, (), _ANY_MAPPING),
    "can-range": NodeCheck(_of_mappings("range_fits"), {}, (), _ANY_MAPPING),
    "reserved-word": NodeCheck(portable.reserved_word, {**_PORTABLE, "words": NAMES}, ("words", "target")),
    "converted-name": NodeCheck(portable.converted_name, {**_PORTABLE, "pattern": TEXT}, ("pattern", "target")),
    "name-length": NodeCheck(
        portable.name_length, {"most": COUNT, "of": _NAME_OR_PATH, "target": TEXT}, ("most", "target")
    ),
    "collision": TreeCheck(portable.collision, {**_PORTABLE, "of": _NAME_OR_PATH}, ("target",)),
}
"""`needs` that starts with `=` is the attribute itself, or several of which one is enough; otherwise it names the option that holds it."""
