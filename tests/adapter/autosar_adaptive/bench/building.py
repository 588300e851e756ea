"""The programs of the tests, built once for as long as nothing of them changes."""

import hashlib
import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from sigcat.adapter.autosar_adaptive.application.adaptive_application import CPP
from sigcat.adapter.autosar_adaptive.bench.adaptive_bench import generate
from sigcat.adapter.autosar_adaptive.bench.runtime_files import runtime_files
from sigcat.adapter.files import GeneratedFile, shipped
from sigcat.adapter.toolchain import toolchain
from sigcat.integration.autosar_adaptive.document import read_integration
from tests.adapter.autosar_adaptive.bench.probe_service import integration_json

WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror")
ADDRESSES = ("-fsanitize=address",)
THREADS = ("-fsanitize=thread",)
UNDEFINED = ("-fsanitize=undefined", "-fno-sanitize-recover=undefined")
DAY = 24 * 3600
"""Seconds after which what was built and not used again is removed."""
_OWN = Path(__file__).parent


def programs(names: Iterable[str], sanitizer: Sequence[str] = ()) -> Mapping[str, Path]:
    """The programs of these sources, with the runtime and the generated services in each."""
    generated = generate(read_integration(integration_json(), "probe.json"))
    flags = ("-std=c++17", "-O0", "-g1", *WARNINGS, *_usable(sanitizer))
    folder = _kept(generated, flags)
    with _alone(folder):
        return _built(folder, names, generated, flags)


def _built(
    folder: Path, names: Iterable[str], generated: Iterable[GeneratedFile], flags: Sequence[str]
) -> Mapping[str, Path]:
    _write(folder / "runtime", runtime_files())
    _write(folder / "generated", generated)
    _write(folder / "adapters/application", shipped(CPP))
    places = ("runtime/include", "runtime/src", "generated/include", "adapters")
    includes = [f"-I{folder}/{each}" for each in places]
    sources = [_together(folder, "runtime"), _together(folder, "generated"), *(_OWN / f"{name}.cpp" for name in names)]
    objects = [_object(folder, source, (*flags, *includes)) for source in sources]
    return {
        name: _linked(folder, name, (*flags, *objects[:2]), own) for name, own in zip(names, objects[2:], strict=True)
    }


@contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Other workers of pytest-xdist wait, and find it built."""
    import fcntl  # which Windows lacks

    with (folder / "lock").open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _usable(sanitizer: Sequence[str]) -> Sequence[str]:
    return () if toolchain().is_zig else sanitizer


def _kept(generated: Iterable[GeneratedFile], flags: Sequence[str]) -> Path:
    """A folder that only the same files and flags have."""
    digest = hashlib.sha256(repr((toolchain().cpp, flags)).encode())
    for file in (*generated, *runtime_files(), *shipped(CPP)):
        digest.update(file.name.encode() + file.data)
    for source in sorted(_OWN.glob("*.cpp")):
        digest.update(source.read_bytes())
    name = f"sigcat-bench-{os.getuid()}"
    folder = Path(tempfile.gettempdir()) / f"{name}-{digest.hexdigest()[:16]}"
    folder.mkdir(exist_ok=True)
    for lock in folder.parent.glob(f"{name}-*/lock"):
        if time.time() - lock.stat().st_mtime > DAY:
            shutil.rmtree(lock.parent, ignore_errors=True)
    return folder


def _write(folder: Path, files: Iterable[GeneratedFile]) -> None:
    for file in files:
        path = folder / file.name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(file.data)


def _together(folder: Path, name: str) -> Path:
    """One source that includes all of them, which compiles in a third of the time."""
    root = folder / name / "src"
    listed = sorted(path.relative_to(folder).as_posix() for path in root.rglob("*.cpp"))
    source = folder / f"{name}.cpp"
    source.write_text("".join(f'#include "{path}"\n' for path in listed))
    return source


def _object(folder: Path, source: Path, flags: Sequence[str]) -> str:
    made = folder / f"{source.stem}.o"
    if not made.exists():
        _run([*toolchain().cpp, *flags, "-c", str(source)], made)
    return str(made)


def _linked(folder: Path, name: str, flags: Sequence[str], own: str) -> Path:
    made = folder / name
    if not made.exists():
        _run([*toolchain().cpp, own, *flags, "-pthread"], made)
    return made


def _run(command: Sequence[str], made: Path) -> None:
    """Under another name first: a run that is interrupted leaves nothing that looks whole."""
    begun = made.with_name(f"{made.name}.{os.getpid()}")
    done = subprocess.run([*command, "-o", str(begun)], check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    begun.rename(made)
