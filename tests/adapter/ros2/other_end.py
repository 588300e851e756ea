"""A node at the other end, in a separate process: see other_end_program.py for its commands."""

import json
import subprocess
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from scripts import ros2_environment
from tests.waiting import wait_until

CONFIGURE, CLEANUP, ACTIVATE, DEACTIVATE = 1, 2, 3, 4
UNCONFIGURED_SHUTDOWN, INACTIVE_SHUTDOWN, ACTIVE_SHUTDOWN = 5, 6, 7
ACTIVE_MODE = 2
PROGRAM = Path(__file__).with_name("other_end_program.py")


class Peer:
    """Each of its methods is a command of the program."""

    def __init__(self, process: "subprocess.Popen[str]", variables: Mapping[str, str]) -> None:
        self._process = process
        self.variables = variables
        """Environment of others in its domain."""

    def __getattr__(self, command: str) -> Callable[..., Any]:
        def ask(*arguments: object) -> Any:
            assert self._process.stdin is not None
            assert self._process.stdout is not None
            self._process.stdin.write(json.dumps([command, arguments]) + "\n")
            self._process.stdin.flush()
            line = self._process.stdout.readline()
            assert line, f"the peer has ended at {command}{arguments}"
            answer = json.loads(line)
            assert "error" not in answer, answer["error"]
            return answer["answer"]

        return ask

    def switch_on(self, node: str) -> None:
        """Its mode is the one in which everything runs."""
        name = "".join(word.capitalize() for word in node.rpartition("/")[2].split("_"))
        topic, message = f"{node}/mode_in", f"eco_control_interfaces/msg/{name}ModeIn"
        self.advertise(topic, message, {"durability": "TRANSIENT_LOCAL"})
        self.publish(topic, {"mode": ACTIVE_MODE})

    def bring(self, node: str, *transitions: int) -> None:
        """Through transitions that are made."""
        for transition in transitions:
            assert self.change(node, transition), f"{node} refuses {transition} in state {self.state(node)}"

    def hears(self, topic: str, is_right: Callable[[list[Mapping[str, Any]]], object]) -> list[Mapping[str, Any]]:
        """Return the message received on a topic, as soon as it is right."""
        wait_until(lambda: is_right(self.heard(topic)), f"{topic} is not heard as it should be")
        return list(self.heard(topic))

    def finds(self, status: str, is_right: Callable[[Mapping[str, Any]], object]) -> Mapping[str, Any]:
        """A status of the diagnostics, as soon as it is right."""
        wait_until(lambda: status in self.diagnostics() and is_right(self.diagnostics()[status]), f"no {status}")
        return dict(self.diagnostics()[status])


@contextmanager
def peer(variables: Mapping[str, str]) -> Iterator[Peer]:
    """It lives meanwhile."""
    command = [str(ros2_environment.PYTHON), str(PROGRAM)]
    process = subprocess.Popen(command, env=variables, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    try:
        yield Peer(process, variables)
    finally:
        process.kill()
        process.wait()
