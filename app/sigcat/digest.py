"""SHA-256 of input, without loading OpenSSL for it: the linter's start-up counts in milliseconds."""

from collections.abc import Callable
from typing import Any

try:
    from _sha2 import sha256 as _sha256  # type: ignore[import-not-found]  # from Python 3.12 on
except ImportError:
    try:
        from _sha256 import sha256 as _sha256  # type: ignore[import-not-found]
    except ImportError:
        from hashlib import sha256 as _sha256

_new: Callable[[bytes], Any] = _sha256


def digest_of(data: bytes) -> str:
    """SHA-256 in hexadecimal."""
    digest: str = _new(data).hexdigest()
    return digest
