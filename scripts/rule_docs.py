"""Write docs/reference/rules.md from interface_rules/; with --check, say whether it is up to date."""

import sys
from pathlib import Path

from sigcat.data import INTERFACE_RULES
from sigcat.rules.pages import rule_book
from sigcat.rules.record import load_rules

TARGET = Path(__file__).parents[1] / "docs" / "reference" / "rules.md"


def main(arguments: list[str]) -> int:
    """Exit code 1 if the document is not up to date."""
    text = rule_book(load_rules(INTERFACE_RULES))
    if "--check" not in arguments:
        TARGET.parent.mkdir(exist_ok=True)
        TARGET.write_text(text, encoding="utf-8")
        return 0
    if TARGET.is_file() and TARGET.read_text(encoding="utf-8") == text:
        return 0
    print("docs/reference/rules.md is not up to date: run scripts/rule_docs.py.")
    return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
