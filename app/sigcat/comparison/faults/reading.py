"""A file of scenarios is read: everything wrong with it is a finding at its line and column."""

from collections.abc import Collection, Iterator, Mapping
from itertools import pairwise
from typing import Annotated, Literal

from pydantic import BeforeValidator, Field, ValidationError

from sigcat import codes
from sigcat.adapter.host.shapes import Shape
from sigcat.comparison.faults.scenario import Killed, Scenario, Slow, Spoilt
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors, in_order
from sigcat.function.declaration.form import DeclarationModel, Duration, Text
from sigcat.function.document.document import Document
from sigcat.function.document.read_yaml import read_yaml
from sigcat.function.document.structure import structural_findings
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import did_you_mean
from sigcat.runs.recording.cells import Unfit, value_of
from sigcat.runs.recording.times import NANOSECONDS


def _as_text(value: object) -> object:
    """A number, or true, as a trace has it: who writes it needs no quotes."""
    if isinstance(value, bool):
        return str(value).lower()
    return str(value) if isinstance(value, int | float) else value


Cell = Annotated[Text, BeforeValidator(_as_text)]
"""A cell of a trace."""


class _SpoiltForm(DeclarationModel):
    """A fault of a signal."""

    fault: Literal["value", "dropped", "delayed", "doubled"] = Field(description="What becomes of its values.")
    signal: Text = Field(description="Path or interface, as in the trace.")
    start: Duration = Field(description="Start, in s.", alias="from")
    end: Duration = Field(description="Until when, in s.", alias="to")
    value: Cell | None = Field(None, description="What comes instead.")
    by: Duration | None = Field(None, description="How much later it comes, in s.")


class _SentForm(DeclarationModel):
    """A value that comes, too."""

    fault: Literal["sent"] = Field(description="What happens.")
    signal: Text = Field(description="Path or interface, as in the trace.")
    at: Duration = Field(description="When, in s.")
    value: Cell = Field(description="What comes.")


class _SlowForm(DeclarationModel):
    """A call that takes long."""

    fault: Literal["slow"] = Field(description="What happens.")
    call: Text = Field(description="Interface of the call.")
    start: Duration = Field(description="Start, in s.", alias="from")
    end: Duration = Field(description="Until when, in s.", alias="to")
    takes: Duration = Field(description="How long, in s.")


class _KilledForm(DeclarationModel):
    """A function that is gone."""

    fault: Literal["killed"] = Field(description="What happens.")
    function: Text = Field(description="Name of the function.")
    at: Duration = Field(description="When, in s.")


_Fault = _SpoiltForm | _SentForm | _SlowForm | _KilledForm
_Form = Annotated[_Fault, Field(discriminator="fault")]


class _ScenarioForm(DeclarationModel):
    """A scenario."""

    name: Text = Field(description="Short, for files and addresses.")
    title: Text = Field(description="What happens, in a few words.")
    description: str = Field("", description="What the functions have to do.")
    start: Duration = Field(description="Start of the observation, in s.", alias="from")
    end: Duration = Field(description="Until when, in s.", alias="to")
    faults: list[_Form] = Field(min_length=1, description="What happens.")


class _FileForm(DeclarationModel):
    """The file."""

    scenarios: list[_ScenarioForm] = Field(min_length=1, description="In any order.")


def read_scenarios(
    data: bytes,
    name: str,
    signals: Collection[str],
    calls: Collection[str],
    functions: Collection[str],
    shapes: Mapping[str, Shape] = {},
    limits: Limits = DEFAULT_LIMITS,
) -> tuple[Scenario, ...]:
    """The scenarios, in order of time. Raises InputRefused with everything that is wrong; `shapes` are those of signals, by name."""
    document = read_yaml(data, name, limits)
    findings = list(document.findings)
    if not has_errors(findings):
        try:
            form = _FileForm.model_validate(document.value)
        except ValidationError as error:
            findings += structural_findings(error, document, _FileForm)
        else:
            findings += _problems(form, document, {"signal": signals, "call": calls, "function": functions})
            findings += _unfit_values(form, document, shapes)
            if not has_errors(findings):
                return tuple(sorted(map(_scenario, form.scenarios), key=lambda each: (each.start, each.name)))
    raise InputRefused(f"{name} cannot be used as a file of faults.", in_order(findings))


def _problems(form: _FileForm, document: Document, known: dict[str, Collection[str]]) -> Iterator[Finding]:
    seen: set[str] = set()
    for index, scenario in enumerate(form.scenarios):
        at = ("scenarios", index)
        if scenario.name in seen:
            yield _finding(document, (*at, "name"), f"The name {scenario.name!r} must belong to one scenario only.")
        seen.add(scenario.name)
        if scenario.end <= scenario.start:
            yield _finding(document, (*at, "to"), "A scenario must end after it begins.")
        for number, fault in enumerate(scenario.faults):
            yield from _of_fault(fault, scenario, document, (*at, "faults", number), known)
    lasting = [each for each in enumerate(form.scenarios) if not _kills(each[1])]
    ordered = sorted(lasting, key=lambda each: (each[1].start, each[1].end))
    for (_, one), (index, other) in pairwise(ordered):
        if other.start < one.end:
            message = f"Two scenarios must not be watched at one time: {one.name} is, until {one.end:g} s."
            yield _finding(document, ("scenarios", index, "from"), message)


def _unfit_values(form: _FileForm, document: Document, shapes: Mapping[str, Shape]) -> Iterator[Finding]:
    """Values that no platform could be given."""
    for index, scenario in enumerate(form.scenarios):
        for number, fault in enumerate(scenario.faults):
            if not isinstance(fault, _SpoiltForm | _SentForm) or fault.value is None or fault.signal not in shapes:
                continue
            try:
                value_of(fault.value, shapes[fault.signal])
            except Unfit as reason:
                at = ("scenarios", index, "faults", number, "value")
                yield _finding(document, at, f"{fault.signal} {reason}.", reason.fix)


def _kills(scenario: _ScenarioForm) -> bool:
    """Whether it ends the drive that it is in: there may be others at its time."""
    return any(isinstance(fault, _KilledForm) for fault in scenario.faults)


def _of_fault(
    fault: _Fault,
    scenario: _ScenarioForm,
    document: Document,
    at: tuple[str | int, ...],
    known: dict[str, Collection[str]],
) -> Iterator[Finding]:
    word = _WORDS[type(fault)]
    named = getattr(fault, word)
    if named not in known[word]:
        hint = did_you_mean(named, known[word]) or f"It has {', '.join(sorted(known[word])[:_SHOWN])}."
        yield _finding(document, (*at, word), f"{named} is no {word} that the drive has.", hint)
    begin, place = (fault.start, "from") if isinstance(fault, _SpoiltForm | _SlowForm) else (fault.at, "at")
    if not scenario.start <= begin < scenario.end:
        yield _finding(document, (*at, place), "A fault must begin while its scenario is watched.")
    if isinstance(fault, _SpoiltForm | _SlowForm) and fault.end <= fault.start:
        yield _finding(document, (*at, "to"), "A fault must end after it begins.")
    if isinstance(fault, _SpoiltForm):
        yield from _of_spoilt(fault, document, at)


_SHOWN = 10
"""Names that a hint lists, where none is near."""
_WORDS = {_SpoiltForm: "signal", _SentForm: "signal", _SlowForm: "call", _KilledForm: "function"}


def _of_spoilt(fault: _SpoiltForm, document: Document, at: tuple[str | int, ...]) -> Iterator[Finding]:
    needed = {"value": "value", "delayed": "by"}.get(fault.fault)
    for key in ("value", "by"):
        if (getattr(fault, key) is not None) != (key == needed):
            verb = "must say" if key == needed else "has no"
            yield _finding(document, (*at, "fault"), f"A fault `{fault.fault}` {verb} `{key}`.")


def _finding(document: Document, pointer: tuple[str | int, ...], message: str, fix: str = "") -> Finding:
    return document.finding(codes.VALUE_UNFIT, pointer, message, fix=fix)


def _scenario(form: _ScenarioForm) -> Scenario:
    spoilt: list[Spoilt] = []
    slow: list[Slow] = []
    killed: list[Killed] = []
    for fault in form.faults:
        if isinstance(fault, _SpoiltForm):
            window = (_ns(fault.start), _ns(fault.end))
            spoilt.append(Spoilt(fault.fault, fault.signal, *window, fault.value or "", _ns(fault.by or 0)))
        elif isinstance(fault, _SentForm):
            spoilt.append(Spoilt("sent", fault.signal, _ns(fault.at), _ns(fault.at), fault.value))
        elif isinstance(fault, _SlowForm):
            slow.append(Slow(fault.call, _ns(fault.start), _ns(fault.end), _ns(fault.takes)))
        else:
            killed.append(Killed(fault.function, _ns(fault.at)))
    return Scenario(
        form.name, form.title, form.description, _ns(form.start), _ns(form.end),
        tuple(spoilt), tuple(slow), tuple(killed),
    )  # fmt: skip


def _ns(seconds: float) -> int:
    return round(seconds * NANOSECONDS)
