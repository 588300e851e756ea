"""Plain English: pages have none of the phrases in words.yaml, which also has replacements."""

import re
from pathlib import Path

import pytest
import yaml

from tests.documentation.pages import ROOT

WORDS = yaml.safe_load((Path(__file__).parent / "words.yaml").read_text(encoding="utf-8"))
PAGES = sorted(path.relative_to(ROOT).as_posix() for pattern in WORDS["pages"] for path in ROOT.glob(pattern))
PHRASES = [(re.compile(rf"\b(?:{each['phrase']})\b"), each["write"]) for each in WORDS["phrases"]]
EXCEPTIONS = {(each["page"], each["text"]) for each in WORDS["exceptions"]}


def riddles(text):
    """Yield the line number, the phrase and its replacement."""
    for number, line in enumerate(text.splitlines(), 1):
        for phrase, write in PHRASES:
            yield from ((number, found[0], write) for found in phrase.finditer(line))


@pytest.mark.parametrize("page", PAGES)
def test_a_page_is_in_plain_english(page):
    text = (ROOT / page).read_text(encoding="utf-8")
    found = [
        f"{page}:{n}: write {better!r}, not {said!r}"
        for n, said, better in riddles(text)
        if (page, said) not in EXCEPTIONS
    ]
    assert not found, "\n".join(found)


def test_a_phrase_is_found_where_it_is():
    assert list(riddles("It goes on.\nThe file stands beside it.")) == [
        (1, "goes on", "continue"), (2, "stands beside", "is in, is next to, means"),
    ]  # fmt: skip
    assert not list(riddles("It continues. Category, lowland."))
