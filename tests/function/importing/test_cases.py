"""C code of each shape gives the function.yaml next to it, and lints up to its paths."""

import pytest

from scripts.cases import CODE, CODE_FINDINGS, CODE_REFUSED, ROOT
from sigcat.cli import main
from sigcat.codes import SIGNAL_UNKNOWN
from tests.function.importing.linting import rules_found


@pytest.mark.parametrize("name", CODE.names)
def test_the_function_is_as_expected(name):
    assert CODE.made(name) == CODE.text(name), "If that is meant, run `make generate`."


@pytest.mark.parametrize("name", CODE_FINDINGS.names)
def test_what_is_said_is_as_expected(name):
    assert CODE_FINDINGS.made(name) == CODE_FINDINGS.text(name), "If that is meant, run `make generate`."


@pytest.mark.parametrize("name", CODE_REFUSED.names)
def test_code_that_cannot_be_imported_says_why(name):
    assert CODE_REFUSED.made(name) == CODE_REFUSED.text(name), "If that is meant, run `make generate`."


@pytest.mark.parametrize("name", CODE.names)
def test_nothing_but_paths_is_left_to_choose(name, tmp_path):
    code = ROOT / CODE.folder / name / "code"
    (tmp_path / "code").symlink_to(code)
    (tmp_path / "function.yaml").write_text(CODE.text(name))
    assert rules_found(tmp_path / "function.yaml") <= {SIGNAL_UNKNOWN.id}


def test_a_chosen_path_is_all_that_is_missing(tmp_path, capsys):
    code = tmp_path / "code"
    code.mkdir()
    (code / "wash.h").write_text("#pragma once\nextern float VehSpd; /* '<Root>/VehSpd' [km/h] */\nextern float Level;\n"
                                 "void wash_init(void);\nvoid wash_step(void);\n")  # fmt: skip
    (code / "wash.c").write_text('#include "wash.h"\nfloat VehSpd;\nfloat Level;\nvoid wash_init(void) {}\n'
                                 "void wash_step(void) { Level = VehSpd; }\n")  # fmt: skip
    assert main(["function", "new", "Washing", "--from-c", str(code)]) == 0
    assert "1 input, 1 output, 0 parameters of wash" in capsys.readouterr().err
    file = code / "function.yaml"
    assert rules_found(file) == {SIGNAL_UNKNOWN.id}
    text = file.read_text()
    assert "path: Vehicle.Speed" in text
    file.write_text(text.replace("Vehicle.TODO.Level", "Vehicle.Powertrain.Range").replace("datatype: float\n", "", 1))
    assert SIGNAL_UNKNOWN.id not in rules_found(file)
