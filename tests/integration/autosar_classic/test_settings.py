"""Errors in the section of the deployment file are reported at their lines, before anything is derived."""

import pytest

from sigcat.errors import InputRefused
from sigcat.platforms.deployment_file import read_deployment

WRONG = {
    "a package that is a keyword": ("package: int", 2, "`package` must be no keyword"),
    "an ECU that is a keyword": ("ecu: class", 2, "`ecu` must be no keyword"),
    "a package with a space": ("package: Eco Control", 2, "letters, digits and underscores"),
    "a signal with a space": ("signals:\n    Vehicle.Speed: {signal: Spd x}", 3, "letters, digits and underscores"),
    "a signal without a name": ('signals:\n    Vehicle.Speed: {signal: ""}', 3, "letters, digits and underscores"),
    "a signal with an umlaut": ("signals:\n    Vehicle.Speed: {signal: Größe}", 3, "letters, digits and underscores"),
    "a message with a space": ("signals:\n    Vehicle.Speed: {signal: Spd, message: A B}", 3, "letters, digits"),
    "one signal for two elements": (
        "signals:\n    Vehicle.Speed: {signal: Spd}\n    Vehicle.Mass: {signal: Spd}", 4, "must carry one data element",
    ),
    "two signals for one element": (
        "signals:\n    Vehicle.Speed: {signal: Spd}\n    Vehicle_Speed: {signal: Spd2}", 4, "must have one signal",
    ),
    "a window without a message": ("e2e: {valid: {windowSize: 0}}", 2, "`windowSize`"),
    "more good messages than a window has": (
        "e2e: {valid: {windowSize: 3, minOkState: 4}}", 2, "`minOkState` must be at most `windowSize`, 3, not 4",
    ),
    "more errors than a window has": (
        "e2e:\n    elements:\n      Vehicle.Speed:\n        init: {maxErrorState: 2}", 5, "`maxErrorState` must be at most",
    ),
    "an unknown state": ("e2e: {deinit: {windowSize: 3}}", 2, "deinit"),
    "one element twice": (
        "signals:\n    Vehicle.Speed: {signal: Spd}\n    Vehicle.Speed: {signal: Spd2}", 4, "is given twice",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("text", "line", "said"), WRONG.values(), ids=WRONG)
def test_a_deployment_is_refused_for(text, line, said):
    with pytest.raises(InputRefused) as refused:
        read_deployment(f"autosarClassic:\n  {text}\n".encode(), "deployment.yaml")
    (finding,) = refused.value.findings
    assert (finding.file, finding.line) == ("deployment.yaml", line)
    assert said in finding.message


@pytest.mark.parametrize(
    "text",
    [
        "signals:\n    Vehicle.Speed: {signal: Spd, message: A}\n    Vehicle.Mass: {signal: Spd, message: B}",
        "signals:\n    Vehicle.A.Speed: {signal: Spd}\n    Other.A.Speed: {signal: Spd2}",
    ],
    ids=["signals of one name in two messages", "paths of one name in two trees"],
)
def test_a_deployment_may_have(text):
    deployment = read_deployment(f"autosarClassic:\n  {text}\n".encode(), "deployment.yaml")
    assert len(deployment.model_dump()["autosar_classic"]["signals"]) == 2
