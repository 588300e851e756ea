"""`python -m sigcat.cli.health_check`: whether the service of this container is ready, at the address that it was started with.

The options are those of process 1, the project and the environment are those of the container.
"""

import sys
from collections.abc import Sequence
from pathlib import Path
from urllib.request import urlopen

from sigcat.cli import parser_of
from sigcat.cli.catalogue_options import served_project

_TIMEOUT = 2
_ANY = {"0.0.0.0": "127.0.0.1", "::": "[::1]"}  # noqa: S104 -- addresses that are translated, not listened on


def ready_address(words: Sequence[str]) -> str:
    """Return where a service that was started with this command line answers whether it is ready. Raises UsageError."""
    start = words.index("serve") if "serve" in words else len(words)
    _, settings = served_project(parser_of("serve").parse_args(["serve", *words[start + 1 :]]))
    host = f"[{settings.host}]" if ":" in settings.host else settings.host
    return f"http://{_ANY.get(settings.host, host)}:{settings.port}/health/ready"


def main() -> int:
    """Ask; 1 if the service is not ready."""
    words = Path("/proc/1/cmdline").read_bytes().decode().split("\0")[:-1]
    try:
        with urlopen(ready_address(words), timeout=_TIMEOUT):  # noqa: S310 -- an address of this machine
            return 0
    except OSError as error:
        print(error, file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
