"""Drawn pairs of trees: a binding breaks if, and only if, its tool says so."""

from collections.abc import Sequence
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest

from sigcat.catalogue.comparing.bindings import Binding, form_of
from sigcat.catalogue.comparing.changes import Class, worst
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.kept_numbers import with_kept_numbers
from sigcat.catalogue.comparing.sides import read_side
from sigcat.catalogue.exporting.field_numbers import read_lock
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import NotFound
from tests.catalogue.comparing.witnesses.drawn_trees import Drawer
from tests.catalogue.comparing.witnesses.tools import (
    EACH_BINDING,
    VERDICTS,
    exported,
    hashes,
    messages_break,
    protobuf_breaks,
    schemas_break,
)
from tests.needs import buf, ros2, sampled

LENGTH = 26
"""Trees of a chain; its neighbours are pairs."""
CHAINS = range(12)


def no_release(name):
    raise NotFound(name)


@cache
def chain(seed: int, folder: Path) -> Sequence[Catalogue]:
    """Catalogues of the trees."""
    files = [folder / f"tree{number}.vspec" for number in range(LENGTH)]
    for file, text in zip(files, Drawer(seed).chain(LENGTH), strict=True):
        file.write_text(text)
    return [read_side(str(file), no_release).catalogue for file in files]


def form(old: Catalogue, new: Catalogue, binding: Binding) -> Class:
    """The worst class of the changes, of the form alone."""
    return worst(form_of(change, binding) for change in compare(old, new))


def disagreements(catalogues: Sequence[Catalogue], binding: Binding, verdicts: Sequence[bool]) -> Sequence[str]:
    """Pairs for which table and tool differ. A risky change may break or not."""
    found = []
    for number, ((old, new), breaks) in enumerate(zip(pairwise(catalogues), verdicts, strict=True)):
        predicted = form(old, new, binding)
        if predicted != "risky" and (predicted == "breaking") is not breaks:
            rules = [(change.path, change.rule, change.effects) for change in compare(old, new)]
            found.append(f"{number}: {predicted}, and the tool says {'breaking' if breaks else 'fine'}: {rules}")
    return found


@pytest.mark.parametrize("seed", CHAINS)
@pytest.mark.parametrize("binding", EACH_BINDING)
def test_table_and_tool_agree(binding, seed, tmp_path):
    catalogues = chain(seed, tmp_path)
    format_name, breaks = VERDICTS[binding]
    exports = [exported(each, format_name) for each in catalogues]
    verdicts = [breaks(old, new, tmp_path / str(number)) for number, (old, new) in enumerate(pairwise(exports))]
    assert True in verdicts
    assert not disagreements(catalogues, binding, verdicts)


@pytest.mark.real
@pytest.mark.parametrize("seed", sampled(CHAINS, {0}))
def test_table_and_graphql_inspector_agree(seed, tmp_path):
    catalogues = chain(seed, tmp_path)
    verdicts = schemas_break([exported(each, "s2dm")["tree.graphql"].decode() for each in catalogues], tmp_path)
    assert set(verdicts) == {True, False}
    assert not disagreements(catalogues, "graphql", verdicts)


@buf
@pytest.mark.parametrize("seed", CHAINS)
def test_with_a_lock_of_numbers_no_position_breaks_protobuf(seed, tmp_path):
    catalogues = chain(seed, tmp_path)
    lock = tmp_path / "numbers.json"
    exports, locks = [], []
    for catalogue in catalogues:
        files = exported(catalogue, "protobuf", keep_numbers_of=lock)
        lock.write_bytes(files["numbers.json"])
        exports.append(files)
        locks.append(read_lock(lock))
    verdicts = [
        protobuf_breaks(old, new, tmp_path / str(number)) for number, (old, new) in enumerate(pairwise(exports))
    ]
    for (old, new), numbers, breaks in zip(pairwise(catalogues), locks[:-1], verdicts, strict=True):
        kept = with_kept_numbers(compare(old, new), old, numbers)
        if (predicted := worst(form_of(change, "protobuf") for change in kept)) != "risky":
            assert (predicted == "breaking") is breaks, [(change.path, change.rule, change.effects) for change in kept]


@ros2
@pytest.mark.parametrize("seed", CHAINS)
def test_a_message_has_another_hash_where_the_table_says_breaking(seed, tmp_path):
    catalogues = chain(seed, tmp_path)
    packages = []
    for number, catalogue in enumerate(catalogues):
        for name, data in exported(catalogue, "ros2interface").items():
            file = tmp_path / str(number) / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(data)
        packages.append(tmp_path / str(number) / "vss_interfaces")
    verdicts = [messages_break(old, new) for old, new in pairwise(hashes(packages))]
    assert True in verdicts
    assert not disagreements(catalogues, "ros2", verdicts)
