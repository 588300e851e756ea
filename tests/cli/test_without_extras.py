"""Packages that only some commands need: without them a command says what to install, and never a traceback."""

import subprocess
import sys

import pytest

from sigcat.data import EXAMPLES

_CAN = EXAMPLES / "ecocontrol/can"
_LOG, _DATABASE = _CAN / "drive.log.gz", _CAN / "ecocontrol.dbc"
_FUNCTION, _ROWS = EXAMPLES / "core_acc/function.yaml", EXAMPLES / "ecocontrol/run.csv"
_WITHOUT = "import sys; sys.modules.update(dict.fromkeys({packages})); from sigcat.cli import main; sys.exit(main())"
COMMANDS = {
    "gateway": ("can", "gateway", _LOG, "--dbc", _DATABASE, "-o", "trace.csv"),
    "lint": ("can", "lint", "overlay.vspec", "--dbc", _DATABASE),
    "compare": (
        "can",
        "compare",
        _FUNCTION.parent,
        "--trace",
        _LOG,
        "--dbc",
        _DATABASE,
        "-o",
        "report",
    ),
    "lsp": ("lsp", "lsp"),
    "mcp": ("mcp", "mcp"),
    "simulate": ("mcap", "simulate", _FUNCTION, "--trace", _ROWS, "-o", "run.mcap"),
}


@pytest.mark.parametrize("command", COMMANDS)
def test_it_says_what_to_install(command, tmp_path):
    extra, *arguments = COMMANDS[command]
    (tmp_path / "overlay.vspec").write_text("Vehicle.Speed: {type: sensor, datatype: float, description: The speed.}\n")
    code = _WITHOUT.format(packages=("can", "cantools", "mcap", "pygls", "pygls.lsp", "lsprotocol", "mcp"))
    ended = subprocess.run(
        [sys.executable, "-c", code, *map(str, arguments)], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert (ended.returncode, ended.stdout) == (2, "")
    assert ended.stderr.splitlines()[-1].endswith(f"run `pip install 'sigcat[{extra}]'`")
    assert "Traceback" not in ended.stderr
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == ["overlay.vspec"]
