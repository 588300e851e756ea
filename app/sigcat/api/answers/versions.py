"""Versions of hosted catalogues: hashes that are equal on all replicas."""

import hashlib
from weakref import WeakKeyDictionary

from sigcat import __version__
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.model.catalogue import Catalogue

_versions: "WeakKeyDictionary[Catalogue, tuple[str, str]]" = WeakKeyDictionary()


def version_of(hosted: Hosted) -> str:
    """A digest of a catalogue: content, files with their positions, findings. A newer state with errors is not part of it."""
    known = _versions.get(hosted.catalogue)
    if known is None or known[0] != hosted.source.title:
        known = (hosted.source.title, _version(hosted))
        _versions[hosted.catalogue] = known
    return known[1]


def state_of(hosted: Hosted) -> str:
    """The version, and with it the findings of a newer state that was rejected."""
    if not hosted.rejected:
        return version_of(hosted)
    return f"{version_of(hosted)}-{hashlib.sha256(repr(hosted.rejected).encode('utf-8', 'replace')).hexdigest()[:8]}"


def _version(hosted: Hosted) -> str:
    parts = [__version__, hosted.source.title, hosted.catalogue.digest]
    parts += [layer.digest for layer in hosted.catalogue.layers]
    parts += [file.digest for file in hosted.catalogue.vocabulary.files]
    parts += [f"{each.name} {each.title} {each.labels}" for each in hosted.source.vehicles]
    return hashlib.sha256("\n".join(parts).encode("utf-8", "replace")).hexdigest()[:24]
