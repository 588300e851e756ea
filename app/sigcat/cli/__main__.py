"""`python -m sigcat.cli` is `sigcat`."""

import sys

from sigcat.__main__ import main

if __name__ == "__main__":
    sys.exit(main())
