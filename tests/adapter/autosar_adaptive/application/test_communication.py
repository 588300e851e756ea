"""A subscription takes what end-to-end protection accepts, and rejects what a platform leaves unchecked."""

import subprocess
from pathlib import Path

import pytest

from sigcat.adapter.autosar_adaptive import application, bench
from sigcat.adapter.toolchain import toolchain
from tests.needs import c_compiler

pytestmark = c_compiler
APPLICATION = Path(application.__file__).with_name("cpp")
BENCH = Path(bench.__file__).with_name("runtime") / "include"
LOGGER = """
#pragma once
#include <iostream>
namespace ara::log {
struct Logger {
    std::ostream& LogError() { return std::cout << "\\nlog "; }
};
}
"""
MAIN = """
#include <cstdlib>
#include <functional>
#include <string>

#include "application/communication.h"

using Status = ara::com::e2e::ProfileCheckStatus;

struct Done { bool HasValue() const { return is_good; } bool is_good; };

struct Sample {
    Status status;
    Status GetProfileCheckStatus() const { return status; }
    int operator*() const { return 1; }
};

struct Event {
    bool is_there;
    Sample next{};
    std::function<void()> handler{};
    Done SetReceiveHandler(std::function<void()> given) { handler = given; return {true}; }
    Done Subscribe(std::size_t) { return {is_there}; }
    template <typename F> int GetNewSamples(F take) { take(next); return 1; }
};

int main(int, char** arguments) {
    const bool is_protected = std::string{arguments[1]} == "protected";
    ara::log::Logger logger;
    Event event{std::string{arguments[2]} == "there"};
    application::Receive(logger, event, {"Speed", 16U, is_protected}, [](int) { std::cout << "taken "; },
                         [] { std::cout << "rejected "; });
    for (int i = 3; arguments[i] != nullptr; ++i) {
        event.next.status = static_cast<Status>(std::atoi(arguments[i]));
        event.handler();
    }
}
"""
OK, REPEATED, WRONG_SEQUENCE, ERROR, NOT_AVAILABLE, NO_NEW_DATA, CHECK_DISABLED = range(7)


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("communication")
    (folder / "application").symlink_to(APPLICATION)
    (folder / "ara/log").mkdir(parents=True)
    (folder / "ara/log/logger.h").write_text(LOGGER)
    (folder / "main.cpp").write_text(MAIN)
    made = folder / "main"
    command = [*toolchain().cpp, "-std=c++17", "-Wall", "-Wextra", "-Werror", f"-I{folder}", f"-I{BENCH}", "-o", made]
    subprocess.run([*map(str, command), str(folder / "main.cpp")], check=True)
    return made


def heard(program: Path, protection: str, *states: int, event: str = "there") -> list[str]:
    """Return the results for samples of these states, one after the other, and the log."""
    command = [str(program), protection, event, *map(str, states)]
    printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return [word for line in printed.splitlines() for word in ([line] if line.startswith("log") else line.split())]


@pytest.mark.parametrize("state", [NOT_AVAILABLE, NO_NEW_DATA, CHECK_DISABLED])
def test_a_sample_of_a_protected_event_that_is_not_checked_is_rejected_and_logged_once(
    program: Path, state: int
) -> None:
    found = heard(program, "protected", state, state)
    assert found[0] == "rejected" or found[0].startswith("log")
    text = "".join(found)
    assert text.count("rejected") == 2
    assert text.count("Speed must be protected end to end, but the platform does not check it") == 1
    assert "taken" not in text


@pytest.mark.parametrize("state", [OK, NOT_AVAILABLE, NO_NEW_DATA, CHECK_DISABLED])
def test_what_is_not_protected_is_taken(program: Path, state: int) -> None:
    assert heard(program, "not", state) == ["taken"]


@pytest.mark.parametrize("protection", ["protected", "not"])
def test_what_is_spoilt_repeated_or_out_of_sequence_is_rejected(program: Path, protection: str) -> None:
    states = (WRONG_SEQUENCE, OK, WRONG_SEQUENCE, REPEATED, ERROR, OK)
    assert heard(program, protection, *states) == ["taken", "taken", "rejected", "rejected", "rejected", "taken"]


def test_an_event_that_cannot_be_subscribed_to_is_logged_with_its_name(program: Path) -> None:
    assert heard(program, "protected", event="gone") == ["log Speed cannot be subscribed to"]
