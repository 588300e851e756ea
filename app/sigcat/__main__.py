"""The command `sigcat`, and `python -m sigcat`."""

import sys


def main() -> int:
    """Run one command and return its exit status: 130 also for an interrupt while its modules are imported."""
    try:
        from sigcat.cli import main as run

        return run()
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
