"""Whatever a text says, a filter makes it harmless in its place: read by parsers of the languages, it is a comment or a string."""

import ast
import io
import json
import re
import tokenize
from xml.parsers import expat

import pytest
import yaml
from clang.cindex import Index, TokenKind, TranslationUnit

from sigcat.adapter import text_filters
from sigcat.function.document.text import Text

HOSTILE = (
    "*/ int evil; /*", "// */ evil", "*\\/", '"; evil(); "', "'; evil(); '", "evil \\", "evil ??/", "evil \\ ??/ \\\n int evil;",
    "a\nint evil;", "a\r\nint evil;", "a\u2028int evil;", "a\x85int evil;", "a\x0bint evil;", "a\x0cint evil;", "\0int evil;",
    "]]> <evil/> <!-- & ]]>", "<script>evil()</script>", "${evil} $ENV{evil} $(evil) `evil` @evil@ $<evil>", "#) evil #]] evil [[",
    '"""\nevil()\n"""', "'''\nevil()\n'''", '\\"""', '"' * 7, "\\" * 7, "{evil} {{evil}} %s %n %(evil)s", "--- evil: *evil &evil !evil",
    "\u202eevil\u202c \u2066evil\u2069 \u200f\ufeff\u00ad", "\ud800evil\udfff", "\x1b[31mevil\x07", "coding: utf-7 coding=utf-7",
    "- evil", "# evil", "1. evil", "~~~\nevil", "===", "---", "| evil |", "[evil](http://evil) ![evil](evil)", "evil " * 2000, "e" * 10_000,
    "a; b;\\;c", "", " ", "\U0010ffff\ufffe", "Drehzahl in 1/min: größer als 0 °C, 速度",
)  # fmt: skip
VISIBLE = re.compile(r"[^\n\t\0-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff]*")


hostile = pytest.mark.parametrize("text", HOSTILE, ids=lambda text: ascii(text)[:30])


def kinds(code: str, name: str) -> list[TokenKind]:
    """The kinds of the tokens between two that the test knows, as Clang reads them."""
    source = f"int before;\n{code}\nint after;\n"
    options = ["-trigraphs", "-std=c99"] if name.endswith(".c") else ["-trigraphs", "-std=c++14"]
    unit: TranslationUnit = Index.create().parse(name, options, unsaved_files=[(name, source)])
    found = list(unit.get_tokens(extent=unit.cursor.extent))
    assert [each.spelling for each in found[:3]] == ["int", "before", ";"]
    assert [each.spelling for each in found[-3:]] == ["int", "after", ";"]
    return [each.kind for each in found[3:-3]]


@hostile
def test_a_comment_is_one_line_of_printable_characters(text):
    for made in (text_filters.comment(text), *text_filters.ros_comment_rows(text, "km", 100)):
        assert VISIBLE.fullmatch(made)
        made.encode()
        assert text_filters.comment(made) == made


@hostile
def test_comments_of_c_end_where_they_end(text):
    made = text_filters.block_comment(text)
    assert kinds(made, "a.c") == kinds(made, "a.cpp") == [TokenKind.COMMENT] * bool(made)
    rows = text_filters.comment_rows(text, "//", 60)
    assert kinds("\n".join(rows), "a.cpp") == [TokenKind.COMMENT] * len(rows)


@hostile
def test_strings_of_c_end_where_they_end(text):
    made = text_filters.c_string(text)
    assert made.isascii()
    assert "/*" not in made
    assert kinds(made, "a.c") == kinds(made, "a.cpp") == [TokenKind.LITERAL]
    assert "%" not in text_filters.c_format(text).replace("%%", "")
    pieces = text_filters.c_strings(text, 60)
    assert kinds("\n".join(pieces), "a.cpp") == [TokenKind.LITERAL] * len(pieces)


@hostile
def test_strings_of_c_keep_what_they_can(text):
    written = text_filters.c_string(text)[1:-1].encode()
    read = re.sub(rb"\\([0-7]{3})", lambda found: bytes([int(found[1], 8)]), written).decode()
    assert read == re.sub("[\0\ud800-\udfff]", lambda found: f"[U+{ord(found[0]):04X}]", text)


@hostile
def test_python_reads_strings_docstrings_and_comments(text):
    assert ast.literal_eval(text_filters.python_string(text)) == text
    pieces = "\n".join(text_filters.python_strings(text, 60))
    assert ast.literal_eval(f"({pieces})") == text
    (body,) = ast.parse(f'"""{text_filters.docstring_text(text)}"""').body
    assert isinstance(body, ast.Expr)
    assert isinstance(body.value, ast.Constant)
    rows = text_filters.comment_rows(text, "#", 60)
    whole = "\n".join((*rows, "after = 1\n")).encode()
    assert tokenize.detect_encoding(io.BytesIO(whole).readline)[0] == "utf-8"
    tokens = [token for token in tokenize.tokenize(io.BytesIO(whole).readline) if token.type == tokenize.COMMENT]
    assert len(tokens) == len(rows)
    assert len(ast.parse(whole).body) == 1


@hostile
def test_cmake_finds_no_reference_list_or_end_of_an_argument(text):
    assert not set('"\\$;@\n') & set(text_filters.cmake_argument(text))
    assert re.fullmatch(r'[\w./+-]+|"[^"\\$;@\n]*"', text_filters.cmake_word(text))


@hostile
def test_xml_has_one_element_and_one_attribute(text):
    found: list[tuple[str, dict[str, str]]] = []
    parser = expat.ParserCreate()
    parser.StartElementHandler = lambda name, attributes: found.append((name, attributes))
    made = text_filters.xml_text(text)
    parser.Parse(f'<a b="{made}">{made}</a>', True)
    assert [(name, list(attributes)) for name, attributes in found] == [("a", ["b"])]


@hostile
def test_yaml_reads_strings_and_comments(text):
    made = text_filters.yaml_string(text)
    rows = "\n".join(text_filters.comment_rows(text, "#", 60))
    expected = re.sub("[\0\ud800-\udfff]", lambda found: f"[U+{ord(found[0]):04X}]", text)
    assert yaml.safe_load(f"{rows}\na: {made}\nb: 1\n") == {"a": expected, "b": 1}


@hostile
def test_markdown_has_no_markup(text):
    made = text_filters.markdown(text)
    assert "<" not in made
    assert VISIBLE.fullmatch(made)
    assert not re.search(r"(?<!\\)(?:\\\\)*[`*_\[\]|#~]", made)
    assert not re.match(r"(?:[-+]|\d+[.)])(?: |$)|[-=]+$", made)
    code = text_filters.markdown_code(text)
    assert code.count("`") == 2
    assert not re.search(r"(?<!\\)\|", code)


@hostile
def test_labels_of_mermaid_have_no_quotation_mark(text):
    assert not set('"<>[](){}|&\n') & set(text_filters.mermaid_text(text))


@hostile
def test_constants_of_messages_are_one_string_on_one_line(text):
    made = text_filters.ros_string(text)
    assert VISIBLE.fullmatch(made)
    assert re.fullmatch(r'"(?:[^"\\]|\\")*"', made)


@hostile
def test_a_text_is_filtered_as_its_characters_are(text):
    for name in (
        "comment",
        "c_string",
        "cmake_argument",
        "python_string",
        "xml_text",
        "markdown",
        "yaml_string",
        "arxml_text",
    ):
        written = getattr(text_filters, name)
        assert written(Text(text)) == written(text)


def test_what_is_plain_stays_as_it_is():
    text = "Speed of the vehicle, in km/h (at least 0.5 °C)."
    assert text_filters.block_comment(text) == f"/* {text} */"
    assert text_filters.markdown(text) == text_filters.xml_text(text) == text_filters.cmake_argument(text) == text
    assert text_filters.comment_rows("Unit of the speed", "//", 12) == ["// Unit of", "// the speed"]
    assert text_filters.ros_comment_rows("Speed [of] it", "km/h", 80) == ["# Speed (of) it [km/h]"]
    assert json.loads(text_filters.yaml_string(text)) == text


def test_characters_that_nobody_sees_become_their_numbers():
    assert text_filters.comment("a\u202eb\0") == "a[U+202E]b[U+0000]"
    assert text_filters.markdown("a\u202eb") == r"a\[U+202E\]b"
