"""Find the Chromium that browser tests and pictures use, or install it where that takes one command.

Prints one line if there is none: how to get it, and what is left out without it.
"""

import os
import shutil
import subprocess
import sys

NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
"""The headless shell is Chromium without windows: it opens a page in a quarter of the time."""
PLACES = ("/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",)


def find_browser() -> str | None:
    """Path of a Chromium: that of SIGCAT_BROWSER, or the first one on the system."""
    chosen = os.environ.get("SIGCAT_BROWSER")
    if chosen:
        return shutil.which(chosen)
    found = (shutil.which(name) for name in (*NAMES, *PLACES))
    return next((path for path in found if path), None)


def install_browser() -> None:
    """Install Debian's Chromium where we may; quietly do nothing elsewhere."""
    if shutil.which("apt-get") is None or os.geteuid() != 0:
        return
    _quietly("apt-get", "update")
    for package in ("chromium-headless-shell", "chromium"):
        if find_browser() is None:
            _quietly("apt-get", "install", "--yes", "--no-install-recommends", package)


def _quietly(*command: str) -> None:
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)


def main() -> int:
    """Make sure that a browser is installed, or say what is missing."""
    if find_browser() is None:
        install_browser()
    if find_browser() is None:
        print(
            "sigcat: no Chromium found, so the browser tests are skipped; "
            "install one (Debian: apt install chromium-headless-shell) or name it in SIGCAT_BROWSER",
            file=sys.stderr,
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
