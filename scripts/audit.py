"""Compare what is shipped with the database of known vulnerabilities, which needs the network: `python -m scripts.audit`.

Exit status: 0 if there are none, 1 if there are some, 2 if the database could not be asked.
"""

import json
import subprocess
import sys
from collections.abc import Mapping
from typing import Any

from scripts.shipped import REQUIREMENTS

_UNREACHABLE = "sigcat: not audited: the database of vulnerabilities cannot be reached from here"


def verdict(output: str) -> tuple[int, list[str]]:
    """The exit status and the lines to print, for what pip-audit says as JSON; it says nothing if it could not ask."""
    try:
        packages: list[Mapping[str, Any]] = json.loads(output)["dependencies"]
    except ValueError:
        return 2, [_UNREACHABLE]
    found = [_line(package, each) for package in packages for each in package.get("vulns", ())]
    if found:
        return 1, found
    skipped = sum(1 for package in packages if "skip_reason" in package)
    if skipped:
        return 2, [f"sigcat: not audited: the package index tells nothing of {skipped} of {len(packages)} packages"]
    return 0, [f"{len(packages)} packages, no known vulnerabilities"]


def _line(package: Mapping[str, Any], vulnerability: Mapping[str, Any]) -> str:
    fixed = ", ".join(vulnerability["fix_versions"]) or "no version yet"
    return f"{package['name']} {package['version']}: {vulnerability['id']}, fixed in {fixed}"


def main() -> int:
    """Ask, and print one line for each vulnerability."""
    options = ["--requirement", str(REQUIREMENTS), "--no-deps", "--disable-pip", "--format", "json"]
    command = [sys.executable, "-m", "pip_audit", *options, "--progress-spinner", "off"]
    result = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
    status, lines = verdict(result.stdout)
    print("\n".join(lines), file=sys.stderr if status else sys.stdout)
    return status


if __name__ == "__main__":
    sys.exit(main())
