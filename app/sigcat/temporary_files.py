"""The folder for temporary files: the one that the environment names, and no other."""

import os
import tempfile

from sigcat.errors import NoRoom

_VARIABLES = ("TMPDIR", "TEMP", "TMP")


def temporary_folder(prefix: str) -> "tempfile.TemporaryDirectory[str]":
    """A new folder, which is removed when it is left. Raises NoRoom where none can be made.

    Python takes another place in silence where the one that is named is full or not there.
    """
    place = next(filter(None, map(os.environ.get, _VARIABLES)), None)
    try:
        return tempfile.TemporaryDirectory(prefix=prefix, dir=place, ignore_cleanup_errors=True)
    except OSError as error:
        reason = error.strerror or error
        raise NoRoom(
            f"Temporary files cannot be written: {reason}. Free some space, or let TMPDIR name another folder."
        ) from None
