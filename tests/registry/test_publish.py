"""What publish accepts, and what it refuses."""

import sqlite3
from itertools import pairwise
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.errors import InputRefused
from sigcat.registry.candidates.candidate import Candidate
from sigcat.registry.lines import record, set_rule, set_state
from sigcat.registry.publish import publish
from sigcat.registry.published import all_versions, version_named
from sigcat.registry.reference import Kind, Reference, name_problem
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.database import Place, reading
from sigcat.registry.storing.ledger import Registry, log_page
from sigcat.registry.storing.tables import SCHEMA
from sigcat.registry.version import raised_part, version_of, version_problem
from tests.registry.parts import candidate, catalogue, declaration, plain_candidate

CATALOGUE = catalogue()


@pytest.fixture
def registry(place: Place) -> Registry:
    return Registry(place)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    """The file of a registry in SQLite."""
    return tmp_path / "registry.db"


def alpha(version: str, provided: tuple[str, ...] = ("S0", "S1"), consumed: tuple[str, ...] = ()) -> Candidate:
    return candidate(declaration("Alpha", provided, consumed, version), CATALOGUE)


def outcome(registry: Registry, *candidates: Candidate, draft: bool = False) -> list[str]:
    """Statuses, or the rules of the findings."""
    try:
        return [each.status for each in publish(registry, candidates, is_draft=draft).outcomes]
    except InputRefused as refused:
        return [each.rule for each in refused.findings]


def stored(registry: Registry) -> list[tuple[str, str, str]]:
    with reading(registry.database) as connection:
        return [(each.name, each.version, each.state) for each in all_versions(connection)]


def test_the_same_bytes_again_change_nothing_and_other_bytes_are_refused(registry: Registry) -> None:
    assert outcome(registry, alpha("1.0.0")) == ["published"]
    assert outcome(registry, alpha("1.0.0")) == ["unchanged"]
    assert outcome(registry, alpha("1.0.0", ("S0", "S1", "S2"))) == ["E003"]
    assert outcome(registry, alpha("1.0.0", ("S0",)), draft=True) == ["E003"]


def test_versions_that_differ_in_build_metadata_are_one_version(registry: Registry) -> None:
    assert outcome(registry, plain_candidate("name", "1.0.0+a")) == ["published"]
    assert outcome(registry, plain_candidate("name", "1.0.0+b")) == ["unchanged"]
    assert outcome(registry, plain_candidate("name", "1.0.0+b", b"other")) == ["E003"]


def test_the_same_bytes_over_a_catalogue_with_other_signals_are_another_version(registry: Registry) -> None:
    outcome(registry, alpha("1.0.0"))
    other = candidate(declaration("Alpha", ("S0", "S1"), (), "1.0.0"), catalogue({"S0": "uint8"}))
    assert outcome(registry, other) == ["E003"]


def test_two_files_with_one_version_in_one_command_are_refused_together(registry: Registry) -> None:
    assert outcome(registry, alpha("1.0.0"), alpha("1.0.0", ("S0",))) == ["E003"]
    assert stored(registry) == []


def test_a_draft_changes_until_it_is_published(registry: Registry) -> None:
    assert outcome(registry, alpha("1.0.0"), draft=True) == ["draft"]
    assert outcome(registry, alpha("1.0.0", ("S0",)), draft=True) == ["draft"]
    assert stored(registry) == [("Alpha", "1.0.0", "draft")]
    assert outcome(registry, alpha("1.0.0", ("S0", "S2"))) == ["published"]
    with reading(registry.database) as connection:
        version = version_named(connection, "function", Reference("Alpha", "1.0.0"))
        assert content_of(connection, version.content) == declaration("Alpha", ("S0", "S2"))


@pytest.mark.parametrize(
    ("provided", "consumed", "refused", "accepted"),
    [
        (("S0",), (), ("1.1.0", "1.0.1"), "2.0.0"),  # an output is gone
        (("S0", "S1", "S2"), (), ("1.0.1",), "1.1.0"),  # an output is new
        (("S0", "S1"), ("S3",), ("1.0.1",), "1.1.0"),  # it needs another provider
        (("S0", "S1"), (), (), "1.0.1"),
    ],
)
def test_a_version_rises_by_the_part_that_its_worst_change_needs(
    registry: Registry, provided: tuple[str, ...], consumed: tuple[str, ...], refused: tuple[str, ...], accepted: str
) -> None:
    outcome(registry, alpha("1.0.0"))
    for version in refused:
        assert outcome(registry, alpha(version, provided, consumed)) == ["E004"], version
    assert outcome(registry, alpha(accepted, provided, consumed)) == ["published"]


def test_the_rule_full_refuses_what_breaks_others_and_the_rule_none_refuses_nothing(registry: Registry) -> None:
    outcome(registry, alpha("1.0.0"))
    set_rule(registry, "function", "Alpha", "full")
    assert outcome(registry, alpha("2.0.0", ("S0",))) == ["E004"]
    set_rule(registry, "function", "Alpha", "none")
    assert outcome(registry, alpha("1.0.1", ("S0",))) == ["published"]


VERSIONS = ("", "1", "1.2", "v1.0.0", "01.0.0", "1.0.0-", "1.0.0-01", "1.0.0+", "1.0.0 ", "1.0.0\n", "١.0.0", "1.0.0-é",
            "-1.0.0", "1.0.9999999999", f"1.0.0-{'a' * 200}", "latest", "1.0.0/2")  # fmt: skip


@pytest.mark.parametrize("version", VERSIONS)
def test_a_version_that_is_none_is_refused(file: Path, version: str) -> None:
    assert outcome(Registry(file), plain_candidate("name", version)) == ["E001"]
    assert not file.exists()


@pytest.mark.parametrize(
    ("version", "fix"),
    [
        ("1.2", "Write 1.2.0."),
        ("v1.0.0", "Write 1.0.0."),
        ("V2", "Write 2.0.0."),
        ("01.02.0-rc.1", "Write 1.2.0-rc.1."),
        ("1.2.3.4", "Write 1.2.3."),
        ("latest", "Write three numbers, such as 1.2.0."),
        ("1.0.0-01", "Write three numbers, such as 1.2.0."),
        ("1.0.9999999999", "Write smaller numbers."),
        (f"1.0.0-{'a' * 200}", "Shorten it."),
    ],
)
def test_a_version_that_is_none_gets_the_nearest_one_as_advice(version: str, fix: str) -> None:
    problem = version_problem(version)
    assert problem is not None
    assert problem.fix == fix


@given(text=st.text(max_size=120) | st.from_regex(r"v?[0-9.]{1,20}[-+a-z0-9.]{0,10}"))
def test_any_text_is_a_version_or_has_advice(text: str) -> None:
    assert (version_problem(text) is None) == (version_of(text) is not None)


@pytest.mark.parametrize(
    ("name", "kind", "requirement", "fix"),
    [
        ("a b", "overlay", "have only letters and digits of ASCII", "Rename the file"),
        ("-a", "function", "begin with a letter or a digit", "Rename the function"),
        ("x" * 101, "line", "have at most 100 characters", "SUV-2025"),
        ("Vеhicle", "catalogue", "have only letters and digits of ASCII", "[[catalogue]]"),
    ],
)
def test_a_name_that_is_none_says_what_is_wrong(name: str, kind: Kind, requirement: str, fix: str) -> None:
    finding = name_problem(name, kind)
    assert finding is not None
    assert requirement in finding.message
    assert fix in finding.fix


NAMES = ("", ".", "..", "a/b", "../a", "a\\b", "a b", "a\n", "a@1", "-a", "Vеhicle", "CoreＡcc", "a\u202eb", "x" * 101)


@pytest.mark.parametrize("name", NAMES)
def test_a_name_with_slashes_or_letters_that_look_alike_is_refused(file: Path, name: str) -> None:
    assert outcome(Registry(file), plain_candidate(name, "1.0.0")) == ["E002"]
    assert not file.exists()
    with pytest.raises(InputRefused):
        record(Registry(file), "release", name, Reference("Alpha", "1.0.0"))


def test_a_name_in_another_case_is_refused(registry: Registry) -> None:
    outcome(registry, plain_candidate("Body", "1.0.0"))
    assert outcome(registry, plain_candidate("body", "1.0.0")) == ["E002"]


@pytest.mark.parametrize(
    ("owner", "rules"),
    [
        ("Team Alpha", ["published"]),
        ("Team Beta", ["published"]),
        ("\u0422eam Alpha", ["E002"]),
        ("Te\u0430m \u0391lpha", ["E002"]),
        ("TEAM ALPHA", ["E002"]),
        ("Team\u00a0Alpha ", ["E002"]),
        ("Team\u200b Alpha", ["E002"]),
        ("\uff34eam Alpha", ["E002"]),
        ("Team Alpha\u3164", ["E002"]),
        ("Team \u13aalpha", ["E002"]),
        ("Team Alp\u0570a", ["E002"]),
        ("Te\ua4eem Alpha", ["E002"]),
        ("Team \uab7alpha", ["E002"]),
        ("\u13a2eam Alpha", ["E002"]),
        ("Team Al\u03c1ha", ["E002"]),
        ("Team \U000118a0lpha", ["published"]),
        ("\u0540\u0561\u0575\u0565\u0580", ["published"]),
        ("\u041a\u043e\u043c\u0430\u043d\u0434\u0430", ["published"]),
    ],
)
def test_an_owner_that_looks_like_another_one_is_refused(registry: Registry, owner: str, rules: list[str]) -> None:
    first = plain_candidate("Body", "1.0.0")._replace(owner="Team Alpha")
    assert outcome(registry, first) == ["published"]
    assert outcome(registry, plain_candidate("Light", "1.0.0")._replace(owner=owner)) == rules
    assert outcome(registry, first._replace(version="1.1.0", owner=owner)) == rules


def test_a_newer_version_of_another_owner_names_both(registry: Registry) -> None:
    """It is accepted, as a team hands its functions over, but not without a word."""

    def published(version: str, owner: str, *, is_draft: bool = False) -> str:
        each = plain_candidate("Body", version)._replace(owner=owner)
        return publish(registry, [each], is_draft=is_draft).outcomes[0].sentence

    def previous() -> object:
        with reading(registry.database) as connection:
            return log_page(connection, 0, 100)[-1].entry.data.get("previous_owner")

    assert (published("1.0.0", "Team Alpha"), previous()) == ("overlay Body 1.0.0: published", None)
    change = ", owner changed from Team Alpha to Team Beta"
    for is_draft, state in ((True, "draft"), (False, "published")):
        said = published("2.0.0", "Team Beta", is_draft=is_draft)
        assert (said, previous()) == (f"overlay Body 2.0.0: {state}{change}", "Team Alpha")
    assert published("2.0.0", "Team Beta") == "overlay Body 2.0.0: unchanged"
    assert (published("2.1.0", "Team Beta"), previous()) == ("overlay Body 2.1.0: published", None)
    assert published("1.1.0", "Team Alpha") == "overlay Body 1.1.0: published", "the newest version stays Team Beta's"
    assert published("3.0.0", "") == "overlay Body 3.0.0: published, owner changed from Team Beta to none"


def test_a_draft_that_another_owner_publishes_names_both(registry: Registry) -> None:
    draft = plain_candidate("Body", "1.0.0")._replace(owner="Team Alpha")
    publish(registry, [draft], is_draft=True)
    (found,) = publish(registry, [draft._replace(owner="Team Beta")]).outcomes
    assert found.sentence == "overlay Body 1.0.0: published, owner changed from Team Alpha to Team Beta"


@pytest.mark.parametrize(("first", "again", "said"), [
    ("Team Alpha", "Team Alpha", []), ("Team Alpha", "", []),
    ("", "Team Alpha", ["Body 1.0.0 is published with no owner, not with the owner 'Team Alpha'."]),
    ("Team Alpha", "Team Beta", ["Body 1.0.0 is published with the owner 'Team Alpha', not with the owner 'Team Beta'."]),
])  # fmt: skip
def test_the_same_bytes_with_another_owner_change_nothing_silently(
    registry: Registry, first: str, again: str, said: list[str]
) -> None:
    each = plain_candidate("Body", "1.0.0")
    publish(registry, [each._replace(owner=first)])
    try:
        assert [each.status for each in publish(registry, [each._replace(owner=again)]).outcomes] == ["unchanged"]
        found = []
    except InputRefused as refused:
        found = [each.message for each in refused.findings]
    assert found == said


def test_the_refusal_of_an_owner_shows_which_letters_differ(registry: Registry) -> None:
    """The published name may be the one with a foreign letter."""
    outcome(registry, plain_candidate("Body", "1.0.0")._replace(owner="T\u0435am"))
    with pytest.raises(InputRefused) as refused:
        publish(registry, [plain_candidate("Light", "1.0.0")._replace(owner="Team")])
    assert refused.value.findings[0].message == "The owner must be 'T\\u0435am', as it is published, not 'Team'."


def test_versions_are_in_the_order_of_semver() -> None:
    ordered = "1.0.0-alpha 1.0.0-alpha.1 1.0.0-alpha.beta 1.0.0-beta.2 1.0.0-beta.11 1.0.0-rc.1 1.0.0 1.0.1 1.2.0 1.10.0 2.0.0"
    versions = [version for text in ordered.split() if (version := version_of(text)) is not None]
    assert len(versions) == len(ordered.split())
    assert all(a < b for a, b in pairwise(versions))


@given(
    parts=st.lists(st.sampled_from(("0", "1", "2", "10", "11", "100", "a", "a-", "A1", "b", "ab", "1a")), max_size=4),
    others=st.lists(st.sampled_from(("0", "1", "2", "10", "11", "100", "a", "a-", "A1", "b", "ab", "1a")), max_size=4),
    numbers=st.sampled_from(("1.0.0", "1.0.9", "1.0.10", "1.10.0", "10.0.0", "999999999.0.0")),
)
def test_the_texts_of_versions_are_in_their_order(parts: list[str], others: list[str], numbers: str) -> None:
    first = version_of("-".join(filter(None, ("1.0.10", ".".join(parts)))))
    second = version_of("-".join(filter(None, (numbers, ".".join(others)))))
    assert first is not None
    assert second is not None
    assert (first < second, first == second) == (
        first.sort_text < second.sort_text, first.sort_text == second.sort_text
    )  # fmt: skip


@pytest.mark.parametrize(
    ("old", "new", "part"),
    [
        ("1.2.3", "2.0.0", "major"),
        ("1.2.3", "1.3.0", "minor"),
        ("1.2.3", "1.2.4", "patch"),
        ("0.1.0", "0.2.0", "major"),
    ],
)
def test_the_part_that_rises(old: str, new: str, part: str) -> None:
    before, after = version_of(old), version_of(new)
    assert before is not None
    assert after is not None
    assert raised_part(before, after) == part


def test_a_document_of_ten_megabytes_is_published_byte_for_byte(registry: Registry) -> None:
    content = b"# \xc3\xa9\r\n" * 1_500_000
    assert outcome(registry, plain_candidate("large", "1.0.0", content)) == ["published"]
    with reading(registry.database) as connection:
        version = version_named(connection, "overlay", Reference("large", "1.0.0"))
        assert content_of(connection, version.content) == content


def test_a_version_in_a_vehicle_line_is_not_retired_and_a_draft_is_not_deployed(registry: Registry) -> None:
    reference = Reference("Alpha", "1.0.0")
    outcome(registry, alpha("1.0.0"), draft=True)
    with pytest.raises(InputRefused, match="nothing was changed"):
        record(registry, "deployment", "SUV-2025", reference)
    outcome(registry, alpha("1.0.0"))
    record(registry, "deployment", "SUV-2025", reference)
    with pytest.raises(InputRefused):
        record(registry, "release", "suv-2025", reference)
    set_state(registry, "function", reference, "deprecated", "2040-01-31")
    with pytest.raises(InputRefused):
        set_state(registry, "function", reference, "retired")
    record(registry, "support ended", "SUV-2025", reference)
    set_state(registry, "function", reference, "retired")
    with pytest.raises(InputRefused):
        record(registry, "deployment", "SUV-2025", reference)
    with pytest.raises(InputRefused):
        set_state(registry, "function", reference, "deprecated")


def test_a_version_is_not_its_own_successor(registry: Registry) -> None:
    outcome(registry, alpha("1.0.0"))
    with pytest.raises(InputRefused) as refused:
        set_state(registry, "function", Reference("Alpha", "1.0.0"), "deprecated", successor="1.0.0")
    assert [each.rule for each in refused.value.findings] == ["E009"]


@pytest.mark.parametrize("date", ["soon", "2027-02-30", "27-01-01", "2027-1-1"])
def test_a_date_that_is_none_is_refused(registry: Registry, date: str) -> None:
    outcome(registry, alpha("1.0.0"))
    with pytest.raises(InputRefused):
        set_state(registry, "function", Reference("Alpha", "1.0.0"), "deprecated", date)


@pytest.mark.parametrize("pragma", [f"user_version = {SCHEMA + 1}", "application_id = 7"])
def test_a_database_of_a_newer_schema_or_another_program_is_refused(file: Path, pragma: str) -> None:
    outcome(Registry(file), alpha("1.0.0"))
    with sqlite3.connect(file) as connection:
        connection.execute(f"PRAGMA {pragma}")
    connection.close()
    assert outcome(Registry(file), alpha("1.1.0")) == ["E011"]
    with pytest.raises(InputRefused), reading(file):
        pass


def test_a_file_that_is_no_database_is_refused_and_kept(file: Path) -> None:
    file.write_bytes(b"important" * 1000)
    assert outcome(Registry(file), alpha("1.0.0")) == ["E011"]
    assert file.read_bytes() == b"important" * 1000


def test_a_database_of_another_program_is_kept(file: Path) -> None:
    with sqlite3.connect(file) as connection:
        connection.execute("CREATE TABLE theirs (id INTEGER)")
    connection.close()
    assert outcome(Registry(file), alpha("1.0.0")) == ["E011"]


def test_reading_creates_no_file(file: Path) -> None:
    assert stored(Registry(file)) == []
    assert not file.exists()
