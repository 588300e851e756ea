"""Generated code of a platform, compiled next to declarations of the names in its functions; on the test RTE of AUTOSAR Classic it also runs."""

import ast
import functools
import re
import subprocess
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from xml.etree import ElementTree as ET

from scripts import ros2_environment, ros2_packages
from sigcat.adapter.core.plan import CLASS
from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.toolchain import EXACT, toolchain
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import data
from tests.adapter.core.core_side import write_headers
from tests.adapter.core.driver import silent_code
from tests.adapter.core.subject import Subject, subject

STRICT = ("-Wall", "-Wextra", "-Werror")
"""Compiler options of generated code. The called functions are missing: only the use of a function's names is compiled."""
CODE = "code"
"""Folder of the functions' own files, beside what is generated."""
MESSAGES = Path(__file__).with_name("rosidl_messages.py")
_LONGEST = 60
"""Seconds that a program may take."""


class Fails(Exception):
    """Return the output of a compiler or a program that fails."""


def compiled(platform: str, files: Iterable[GeneratedFile], functions: Sequence[FunctionJson]) -> None:
    """Compile what is generated, with the declarations that its functions need. Raises Fails."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file in files:
            (folder / file.name).parent.mkdir(parents=True, exist_ok=True)
            (folder / file.name).write_bytes(file.data)
        subjects = [subject(function) for function in functions]
        for number, each in enumerate(subjects):
            _write_code(each, number, folder)
        _BY_PLATFORM[platform](folder, subjects)


def _write_code(made: Subject, number: int, folder: Path) -> None:
    """Headers that declare the variables and calls of a function, and a source that has them."""
    code = folder / CODE
    code.mkdir(exist_ok=True)
    write_headers(made, code, f"F{number}_H")
    (code / f"f{number}.c").write_text(f'#include "{made.plan.function}_adapter.h"\n{silent_code(made)}')


def _run(command: Iterable[object], folder: Path, environment: Mapping[str, str] | None = None) -> None:
    words = [str(word) for word in command]
    done = subprocess.run(
        words, cwd=folder, env=environment, capture_output=True, text=True, check=False, timeout=_LONGEST
    )
    if done.returncode:
        raise Fails(f"{' '.join(words)[:500]}\nends with {done.returncode}:\n{(done.stdout + done.stderr)[:4000]}")


def _syntax(sources: Iterable[Path], folder: Path, *options: object) -> None:
    """Check sources of one language, each as a compiler takes it."""
    for source in sources:
        is_cpp = source.suffix == ".cpp"
        compiler = toolchain().compiler(is_cpp=is_cpp)
        standard = "-std=c++17" if is_cpp else "-std=c99"
        _run((*compiler, standard, *STRICT, *EXACT, "-fsyntax-only", f"-I{CODE}", *options, source), folder)


# -- AUTOSAR Classic ----------------------------------------------------------------------------------------------


def _classic(folder: Path, subjects: Sequence[Subject]) -> None:
    """Build components and the test RTE, and play a second to them."""
    options = ("-Itest_rte", "-Icontract", "-Icore", "-Itest_rte/include")
    sources = sorted(
        path.relative_to(folder) for part in ("swc", "core", "test_rte") for path in (folder / part).glob("*.c*")
    )
    if any(each.signature == CLASS for each in subjects):
        return _syntax(sources, folder, *options)
    own = sorted(path.relative_to(folder) for path in (folder / CODE).glob("*.c"))
    compiler = toolchain().c
    _run(
        (*compiler, "-std=c99", "-O0", "-w", *EXACT, *options, f"-I{CODE}", *sources, *own, "-lm", "-o", "program"),
        folder,
    )
    _syntax([path for path in sources if path.parts[0] != "test_rte" or path.name.startswith("Rte")], folder, *options)
    (folder / "trace.csv").write_text(_drive(subjects))
    _run((folder / "program", "lock", "trace.csv", "recorded.csv", "services.csv", 10**9), folder)
    return None


def _drive(subjects: Sequence[Subject]) -> str:
    """Numbers for everything that is received at a path."""
    provided = {item.vss_path for each in subjects for _, _, item in data(each.document) if item.role == "Provider"}
    paths = dict.fromkeys(
        item.vss_path for each in subjects for _, _, item in data(each.document)
        if item.role == "Consumer" and item.vss_path and item.vss_path not in provided and item.vss_datatype in _NUMBERS
    )  # fmt: skip
    rows = [[str(10**8 * row), *["1" if row % 2 else "0"] * len(paths)] for row in range(8)]
    return "".join("\t".join(row) + "\n" for row in [["time_ns", *map(str, paths)], *rows])


_NUMBERS = ("float", "double", "uint8", "int8", "uint16", "int16", "uint32", "int32")


# -- AUTOSAR adaptive ---------------------------------------------------------------------------------------------


def _adaptive(folder: Path, subjects: Sequence[Subject]) -> None:
    """Check the sources of each executable, its core, and what the bench generates, against the headers of the bench."""
    options = ("-I.", "-Igenerated/include", "-Ibench/include")
    _syntax([path.relative_to(folder) for path in sorted(folder.glob("core/*.c*"))], folder, *options)
    parts = ("*Executable/*_adapter.cpp", "*Executable/main.cpp", "player/ports.cpp", "generated/src/**/*.cpp")
    sources = [path.relative_to(folder) for part in parts for path in sorted(folder.glob(part))]
    (folder / "whole.cpp").write_text("".join(f'#include "{path}"\n' for path in sources))
    _syntax([Path("whole.cpp")], folder, *options)
    del subjects


# -- ROS 2 --------------------------------------------------------------------------------------------------------


def _ros2(folder: Path, subjects: Sequence[Subject]) -> None:
    """Check the modules of the Python packages, and the nodes in C++ where ROS 2 is there."""
    del subjects
    for module in sorted(folder.rglob("*.py")):
        _check_module(module, folder)
    nodes = [path.parent for path in folder.glob("*/src") if (path.parent / "core").is_dir()]
    _syntax([path.relative_to(folder) for node in nodes for path in sorted((node / "core").glob("*.c*"))], folder,
            *(f"-I{node.relative_to(folder)}/core" for node in nodes))  # fmt: skip
    if not ros2_environment.is_made():
        return
    packages = [path.parent for path in folder.glob("*_interfaces/package.xml")]
    for package in packages:
        command = (ros2_environment.PYTHON, MESSAGES, package.name, package.name, "messages")
        _run(command, folder, ros2_environment.variables())
    for node in nodes:
        own = (f"-I{node.relative_to(folder)}/include", f"-I{node.relative_to(folder)}/core", "-Imessages")
        sources = [path.relative_to(folder) for path in sorted((node / "src").glob("*_node.cpp"))]
        _syntax(sources, folder, *own, *_ros_headers())


@functools.cache
def _ros_headers() -> tuple[str, ...]:
    wheels = sorted((ros2_environment.ENVIRONMENT / "include").iterdir())
    return (f"-I{ros2_packages.SUBSET / 'include'}", *(option for each in wheels for option in ("-isystem", str(each))))


def _check_module(module: Path, folder: Path) -> None:
    """Compile a module, and find what it imports from modules beside it."""
    try:
        tree = ast.parse(module.read_text(encoding="utf-8"))
        compile(tree, module.name, "exec")
    except (SyntaxError, ValueError) as error:
        raise Fails(f"{module.relative_to(folder)}: {error}") from error
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module:
            _check_import(node, module, folder)


def _check_import(node: ast.ImportFrom, module: Path, folder: Path) -> None:
    package, *inner = (node.module or "").split(".")
    root = next(iter(folder.glob(f"{package}/{package}/__init__.py")), None)
    if root is None:
        return
    imported = root.parent.joinpath(*inner)
    source = imported / "__init__.py" if imported.is_dir() else imported.with_suffix(".py")
    text = source.read_text(encoding="utf-8") if source.exists() else ""
    for alias in node.names:
        if not (re.search(rf"\b{re.escape(alias.name)}\b", text) or (imported / f"{alias.name}.py").exists()):
            raise Fails(f"{module.relative_to(folder)}:{node.lineno}: {node.module} has no {alias.name}")


# -- FMI ----------------------------------------------------------------------------------------------------------


def _fmi(folder: Path, subjects: Sequence[Subject]) -> None:
    """Check that the description of each FMU is XML, and its sources."""
    for description in sorted(folder.glob("*/modelDescription.xml")):
        ET.parse(description)
        sources = description.parent / "sources"
        own = f"-I{sources.relative_to(folder)}"
        _syntax([path.relative_to(folder) for path in sorted(sources.rglob("*.c*"))], folder, own)
    del subjects


_BY_PLATFORM: Mapping[str, Callable[[Path, Sequence[Subject]], None]] = {
    "autosar-classic": _classic,
    "autosar-adaptive": _adaptive,
    "ros2": _ros2,
    "fmi": _fmi,
}
