"""Only functions that may have to do with a deployment are read, and the conflicts are those of all."""

from collections.abc import Sequence
from typing import Any

import pytest

from sigcat.registry.compatibility import breaking, deploying, member
from sigcat.registry.compatibility.breaking import broken_by_functions
from sigcat.registry.compatibility.deploying import can_deploy
from sigcat.registry.compatibility.member import candidate_member
from sigcat.registry.published import Published
from sigcat.registry.reference import Reference
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.database import in_memory
from tests.registry.parts import add, candidate, catalogue, declaration, deploy
from tests.registry.test_decisions import History


def _everything(*values: Any) -> Sequence[Published]:
    field: Sequence[Published] = values[-1]
    return field


def test_conflicts_are_those_with_all_functions_read(monkeypatch: pytest.MonkeyPatch) -> None:
    conflicts = 0
    for seed in range(60):
        history = History(seed)
        with in_memory() as connection:
            add(connection, *(candidate(text, over) for text, over in history.versions.values()))
            deploy(connection, "SUV-2025", history.field)
            deploy(connection, "VAN-2026", history.field[::2])
            deployed = [candidate_member(candidate(*history.versions[each])) for each in history.deployed]
            found = can_deploy(connection, history.deployed, "SUV-2025"), broken_by_functions(connection, deployed)
            with monkeypatch.context() as patch:
                for module in (deploying, breaking):
                    patch.setattr(module, "concerned", _everything)
                assert (
                    can_deploy(connection, history.deployed, "SUV-2025"),
                    broken_by_functions(connection, deployed),
                ) == found
        conflicts += len(found[1])
    assert conflicts > 10


def test_functions_that_exchange_nothing_with_a_deployed_one_are_not_read(monkeypatch: pytest.MonkeyPatch) -> None:
    over = catalogue()
    read: list[str] = []
    with in_memory() as connection:
        files = (declaration("Alpha", ("S0",)), declaration("Beta", ("S1",), ("S0",)), declaration("Gamma", ("S3",)))
        add(connection, *(candidate(each, over) for each in files))
        deploy(connection, "SUV-2025", [Reference(name, "1.0.0") for name in ("Alpha", "Beta", "Gamma")])
        uses = {candidate(text, over).uses: name for text, name in zip(files, ("Alpha", "Beta", "Gamma"), strict=True)}

        def counted(*values: Any) -> bytes:
            data = content_of(*values)
            read.append(uses.get(data, ""))
            return data

        monkeypatch.setattr(member, "content_of", counted)
        answer = can_deploy(connection, [Reference("Alpha", "1.0.0")], "SUV-2025")
    assert [str(each) for each in answer.checked] == ["Beta 1.0.0", "Gamma 1.0.0"]
    assert set(read) - {""} == {"Alpha", "Beta"}
