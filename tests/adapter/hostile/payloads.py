"""Texts that are code in the languages of generated files, once they get out of their place."""

EVIL = "EVIL_code"
PAYLOADS = (
    f"x */ {EVIL}; /*", f'x"; {EVIL}; "', f"x'; {EVIL}; '", "x\\", f"x\n{EVIL}", f"x\r{EVIL}", f"]]><{EVIL}/>", f"${{{EVIL}}}", f"$({EVIL})",
    f"#) {EVIL}(", f'"""\n{EVIL}\n"""', f"x ??/\n{EVIL}", f"x\0{EVIL}", f"x\u202e{EVIL}", f"x\u2066{EVIL}", f"x\u2028{EVIL}", f"`{EVIL}`",
    f"<script>{EVIL}</script>", f"x; {EVIL}", f"$<{EVIL}:x>", f"@{EVIL}@", f"x // {EVIL}\n", f"%s {{0}} #{EVIL}", f"x {EVIL} " * 1_000,
)  # fmt: skip
