"""Examples of the Python API run as they are shown, and it is documented as a whole."""

import doctest
import re

from sigcat import _NAMES
from tests.documentation.pages import ROOT, blocks, text_of
from tests.needs import c_compiler

PAGE, RUN_PAGE = "docs/reference/python.md", "docs/how-to/simulate.md"


@c_compiler
def test_the_examples_of_the_page_show_what_is_returned(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for block in (*blocks(RUN_PAGE), *blocks(PAGE)):
        if block.title:
            (tmp_path / block.title).parent.mkdir(exist_ok=True)
            (tmp_path / block.title).write_text(block.text, encoding="utf-8")
    text = "\n".join(block.text for block in blocks(PAGE, "pycon"))
    runner, said = doctest.DocTestRunner(), list[str]()
    result = runner.run(doctest.DocTestParser().get_doctest(text, {}, PAGE, PAGE, 0), out=said.append)
    assert (result.failed, result.attempted > 20) == (0, True), "".join(said)


def test_every_public_name_has_a_signature():
    signatures = (ROOT / "docs/reference/python-api.pyi").read_text(encoding="utf-8")
    named = set(re.findall(r"^(?:class|def) (\w+)", signatures, re.MULTILINE))
    assert named == {name for names in _NAMES.values() for name in names}


def test_the_page_of_assistants_names_every_tool():
    tools = re.findall(
        r"^    def ([a-z]\w*)\(", (ROOT / "app/sigcat/assistants/server.py").read_text("utf-8"), re.MULTILINE
    )
    named = re.findall(r"^\| `(\w+)` \|", text_of("docs/how-to/assistants.md"), re.MULTILINE)
    assert [tool for tool in tools if tool != "all"] == named
