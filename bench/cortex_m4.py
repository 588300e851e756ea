"""Memory of compiled C on an Arm Cortex-M4 with a unit for floats: sizes, stack, and functions of the compiler's library."""

import subprocess
from collections.abc import Iterator, Sequence
from io import BytesIO
from pathlib import Path
from typing import NamedTuple

from elftools.common.construct_utils import ULEB128
from elftools.elf.constants import SH_FLAGS
from elftools.elf.elffile import ELFFile
from elftools.elf.sections import SymbolTableSection

from bench.rows import Missing
from sigcat.adapter.toolchain import EXACT, packaged

_TARGET = ("-target", "thumb-linux-musleabihf", "-mcpu=cortex_m4+vfp4d16sp")
_FLAGS = ("-std=c99", "-Os", "-ffunction-sections", "-fno-unwind-tables", "-fstack-size-section", *EXACT)


class Memory(NamedTuple):
    """Bytes of an object, as `size` of GNU counts them."""

    text: int
    data: int
    bss: int
    stack: int
    """Largest stack frame of its functions."""
    library: frozenset[str] = frozenset()
    """Functions of the compiler's library that it calls, such as `__aeabi_dmul`."""


def memory(source: Path, includes: Sequence[Path]) -> Memory:
    """Compile a source for the controller, and measure the object. Raises Missing without the compiler."""
    clang = packaged()
    if clang is None:
        raise Missing("the compiler of PyPI: pip install ziglang")
    made = source.with_suffix(".m4.o")
    folders = [f"-I{folder}" for folder in includes]
    command = [*clang.c, *_TARGET, *_FLAGS, *folders, "-c", str(source), "-o", str(made)]
    subprocess.run(command, capture_output=True, check=True)
    return _of_object(made)


def _of_object(path: Path) -> Memory:
    """Sizes of an object."""
    with path.open("rb") as file:
        elf = ELFFile(file)
        placed = [each for each in elf.iter_sections() if each["sh_flags"] & SH_FLAGS.SHF_ALLOC]
        bss = sum(each["sh_size"] for each in placed if each["sh_type"] == "SHT_NOBITS")
        written = (each for each in placed if each["sh_flags"] & SH_FLAGS.SHF_WRITE and each["sh_type"] != "SHT_NOBITS")
        data = sum(each["sh_size"] for each in written)
        text = sum(each["sh_size"] for each in placed) - data - bss
        stacks = (each.data() for each in elf.iter_sections() if each.name == ".stack_sizes")
        frames = [size for content in stacks for size in _frames(content)]
        tables = (each for each in elf.iter_sections() if isinstance(each, SymbolTableSection))
        names = (symbol.name for table in tables for symbol in table.iter_symbols())
        library = frozenset(name for name in names if name.startswith("__aeabi_"))
    return Memory(text, data, bss, max(frames, default=0), library)


def _frames(content: bytes) -> Iterator[int]:
    """Sizes of frames: the section has the address of each function, and a number in LEB128."""
    stream = BytesIO(content)
    while stream.read(4):
        yield ULEB128("size").parse_stream(stream)
