"""Owners acknowledge the deprecation of a version that their functions use."""

from pathlib import Path

import pytest

from sigcat.errors import InputRefused
from sigcat.registry.author import Author
from sigcat.registry.decisions.acknowledgements import acknowledge, deprecations
from sigcat.registry.events import events_after
from sigcat.registry.lines import record, set_state
from sigcat.registry.publish import publish
from sigcat.registry.reference import Reference
from sigcat.registry.storing.database import reading
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.verify import verify
from tests.registry.parts import candidate, catalogue, declaration, plain_candidate

CATALOGUE = catalogue()
ALPHA = Reference("Alpha", "1.0.0")


@pytest.fixture
def registry(tmp_path: Path) -> Registry:
    """Alpha, which is deprecated, provides S0 to Beta and Gamma; Delta uses nothing of it."""
    made = Registry(tmp_path / "registry.db")
    files = (
        declaration("Alpha", ("S0",), ("S3",)), declaration("Beta", ("S1",), ("S0",)), declaration("Gamma", (), ("S0", "S1")),
        declaration("Delta", ("S3",), ("S1",)),
    )  # fmt: skip
    publish(made, [candidate(each, CATALOGUE) for each in files])
    set_state(made, "function", ALPHA, "deprecated", "2040-12-31")
    return made


def users(registry: Registry) -> list[tuple[str, str, bool]]:
    with reading(registry.database) as connection:
        (found,) = deprecations(connection)
    return [(each.owner, each.functions, bool(each.at)) for each in found.acknowledgements]


def test_owners_of_functions_that_use_a_version_acknowledge_its_deprecation(registry: Registry) -> None:
    assert users(registry) == [("Team Beta", "Beta 1.0.0", False), ("Team Gamma", "Gamma 1.0.0", False)]
    head = acknowledge(registry._replace(author=Author("anna", "Team Beta")), "function", ALPHA, "Team Beta")
    assert users(registry) == [("Team Beta", "Beta 1.0.0", True), ("Team Gamma", "Gamma 1.0.0", False)]
    with reading(registry.database) as connection:
        event = events_after(connection, 5)[-1]
        assert (event["id"], event["type"], event["subject"]) == (
            head,
            "io.sigcat.registry.acknowledged",
            "Alpha@1.0.0",
        )
        assert (event["data"]["owner"], event["data"]["by"]) == ("Team Beta", "anna")
        assert verify(connection).findings == ()


def test_a_second_acknowledgement_changes_nothing(registry: Registry) -> None:
    first = acknowledge(registry, "function", ALPHA, "Team Beta")
    assert acknowledge(registry, "function", ALPHA, "Team Beta") == first


def test_another_deprecation_has_to_be_acknowledged_again(registry: Registry) -> None:
    acknowledge(registry, "function", ALPHA, "Team Beta")
    set_state(registry, "function", ALPHA, "deprecated", "2040-12-31")
    assert users(registry)[0] == ("Team Beta", "Beta 1.0.0", False)
    acknowledge(registry, "function", ALPHA, "Team Beta")
    assert users(registry)[0] == ("Team Beta", "Beta 1.0.0", True)


def test_an_acknowledgement_is_kept_when_its_owner_uses_the_version_no_more(registry: Registry) -> None:
    acknowledge(registry, "function", ALPHA, "Team Beta")
    publish(registry, [candidate(declaration("Beta", ("S1",), version="2.0.0"), CATALOGUE)])
    assert users(registry)[0] == ("Team Beta", "", True)


def test_versions_in_vehicles_count_and_others_do_not(registry: Registry) -> None:
    publish(registry, [candidate(declaration("Beta", ("S1",), version="2.0.0"), CATALOGUE)])
    assert users(registry) == [("Team Gamma", "Gamma 1.0.0", False)]
    record(registry, "release", "SUV-2025", Reference("Beta", "1.0.0"))
    assert users(registry)[0] == ("Team Beta", "Beta 1.0.0", False)


@pytest.mark.parametrize(
    ("reference", "owner", "author", "rule"),
    [
        ("Alpha@1.0.0", "Team Delta", "", "E014"), ("Alpha@1.0.0", "", "", "E014"), ("Alpha@1.0.0", "Team Beta", "Team Gamma", "E015"),
        ("Beta@1.0.0", "Team Gamma", "", "E014"), ("Alpha@2.0.0", "Team Beta", "", "E005"), ("Nothing@1.0.0", "Team Beta", "", "E005"),
    ],
)  # fmt: skip
def test_what_does_not_fit_is_refused(registry: Registry, reference: str, owner: str, author: str, rule: str) -> None:
    name, version = reference.split("@")
    with pytest.raises(InputRefused) as refused:
        acknowledge(registry._replace(author=Author("x", author)), "function", Reference(name, version), owner)
    assert [each.rule for each in refused.value.findings] == [rule]


def test_nodes_of_an_overlay_are_used_by_functions(registry: Registry) -> None:
    overlay = plain_candidate("signals", "1.0.0")._replace(resolved=b'{"Vehicle.S1": {"type": "sensor"}}')
    publish(registry, [overlay])
    set_state(registry, "overlay", Reference("signals", "1.0.0"), "deprecated")
    with reading(registry.database) as connection:
        found = {str(each.published.reference): each for each in deprecations(connection)}
    assert [each.owner for each in found["signals 1.0.0"].acknowledgements] == ["Team Delta", "Team Gamma"]
