"""
The core of a function: an object of a shared library, without ROS.

Times are in nanoseconds. There is no lock here: callers with several threads hold one around
everything but `run`. While `run` runs, other threads of Python continue.
"""

from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple

from cffi import FFI

NO_CALL = 0
NEVER = 2 ** 64 - 1
"""Result of `next_time` if nothing is due any more."""

OK = 0
"""Reply of a method that has run."""

NOT_TESTED, PASSED, PREFAILED, FAILED, HEALING = range(5)
"""States of an error."""


class LayoutError(RuntimeError):
    """The library was not built from what this package was generated with."""


class Call(NamedTuple):
    """A call of the function that runs while it is active."""

    name: str
    """In the library: `Step`."""
    interface: str
    """In the declaration: `CoreAcc_Step`."""
    longest: Optional[int] = None
    """Nanoseconds after which its supervision has to look at it, though it runs."""


class Error(NamedTuple):
    """An error of the function."""

    name: str
    """In the library: `AliveError`."""
    interface: str
    """In the declaration: `CoreAcc_AliveError_ErrorSts`."""
    description: str
    is_mild: bool
    """Whether it is a warning to people while it is failed."""


class ErrorStatus(NamedTuple):
    """State and counts of an error."""

    state: int
    is_confirmed: bool
    occurrences: int
    ignition_cycles: int


class CallCounts(NamedTuple):
    """Activations of a call that did not run."""

    missed: int
    """Activations that came too late."""
    dropped: int
    """Activations that the mode excluded."""


class Leaf(NamedTuple):
    """A number, or an array of numbers, of the stored values."""

    parameter: str
    """Name of the parameter that it is of."""
    key: str
    """`Offset`, `Gains[2].slope`."""
    path: Tuple[Any, ...]
    """Names of members, and numbers of elements."""
    datatype: str
    """In C: `float`."""
    length: Optional[int]


def find_library(package: str, name: str) -> Path:
    """Find a library that a package has installed."""
    from ament_index_python.packages import get_package_prefix

    return Path(get_package_prefix(package)) / 'lib' / f'lib{name}.so'


class Core:
    """Behaviour of all cores. A subclass for each function defines its inputs and outputs."""

    function: str
    """Name of the function, with which all names of the library begin."""
    package: str
    """Package that has the library."""
    library: str
    """Name of the library, without `lib` and `.so`."""
    declarations: str
    """Declarations of the library, in C."""
    digest: str
    """Digest of the input that the library was generated from."""
    structs: Tuple[str, ...]
    """Structs whose layout is compared."""
    calls: Tuple[Call, ...] = ()
    errors: Tuple[Error, ...] = ()
    learned: Mapping[str, str] = {}
    """Parameters that the function changes, and the keys under which they are stored."""

    def __init__(self, library: Optional[Path] = None) -> None:
        """
        Load the library, check it, and take an object of it.

        Without a path, the library is that of the package, as colcon has installed it.
        """
        path = library if library is not None else find_library(self.package, self.library)
        self._ffi: Any = FFI()
        self._ffi.cdef(self.declarations)
        self._lib: Any = self._ffi.dlopen(str(path))
        self._check(path)
        new, free = self._bridge('New'), self._bridge('Free')
        made = new()
        if made == self._ffi.NULL:
            raise RuntimeError(f'{self.function}: there can be no further one in this process')
        self._self: Any = self._ffi.gc(made, free)
        self._runs = [self._of_call(call) for call in self.calls]

    def close(self) -> None:
        """Give the object back. Nothing else may be asked afterwards."""
        self._ffi.release(self._self)

    # -- life ------------------------------------------------------------------------------

    def init(
        self, stored: Optional[Mapping[str, Any]] = None, ignition_cycle: int = 1
    ) -> bool:
        """Initialize the function, with what `stored` has given; False if that has failed."""
        given = self._ffi.NULL
        if stored is not None:
            given = self._ffi.new(f'{self.function}_Adapter_Stored *', dict(stored))
        return bool(self._adapter('Init')(self._self, given, ignition_cycle))

    def start(self, t: int) -> None:
        """Start the clocks."""
        self._adapter('Start')(self._self, t)

    def terminate(self, t: int) -> None:
        """Terminate the function. Afterwards, keep `stored`."""
        self._adapter('Terminate')(self._self, t)

    def stored(self) -> Dict[str, Any]:
        """Copy what is kept from one run to the next."""
        copy = self._ffi.new(f'{self.function}_Adapter_Stored *')
        self._bridge('CopyStored')(self._self, copy)
        return plain_struct(self._ffi, copy[0])

    # -- calls -----------------------------------------------------------------------------

    def next_call(self, t: int) -> int:
        """Answer which call is due: its number from 1 on, or NO_CALL."""
        return int(self._adapter('NextCall')(self._self, t))

    def next_time(self) -> int:
        """Answer when to ask again."""
        return int(self._adapter('NextTime')(self._self))

    def set_input(self, call: int, t: int) -> None:
        """Take the snapshot of the inputs of a call."""
        self._runs[call - 1].set_input(self._self, t)

    def begin(self, call: int, t: int) -> None:
        """Note that a call begins."""
        self._runs[call - 1].begin(self._self, t)

    def run(self, call: int) -> None:
        """Run a call."""
        self._runs[call - 1].run(self._self)

    def get_output(self, call: int, t: int) -> None:
        """Take the outputs of a call that has ended."""
        self._runs[call - 1].get_output(self._self, t)

    def supervise(self, t: int) -> None:
        """Close what has to be closed by now."""
        self._adapter('Supervise')(self._self, t)

    def published(self) -> None:
        """Note that what `publish` names has been sent."""
        self._adapter('Published')(self._self)

    def run_due(self, t: int) -> List[str]:
        """Run everything that is due, for notebooks, and answer the names of these calls."""
        names = []
        call = self.next_call(t)
        while call != NO_CALL:
            self.set_input(call, t)
            self.begin(call, t)
            self.run(call)
            self.get_output(call, t)
            names.append(self.calls[call - 1].interface)
            call = self.next_call(t)
        self.supervise(t)
        return names

    def set_parameters(self, values: Mapping[str, Any]) -> bool:
        """Set parameters, all of them or none; False if one is outside of its limits."""
        if not values:
            return True
        copy = self._ffi.new(f'{self.function}_Adapter_Parameters *')
        self._bridge('CopyParameters')(self._self, copy)
        fields = dict(self._ffi.typeof(copy[0]).fields)
        for name, value in values.items():
            length = fields[name].type.length if fields[name].type.kind == 'array' else None
            if length is not None and len(value) != length:
                raise ValueError(f'{name} must have {length} elements, not {len(value)}')
            setattr(copy, name, value)
        return bool(self._adapter('SetParameters')(self._self, copy))

    # -- what it tells -----------------------------------------------------------------------

    def error_status(self) -> List[ErrorStatus]:
        """Answer what is known of each error, in the order of `errors`."""
        if not self.errors:
            return []
        copies = self._ffi.new(f'{self.function}_Bridge_Error[]', len(self.errors))
        self._bridge('CopyErrors')(self._self, copies)
        return [
            ErrorStatus(each.state, each.is_confirmed, each.occurrences, each.ignition_cycles)
            for each in copies
        ]

    def call_counts(self) -> List[CallCounts]:
        """Answer which activations did not run, in the order of `calls`."""
        if not self.calls:
            return []
        copies = self._ffi.new(f'{self.function}_Bridge_Call[]', len(self.calls))
        self._bridge('CopyCalls')(self._self, copies)
        return [CallCounts(each.missed, each.dropped) for each in copies]

    def learned_leaves(self) -> List[Leaf]:
        """Answer the numbers that learned parameters are made of."""
        if not self.learned:
            return []
        fields = dict(self._ffi.typeof(f'{self.function}_Adapter_Stored').fields)
        return [
            leaf
            for name, key in self.learned.items()
            for leaf in _leaves(name, key, (), dict(fields[name].type.fields)['value'].type)
        ]

    def out(self) -> Any:
        """Copy what is sent."""
        return ()

    def publish(self) -> Any:
        """Copy the values to send now."""
        return ()

    def _run_method(
        self, name: str, arguments: Mapping[str, Any], has_results: bool
    ) -> Tuple[int, Dict[str, Any]]:
        """Run an offered method, which no call may do at this time; reply and results."""
        given: List[Any] = []
        if arguments:
            given.append(self._struct(f'{self.function}_Adapter_{name}_Arguments', arguments))
        results = None
        if has_results:
            results = self._ffi.new(f'{self.function}_Adapter_{name}_Results *')
            given.append(results)
        reply = int(self._adapter(f'Method_{name}')(self._self, *given))
        return reply, {} if results is None else plain_struct(self._ffi, results[0])

    def _copied_request(self, name: str, has_arguments: bool) -> Tuple[int, Dict[str, Any]]:
        """Copy what the function asks for: number and arguments."""
        if not has_arguments:
            return int(self._bridge(f'CopyRequest_{name}')(self._self)), {}
        copy = self._ffi.new(f'{self.function}_Adapter_{name}_Arguments *')
        number = int(self._bridge(f'CopyRequest_{name}')(self._self, copy))
        return number, plain_struct(self._ffi, copy[0])

    def _take_answer(
        self, name: str, number: int, is_ok: bool, results: Optional[Mapping[str, Any]], t: int
    ) -> None:
        """Take an answer; `results` is None for a method that has none."""
        given: List[Any] = []
        if results is not None:
            given.append(self._struct(f'{self.function}_Adapter_{name}_Results', results))
        self._adapter(f'Answer_{name}')(self._self, number, is_ok, *given, t)

    def _array(self, datatype: str, value: Sequence[Any], length: int) -> Any:
        if len(value) != length:
            raise ValueError(f'there must be {length} elements, not {len(value)}')
        return self._ffi.new(f'{datatype}[]', list(value))

    def _struct(self, datatype: str, value: Mapping[str, Any]) -> Any:
        return self._ffi.new(f'{datatype} *', dict(value))

    def _copied(self, what: str) -> Any:
        """Copy `out` or `publish`."""
        copy = self._ffi.new(f'{self.function}_Bridge_{what} *')
        self._bridge(f'Copy{what}')(self._self, copy)
        return copy[0]

    def _plain(self, value: Any) -> Any:
        return plain(self._ffi, value)

    # -- the library -------------------------------------------------------------------------

    def _adapter(self, name: str) -> Any:
        return getattr(self._lib, f'{self.function}_Adapter_{name}')

    def _bridge(self, name: str) -> Any:
        return getattr(self._lib, f'{self.function}_Bridge_{name}')

    def _of_call(self, call: Call) -> '_CallFunctions':
        ways = ('SetInput', 'Begin', 'Run', 'GetOutput')
        return _CallFunctions(*(self._adapter(f'{way}_{call.name}') for way in ways))

    def _check(self, path: Path) -> None:
        """Refuse a library with which values would be read from wrong places."""
        try:
            digest = self._ffi.string(self._bridge('Digest')()).decode()
        except AttributeError:
            raise LayoutError(f'{path} does not have the core of {self.function}') from None
        if digest != self.digest:
            raise LayoutError(f'{path} was generated from another {self.function}: build it again')
        count = self._ffi.new('size_t *')
        found = self._bridge('Layout')(count)
        layout = self._ffi.unpack(found, count[0])
        expected = [number for name in self.structs for number in self._layout_of(name)]
        if layout != expected:
            raise LayoutError(f'{path} has another layout than this machine: build it again')

    def _layout_of(self, name: str) -> Iterator[int]:
        """Answer the size of a struct, and place and size of each of its members."""
        struct = self._ffi.typeof(name)
        yield self._ffi.sizeof(struct)
        for _, field in struct.fields:
            yield field.offset
            yield self._ffi.sizeof(field.type)


class _CallFunctions(NamedTuple):
    """Functions of the library for one call."""

    set_input: Any
    begin: Any
    run: Any
    get_output: Any


def plain(ffi: Any, value: Any) -> Any:
    """Turn a value of C into one of Python: arrays into lists, structs into dictionaries."""
    if not isinstance(value, ffi.CData):
        return value
    datatype = ffi.typeof(value)
    if datatype.kind == 'array':
        return [plain(ffi, element) for element in value]
    return plain_struct(ffi, value)


def plain_struct(ffi: Any, value: Any) -> Dict[str, Any]:
    """Turn a struct of C into a dictionary."""
    names = (name for name, _ in ffi.typeof(value).fields)
    return {name: plain(ffi, getattr(value, name)) for name in names}


def _leaves(name: str, key: str, path: Tuple[Any, ...], datatype: Any) -> Iterator[Leaf]:
    if datatype.kind == 'struct':
        for member, field in datatype.fields:
            yield from _leaves(name, f'{key}.{member}', (*path, member), field.type)
    elif datatype.kind == 'array' and datatype.item.kind == 'struct':
        for index in range(datatype.length):
            yield from _leaves(name, f'{key}[{index}]', (*path, index), datatype.item)
    elif datatype.kind == 'array':
        yield Leaf(name, key, path, datatype.item.cname, datatype.length)
    else:
        yield Leaf(name, key, path, datatype.cname, None)
