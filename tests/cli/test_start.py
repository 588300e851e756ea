"""The start of the command: before its modules are imported, too, an interrupt is no traceback."""

import subprocess
import sys

import pytest

INTERRUPTED = """
import sys

class Interrupts:
    def find_spec(self, name, *_):
        if name == {module!r}:
            raise KeyboardInterrupt

sys.meta_path.insert(0, Interrupts())
sys.argv = ["sigcat", "units"]
from sigcat.__main__ import main
sys.exit(main())
"""


@pytest.mark.parametrize("module", ["sigcat.cli", "sigcat.cli.command_parser", "sigcat.cli.units", "sigcat.catalogue"])
def test_an_interrupt_while_modules_are_imported_ends_the_command(module):
    command = [sys.executable, "-c", INTERRUPTED.format(module=module)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (130, "")
