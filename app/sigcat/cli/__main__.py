"""`python -m sigcat.cli` is `sigcat`."""

import sys

from sigcat.cli import main

if __name__ == "__main__":
    sys.exit(main())
