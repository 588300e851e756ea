"""A rule of a company, as it is written in a file of rules."""

OWN_RULE = """\
ACME001:
  name: short-path
  title: Paths are short.
  severity: warning
  why: Long paths do not fit our displays.
  check: path-depth
  options: {most: 3}
  source: ACME
"""
