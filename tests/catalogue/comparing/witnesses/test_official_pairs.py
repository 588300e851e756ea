"""Neighbouring official releases: each message, type and id that a tool finds broken is one of the table, and no other."""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import cache
from itertools import pairwise
from typing import Any

import pytest
import yaml
from graphql import BreakingChange, build_schema, find_breaking_changes

from scripts.census import RELEASES
from sigcat.catalogue.comparing.bindings import Binding, form_of
from sigcat.catalogue.comparing.changes import Change
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.sides import read_side
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import NotFound
from sigcat.names import parent_path
from tests.catalogue.comparing.witnesses.tools import buf_messages, dds_types, exported, hashes, nodes, signals
from tests.needs import OFFICIAL, buf, cpp_compiler, idlc, official_releases, ros2

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
def test_a_schema_breaks_where_the_table_says_so(old, new):
    """A type may break for a risky change too: a new branch of the same name renames it."""
    schemas = [exported(side(name), "s2dm")["tree.graphql"].decode() for name in (old, new)]
    found = find_breaking_changes(*map(build_schema, schemas))
    classes = {form_of(change, "graphql") for change in changes(old, new)}
    assert bool(found) <= bool(classes & {"breaking", "risky"})
    branches = dict(re.findall(r"^(?:type|enum) (\w+)[^{]*@vspec\([^)]*fqn: \"([^\"]+)\"", schemas[0], re.MULTILINE))
    flagged = {branches[name] for name in types_of(found) if name in branches}
    _, without = unlike(flagged, broken(old, new, "graphql"), lambda change: templates_of(change, old))
    assert without == ()


def types_of(found: Iterable[BreakingChange]) -> Iterator[str]:
    """Types that breaking changes are about; those of instances are of their branch."""
    for each in found:
        text = each.description.partition(" was removed from enum type ")[2] or each.description
        yield re.split(r"[. ]|_InstanceTag", text)[0]


def templates_of(change: Change, release: str) -> Iterator[str]:
    """Definitions of the nodes that a change concerns, and of the branches that they are in."""
    known, paths = side(release).nodes, old_paths(change)
    concerned = (*branches_of(change), *paths, *map(parent_path, paths))
    yield from (known[path].template for path in concerned if path in known)


@pytest.mark.parametrize(("old", "new"), PAIRS)
def test_look_ups_of_a_signal_fail_where_the_table_says_so(old, new):
    before, after = (signals(exported(side(name), "json")) for name in (old, new))
    failing = {path for path, node in before.items() if after.get(path, {}).get("datatype") != node["datatype"]}
    assert unlike(failing, broken(old, new, "path")) == ((), ())


@pytest.mark.parametrize(("old", "new"), PAIRS)
def test_readers_of_the_exported_json_fail_where_the_table_says_so(old, new):
    before, after = (nodes(exported(side(name), "json")) for name in (old, new))
    failing = {path for path, node in before.items() if path not in after or differs(node, after[path])}
    assert unlike(failing, broken(old, new, "json")) == ((), ())


def unlike(
    failing: Collection[str], breaking: Iterable[Change], also: Callable[[Change], Iterable[str]] = lambda _: ()
) -> tuple[Sequence[str], Sequence[str]]:
    """Failing paths of which no breaking change tells, and breaking changes without a failing path.

    A change tells of its paths with all below, and of `also`.
    """
    found, without = set[str](), list[str]()
    for change in breaking:
        tops = tuple(f"{path}." for path in old_paths(change))
        below = {path for path in failing if f"{path}.".startswith(tops)} | set(also(change)).intersection(failing)
        found |= below
        without += [] if below else [change.path]
    return tuple(sorted(set(failing) - found)), tuple(without)


def differs(old: Mapping[str, Any], new: Mapping[str, Any]) -> bool:
    return any(old[key] != new.get(key) for key in ("datatype", "constUID") if key in old)


@ros2
@pytest.mark.parametrize(("old", "new"), PAIRS)
def test_messages_of_ros_2_have_another_hash_where_the_table_says_so(old, new, tmp_path):
    packages = []
    for name in (old, new):
        for file_name, data in exported(side(name), "ros2interface").items():
            file = tmp_path / name / file_name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(data)
        packages.append(tmp_path / name / "vss_interfaces")
    before, after = hashes(packages)
    paths = {path.replace(".", ""): path for path in side(old).nodes}
    failing = {paths[name] for name, value in before.items() if after.get(name) != value}
    assert unlike(failing, broken(old, new, "ros2"), branches_of) == ((), ())


@idlc
@cpp_compiler
@pytest.mark.parametrize(("old", "new"), PAIRS)
def test_types_of_dds_change_where_the_table_says_so(old, new, tmp_path):
    before, after = (exported(side(name), "ddsidl") for name in (old, new))
    paths = {path.replace(".", "_"): path for path in side(old).nodes}
    types = dds_types(before, after, tmp_path)
    failing = {paths[re.sub(r"_M_\w+Values$", "", name)] for name in types}
    assert unlike(failing, broken(old, new, "dds"), branches_of) == ((), ())
