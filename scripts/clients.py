"""Generate and check a Python and a TypeScript client of the running service: `python -m scripts.clients [FOLDER]`."""

import sys
import tempfile
from pathlib import Path

from tests.clients.generating import NoNode, check_python_client, check_typescript_client, running_service


def main() -> int:
    """Leave the clients in a folder, and say what was checked."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(tempfile.mkdtemp(prefix="sigcat-clients-"))
    with running_service() as address:
        for name, check in (("python", check_python_client), ("typescript", check_typescript_client)):
            place = folder / name
            place.mkdir(parents=True)
            try:
                check(address, place)
            except NoNode as reason:
                print(f"{name}: left out, {reason}")
            else:
                print(f"{name}: generated, type-checked, round trip done: {place}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
