"""Memory of compiled C on an Arm Cortex-M4 with a unit for floats: sizes, stack, and functions of the compiler's library."""

import re
import struct
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from bench.rows import Missing
from sigcat.adapter.toolchain import EXACT, packaged

_TARGET = ("-target", "thumb-linux-musleabihf", "-mcpu=cortex_m4+vfp4d16sp")
_FLAGS = ("-std=c99", "-Os", "-ffunction-sections", "-fno-unwind-tables", "-fstack-size-section", *EXACT)
_STRINGS, _NO_BITS = 3, 8
"""Types of sections in ELF."""
_WRITTEN, _ALLOCATED = 1, 2
"""Flags of sections."""


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
    return _of_object(made.read_bytes())


class _Section(NamedTuple):
    name: str
    type: int
    flags: int
    content: bytes
    size: int


def _of_object(elf: bytes) -> Memory:
    """Sizes of an object in ELF of 32 bits."""
    sections = [*_sections(elf)]
    placed = [section for section in sections if section.flags & _ALLOCATED]
    bss = sum(section.size for section in placed if section.type == _NO_BITS)
    data = sum(section.size for section in placed if section.type != _NO_BITS and section.flags & _WRITTEN)
    text = sum(section.size for section in placed) - data - bss
    frames = [size for section in sections if section.name == ".stack_sizes" for size in _frames(section.content)]
    names = b"\0".join(section.content for section in sections if section.type == _STRINGS).decode()
    return Memory(text, data, bss, max(frames, default=0), frozenset(re.findall(r"__aeabi_\w+", names)))


def _sections(elf: bytes) -> Iterator[_Section]:
    (table,) = struct.unpack_from("<I", elf, 32)
    length, count, of_names = struct.unpack_from("<HHH", elf, 46)
    heads = [struct.unpack_from("<6I", elf, table + number * length) for number in range(count)]
    names = heads[of_names][4]
    for name, kind, flags, _, offset, size in heads:
        text = elf[names + name : elf.index(b"\0", names + name)].decode()
        yield _Section(text, kind, flags, b"" if kind == _NO_BITS else elf[offset : offset + size], size)


def _frames(content: bytes) -> Iterator[int]:
    """Sizes of frames: of each function its address, and a number of seven bits in each byte."""
    place = 4
    while place < len(content):
        size, shift = 0, 0
        while content[place] & 0x80:
            size |= (content[place] & 0x7F) << shift
            place, shift = place + 1, shift + 7
        yield size | content[place] << shift
        place += 5
