"""The pipelines and hooks of a project, and what they install."""

import json
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from sigcat import __version__

FILES = Path(__file__).parent / "files"
PIPELINES = {"github": (".github/workflows/signals.yml", "github.yml"), "gitlab": (".gitlab-ci.yml", "gitlab.yml")}
"""By server: where its pipeline is in a repository, and the text of it here."""
HOOKS = ".pre-commit-config.yaml"


def pipeline_text(server: str, source: str) -> str:
    """Return the pipeline for a server. `source` is what pip installs."""
    text = (FILES / PIPELINES[server][1]).read_text(encoding="utf-8")
    return text.replace("__SIGCAT__", source)


def hooks_text() -> str:
    """Return the configuration of pre-commit."""
    return (FILES / "pre-commit.yaml").read_text(encoding="utf-8")


EXTRAS = "c"
"""Extra that lint needs to compare functions with their headers."""


def installed_source() -> str:
    """Return what pip needs to install this sigcat elsewhere, with `EXTRAS`: the commit that it is from, else its version."""
    try:
        origin = json.loads(distribution("sigcat").read_text("direct_url.json") or "{}")
    except PackageNotFoundError:
        origin = {}
    versioned = origin.get("vcs_info", {})
    if versioned.get("vcs") == "git":
        return f"sigcat[{EXTRAS}] @ git+{origin['url']}@{versioned['commit_id']}"
    return f"sigcat[{EXTRAS}]=={__version__}"


def is_from_index(source: str) -> bool:
    """Whether pip looks for a source in a package index."""
    return "==" in source
