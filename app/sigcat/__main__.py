"""`python -m sigcat`, which is the command `sigcat`."""

import sys

from sigcat.cli import main

if __name__ == "__main__":
    sys.exit(main())
