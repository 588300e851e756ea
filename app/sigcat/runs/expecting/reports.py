"""Differences from expected outputs: findings, a table, a picture of the first ones, and a JUnit report."""

from collections.abc import Iterator, Mapping, Sequence
from xml.etree import ElementTree as ET

from sigcat import codes
from sigcat.adapter.host.shapes import Number
from sigcat.findings import Finding
from sigcat.runs.expecting.comparison import Compared, Difference
from sigcat.runs.recording.cells import cell_of
from sigcat.runs.recording.picture import Beside, picture
from sigcat.runs.recording.samples import Sample
from sigcat.runs.recording.svg_file import stacked
from sigcat.runs.recording.times import seconds
from sigcat.runs.recording.trace_file import Trace, column_in

_MOST_PICTURED = 8
_LONGEST = 40
"""Characters of a value in a table."""
_HEAD = ("output", "compared", "differ", "first at", "expected", "actual", "largest difference")


def findings_of(columns: Sequence[Compared], trace: Trace) -> tuple[Finding, ...]:
    """A finding for each output that differs, where it does so first."""
    return tuple(_finding(each, each.first, trace) for each in columns if each.first is not None)


def _finding(each: Compared, first: Difference, trace: Trace) -> Finding:
    column = column_in(trace, first.line, each.name)
    message = _message(each, first)
    return codes.OUTPUT_UNEXPECTED.finding(message, *trace.place(first.line, column), path=each.name)


def _message(each: Compared, first: Difference) -> str:
    expected, actual = _texts(each, first)
    return f"{each.name} must be {expected} at {seconds(first.time)} s, not {actual}."


def _texts(each: Compared, first: Difference) -> tuple[str, str]:
    """The expected value, and what was there instead."""
    if first.has_ended:
        actual = "nothing: the run has ended"
    else:
        actual = "nothing yet" if first.actual is None else _short(cell_of(first.actual, each.shape))
    return _short(cell_of(first.expected, each.shape)), actual


def _short(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}..."


def summary(columns: Sequence[Compared], file: str) -> str:
    """Say whether all is as expected, with a table of the differences."""
    wrong = [each for each in columns if each.first]
    compared = [each for each in columns if each.total]
    empty = [each.name for each in columns if not each.total]
    without = f" Not compared, as they have no value: {', '.join(empty)}." if empty else ""
    if not wrong:
        return f"All {len(compared)} outputs of {file} are as expected.{without}"
    return f"{len(wrong)} of {len(compared)} outputs differ from {file}.{without}\n{_table(wrong)}"


def _table(wrong: Sequence[Compared]) -> str:
    rows = [_HEAD, *map(_row, wrong)]
    widths = [max(len(row[index]) for row in rows) for index in range(len(_HEAD))]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows
    )


def _row(each: Compared) -> tuple[str, ...]:
    assert each.first is not None
    counts = (str(each.total), str(each.differing))
    return (each.name, *counts, seconds(each.first.time), *_texts(each, each.first), f"{each.largest:.9g}")


# -- a picture ----------------------------------------------------------------------------------------------------


def differences_svg(columns: Sequence[Compared], units: Mapping[str, str]) -> str:
    """A panel for each output that differs, around its first difference, with what is expected as a dashed line."""
    wrong = [each for each in columns if each.first and isinstance(each.shape, Number)]
    drawn = []
    for each in wrong[:_MOST_PICTURED]:
        actual = [Sample(time, each.name, value) for time, value in each.actual]
        expected: Beside = {each.name: [(time, float(value)) for time, value in each.expected]}
        ends = [Sample(time, "", 0) for time, _ in (each.expected[0], each.expected[-1])]
        samples = sorted([*actual, *ends], key=lambda sample: sample.time)
        drawn.append(picture([each.name], {each.name: each.shape}, units, samples, expected))
    return stacked(drawn)


# -- JUnit --------------------------------------------------------------------------------------------------------


def junit(columns: Sequence[Compared], file: str, stop: str = "") -> str:
    """A test case for each expected output; one more for a run that did not come to its end."""
    cases = list(_cases(columns, file))
    if stop:
        cases.append(_case("run", file, stop))
    failures = str(sum(len(case) for case in cases))
    root = ET.Element("testsuites", name="sigcat simulate", tests=str(len(cases)), failures=failures)
    suite = ET.SubElement(root, "testsuite", name=file, tests=str(len(cases)), failures=failures)
    suite.extend(cases)
    ET.indent(root)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ET.tostring(root, encoding="unicode")}\n'


def _cases(columns: Sequence[Compared], file: str) -> Iterator[ET.Element]:
    for each in columns:
        text = f"{_message(each, each.first)} {each.differing} of {each.total} values differ." if each.first else ""
        yield _case(each.name, file, text)


def _case(name: str, file: str, failure: str) -> ET.Element:
    case = ET.Element("testcase", name=name, classname=file)
    if failure:
        ET.SubElement(case, "failure", message=failure.partition("\n")[0]).text = failure
    return case
