"""Write the bill of materials of the shipped packages, as CycloneDX 1.6: `python -m scripts.sbom [FILE]`.

It says what requirements.txt pins, so it needs no network, and the same checkout gives the same bytes.
"""

import json
import sys
from pathlib import Path
from typing import Any

from scripts.shipped import OURS, ROOT, Package, licences_in, shipped
from sigcat import __version__

FILE = ROOT / "build" / "sbom.json"


def bill_of_materials() -> dict[str, Any]:
    """The document."""
    packages = shipped()
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {"component": _component("application", Package(OURS, __version__, "Apache-2.0", ()))},
        "components": [_component("library", package) for package in packages],
        "dependencies": [_dependencies(each, packages) for each in (OURS, *(package.name for package in packages))],
    }


def _component(kind: str, package: Package) -> dict[str, Any]:
    return {
        "type": kind,
        "bom-ref": package.name,
        "name": package.name,
        "version": package.version,
        "purl": package.address,
        "licenses": [_licence(package.licence)],
    }


def _licence(expression: str) -> dict[str, Any]:
    is_one = licences_in(expression) == {expression}
    return {"license": {"id": expression}} if is_one else {"expression": expression}


def _dependencies(name: str, packages: tuple[Package, ...]) -> dict[str, Any]:
    return {"ref": name, "dependsOn": [package.name for package in packages if name in package.needed_by]}


def main() -> int:
    """Write it, and say where."""
    file = Path(sys.argv[1]) if len(sys.argv) > 1 else FILE
    file.parent.mkdir(parents=True, exist_ok=True)
    document = bill_of_materials()
    file.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
    print(f"{file}: {len(document['components'])} packages")
    return 0


if __name__ == "__main__":
    sys.exit(main())
