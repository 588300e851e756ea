"""
Stored values of a node as text: a first line that names the format, then lines of `key: value`.

A value is a flag, a number or numbers with a space between, and is written in one way only.
"""

from math import isinf
import re
from reprlib import repr as shortened
from struct import pack, unpack
from typing import Any, Dict, List, Mapping

FIRST_LINE = 'sigcat 1'
_FLAGS = {'false': False, 'true': True}
_INTEGER = re.compile('0|-?[1-9][0-9]{0,19}')
_DECIMAL = re.compile(r'-?(?:[0-9]+(?:\.[0-9]+)?(?:e[-+]?[0-9]+)?|inf|nan)')


class BrokenFile(ValueError):
    """A file that this package did not write."""


def parse(data: bytes) -> Dict[str, str]:
    """Answer the texts of values by key. Bytes other than ASCII stay what they are."""
    first, *rows = data.decode('ascii', 'surrogateescape').split('\n')
    if first != FIRST_LINE or rows[-1:] != ['']:
        raise BrokenFile(f'the first line is not {FIRST_LINE!r}, or the last one has no end')
    values: Dict[str, str] = {}
    for row in rows[:-1]:
        key, sign, value = row.partition(': ')
        if not sign or not key or key in values:
            raise BrokenFile(f'{shortened(row)} is not one of its lines')
        values[key] = value
    return values


def stored_text(values: Mapping[str, str]) -> bytes:
    """Answer what `parse` reads."""
    rows = [FIRST_LINE, *(f'{key}: {value}' for key, value in sorted(values.items()))]
    return ''.join(f'{row}\n' for row in rows).encode('ascii', 'surrogateescape')


def read_text(text: str, datatype: str) -> Any:
    """Answer the value of a text; the datatype is one of C."""
    value = _value(text, datatype)
    if value is None:
        raise BrokenFile(f'{shortened(text)} is no {datatype}')
    return value


def read_texts(text: str, datatype: str, length: int) -> List[Any]:
    """Answer as many values."""
    values = [read_text(word, datatype) for word in text.split(' ')]
    if len(values) != length:
        raise BrokenFile(f'{shortened(text)} has {len(values)} elements and not {length}')
    return values


def text_of(value: Any, datatype: str) -> str:
    """Answer the shortest text that reads back the same."""
    if datatype == '_Bool':
        return 'true' if value else 'false'
    if datatype == 'float' and value - value == 0:
        texts = (f'{value:.{digits}g}' for digits in range(1, 10))
        return next(text for text in texts if _value(text, datatype) == value)
    return repr(value)


def _value(text: str, datatype: str) -> Any:
    """Answer the value, or None."""
    if datatype == '_Bool':
        return _FLAGS.get(text)
    if datatype in ('float', 'double'):
        return _decimal(text, datatype) if _DECIMAL.fullmatch(text) else None
    return _integer(int(text), datatype) if _INTEGER.fullmatch(text) else None


def _integer(number: int, datatype: str) -> Any:
    bits = int(datatype.strip('uint_t'))
    low, high = (0, 2 ** bits) if datatype[0] == 'u' else (-2 ** (bits - 1), 2 ** (bits - 1))
    return number if low <= number < high else None


def _decimal(text: str, datatype: str) -> Any:
    number = float(text)
    if isinf(number) and not text.endswith('inf'):
        return None
    if datatype == 'double':
        return number
    try:
        return unpack('=f', pack('=f', number))[0]
    except OverflowError:
        return None
