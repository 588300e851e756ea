"""Errors of compilers, taken apart."""

from sigcat.runs.building.diagnostics import Diagnostic, diagnostics


def test_a_file_that_gcc_cannot_read_is_an_error_of_the_file():
    text = "cc1: fatal error: functions/Air.c: Permission denied\ncompilation terminated.\n"
    assert list(diagnostics(text)) == [Diagnostic("functions/Air.c", 0, 0, "Permission denied")]
    assert list(diagnostics(text.replace("cc1", "cc1plus"))) == list(diagnostics(text))
