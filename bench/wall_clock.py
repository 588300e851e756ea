"""Nodes as another program counts them: `wrk` with eight connections on the last core, by wall clock, the server's log on.

Each run asks the floor first, on the same core: other work of the machine slows both.
"""

import re
import subprocess
import sys
import tempfile
import urllib.request
from collections.abc import Iterator
from shutil import which
from statistics import median

from bench.servers import FLOOR, SERVICE, Server, server
from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.data import ROOT_FILE

Row = tuple[str, str, str, str, str, bool]
_NODES = "/api/v1/catalogues/vss/nodes"
_KEEPS_NOTHING = 'import os\nos.environ["SIGCAT_CACHE_BYTES"] = "0"\n'
"""Before the code of a service: each of its answers is made, none is taken from the cache."""
_IN_TURN = """
local paths = {%s}
local number = 0
request = function()
  number = number %% #paths + 1
  return wrk.format(nil, paths[number])
end
"""


def rows(runs: int) -> Iterator[Row]:
    """Work, figure, reference, ratio, target and whether it is met, for a node that is kept and for one that is made."""
    if which("wrk") is None:
        print("sigcat: the rows by wall clock are left out for want of wrk: `apt-get install wrk`", file=sys.stderr)
        return
    with (
        tempfile.NamedTemporaryFile("w", suffix=".lua") as script,
        server(FLOOR) as floor,
        server(SERVICE) as keeping,
        server(_KEEPS_NOTHING + SERVICE) as making,
    ):
        script.write(_IN_TURN % ", ".join(f'"{_NODES}/{path}"' for path in read_catalogue(ROOT_FILE).nodes))
        script.flush()
        for service in (keeping, making):  # both before the first figure: they share a core
            _warm_up(service, script.name)
        for work, least, service in (("kept", 0.6, keeping), ("never asked before", 0.4, making)):
            rates = [(_rate(service, _NODES, script.name), _rate(floor, "/floor")) for _ in range(runs)]
            rate, reference = (median(taken) for taken in zip(*rates, strict=True))
            ratio = median(ours / other for ours, other in rates)
            name = f"node by path, {work}, by wall clock of `wrk`"
            yield (
                name,
                f"{rate:.0f}/s",
                f"prebuilt bytes: {reference:.0f}/s",
                f"{ratio:.2f} ×",
                f"at least {least} ×",
                ratio >= least,
            )


def _warm_up(service: Server, script: str) -> None:
    """Wait until workers are ready, which need the same core until then, and ask for each node, so that the cache has it."""
    overlay = b"Vehicle.Speed: {type: sensor, datatype: float, description: Speed.}"
    urllib.request.urlopen(f"http://{service.place}/api/v1/lint", overlay).close()
    _rate(service, _NODES, script)


def _rate(asked: Server, address: str, script: str = "") -> float:
    """Answers in a second."""
    options = ["-s", script] if script else []
    command = ["wrk", "-t1", "-c8", "-d2", *options, f"http://{asked.place}{address}"]
    told = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    rate = re.search(r"Requests/sec:\s+([\d.]+)", told)
    assert rate, told
    assert "Non-2xx" not in told, told
    return float(rate[1])


def main() -> int:
    """Print the rows."""
    for row in rows(runs=int(sys.argv[1]) if len(sys.argv) > 1 else 5):
        print(f"| {' | '.join(map(str, row))} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
