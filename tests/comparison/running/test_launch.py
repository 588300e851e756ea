"""The launcher with processes of a shell: it ends when the player does, tells who died, and leaves nothing running."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from sigcat.comparison.running.processes import Process, launched, own_network
from tests.processes import is_running
from tests.waiting import DEADLINE, wait_until

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the launcher ends processes as Linux does")
WAITS = 'echo $$ > "$0"; trap "exit 0" TERM; while :; do sleep 0.05; done'


def process(name: str, script: str, *arguments: object) -> Process:
    return Process(name, ("sh", "-c", script, *map(str, arguments)), dict(os.environ))


def started(path: Path) -> int:
    """The process that has written its number."""
    return int(wait_until(lambda: path.exists() and path.read_text().strip(), "the process has begun"))


def waiting(path: Path) -> str:
    """A script that waits until another one has begun."""
    return f'while [ ! -s "{path}" ]; do sleep 0.01; done'


def test_the_others_are_told_to_end_when_the_player_has_ended(tmp_path):
    begun = tmp_path / "begun"
    outcome = launched([process("node", WAITS, begun)], process("player", waiting(begun)), tmp_path / "run")
    assert outcome.last_words == ""
    assert [load.name for load in outcome.loads] == ["node", "player"]
    assert [load.is_player for load in outcome.loads] == [False, True]
    assert not is_running(started(begun))


def test_what_a_function_prints_in_the_player_is_no_request(tmp_path):
    """Much of it neither stops the player nor is lost, whatever bytes it has."""
    prints = "printf 'a\\377\\n'; i=0; while [ $i -lt 40000 ]; do echo line; i=$((i+1)); done; echo last >&2"
    outcome = launched([], process("player", prints), tmp_path / "run", patience=60)
    assert outcome.last_words == ""
    assert (tmp_path / "run/player.txt").read_bytes().count(b"line\n") == 40000


def test_the_load_of_each_process_is_its_own(tmp_path):
    busy = "i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done"
    outcome = launched([], process("player", busy), tmp_path / "run")
    assert outcome.loads[0].cpu_s > 0.01
    assert outcome.loads[0].peak_rss_bytes > 100_000


def test_a_process_that_dies_ends_the_run_with_its_last_words(tmp_path):
    begun = tmp_path / "begun"
    dying = process("node", f"{waiting(begun)}; echo no more bread >&2; kill -SEGV $$")
    outcome = launched([process("other", WAITS, begun), dying], process("player", "sleep 600"), tmp_path / "run")
    assert outcome.last_words == "node ended with SIGSEGV before the drive did: no more bread"
    assert outcome.seconds < 600
    assert not is_running(started(begun))


@pytest.mark.parametrize(("end", "how"), [("exit 3", "status 3"), ("kill -SEGV $$", "SIGSEGV")])
def test_a_process_that_dies_when_it_is_told_to_end_is_told(end, how, tmp_path):
    begun = tmp_path / "begun"
    dying = WAITS.replace("exit 0", f"echo no more bread >&2; {end}")
    outcome = launched([process("node", dying, begun)], process("player", waiting(begun)), tmp_path / "run")
    assert outcome.last_words == f"node ended with {how} when it was asked to end: no more bread"


def test_a_player_that_fails_is_told_with_its_words(tmp_path):
    player = process("player", "echo an event was lost >&2; exit 3")
    outcome = launched([process("node", WAITS, tmp_path / "begun")], player, tmp_path / "run")
    assert outcome.last_words == "player ended with status 3 before the drive did: an event was lost"


def test_the_player_may_have_a_process_killed(tmp_path):
    begun = tmp_path / "begun"
    player = process("player", f'{waiting(begun)}; echo "kill node"; read done; echo $done >&2; sleep 0.2')
    outcome = launched([process("node", WAITS, begun)], player, tmp_path / "run")
    assert outcome.last_words == ""
    assert (tmp_path / "run/player.txt").read_text() == "done\n"
    assert not is_running(started(begun))


def test_a_program_that_is_not_there_is_told(tmp_path):
    outcome = launched([], Process("player", ("./no-such-player",), dict(os.environ)), tmp_path / "run")
    assert "no-such-player" in outcome.last_words


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL], ids=lambda each: each.name)
def test_nothing_goes_on_when_the_caller_ends(number, tmp_path):
    """Not even if it is killed: then the launcher and its processes are, too."""
    script = (
        "import os, sys; from pathlib import Path; from sigcat.comparison.running.processes import Process, launched;"
        "begun, run = sys.argv[1:];"
        f"node = Process('node', ('sh', '-c', {WAITS!r}, begun), dict(os.environ));"
        "launched([node], Process('player', ('sleep', '60'), dict(os.environ)), Path(run))"
    )
    caller = subprocess.Popen(
        [sys.executable, "-c", script, tmp_path / "begun", tmp_path / "run"], stderr=subprocess.PIPE
    )
    node = started(tmp_path / "begun")
    caller.send_signal(number)
    caller.wait(DEADLINE)
    assert caller.stderr is not None
    caller.stderr.close()
    wait_until(lambda: not is_running(node), "the process is gone")


@pytest.mark.skipif(own_network() is None, reason="a network of a test's own")
def test_in_a_network_of_its_own_the_loopback_interface_is_up(tmp_path):
    script = "import socket; s = socket.socket(); s.bind(('127.0.0.1', 0)); s.listen(); socket.create_connection(s.getsockname())"
    player = Process("player", (sys.executable, "-c", script), dict(os.environ))
    outcome = launched([], player, tmp_path / "run", own_network() or ())
    assert outcome.last_words == ""


def test_a_process_that_records_nothing_any_more_is_ended_and_told_as_hanging(tmp_path):
    stuck = process("player", 'echo $$ > "$0"; echo stuck here >&2; while :; do sleep 0.05; done', tmp_path / "begun")
    outcome = launched([], stuck, tmp_path / "run", patience=5)
    assert outcome.last_words == "player hangs: nothing was recorded for 5 s. stuck here"
    left = started(tmp_path / "begun")
    wait_until(lambda: not is_running(left), "the process is gone")


def test_a_process_that_records_slowly_has_all_its_time(tmp_path):
    slow = process(
        "player",
        'for i in 1 2 3 4 5 6 7 8 9 10 11 12; do echo "$i" >> "$0"; sleep 0.5; done',
        tmp_path / "run/recorded",
    )
    assert launched([], slow, tmp_path / "run", patience=5).last_words == ""
