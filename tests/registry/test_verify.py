"""The log and the content of a registry are as they were written, or a finding names what is not."""

import json
import sqlite3
from collections.abc import Iterator
from pathlib import Path

import pytest

from sigcat.errors import InputRefused, UsageError
from sigcat.project.project import ServerUrl
from sigcat.registry.lines import record
from sigcat.registry.publish import publish
from sigcat.registry.published import version_named
from sigcat.registry.reference import Reference
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.database import Place, in_memory, reading
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.signing import new_key
from sigcat.registry.storing.transfer import exported, import_lines
from sigcat.registry.storing.verify import verify
from tests.registry.parts import candidate, catalogue, declaration

CATALOGUE = catalogue()
REFERENCE = Reference("Alpha", "1.0.0")


@pytest.fixture
def registry(tmp_path: Path) -> Registry:
    """A registry with five signed entries, in SQLite."""
    return signed_registry(tmp_path / "registry.db", tmp_path)


def signed_registry(place: Place, tmp_path: Path) -> Registry:
    """A registry with five signed entries."""
    private, public = new_key()
    (tmp_path / "key").write_bytes(private)
    (tmp_path / "key.pub").write_bytes(public)
    made = Registry(place, tmp_path / "key")
    for name, signal in (("Alpha", "S0"), ("Beta", "S1"), ("Gamma", "S2")):
        publish(made, [candidate(declaration(name, (signal,)), CATALOGUE)])
    record(made, "release", "SUV-2025", REFERENCE)
    record(made, "release", "VAN-2026", REFERENCE)
    return made


def change(registry: Registry, *statements: str) -> None:
    assert isinstance(registry.database, Path)
    connection = sqlite3.connect(registry.database, isolation_level=None)
    for statement in statements:
        connection.execute(statement)
    connection.close()


def messages(registry: Registry, public: Path | None = None, head: str = "") -> list[str]:
    with reading(registry.database) as connection:
        return [finding.message for finding in verify(connection, public, head).findings]


def head(registry: Registry) -> str:
    with reading(registry.database) as connection:
        return verify(connection).head


def lines(registry: Registry) -> Iterator[bytes]:
    with reading(registry.database) as connection:
        yield from (line.encode() for line in exported(connection))


def test_what_was_written_verifies_with_the_public_key_alone(registry: Registry) -> None:
    assert registry.key is not None
    assert messages(registry, registry.key.with_name("key.pub")) == []


SWAP = "UPDATE log SET number = CASE number WHEN 2 THEN -3 WHEN 3 THEN -2 END WHERE number IN (2, 3)"


@pytest.mark.parametrize(
    ("statements", "named"),
    [
        (["UPDATE log SET text = replace(text, 'Beta', 'Zeta') WHERE number = 2"], "Entry 2 of the log was changed"),
        (["UPDATE log SET text = '[' WHERE number = 2"], "Entry 2 of the log was changed"),
        (["DELETE FROM log WHERE number = 3"], "Entry 3 of the log is missing"),
        ([SWAP, "UPDATE log SET number = -number WHERE number < 0"], "Entry 2 of the log was swapped"),
        (["UPDATE contents SET data = data || 'x' WHERE rowid = 1"], "Content "),
        (["UPDATE contents SET data = NULL OR 7 WHERE rowid = 1"], "Content "),
        (["UPDATE versions SET owner = 'Other' WHERE version = '1.0.0'"], "A row of `versions` is changed"),
        (["UPDATE versions SET state = 'retired' WHERE id = 2"], "A row of `versions` is changed"),
        (["DELETE FROM uses WHERE version_id = 1"], "A row of `uses` is missing"),
        (["DELETE FROM deployments WHERE id = 1"], "A row of `deployments` is missing"),
        (["UPDATE names SET rule = 'none' WHERE name = 'Alpha'"], "A row of `names` is changed"),
        (["DELETE FROM log WHERE number = 5"], "A row of `names` is not in the log"),
        (["DELETE FROM contents WHERE rowid = 1"], "Content "),
    ],
)  # fmt: skip
def test_what_was_changed_is_named(registry: Registry, statements: list[str], named: str) -> None:
    change(registry, *statements)
    assert messages(registry)[0].startswith(named)


def test_a_log_without_its_end_is_found_by_the_hash_of_its_last_entry(registry: Registry) -> None:
    last = head(registry)
    assert messages(registry, head=last) == []
    change(registry, "DELETE FROM log WHERE number = 5", "DELETE FROM deployments WHERE id = 2", "DELETE FROM names WHERE name = 'VAN-2026'")  # fmt: skip
    assert messages(registry) == []
    assert messages(registry, head=last)[0].startswith("The log has no entry with the given hash")


def test_a_log_that_was_written_again_lacks_the_signature(registry: Registry, tmp_path: Path) -> None:
    forged = Registry(tmp_path / "forged.db")
    publish(forged, [candidate(declaration("Alpha", ("S3",)), CATALOGUE)])
    public = tmp_path / "key.pub"
    assert messages(forged) == []
    assert messages(forged, public) == ["The last entry of the log is not signed."]
    other, _ = new_key()
    (tmp_path / "other").write_bytes(other)
    publish(forged._replace(key=tmp_path / "other"), [candidate(declaration("Beta", ("S3",)), CATALOGUE)])
    assert messages(forged, public)[0].startswith("The signature of entry 2 is not that of")


@pytest.mark.parametrize("content", [b"", b"text", b"-----BEGIN PRIVATE KEY-----\nAAAA\n-----END PRIVATE KEY-----\n"])
def test_a_key_that_is_none_is_refused_and_nothing_is_published(registry: Registry, content: bytes) -> None:
    before = head(registry)
    assert registry.key is not None
    registry.key.write_bytes(content)
    with pytest.raises(UsageError, match="must be an Ed25519 key"):
        publish(registry, [candidate(declaration("Delta", ("S3",)), CATALOGUE)])
    assert head(registry) == before


def test_an_export_and_an_import_carry_everything_byte_for_byte(registry: Registry, tmp_path: Path) -> None:
    other = Registry(tmp_path / "other.db")
    assert import_lines(other.database, lines(registry), "export") == head(registry)
    assert list(lines(other)) == list(lines(registry))
    assert messages(other, tmp_path / "key.pub") == []


def test_an_export_of_one_database_is_imported_into_any_other(place: Place, registry: Registry, tmp_path: Path) -> None:
    other = Registry(place) if isinstance(place, ServerUrl) else Registry(tmp_path / "other.db")
    last = import_lines(other.database, lines(registry), "export")
    assert list(lines(other)) == list(lines(registry))
    assert messages(other, tmp_path / "key.pub", last) == []
    back = Registry(tmp_path / "back.db")
    import_lines(back.database, lines(other), "export")
    assert messages(back, tmp_path / "key.pub", last) == []


def test_an_import_goes_into_an_empty_registry_only(registry: Registry) -> None:
    with pytest.raises(InputRefused) as refused:
        import_lines(registry.database, lines(registry), "export")
    assert [each.rule for each in refused.value.findings] == ["E013"]


def damaged(text: list[bytes]) -> Iterator[list[bytes]]:
    yield []
    yield text[1:]
    yield [b"{}\n", *text[1:]]
    yield [b'{"format": "sigcat registry", "schema": 2}\n', *text[1:]]
    yield [text[0], b"[" * 100_000]
    yield [*text, b"\xff\n"]
    yield [*text, b"null\n"]
    yield [*text, text[-1]]
    yield [text[0], *text[2:]]
    yield text[:-2] + text[-1:]
    yield [line.replace(b"Team Alpha", b"Team Other") for line in text]
    yield [*text, json.dumps({**json.loads(text[-1]), "number": 6, "text": '{"action": "drop"}'}).encode()]


@pytest.mark.parametrize("number", range(12))
def test_a_damaged_export_is_refused_and_nothing_is_imported(registry: Registry, tmp_path: Path, number: int) -> None:
    text = list(damaged(list(lines(registry))))[number]
    other, before = Registry(tmp_path / "other.db"), sorted(each.name for each in tmp_path.iterdir())
    with pytest.raises(InputRefused) as refused:
        import_lines(other.database, text, "export")
    assert {each.rule for each in refused.value.findings} <= {"E010", "E013"}
    assert sorted(each.name for each in tmp_path.iterdir()) == before


@pytest.mark.parametrize("data", ["'x'", "x'78'", None])
def test_content_that_is_not_what_was_published_is_never_used(registry: Registry, data: str | None) -> None:
    where = "where digest = (select resolved from versions where id = 1)"
    change(registry, f"update contents set data = {data} {where}" if data else f"delete from contents {where}")
    with reading(registry.database) as connection, pytest.raises(InputRefused) as refused:
        content_of(connection, version_named(connection, "function", REFERENCE).resolved)
    (finding,) = refused.value.findings
    assert (finding.rule, "sigcat registry verify" in finding.fix) == ("E010", True)


@pytest.mark.parametrize("kept", [1, -1, -2, -3])
def test_a_file_that_is_cut_at_a_line_is_not_imported(registry: Registry, tmp_path: Path, kept: int) -> None:
    other = Registry(tmp_path / "other.db")
    with pytest.raises(InputRefused) as refused:
        import_lines(other.database, list(lines(registry))[:kept], "export")
    assert [finding.rule for finding in refused.value.findings] == ["E013"]
    with reading(other.database) as connection:
        assert list(exported(connection)) == list(empty())


def test_nothing_comes_after_the_end_of_a_file(registry: Registry, tmp_path: Path) -> None:
    text = list(lines(registry))
    with pytest.raises(InputRefused):
        import_lines(tmp_path / "other.db", [*text, text[-1]], "export")


def empty() -> Iterator[str]:
    with in_memory() as connection:
        yield from exported(connection)
