"""`sigcat pull RELEASE`."""

import argparse
import sys
import time

_WIDTH = 30
_REDRAW_SECONDS = 0.1


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "pull",
        help="fetch an official release of VSS",
        description="Fetch an official release of VSS from COVESA's GitHub, check it, and keep it in the data folder.",
        epilog="The data folder is SIGCAT_DATA, or else the one of the platform. HTTPS_PROXY is respected.",
    )
    parser.add_argument("release", metavar="RELEASE", help="such as v5.0")
    parser.add_argument(
        "--from", dest="origin", default="", metavar="URL|FILE", help="take the archive (tar.gz, tar, zip) from here"
    )
    parser.add_argument(
        "--allow-private", action="store_true", help="let the address of --from be one of this machine or its network"
    )
    parser.add_argument("--force", action="store_true", help="replace a release of this name that is here already")
    parser.add_argument("--digest", default="", metavar="SHA256", help="digest that the archive must have")
    parser.set_defaults(run=pull_release)


def pull_release(arguments: argparse.Namespace) -> int:
    """Fetch and keep the release; the line of it goes to standard output."""
    from sigcat.catalogue.hosting.releases import is_pulled, pull

    is_here = is_pulled(arguments.release) and not arguments.force
    bar = ProgressBar(arguments.release) if sys.stderr.isatty() else None
    try:
        release = pull(
            arguments.release, arguments.origin, arguments.digest, replaces=arguments.force,
            allows_private=arguments.allow_private, progress=bar,
        )  # fmt: skip
    finally:
        if bar is not None:
            bar.clear()
    if is_here:
        unused = f", and {arguments.origin} is not used" if arguments.origin else ""
        print(f"sigcat: {release.name} is here already{unused}; --force replaces it", file=sys.stderr)
    print(f"{release.name}: {release.nodes:,} nodes in {release.folder}")
    print(f"{'':{len(release.name)}}  SHA-256 {release.digest}, from {release.source}")
    return 0


class ProgressBar:
    """A bar on standard error, drawn over itself; called with bytes so far and in all."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._drawn = 0.0

    def __call__(self, done: int, total: int | None) -> None:
        now = time.monotonic()
        if now - self._drawn < _REDRAW_SECONDS and done != total:
            return
        self._drawn = now
        print(f"\r\x1b[K{bar_text(self._name, done, total)}", end="", file=sys.stderr, flush=True)

    def clear(self) -> None:
        """Leave the line empty."""
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)


def bar_text(name: str, done: int, total: int | None) -> str:
    """One line: the name, a bar if the whole is known, and what has come."""
    shown = f"{done / 1e6:.1f} MB"
    if not total:
        return f"{name}  {shown}"
    filled = min(done * _WIDTH // total, _WIDTH)
    return f"{name}  [{'#' * filled}{'.' * (_WIDTH - filled)}] {shown} of {total / 1e6:.1f} MB"
