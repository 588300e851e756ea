"""Versions of hosted catalogues: hashes that are equal on all replicas."""

import hashlib
from weakref import WeakKeyDictionary

from app import __version__
from app.catalogue.hosting import Hosted
from app.catalogue.model import Catalogue
from app.findings import Finding

_versions: "WeakKeyDictionary[Catalogue, tuple[str, tuple[Finding, ...], str]]" = WeakKeyDictionary()


def version_of(hosted: Hosted) -> str:
    """A digest of all that is shown of a catalogue: content, files with their positions, findings."""
    known = _versions.get(hosted.catalogue)
    if known is None or (known[0], known[1]) != (hosted.source.title, hosted.rejected):
        known = (hosted.source.title, hosted.rejected, _version(hosted))
        _versions[hosted.catalogue] = known
    return known[2]


def _version(hosted: Hosted) -> str:
    parts = [__version__, hosted.source.title, hosted.catalogue.digest]
    parts += [layer.digest for layer in hosted.catalogue.layers]
    parts += [file.digest for file in hosted.catalogue.vocabulary.files]
    parts += [repr(hosted.rejected)] if hosted.rejected else []
    return hashlib.sha256("\n".join(parts).encode("utf-8", "replace")).hexdigest()[:24]
