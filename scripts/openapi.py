"""Write docs/openapi.json anew, and tell what that breaks compared with the last commit: `python -m scripts.openapi`."""

import json
import subprocess
import sys
from pathlib import Path

from app.api.application import create_app
from app.api.openapi_changes import breaking_changes
from app.catalogue.hosting import Library

ROOT = Path(__file__).parent.parent
FILE = ROOT / "docs" / "openapi.json"


def main() -> int:
    """Write the document; 1 if it breaks clients of the committed one."""
    document = create_app(Library(())).openapi()
    FILE.write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    shown = subprocess.run(["git", "show", "HEAD:docs/openapi.json"], cwd=ROOT, capture_output=True, check=False)
    broken = breaking_changes(json.loads(shown.stdout), document) if shown.returncode == 0 else []
    for change in broken:
        print(f"breaks clients: {change}")
    return int(bool(broken))


if __name__ == "__main__":
    sys.exit(main())
