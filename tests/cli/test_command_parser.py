"""Values of options that no command can use are refused before it runs; the message names the option."""

import pytest

from sigcat.cli import main

REFUSED = {
    "no hits": (("search", "wheel", "--limit", "0"), "--limit: must be a whole number greater than 0"),
    "fewer than no hits": (("search", "wheel", "--limit", "-3"), "--limit: must be a whole number greater than 0"),
    "half a hit": (("search", "wheel", "--limit", "1.5"), "--limit: must be a whole number greater than 0"),
    "no time": (("export", "csv", "--timeout", "0"), "--timeout: must be a number greater than 0"),
    "less than no time": (("export", "json", "--timeout", "-1"), "--timeout: must be a number greater than 0"),
    "no number": (("export", "json", "--timeout", "nan"), "--timeout: must be a number greater than 0"),
    "time without end": (("export", "csv", "--timeout", "inf"), "--timeout: must be a number greater than 0"),
    "more than a clock counts": (("export", "csv", "--timeout", "1e300"), "--timeout: must be a number greater than 0"),
    "an empty path": (("lint", ""), "PATH: must be a path, and it is empty"),
    "an empty path among others": (("lint", "vspec", ""), "PATH: must be a path, and it is empty"),
    "an empty tree": (("export", "json", "-s", ""), "-s/--vspec: must be a path, and it is empty"),
    "an empty overlay": (("show", "Vehicle", "-l", ""), "-l/--overlays: must be a path, and it is empty"),
    "an empty output": (("schema", "function", "-o", ""), "-o/--output: must be a path, and it is empty"),
}  # fmt: skip


@pytest.mark.parametrize(("command", "message"), REFUSED.values(), ids=REFUSED)
def test_a_value_that_cannot_be_used_is_refused(command, message, capsys):
    with pytest.raises(SystemExit) as ended:
        main(command)
    assert ended.value.code == 2
    assert message in capsys.readouterr().err


ABBREVIATED = {
    "of an export": (("export", "csv", "--out", "x"), "unknown option --out. Did you mean '--output'?"),
    "with a value": (("export", "json", "--out=x"), "unknown option --out. Did you mean '--output'?"),
    "before a positional argument": (("show", "--vs", "tree", "A"), "unknown option --vs. Did you mean '--vspec'?"),
    "without one": (("simulate", "--tra", "trace.csv"), "unknown option --tra. Did you mean '--trace'?"),
    "of a command of a command": (("function", "validate", "--over", "x", "f"), "Did you mean '--overlays'?"),
    "several": (("lint", "--ex"), "Did you mean '--extend-select'"),
    "near to nothing": (("lint", "--zzzzzz"), "unknown option --zzzzzz\n"),
}  # fmt: skip


@pytest.mark.parametrize(("command", "message"), ABBREVIATED.values(), ids=ABBREVIATED)
def test_an_abbreviated_option_is_refused_with_the_whole_one(command, message, capsys):
    with pytest.raises(SystemExit) as ended:
        main(command)
    assert ended.value.code == 2
    assert message in capsys.readouterr().err
