"""Functions run with a trace: what they send is the same, byte by byte, whoever compiled them."""

import pytest

from scripts.cases import ROOT, RUNS

FOLDER = ROOT / RUNS.folder


@pytest.mark.parametrize("name", RUNS.names)
def test_functions_send_what_is_expected(name):
    assert RUNS.made(name) == RUNS.text(name), "If that is meant, run `make generate`."
