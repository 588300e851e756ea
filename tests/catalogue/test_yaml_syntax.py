"""Advice for errors in the syntax of YAML."""

import pytest

from sigcat.catalogue.reading.yaml_document import read_document

CASES = [
    ("A:\n  type: sensor\n datatype: float\n", 3, "Indent the line with 2 spaces, as line 2, or with no space, as line 1."),
    ("A:\n  type: sensor\n # of A\n\n datatype: float\n", 5, "Indent the line with 2 spaces, as line 2, or with no space, as line 1."),
    ("A:\r\n  b:\r\n      c: 1\r\n    d: 1\r\n", 4, "Indent the line with 6 spaces, as line 3, or with 2 spaces, as line 2."),
    ("A:\n  b:\n    - a\n   - b\n", 4, "Indent the line with 4 spaces, as line 3."),
    ("A:\n  - name: B\n   runnables: 1\n", 3, "Indent the line with 4 spaces, as line 2, or with no space, as line 1."),
    (" A:\n  type: sensor\nB:\n  type: sensor\n", 3, "Indent the line with 1 space, as line 1."),
    ("A:\n  b: >-\n    a\n   c\n", 4, "Indent the line with 4 spaces, as line 3."),
    ("A:\n  b: 1\n  datatype float\nB:\n  c: 1\n", 3, "Write a colon and a space behind the name."),
    ("A:\n\u00a0\u00a0type: sensor\n  b: 1\n", 2, "Indent with spaces: this one is a no-break space."),
    ("A:\n  b: ['C', 'D 'E']\n", 2, "Close the quotation mark of the value before."),
    ("A:\n  b: ['C' 'D']\n", 2, "Write a comma between the values."),
    ("A:\n  b: 1\n- B:\n  b: 1\n", 3, "Remove the hyphen: no list begins here."),
    ("- A:\n  b: 1\nB:\n  b: 1\n", 3, "Remove the hyphen in line 1, or write one here."),
    ("A:\n  b: uint16 c: rpm\n", 2, "Begin a line with `c:`. If the colon belongs to a text, quote the text."),
    ("A:\n  b: Text that\n  goes on and on.\n  c: 1\n", 3,
     "Write a colon and a space behind the name. If the line continues the text above, indent it."),
    ("A:\n  b: 1\n  // note\n  c: 1\n", 3, "Begin a comment with `#`."),
    ("A\n  b: 1\n", 2, "Write a colon behind the name in line 1."),
    ("A:\n  type:sensor\n  datatype: float\n", 2, "Write a space behind the colon."),
    ("A:\n  b: 1\n<<<<<<< HEAD\n  c: 1\n=======\n  c: 2\n>>>>>>> other\n", 3, "Resolve it, and remove the lines that git wrote."),
    ('A:\n  b: "a\n  c: 1\n', 2, "Close the quotation mark that opens here."),
    ("A:\n  b: [a, b\n  c: 1\n", 2, "Close the bracket that opens here."),
    ("A: {b: 1\nB: {c: 1}\n", 1, "Close the bracket that opens here."),
    ("A:\n  b: [a, b]]\n", 2, "Remove it. If it belongs to a text, quote the whole text."),
    ('A:\n  b: "a" b\n', 2, "Remove it. If it belongs to a text, quote the whole text."),
    ('A:\n  b: "\\q"\n', 2, "Write the backslash twice, or use single quotation marks."),
    ("A:\n\tb: 1\n", 2, "Indent with spaces, not with tabs."),
    ("A:\n  b: float\n \tc: float\n", 3, "Indent with spaces, not with tabs."),
    (f"A: 1\n{'B' * 1025}:\n  b: 1\n", 2, "Shorten the name in line 2: it has at most 1,024 characters."),
    (f"{'A' * 1025}:\n  b: 1\n", 1, "Shorten the name in line 1: it has at most 1,024 characters."),
    ("A:\n  b: @c\n", 2, "Quote the text."),
    ("A:\n  b: *c\n", 2, "If the asterisk belongs to a text, quote the text."),
    ("A:\n  b: c: d\n", 2, "Indent the line as those around it. If the colon belongs to a text, quote the text or write it as a block (`>-`)."),
]  # fmt: skip


@pytest.mark.parametrize(("text", "line", "fix"), CASES)
def test_an_error_has_advice(text, line, fix):
    (finding,) = read_document(text.encode(), "a.vspec").findings
    assert (finding.rule, finding.line, finding.fix) == ("R001", line, fix)


@pytest.mark.parametrize("text", [text for text, _, fix in CASES if "as line" in fix])
def test_a_line_that_is_indented_as_the_advice_says_can_be_read(text):
    (finding,) = read_document(text.encode(), "a.vspec").findings
    lines = text.splitlines()
    for place in finding.fix.split(", or "):
        like = lines[int(place.rstrip(".").rpartition(" ")[2]) - 1]
        column = len(like) - len(like.lstrip(" "))
        column += 2 if like.lstrip().startswith("- ") and not lines[finding.line - 1].lstrip().startswith("- ") else 0
        assert f"with {column or 'no'} space" in place
        changed = [*lines[: finding.line - 1], " " * column + lines[finding.line - 1].lstrip(), *lines[finding.line :]]
        findings = read_document("\n".join(changed).encode(), "a.vspec").findings
        assert all(found.line > finding.line for found in findings)
