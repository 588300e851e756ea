"""Decisions of `check` and `can-i-deploy`, beside an oracle that validates every vehicle as a whole again."""

import random
from collections.abc import Mapping, Sequence
from functools import partial
from itertools import product

import pytest

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.function.function_file import CheckedFunction
from sigcat.function.sets.check_set import check_set
from sigcat.registry.candidates.candidate import Candidate
from sigcat.registry.compatibility.breaking import broken_by_catalogue
from sigcat.registry.compatibility.deploying import can_deploy
from sigcat.registry.published import all_versions
from sigcat.registry.reference import Reference
from sigcat.registry.storing import entry
from sigcat.registry.storing.database import in_memory
from sigcat.registry.storing.ledger import Ledger
from sigcat.registry.users import users_of
from tests.catalogue.trees import ROOT, catalogue_of
from tests.needs import IS_SLOW_RUN
from tests.registry.parts import NAMES, SIGNALS, add, candidate, catalogue, checked, declaration, deploy

HISTORIES = 10_000 if IS_SLOW_RUN else 100
PARTS = 20 if IS_SLOW_RUN else 5
"""Parts of the histories, so that several processes share them."""
_UNPROVIDED = "F103"
_OTHER = {"S0": "uint8", "S2": "uint16"}
CATALOGUES = (catalogue(), catalogue(_OTHER))


class History:
    """A random history: versions of functions, a vehicle line, and a deployment to ask about."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.versions: dict[Reference, tuple[bytes, Catalogue]] = {}
        for name in NAMES[: self.random.randint(2, 4)]:
            for number in range(self.random.randint(1, 3)):
                self.versions[Reference(name, f"1.{number}.0")] = self._function(name, f"1.{number}.0")
        self.names = tuple(dict.fromkeys(each.name for each in self.versions))
        self.field = [each for each in self.versions if self.random.random() < 0.6]
        count = min(len(self.names), self.random.choice((1, 1, 2)))
        chosen = self.random.sample(self.names, count)
        self.deployed = [self.random.choice([each for each in self.versions if each.name == name]) for name in chosen]

    def _function(self, name: str, version: str) -> tuple[bytes, Catalogue]:
        own = SIGNALS[NAMES.index(name)] if self.random.random() < 0.9 else self.random.choice(SIGNALS)
        provided = [own] if self.random.random() < 0.9 else []
        consumed = [each for each in self.random.sample(SIGNALS, self.random.randint(0, 2)) if each != own]
        over = CATALOGUES[self.random.random() < 0.1]
        return declaration(name, provided, consumed, version), over


Functions = Mapping[Reference, CheckedFunction]


def errors(members: Sequence[CheckedFunction]) -> set[tuple[str, str, str]]:
    found = check_set(members, is_whole=False)
    return {(each.rule, each.file, each.message) for each in found if each.severity == "error"}


def unprovided(members: Sequence[CheckedFunction]) -> set[tuple[str, str]]:
    found = [each for each in check_set(members, CATALOGUES[0]) if each.rule == _UNPROVIDED]
    return {(each.file.partition("@")[0], each.path) for each in found}


def fits(history: History) -> bool:
    """Whether no vehicle has an error that it had not before: each vehicle has one version of each function."""
    functions = {
        ref: checked(text, over, f"{ref.name}@{ref.version}") for ref, (text, over) in history.versions.items()
    }
    new = [functions[each] for each in history.deployed]
    names = [each.name for each in history.deployed]
    others = [
        [functions[each] for each in history.field if each.name == name] for name in history.names if name not in names
    ]
    before: list[list[CheckedFunction | None]] = [
        [functions[each] for each in history.field if each.name == name] or [None] for name in names
    ]
    for vehicle in product(*filter(None, others)):
        if errors([*vehicle, *new]) - errors(vehicle):
            return False
        missing = unprovided([*vehicle, *new])
        for old in product(*before):
            if missing - unprovided([*vehicle, *(each for each in old if each is not None)]):
                return False
    return True


@pytest.mark.parametrize("part", range(PARTS))
def test_a_deployment_is_allowed_if_no_vehicle_gets_an_error(part: int) -> None:
    decisions: list[str] = []
    for seed in range(part, HISTORIES, PARTS):
        history = History(seed)
        with in_memory() as connection:
            add(connection, *(candidate(text, over) for text, over in history.versions.values()))
            deploy(connection, "SUV-2025", history.field)
            answer = can_deploy(connection, history.deployed, "SUV-2025")
        expected = "unknown" if not history.field else "yes" if fits(history) else "no"
        assert answer.decision == expected, (seed, history.field, history.deployed, answer.conflicts)
        decisions.append(answer.decision)
    assert {"yes", "no"} <= set(decisions)


@pytest.mark.parametrize("part", range(PARTS))
def test_a_change_of_the_catalogue_breaks_the_functions_that_can_no_longer_be_built_the_same(part: int) -> None:
    found: list[bool] = []
    for seed in range(part, HISTORIES, PARTS):
        chance = random.Random(seed)
        text = declaration("Alpha", chance.sample(SIGNALS, 1), chance.sample(SIGNALS, 1))
        gone = chance.sample(SIGNALS, chance.randint(0, 1))
        datatypes = {name: chance.choice(("float", "uint8", "uint16")) for name in chance.sample(SIGNALS, 1)}
        after = catalogue(datatypes, without=gone, text="Other words.")
        if checked(text, CATALOGUES[0]).sound is None:  # it provides what it consumes
            continue
        with in_memory() as connection:
            add(connection, candidate(text, CATALOGUES[0]))
            broken = broken_by_catalogue(connection, after, "tree.vspec")
        is_broken = any(each.severity == "error" for each in broken)
        assert is_broken is not _is_the_same(text, after), (seed, broken)
        found.append(is_broken)
    assert {True, False} == set(found)


def _is_the_same(text: bytes, after: Catalogue) -> bool:
    """Whether a function can be built over a catalogue with the datatypes that it has."""
    built = checked(text, after)
    if built.sound_function is None:
        return False
    before = checked(text, CATALOGUES[0]).sound_function
    assert before is not None
    return before.datatypes == built.sound_function.datatypes


@pytest.mark.parametrize(
    ("provided", "consumed", "limit", "rules"),
    [
        (("S0",), (), 50, ["E006"]),
        ((), ("S0",), 50, []),
        (("S0",), (), 200, []),
        ((), ("S0",), 200, ["E007"]),
    ],
)
def test_a_narrower_range_breaks_who_provides_and_a_wider_one_may_break_who_reads(
    provided: tuple[str, ...], consumed: tuple[str, ...], limit: int, rules: list[str]
) -> None:
    before, after = (catalogue(text=f"A signal., max: {most}") for most in (100, limit))
    with in_memory() as connection:
        add(connection, candidate(declaration("Alpha", provided, consumed), before))
        assert [finding.rule for finding in broken_by_catalogue(connection, after, "tree.vspec")] == rules


VALUES = ("A", "B", "C", "D", "E")


def _with_values(values: Sequence[str]) -> Catalogue:
    """A catalogue in which a signal has these values; without any, all texts."""
    more = f", allowed: [{', '.join(values)}]" if values else ""
    return catalogue({"S0": f"string{more}"})


def _renamed(values: Sequence[str], chance: random.Random) -> list[str]:
    """A list of values as an edit leaves it: some added, removed, renamed, and all of them reordered."""
    kept = [each for each in values if chance.random() < 0.7]
    new = chance.sample(VALUES, chance.randint(0, 2))
    found = list(dict.fromkeys([*kept, *new]))
    return found if chance.random() < 0.6 else chance.sample(found, len(found))


def _verdict(is_provider: bool, old: Sequence[str], new: Sequence[str]) -> str:
    """The verdict about a function in the vehicles, from the meaning of the values alone.

    Who provides them breaks if it may send one that is not allowed; who reads them may break by any change, but gets
    only texts that it knows if it knows all of them. Code numbers values by their position.
    """
    if list(old) == list(new) or not (is_provider or old):
        return "fits"
    if is_provider:
        is_limited = bool(new) and not (old and set(old) <= set(new))
        kept = [each for each in old if each in new]
        is_renumbered = bool(old and new) and (list(new[: len(kept)]) != kept or set(old) == set(new))
        return "breaks" if is_limited else "may break" if is_renumbered else "fits"
    return "may break"


@pytest.mark.parametrize("is_provider", [True, False], ids=["provider", "consumer"])
def test_a_check_of_a_catalogue_and_a_deployment_over_it_judge_changed_values_alike(is_provider: bool) -> None:
    """The function in the vehicles was built over the old values, and the other end of its signal over the new ones."""
    signals: tuple[list[str], list[str]] = (["S0"], [])
    (here, there) = (signals, signals[::-1]) if is_provider else (signals[::-1], signals)
    found: list[str] = []
    for seed in range(200 if IS_SLOW_RUN else 60):
        chance = random.Random(seed)
        old = chance.sample(VALUES, chance.randint(1, 4)) if chance.random() < 0.9 else []
        new = _renamed(old, chance)
        before, after = _with_values(old), _with_values(new)
        with in_memory() as connection:
            add(
                connection,
                candidate(declaration("Alpha", *here), before),
                candidate(declaration("Beta", *there), after),
            )
            deploy(connection, "SUV-2025", [Reference("Alpha", "1.0.0")])
            answer = can_deploy(connection, [Reference("Beta", "1.0.0")], "SUV-2025")
            checked_ = [
                each for each in broken_by_catalogue(connection, after, "tree.vspec") if "Alpha" in each.message
            ]
        judged = [(each.rule, each.severity, each.message.partition(" Alpha")[0], each.fix) for each in checked_]
        conflicts = [each for each in answer.conflicts if each.rule != "E008"]
        deployed = [(each.rule, each.severity, each.message.partition(" Alpha")[0], each.fix) for each in conflicts]
        expected = _verdict(is_provider, old, new)
        assert deployed == judged, (seed, old, new)
        verdicts = {each.rpartition(" ")[2] for _, _, each, _ in judged}
        assert ("breaks" if "breaks" in verdicts else "may break" if verdicts else "fits") == expected, (seed, old, new)
        found.append(expected)
    assert set(found) == {"fits", "may break"} | ({"breaks"} if is_provider else set())


SETTABLE = """
Vehicle.Function: {{type: branch, description: Functions.}}
Vehicle.Function.Alpha: {{type: branch, description: A function.}}
Vehicle.Function.Alpha.Scheduling: {{type: branch, description: Calls.}}
Vehicle.Function.Alpha.Scheduling.Step: {{type: branch, description: Runs., runType: Cyclic, cycleTime: 10, priority: 1, scheduling: Preemptive, ASILlevel: QM}}
Vehicle.S0: {{type: {type}, datatype: float, description: A signal.}}
"""


@pytest.mark.parametrize(
    ("provided", "consumed", "rules"), [((), ("S0",), []), (("S0",), (), ["E006"]), (("S0",), ("S0",), ["E006"])]
)
def test_a_node_that_cannot_be_set_any_more_breaks_who_sets_it(
    provided: tuple[str, ...], consumed: tuple[str, ...], rules: list[str]
) -> None:
    before = catalogue_of(ROOT, SETTABLE.format(type="actuator"))
    after = catalogue_of(ROOT, SETTABLE.format(type="sensor"))
    with in_memory() as connection:
        add(connection, candidate(declaration("Alpha", provided, consumed), before))
        assert [finding.rule for finding in broken_by_catalogue(connection, after, "tree.vspec")] == rules


@pytest.mark.parametrize(("more", "rules"), [("", ["E006"]), (", optional: true, init: 0", [])])
def test_an_optional_signal_that_is_removed_breaks_nothing(more: str, rules: list[str]) -> None:
    """A change of its datatype breaks the function all the same."""
    text = declaration("Alpha", consumed=["S0"]).replace(b"role: consumed", f"role: consumed{more}".encode())
    with in_memory() as connection:
        add(connection, candidate(text, catalogue()))
        without, other = catalogue(without=["S0"]), catalogue({"S0": "uint8"})
        assert [finding.rule for finding in broken_by_catalogue(connection, without, "tree.vspec")] == rules
        assert [finding.rule for finding in broken_by_catalogue(connection, other, "tree.vspec")] == ["E006"]


@pytest.mark.parametrize(
    ("more", "decision", "severities"), [("", "no", ["error"]), (", optional: true, init: 0", "yes", ["warning"])]
)
def test_a_lost_provider_of_an_optional_signal_is_a_warning(more: str, decision: str, severities: list[str]) -> None:
    user = declaration("Beta", consumed=["S0"]).replace(b"role: consumed", f"role: consumed{more}".encode())
    with in_memory() as connection:
        versions = (declaration("Alpha", ["S0"]), declaration("Alpha", ["S1"], version="2.0.0"), user)
        add(connection, *(candidate(each, catalogue()) for each in versions))
        deploy(connection, "SUV-2025", [Reference("Alpha", "1.0.0"), Reference("Beta", "1.0.0")])
        answer = can_deploy(connection, [Reference("Alpha", "2.0.0")], "SUV-2025")
    assert (answer.decision, [each.severity for each in answer.conflicts]) == (decision, severities)


def test_a_version_whose_support_has_ended_is_a_warning(monkeypatch: pytest.MonkeyPatch) -> None:
    state = {"kind": "function", "name": "Alpha", "version": "1.0.0", "state": "deprecated"}
    with in_memory() as connection:
        add(connection, candidate(declaration("Alpha", ["S0"]), catalogue()))
        deploy(connection, "SUV-2025", [Reference("Alpha", "1.0.0")])
        Ledger(connection, None).append("state", {**state, "until": "2040-12-31", "successor": "2.0.0"})
        asked = partial(can_deploy, connection, [Reference("Alpha", "1.0.0")], "SUV-2025")
        for day, ended in (("2040-12-31", []), ("2041-01-01", [("E009", "warning", "Deploy its successor 2.0.0.")])):
            monkeypatch.setattr(entry, "now", lambda day=day: f"{day}T00:00:00.000+00:00")
            answer = asked()
            assert (answer.decision, [(each.rule, each.severity, each.fix) for each in answer.conflicts]) == (
                "yes",
                ended,
            )
            (version,) = all_versions(connection)
            assert version.end == f"{', support ended on' if ended else ' until'} 2040-12-31, successor 2.0.0"


def test_a_signal_that_the_catalogue_lacks_has_its_users() -> None:
    text = declaration("Alpha", consumed=["S0"]).replace(
        b"role: consumed", b"role: consumed, optional: true, datatype: float, init: 0"
    )
    with in_memory() as connection:
        add(connection, candidate(text, catalogue(without=["S0"])))
        (user,) = users_of(connection, "Vehicle.S0").users
        assert (user.use.verb, user.use.is_optional) == ("consumes", True)
        assert broken_by_catalogue(connection, catalogue(), "tree.vspec") == ()


def follower(name: str, previous: str, version: str = "1.0.0") -> Candidate:
    """A function whose step runs after one of another function, or after none."""
    nodes = [
        f"Vehicle.Function.{each}: {{type: branch, description: A function.}}\n"
        f"Vehicle.Function.{each}.Scheduling: {{type: branch, description: Calls.}}\n"
        f"Vehicle.Function.{each}.Scheduling.Step: {{type: branch, description: Runs., runType: Cyclic, cycleTime: 10, priority: 1,"
        f" scheduling: Preemptive, ASILlevel: QM{f', previousRunnable: {previous}_Step' if previous and each == name else ''}}}\n"
        for each in ("One", "Two", "Three", "Four")
    ]
    signal = "Vehicle.S0: {type: sensor, datatype: float, description: A signal.}\n"
    functions = "Vehicle.Function: {type: branch, description: Functions.}\n"
    over = catalogue_of(ROOT, f"{functions}{''.join(nodes)}{signal}")
    return candidate(declaration(name, ("S0",) if name == "One" else (), (), version), over)


@pytest.mark.parametrize(
    ("previous", "field", "decision"),
    [
        ({"One": "Two", "Two": "Three", "Three": "One"}, ("Two", "Three"), "no"),
        ({"One": "Two", "Two": "Three", "Three": "Four", "Four": "One"}, ("Two", "Three", "Four"), "no"),
        ({"One": "Two", "Two": "Three", "Three": ""}, ("Two", "Three"), "yes"),
        ({"One": "Two", "Two": "Three", "Three": "One"}, ("Two",), "yes"),
        (
            {"One": "Two", "Two": "Three", "Three": "Four", "Four": "Two"},
            ("Two", "Three", "Four"),
            "yes",
        ),  # it was before
    ],
)
def test_a_deployment_that_closes_a_circle_of_calls_is_refused(
    previous: Mapping[str, str], field: Sequence[str], decision: str
) -> None:
    with in_memory() as connection:
        add(connection, *(follower(name, before) for name, before in previous.items()))
        deploy(connection, "SUV-2025", [Reference(name, "1.0.0") for name in field])
        answer = can_deploy(connection, [Reference("One", "1.0.0")], "SUV-2025")
    assert answer.decision == decision, answer.conflicts
    assert all("depends on itself" in each.message for each in answer.conflicts)


def test_a_circle_exists_in_one_vehicle_only_if_it_has_one_version_of_each_function() -> None:
    functions = [
        ("One", "Two", "1.0.0"),
        ("Two", "Three", "1.0.0"),
        ("Two", "", "1.1.0"),
        ("Three", "Two", "1.0.0"),
        ("Three", "One", "1.1.0"),
    ]
    decisions = {}
    for chosen in (("Two", "1.0.0"), ("Two", "1.1.0")):
        with in_memory() as connection:
            add(connection, *(follower(*each) for each in functions))
            deploy(connection, "SUV-2025", [Reference(*chosen), Reference("Three", "1.1.0")])
            decisions[chosen] = can_deploy(connection, [Reference("One", "1.0.0")], "SUV-2025").decision
    assert list(decisions.values()) == ["no", "yes"]
