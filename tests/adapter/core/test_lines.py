"""Long lines of C are broken between words of code, and nowhere else."""

import pytest
from clang.cindex import Index, TokenKind

from sigcat.adapter.core.c.text.lines import Line, code_of, lines, replaced, wrapped
from sigcat.adapter.long_lines import ROS, C, broken
from sigcat.function.document.text_filters import block_comment, c_string

HOSTILE = "evil(evil, evil) || evil = evil /* evil */ evil; " * 8


def kinds(text: str) -> list[TokenKind]:
    """Kinds of the tokens of a line, as it is broken."""
    source = "\n".join(line.text for line in wrapped((Line(text),)))
    unit = Index.create().parse("a.cpp", unsaved_files=[("a.cpp", source)])
    return [token.kind for token in unit.get_tokens(extent=unit.cursor.extent)]


@pytest.mark.parametrize("layout", [C, ROS])
def test_a_line_is_broken_between_words(layout):
    text = f"value = first({', '.join(['second'] * 30)});"
    rows = broken(text, layout)
    assert max(map(len, rows)) <= layout.widest
    assert "".join(rows).replace(" ", "") == text.replace(" ", "")


def test_a_call_without_arguments_stays_whole():
    rows = broken(f"  first = {'long_' * 16}name(), second();", ROS)
    assert len(rows) > 1
    assert not [row for row in rows if row.endswith("(")]


def test_a_string_stays_whole():
    found = kinds(f"value = first(second, {c_string(HOSTILE)}, third);")
    assert found.count(TokenKind.LITERAL) == 1
    assert found.count(TokenKind.IDENTIFIER) == 4


def test_a_comment_stays_one():
    assert kinds(f"// {'evil(' * 60}") == [TokenKind.COMMENT]
    assert kinds(block_comment(HOSTILE)) == [TokenKind.COMMENT]
    assert kinds(f"first = second; {block_comment(HOSTILE)}").count(TokenKind.COMMENT) == 1


COMMENTS = ("/* t, self */", '"t, self"', "// t, self", "/* t\n * self */")


@pytest.mark.parametrize("comment", COMMENTS)
def test_comments_and_strings_are_not_code(comment):
    assert code_of(lines(f"a {comment}\nb")).split() == ["a", "b"]
    assert replaced("self", "me", lines(f"self {comment}")) == lines(f"me {comment}")
