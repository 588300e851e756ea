"""Tell what the OpenAPI document breaks for clients of the released one: `python -m scripts.openapi`.

With `--release` the document becomes the released one, to which later ones are compared; if it breaks clients, it does not.
`make generate` writes docs/reference/openapi.json.
"""

import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sigcat.api.application import create_app
from sigcat.api.openapi_changes import breaking_changes
from sigcat.catalogue.hosting.library import Library

FILE = "docs/reference/openapi.json"
RELEASED = Path(__file__).parents[1] / "docs" / "reference" / "openapi-released.json"
"""The document of the last release. It moves with releases only, so that a change is found however many commits ago."""


def document() -> Mapping[str, Any]:
    """The document of the service, whichever catalogues it hosts."""
    return create_app(Library(())).openapi()


def files() -> Mapping[str, str]:
    """The document that is checked in."""
    return {FILE: json.dumps(document(), indent=1, ensure_ascii=False) + "\n"}


def release(document: Mapping[str, Any], released: Path = RELEASED) -> list[str]:
    """Make a document the released one, unless it breaks clients; what it breaks."""
    broken = breaking_changes(json.loads(released.read_bytes()), document) if released.is_file() else []
    if not broken:
        released.write_text(json.dumps(document, ensure_ascii=False) + "\n", encoding="utf-8")
    return broken


def main() -> int:
    """Print what breaks clients of the released document; 1 if anything does."""
    if "--release" in sys.argv[1:]:
        broken = release(document())
    else:
        broken = breaking_changes(json.loads(RELEASED.read_bytes()), document())
    for change in broken:
        print(f"breaks clients: {change}")
    return int(bool(broken))


if __name__ == "__main__":
    sys.exit(main())
