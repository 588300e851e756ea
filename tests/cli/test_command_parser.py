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
