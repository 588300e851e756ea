"""Neighbouring official releases: each message, type and id that a tool finds broken is one of the table, and no other."""

import re
from collections.abc import Iterator
from functools import cache
from itertools import pairwise

import pytest
import yaml
from graphql import build_schema, find_breaking_changes

from scripts.census import RELEASES
from sigcat.catalogue.comparing.bindings import Binding, form_of
from sigcat.catalogue.comparing.changes import Change
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.sides import read_side
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import NotFound
from sigcat.names import parent_path
from tests.catalogue.comparing.witnesses.tools import buf_messages, exported
from tests.needs import OFFICIAL, buf, official_releases

HERE = [name for name in RELEASES if (OFFICIAL / name).is_dir()]
PAIRS = [
    pytest.param(*pair, id="-".join(pair), marks=official_releases)
    for pair in pairwise(HERE if len(HERE) > 1 else ("v5.0", "v6.0"))
]


def no_release(name):
    raise NotFound(name)


@cache
def side(name: str) -> Catalogue:
    return read_side(str(OFFICIAL / name), no_release).catalogue


@cache
def changes(old: str, new: str) -> tuple[Change, ...]:
    return compare(side(old), side(new))


def broken(old: str, new: str, binding: Binding) -> Iterator[Change]:
    return (change for change in changes(old, new) if form_of(change, binding) == "breaking")


def old_paths(change: Change) -> tuple[str, ...]:
    """Where users of the old tree see the change."""
    return (*(change.former_paths or change.paths), *change.went, *change.came)


@pytest.mark.parametrize(("old", "new"), PAIRS)
def test_static_ids_are_lost_where_the_table_says_so(old, new):
    ids = [
        {path: node["staticUID"] for path, node in yaml.safe_load(exported(side(name), "id")["tree"]).items()}
        for name in (old, new)
    ]
    lost = {path for path, number in ids[0].items() if number not in ids[1].values()}
    tops = {path for change in broken(old, new, "ids") for path in old_paths(change)}
    assert {path for path in lost if not any(f"{path}.".startswith(f"{top}.") for top in tops)} == set()
    assert {
        top for top in tops if top in ids[0] and not any(f"{path}.".startswith(f"{top}.") for path in lost)
    } == set()


@buf
@pytest.mark.parametrize(("old", "new"), PAIRS)
def test_messages_of_protobuf_break_where_the_table_says_so(old, new, tmp_path):
    sides = [without_enumerations(exported(side(name), "protobuf")["tree"].decode()) for name in (old, new)]
    flagged = buf_messages(sides[0], sides[1], tmp_path)
    both = set.intersection(*(set(re.findall(r"^message (\w+)", text, re.MULTILINE)) for text in sides))
    breaking = (change for change in broken(old, new, "protobuf") if not is_of_labels(change))
    predicted = {path.replace(".", "") for change in breaking for path in branches_of(change)}
    assert flagged <= predicted
    assert predicted & both <= flagged


def branches_of(change: Change) -> Iterator[str]:
    """Branches whose fields the change concerns."""
    is_reordered = any(attribute.rule == "reordered" for attribute in change.attributes)
    inside = (*change.came, *change.went)
    yield from change.paths if is_reordered else ()
    yield from map(parent_path, inside if inside or is_reordered else change.former_paths or change.paths)


def is_of_labels(change: Change) -> bool:
    """Whether only an enumeration changed, which the compared files do not have."""
    rules = {effect for effect in change.effects if effect != "id-changed"}
    return (
        change.kind == "changed"
        and rules <= {"label-removed", "label-renumbered", "enumeration-renumbered"}
        and bool(rules)
    )


def without_enumerations(proto: str) -> str:
    """Texts instead of enumerations: those of the official trees do not compile, since vss-tools writes texts twice or as numbers."""
    return re.sub(r"\w+Enum (\w+ = \d+;)", r"string \1", re.sub(r"  enum \w+ \{[^}]*\}\n", "", proto))


@pytest.mark.parametrize(("old", "new"), PAIRS)
def test_a_schema_breaks_only_where_the_table_says_breaking_or_risky(old, new):
    schemas = [build_schema(exported(side(name), "s2dm")["tree.graphql"].decode()) for name in (old, new)]
    classes = {form_of(change, "graphql") for change in changes(old, new)}
    assert bool(find_breaking_changes(*schemas)) <= bool(classes & {"breaking", "risky"})
