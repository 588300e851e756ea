"""Requirements of some tests that not every machine meets. Without them, tests are skipped, and the end of the run lists what was missing.

VSS_RELEASES names a folder with official releases of VSS, each in a folder of its name, with `spec` and `overlays`. Without it,
those that `sigcat pull` downloaded are used. ELIV_PRESENTATION names a checkout of the publication by the authors of the method.
"""

import os
import subprocess
import sys
from collections.abc import Container, Iterable
from importlib.util import find_spec
from pathlib import Path
from shutil import which

import pytest

from scripts import ros2_environment
from sigcat.catalogue.hosting.releases import releases_folder
from sigcat.comparison.running.processes import own_network as has_own_network

RELEASES = ("v5.0", "v6.0")
OFFICIAL = Path(os.environ.get("VSS_RELEASES") or releases_folder()).resolve()
"""Folder of the official releases, if they are there."""
HAS_OFFICIAL = all((OFFICIAL / release / "spec").is_dir() for release in RELEASES)
official_releases = pytest.mark.skipif(
    not HAS_OFFICIAL,
    reason="the official releases of VSS: `sigcat pull v5.0` and `sigcat pull v6.0`, or name a folder of both in VSS_RELEASES",
)

IS_SLOW_RUN = "SIGCAT_SLOW" in os.environ
"""Whether `make slow` runs the tests: with every repetition of cases that a usual run tests once."""
slow = pytest.mark.skipif(not IS_SLOW_RUN, reason="time: `make slow` runs these too")


def sampled(cases: Iterable[object], usual: Container[object]) -> list[object]:
    """Cases that say the same again and again, for `parametrize`: all but the usual ones are for `make slow`."""
    return [case if case in usual else pytest.param(case, marks=slow) for case in cases]


_PUBLISHED = os.environ.get("ELIV_PRESENTATION")
_FILES = {path.name: path for path in Path(_PUBLISHED).rglob("*.*")} if _PUBLISHED else {}
published_files = pytest.mark.skipif(
    "function_model_core_acc.json" not in _FILES,
    reason="the published example: clone github.com/ZF-Group/ELIV-presentation and name the folder in ELIV_PRESENTATION",
)


def published(name: str) -> bytes:
    """A file that the authors of the method published, at any path of their repository."""
    return _FILES[name].read_bytes()


_ZIG = ((sys.executable, "-m", "ziglang", "cc"),) if find_spec("ziglang") and not which("clang") else ()
C_COMPILERS = (*((name,) for name in ("gcc", "clang") if which(name)), *_ZIG)
"""Commands of this machine that compile C and C++: gcc, and clang or what PyPI has of it."""
c_compiler = pytest.mark.skipif(not C_COMPILERS, reason="a C compiler: install gcc or clang, or `pip install ziglang`")
_ZIG_CPP = tuple((*command[:-1], "c++") for command in _ZIG)
CPP_COMPILERS = (*((name,) for name in ("g++", "clang++") if which(name)), *_ZIG_CPP)
"""Those of C++."""
cpp_compiler = pytest.mark.skipif(not CPP_COMPILERS, reason="a C++ compiler: install g++")
FMUSIM = which("fmusim")
fmusim = pytest.mark.skipif(not FMUSIM, reason="fmusim, the importer of the Reference FMUs: build it")
fmpy = pytest.mark.skipif(not find_spec("fmpy"), reason="FMPy: pip install fmpy")
cmake = pytest.mark.skipif(
    not (which("cmake") and CPP_COMPILERS), reason="CMake and a C++ compiler: install cmake and g++"
)
own_network = pytest.mark.skipif(
    has_own_network() is None, reason="a network of a test's own: let users make namespaces (`unshare -Urn`)"
)
own_disk = pytest.mark.skipif(
    subprocess.run(["unshare", "-Urm", "true"], capture_output=True, check=False).returncode != 0
    if which("unshare")
    else True,
    reason="a disk of a test's own: let users make namespaces (`unshare -Urm`)",
)
object_reader = pytest.mark.skipif(not which("nm"), reason="nm, which reads object files: install binutils")
BUF = which("buf", path=os.pathsep.join((str(Path(sys.executable).parent), os.environ.get("PATH", ""))))
buf = pytest.mark.skipif(not BUF, reason="buf, which compares Protocol Buffers: `pip install buf-bin`")
IDLC = which("idlc")
idlc = pytest.mark.skipif(not IDLC, reason="idlc, the compiler of DDS IDL: install cyclonedds-tools")
ros2 = pytest.mark.skipif(not ros2_environment.is_made(), reason="ROS 2: `make ros2`, which needs Python 3.11")

HAS_POSTGRESQL = bool(which("postgres") or list(Path("/usr/lib/postgresql").glob("*/bin/initdb"))) and bool(
    find_spec("psycopg")
)
"""Whether tests can start a PostgreSQL server."""
postgresql = pytest.mark.skipif(
    not HAS_POSTGRESQL, reason="a PostgreSQL server: install postgresql, and `pip install 'psycopg[binary]'`"
)
