"""Expected outputs in the folders of cases of the tests. Each case is a folder with its expected output.

Review each change of an expected output. If vss-tools accepts the case, tests also compare the output with vss-tools.
"""

import contextlib
import io
import json
import shlex
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.core.clashes import code_problems
from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.cli import main as sigcat
from sigcat.errors import InputRefused
from sigcat.function.declaration.scaffold import SCHEMA_FILE
from sigcat.function.function_file import check_function, checked_file
from sigcat.function.function_json.model import to_json
from sigcat.function.importing.import_code import Imported, import_code
from sigcat.function.sets.check_set import check_functions

ROOT = Path(__file__).parents[1]


class Cases(NamedTuple):
    """A folder of cases, and how what is expected of each is made."""

    folder: str
    expected: str
    """Name of the file."""
    make: Callable[[], str]
    """Runs with the case as the current folder."""

    @property
    def names(self) -> Sequence[str]:
        """Return the cases. No case is an error, so that no test passes for lack of cases."""
        names = sorted(path.name for path in (ROOT / self.folder).iterdir() if path.is_dir())
        assert names, f"There are no cases in {self.folder}."
        return names

    def made(self, name: str) -> str:
        """Return the present output of a case."""
        with contextlib.chdir(ROOT / self.folder / name):
            try:
                return self.make()
            except Exception as error:
                error.add_note(f"This is the case {self.folder}/{name}.")
                raise

    def text(self, name: str) -> str:
        """Return the expected output of a case."""
        return (ROOT / self.folder / name / self.expected).read_text(encoding="utf-8")


def options() -> list[str]:
    """Options of the command line that the case has in a file of that name."""
    file = Path("options")
    return shlex.split(file.read_text(encoding="utf-8")) if file.exists() else []


def export() -> str:
    """The tree as `sigcat export json` writes it, indented."""
    exported = output_of("export", "json", "-s", "tree.vspec", *options())
    return json.dumps(json.loads(exported), indent=2) + "\n"


def findings() -> str:
    """The findings of a tree and its overlays."""
    overlays = [Path(option) for option in options()[1::2]]
    return lines(finding.line_of_text for finding in read_catalogue(Path("tree.vspec"), overlays).findings)


def findings_of_older() -> str:
    """The findings of a tree in the layout of an older release, without what to do."""
    catalogue = load(Source("old", "Old", Path("VehicleSignalSpecification.vspec"), release=""))
    return lines(finding._replace(fix="").line_of_text for finding in catalogue.findings)


def changes() -> str:
    """Return the output of `sigcat diff` for an old and a new tree."""
    return output_of("diff", *sides())


def sides() -> tuple[str, str]:
    """The two trees of a case of `sigcat diff`."""
    return "old.vspec", "new.vspec+overlay.vspec" if Path("overlay.vspec").exists() else "new.vspec"


def function_json() -> str:
    """The Function JSON of a function.yaml, without what it was made from."""
    checked = checked_file(Path("function.yaml").read_bytes(), "function.yaml", _interfaces())
    function = checked.sound_function
    assert function is not None, lines(finding.line_of_text for finding in checked.findings)
    return to_json(function.model_copy(update={"provenance": None})).decode()


def findings_of_function() -> str:
    """The findings of a function.yaml and of the files that it names."""
    file = (Path("function.yaml").read_bytes(), "function.yaml")
    found = check_functions([file], _interfaces(), is_whole=False, check_code=code_problems)
    return lines(finding.line_of_text for finding in found)


def function_of_code() -> str:
    """The function.yaml of C code."""
    return imported(Path.cwd()).text


def findings_of_code() -> str:
    """Return the findings in C code, the tasks left to its author, and the findings in the resulting function.yaml."""
    made = imported(Path.cwd())
    found = check_function(made.text.encode(), "function.yaml", _interfaces())
    return lines([
        *(finding.line_of_text for finding in made.findings),
        f"{made.summary}",
        *(f"To do: {line}" for line in made.to_do),
        *(finding.line_of_text for finding in found),
    ])  # fmt: skip


def refusal_of_code() -> str:
    """Why C code cannot be imported."""
    try:
        imported(Path.cwd())
    except InputRefused as error:
        return lines([*(finding.line_of_text for finding in error.findings), str(error)])
    raise AssertionError("the code was imported")


@cache
def imported(case: Path) -> Imported:
    """The code of a case, with the name of its function, and perhaps that of the model, in `options`."""
    name, *model = shlex.split((case / "options").read_text(encoding="utf-8"))
    return import_code(name, Path("code"), Path(), _interfaces(), SCHEMA_FILE, *model)


def simulated() -> str:
    """Return the outputs of the functions of a case in a run."""
    return output_of("simulate", *options())


@cache
def _interfaces() -> Catalogue:
    """The shipped tree with the overlays of interfaces."""
    return load(next(source for source in shipped_sources() if source.id == "interfaces"))


LANGUAGE = Cases("tests/catalogue/cases", "expected.json", export)
BAD_INPUT = Cases("tests/catalogue/bad", "expected.txt", findings)
OLDER_RELEASES = Cases("tests/catalogue/hosting/older", "expected.txt", findings_of_older)
CHANGES = Cases("tests/catalogue/comparing/cases", "expected.txt", changes)
FUNCTIONS = Cases("tests/function/cases", "expected.json", function_json)
BAD_FUNCTIONS = Cases("tests/function/bad", "expected.txt", findings_of_function)
CODE = Cases("tests/function/importing/cases", "expected.yaml", function_of_code)
CODE_FINDINGS = Cases("tests/function/importing/cases", "expected.txt", findings_of_code)
CODE_REFUSED = Cases("tests/function/importing/refused", "expected.txt", refusal_of_code)
RUNS = Cases("tests/runs/cases", "expected.csv", simulated)
ALL = (
    LANGUAGE, BAD_INPUT, OLDER_RELEASES, CHANGES, FUNCTIONS, BAD_FUNCTIONS, CODE, CODE_FINDINGS, CODE_REFUSED, RUNS,
)  # fmt: skip


def files() -> Mapping[str, str]:
    """Return the expected output of every case."""
    return {f"{cases.folder}/{name}/{cases.expected}": cases.made(name) for cases in ALL for name in cases.names}


def lines(texts: Iterable[str]) -> str:
    """The texts as lines."""
    return "".join(f"{text}\n" for text in texts)


def output_of(*arguments: str) -> str:
    """Return the standard output of a command of sigcat."""
    output, problems = io.TextIOWrapper(io.BytesIO(), "utf-8"), io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(problems):
        status = sigcat(arguments)
    output.seek(0)
    assert status == 0, problems.getvalue()
    return output.read()
