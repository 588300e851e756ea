"""Input whose few lines become large or slow is bounded, and reported."""

import pytest

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.composing.compose_part import compose_part
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.findings import Finding
from sigcat.limits import Limits
from sigcat.patterns import BadPattern, Matching, compile_bounded

TREE = b"Vehicle: {type: branch, description: A vehicle.}\n" + b"".join(
    b"Vehicle.S%d: {type: sensor, datatype: float, description: A signal.}\n" % n for n in range(100)
)
EXPLODING = "^(a|a|aa)*$"
TEXT = "a" * 60 + "b"


def with_wildcards(count: int, limits: Limits) -> tuple[Catalogue, tuple[Finding, ...]]:
    overlay = b"".join(b"Vehicle.*%d: {comment: '%d'}\n" % (n, n) for n in range(count))
    base = layer_from_text(TREE, "tree", is_overlay=False)
    layer = layer_from_text(overlay, "overlay")
    part = compose_part(compose([base]), layer, limits)
    return compose([base, layer], limits=limits), part.findings


def test_wildcard_paths_are_applied_up_to_the_limit_and_the_rest_is_told() -> None:
    catalogue, findings = with_wildcards(10, Limits(compared=5 * 20_000))
    (finding,) = catalogue.findings
    assert findings == catalogue.findings
    assert (finding.rule, finding.severity, finding.line, finding.path) == ("O002", "error", 6, "Vehicle.*5")
    assert "10 wildcard paths; the limit for a tree of this size is 5." in finding.message
    assert catalogue.definitions["Vehicle.S14"].values["comment"] == "4"
    assert "comment" not in catalogue.definitions["Vehicle.S15"].values


def test_wildcard_paths_below_the_limit_are_no_finding() -> None:
    catalogue, findings = with_wildcards(10, Limits(compared=10 * 20_000))
    assert catalogue.findings == findings == ()


def test_all_patterns_of_a_tree_share_one_time_and_the_rest_is_told_as_unchecked() -> None:
    signals = (
        f"Vehicle.S{n}: {{type: sensor, datatype: string, description: S., pattern: '{EXPLODING}', default: {TEXT}}}\n"
        for n in range(200)
    )
    text = "Vehicle: {type: branch, description: A vehicle.}\n" + "".join(signals)
    catalogue = compose([layer_from_text(text.encode(), "tree", is_overlay=False)], limits=Limits(pattern_seconds=0.3))
    told = [finding.message for finding in catalogue.findings if finding.rule == "V016"]
    assert len(told) == 200
    assert "takes too long" in told[0]
    assert "was not checked" in told[-1]


def test_patterns_that_are_quick_leave_time_for_the_others() -> None:
    matching = Matching(1.0)
    assert not any(matching.mismatch("^[A-Z]{3}$", "ABC") for _ in range(1_000))
    assert matching.mismatch("^[A-Z]{3}$", "abc") == "does not match"


@pytest.mark.parametrize(
    "text",
    [
        "a{99999999}", "((a{100}){100}){100}", "(?i)(a{100}){1000}", "(?x)a{ 9 9 9#\n9 9 9 9 }", "[[:alpha:])]{99999999}",
        "(?#[)a{99999999}(?#])", "(" * 5_000 + "a" + ")" * 5_000, "a" * 100_000, "[a", "a{5,1}", "(?P<a", r"\L<x>",
    ],
)  # fmt: skip
def test_a_pattern_that_would_fill_memory_is_refused_before_it_does(text: str) -> None:
    with pytest.raises(BadPattern):
        compile_bounded(text)


@pytest.mark.parametrize(
    ("pattern", "text"),
    [
        ("^[A-HJ-NPR-Z0-9]{17}$", "WVWZZZ1JZXW000001"),
        (r"^[0-9a-f]{8}-([0-9a-f]{4}-){3}[0-9a-f]{12}(,[0-9a-f]{8}-([0-9a-f]{4}-){3}[0-9a-f]{12})?$",
         "01234567-0123-0123-0123-0123456789ab"),
        (r"^(?i:[a-z]{2}){1,3}[]x)]\{\d{1,4000}$", "abCD){42"),
        ("^.{0,9999}$", "text"),
    ],
)  # fmt: skip
def test_a_pattern_of_ordinary_size_is_taken(pattern: str, text: str) -> None:
    assert not Matching(1.0).mismatch(pattern, text)
