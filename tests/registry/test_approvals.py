"""Versions that break functions of other owners wait for these owners."""

import datetime as dt
from pathlib import Path

import pytest

from sigcat.errors import InputRefused
from sigcat.registry.author import Author
from sigcat.registry.candidates.candidate import Candidate
from sigcat.registry.compatibility.deploying import can_deploy
from sigcat.registry.decisions import approvals
from sigcat.registry.decisions.approvals import approve, pending, reject
from sigcat.registry.lines import set_rule, set_state
from sigcat.registry.publish import publish
from sigcat.registry.published import all_versions, version_named
from sigcat.registry.reference import Reference
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.database import reading
from sigcat.registry.storing.entry import time_text
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.transfer import exported, import_lines
from sigcat.registry.storing.verify import read_log, verify
from tests.registry.parts import candidate, catalogue, declaration

CATALOGUE = catalogue()
ALPHA = Reference("Alpha", "1.1.0")


def function(name: str, version: str, provided: tuple[str, ...] = (), consumed: tuple[str, ...] = ()) -> Candidate:
    return candidate(declaration(name, provided, consumed, version), CATALOGUE)


BREAKING = function("Alpha", "1.1.0", ("S1",))


@pytest.fixture
def registry(tmp_path: Path) -> Registry:
    """A registry in which Beta and Gamma consume what Alpha provides, and Alpha asks for approval."""
    registry = Registry(tmp_path / "registry.db")
    publish(
        registry,
        [
            function("Alpha", "1.0.0", ("S0", "S1")),
            function("Beta", "1.0.0", ("S2",), ("S0",)),
            function("Gamma", "1.0.0", ("S3",), ("S0", "S1")),
        ],
    )
    set_rule(registry, "function", "Alpha", "approval")
    return registry


def status(registry: Registry, *candidates: Candidate) -> str:
    return publish(registry, candidates).outcomes[0].status


def entries(registry: Registry) -> list[str]:
    with reading(registry.database) as connection:
        assert verify(connection).findings == ()
        return [link.entry.action for link in read_log(connection)]


def refused(call, *arguments) -> list[str]:
    with pytest.raises(InputRefused) as error:
        call(*arguments)
    return [each.rule for each in error.value.findings]


def test_a_version_is_published_when_every_owner_has_approved_and_the_same_bytes_are_published_again(
    registry: Registry,
) -> None:
    outcome = publish(registry, [BREAKING]).outcomes[0]
    assert (outcome.status, [(each.owner, each.functions) for each in outcome.approvals]) == (
        "pending", [("Team Beta", "Beta 1.0.0"), ("Team Gamma", "Gamma 1.0.0")],
    )  # fmt: skip
    approve(registry, "function", ALPHA, "Team Beta")
    assert status(registry, BREAKING) == "pending"
    approve(registry, "function", ALPHA, "Team Gamma")
    assert status(registry, BREAKING) == "published"
    assert status(registry, BREAKING) == "unchanged"
    with reading(registry.database) as connection:
        assert pending(connection) == ()
    assert entries(registry)[-4:] == ["publish", "approve", "approve", "publish"]


def test_a_pending_version_is_stored_whole_and_neither_deployed_nor_a_baseline(registry: Registry) -> None:
    publish(registry, [BREAKING])
    with reading(registry.database) as connection:
        (waiting,) = pending(connection)
        assert content_of(connection, waiting.published.content) == BREAKING.content
        assert refused(can_deploy, connection, [ALPHA], "SUV-2025") == ["E009"]
    assert refused(set_state, registry, "function", ALPHA, "deprecated") == ["E009"]
    assert status(registry, function("Alpha", "1.1.1", ("S0", "S1"))) == "published"


def test_the_same_bytes_again_write_nothing_and_keep_the_approval(registry: Registry) -> None:
    publish(registry, [BREAKING])
    approve(registry, "function", ALPHA, "Team Beta")
    before = entries(registry)
    for _ in range(3):
        assert status(registry, BREAKING) == "pending"
    assert entries(registry) == before


def test_other_bytes_need_approvals_again_and_the_first_bytes_have_theirs(registry: Registry) -> None:
    publish(registry, [BREAKING])
    for owner in ("Team Beta", "Team Gamma"):
        approve(registry, "function", ALPHA, owner)
    other = function("Alpha", "1.1.0", ("S1", "S3"))
    assert status(registry, other) == "pending"
    assert [each.decision for each in publish(registry, [other]).outcomes[0].approvals] == ["", ""]
    assert status(registry, BREAKING) == "published"
    assert entries(registry)


def test_an_approval_ends(registry: Registry, monkeypatch: pytest.MonkeyPatch) -> None:
    publish(registry, [BREAKING])
    for owner in ("Team Beta", "Team Gamma"):
        approve(registry, "function", ALPHA, owner, 7)
    later = dt.datetime.now(dt.UTC) + dt.timedelta(days=7, seconds=1)
    monkeypatch.setattr(approvals, "now", lambda: time_text(later))
    assert status(registry, BREAKING) == "pending"
    (first, _) = publish(registry, [BREAKING]).outcomes[0].approvals
    assert "its approval ended on" in first.sentence(time_text(later))


def test_a_rejection_has_a_reason_and_its_owner_may_approve_later(registry: Registry) -> None:
    publish(registry, [BREAKING])
    approve(registry, "function", ALPHA, "Team Gamma")
    decided = reject(registry, "function", ALPHA, "Team Beta", "The display needs S0.")
    assert decided.approvals[0].sentence("2000") == "Team Beta rejected it: The display needs S0."
    assert status(registry, BREAKING) == "pending"
    approve(registry, "function", ALPHA, "Team Beta")
    assert status(registry, BREAKING) == "published"


def test_a_new_major_version_beside_the_old_one_needs_no_approval(registry: Registry) -> None:
    assert status(registry, function("Alpha", "2.0.0", ("S1",))) == "published"


def test_what_breaks_no_other_owner_needs_no_approval(registry: Registry) -> None:
    assert status(registry, function("Alpha", "1.0.1", ("S0", "S1"))) == "published"
    alone = function("Gamma", "1.1.0", (), ("S0", "S1"))  # nobody consumes S3
    set_rule(registry, "function", "Gamma", "approval")
    assert status(registry, alone) == "published"


def test_a_consumer_that_is_published_in_the_same_command_is_not_asked(registry: Registry) -> None:
    beta, gamma = (function(name, "2.0.0", (own,)) for name, own in (("Beta", "S2"), ("Gamma", "S3")))
    assert [each.status for each in publish(registry, [BREAKING, beta, gamma]).outcomes] == ["published"] * 3


def test_a_function_that_relies_on_it_meanwhile_is_asked_as_well(registry: Registry) -> None:
    publish(registry, [BREAKING])
    for owner in ("Team Beta", "Team Gamma"):
        approve(registry, "function", ALPHA, owner)
    publish(registry, [function("Delta", "1.0.0", (), ("S0",))])
    outcome = publish(registry, [BREAKING]).outcomes[0]
    assert (outcome.status, [each.owner for each in outcome.approvals if not each.decision]) == (
        "pending", ["Team Delta"],
    )  # fmt: skip


def test_a_file_that_names_another_owner_does_not_spare_this_owner_the_question(registry: Registry) -> None:
    content = BREAKING.content.replace(b"responsible: Team Alpha", b"responsible: Team Beta")
    outcome = publish(registry, [candidate(content, CATALOGUE)]).outcomes[0]
    assert [each.owner for each in outcome.approvals] == ["Team Beta", "Team Gamma"]


def test_a_decision_that_does_not_fit_is_a_finding(registry: Registry) -> None:
    publish(registry, [BREAKING])
    assert refused(approve, registry, "function", ALPHA, "Team Gama") == ["E014"]
    assert refused(approve, registry, "function", ALPHA, "Team Beta", 0) == ["E014"]
    assert refused(approve, registry, "function", ALPHA, "Team Beta", 10**10) == ["E014"]
    assert refused(approve, registry, "function", ALPHA, "Team Beta", 1, "0" * 64) == ["E014"]
    assert refused(reject, registry, "function", ALPHA, "Team Beta", " ") == ["E014"]
    assert refused(approve, registry, "function", Reference("Alpha", "1.0.0"), "Team Beta") == ["E014"]
    assert refused(approve, registry, "function", Reference("Alpha", "7.0.0"), "Team Beta") == ["E005"]


def test_an_overlay_asks_the_owners_of_functions_that_rely_on_its_nodes(registry: Registry) -> None:
    def overlay(version: str, **datatypes: str) -> Candidate:
        after = catalogue(datatypes)
        nodes = {path: dict(node.values) for path, node in after.nodes.items()}
        text = str(datatypes).encode()
        return Candidate("overlay", "signals", version, "Platform team", text, b"{}", b"", "s.vspec", nodes, after)

    assert status(registry, overlay("1.0.0")) == "published"
    set_rule(registry, "overlay", "signals", "approval")
    outcome = publish(registry, [overlay("1.1.0", S2="uint8")]).outcomes[0]
    assert (outcome.status, [each.owner for each in outcome.approvals]) == ("pending", ["Team Beta"])
    approve(registry, "overlay", outcome.reference, "Team Beta")
    assert status(registry, overlay("1.1.0", S2="uint8")) == "published"


def test_a_token_with_an_owner_decides_for_this_owner_alone(registry: Registry) -> None:
    publish(registry, [BREAKING])
    own = registry._replace(author=Author("ci", "Team Beta"))
    assert refused(approve, own, "function", ALPHA, "Team Gamma") == ["E015"]
    assert refused(reject, own, "function", ALPHA, "Team Gamma", "S0 is needed.") == ["E015"]
    approve(own, "function", ALPHA, "Team Beta")


def test_decisions_are_exported_imported_and_verified(registry: Registry, tmp_path: Path) -> None:
    publish(registry, [BREAKING])
    approve(registry, "function", ALPHA, "Team Beta")
    reject(registry, "function", ALPHA, "Team Gamma", "S0 is needed.")
    with reading(registry.database) as connection:
        lines = list(exported(connection))
        before = pending(connection)
    second = Registry(tmp_path / "second.db")
    import_lines(second.database, [line.encode() for line in lines], "export")
    with reading(second.database) as connection:
        assert pending(connection) == before
        assert list(exported(connection)) == lines
    approve(second, "function", ALPHA, "Team Gamma")
    assert status(second, BREAKING) == "published"


def test_a_decision_that_is_not_in_the_log_is_found(registry: Registry) -> None:
    import sqlite3

    publish(registry, [BREAKING])
    with sqlite3.connect(str(registry.database)) as connection:
        connection.execute("UPDATE approvals SET decision = 'approved', until = '9999' WHERE owner = 'Team Beta'")
    with reading(registry.database) as opened:
        assert ["approvals" in each.message for each in verify(opened).findings] == [True]


def test_a_draft_asks_nobody_and_replaces_a_pending_version(registry: Registry) -> None:
    publish(registry, [BREAKING])
    assert publish(registry, [BREAKING], is_draft=True).outcomes[0].status == "draft"
    assert status(registry, BREAKING) == "pending"
    with reading(registry.database) as connection:
        assert version_named(connection, "function", ALPHA).state == "pending"
        assert len(all_versions(connection, "function", "Alpha")) == 2
