"""Numbers and names that pages state are those of the code."""

import json
import re

import pytest
import yaml

from sigcat import limits
from sigcat.api.settings import Settings
from sigcat.data import INTERFACE_RULES
from sigcat.function.function_json.model import function_schema
from sigcat.limits import DEFAULT_ARCHIVE_LIMITS as ARCHIVE
from sigcat.limits import DEFAULT_FETCH_LIMITS as FETCH
from sigcat.platforms.table import PLATFORMS
from sigcat.rules.record import load_rules
from tests.documentation.pages import PAGES, ROOT, text_of

MIB = 1024 * 1024
GLOSSARY = text_of("docs/reference/glossary.md").split("## The paper's interfaces")[1].split("\n## ")[0]
KNOWN = {
    f"/{path.relative_to(ROOT).as_posix()}"
    for folder in ("app", "docs", "scripts", "tests")
    for path in (ROOT / folder).rglob("*")
}
ROWS = [row.split(" | ") for row in re.findall(r"^\| (.*) \|$", GLOSSARY, re.MULTILINE)]


@pytest.mark.parametrize(
    "statement",
    [
        (
            f"{FETCH.bytes // MIB} MiB, {FETCH.idle_seconds:.0f} s without a byte, {FETCH.total_seconds / 60:.0f} minutes in all,"
            f" {FETCH.redirects} redirects"
        ),
        f"{ARCHIVE.entries:,} files, {ARCHIVE.unpacked_bytes // MIB} MiB unpacked, {ARCHIVE.file_bytes // MIB} MiB in one file",
        f"{ARCHIVE.ratio} times its own size",
        f"{ARCHIVE.path_characters} characters or {ARCHIVE.path_names} names",
    ],
)
def test_releases_are_refused_where_the_page_says(statement):
    assert statement in text_of("docs/reference/releases.md")


def test_the_glossary_names_attributes_that_rules_know():
    fields = {name for rule in load_rules(INTERFACE_RULES) for name in rule.options.get("fields", {})}
    named = {name for row in ROWS for name in re.findall(r"`([a-z]\w+)`", row[1])}
    assert "maturationTime" in named
    assert named <= fields


def test_the_glossary_names_keys_of_function_json():
    keys = set(re.findall(r'"(\w+)": \{', json.dumps(function_schema())))
    named = {name for row in ROWS for name in re.findall(r"`(\w+)`", row[2])}
    assert "Dependancy" in named
    assert named <= keys


def test_files_and_folders_of_code_that_pages_name_are_there():
    named = {
        (name, page)
        for page in PAGES
        for name in re.findall(r"`([\w/]+\.py|\w+/\w+/)`", text_of(page))
        if "NAME" not in name
    }
    endings = {name: f"/{name.rstrip('/')}" for name, _ in named}
    there = {name for name, ending in endings.items() if any(path.endswith(ending) for path in KNOWN)}
    assert sorted(f"{page}: {name}" for name, page in named if name not in there) == []


def test_the_architecture_names_every_room():
    page = text_of("docs/explanation/architecture.md")
    rooms = [path.name for path in (ROOT / "app/sigcat").iterdir() if (path / "__init__.py").exists()]
    assert [room for room in rooms if f"`{room}/`" not in page] == []
    inner = [
        path.name
        for room in rooms
        for path in (ROOT / "app/sigcat" / room).iterdir()
        if (path / "__init__.py").exists()
    ]
    platforms = {platform.section for platform in PLATFORMS.values()}
    assert [room for room in inner if f"`{room}`" not in page and room not in platforms] == []


def test_production_names_settings_and_metrics_that_there_are():
    page = text_of("docs/how-to/production.md")
    folder = ROOT / "app/sigcat/api/middleware"
    metrics = "".join((folder / name).read_text(encoding="utf-8") for name in ("metrics.py", "process_metrics.py"))
    named = set(re.findall(r"`sigcat_(\w+)", page))
    assert len(named) > 5
    assert [
        name for name in named if f'"sigcat_{name.removesuffix("_total").removesuffix("_info")}' not in metrics
    ] == []
    written = set(re.findall(r"`([a-z]+_[a-z_]+)`", page))
    assert "heavy_requests" in written
    assert {name for name in written if not name.startswith(("sigcat_", "process_", "request_id", "trace_id"))} <= set(
        Settings.model_fields
    )
    (user,) = re.findall(r"--uid (\d+)", (ROOT / "Dockerfile").read_text(encoding="utf-8"))
    assert f"user {user}" in page


def test_the_probes_of_kubernetes_ask_what_answers():
    page = text_of("docs/how-to/production.md")
    (pod,) = [
        yaml.safe_load(block)
        for block in re.findall(r"^```yaml\n(containers:.*?)^```$", page, re.MULTILINE | re.DOTALL)
    ]
    (container,) = pod["containers"]
    probes = [probe["httpGet"]["path"] for name, probe in container.items() if name.endswith("Probe")]
    paths = json.loads(text_of("docs/reference/openapi.json"))["paths"]
    assert len(probes) == 3
    assert set(probes) <= paths.keys()
    assert pod["terminationGracePeriodSeconds"] > Settings().stop_seconds


def test_every_limit_has_a_row_that_says_what_it_bounds():
    owners = (limits.Limits, limits.FetchLimits, limits.ArchiveLimits)
    constants = [name for name, value in vars(limits).items() if name.isupper() and isinstance(value, int | float)]
    rows = re.findall(r"^\| \d.* \| [A-Z].*\. \|$", text_of("docs/reference/limits.md"), re.MULTILINE)
    assert len(rows) == sum(len(owner._fields) for owner in owners) + len(constants)
