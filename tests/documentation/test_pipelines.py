"""The pipelines of the page run: with real git, and with a local server in place of the API of comments."""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

import pytest
import yaml

from sigcat.cli import main
from sigcat.project.starting.ci import pipeline_text
from tests.documentation.pages import ROOT, blocks, text_of

PIPELINE = "docs/how-to/pipeline.md"
SOURCE = "sigcat[c] @ git+https://example.org/your/copy/of/sigcat@REVISION"
TITLES = {"github": ".github/workflows/signals.yml", "gitlab": ".gitlab-ci.yml"}
MARK = "<!-- sigcat diff -->"
NOISE = """\
Vehicle.Cabin.AcmeNoise:
  type: sensor
  datatype: float
  unit: dB
  owner: Cabin team
  description: Sound pressure level at the ears of the driver.
"""


def shown(server):
    return next(each.text for each in blocks(PIPELINE) if each.title == TITLES[server])


@pytest.mark.parametrize("server", TITLES)
def test_the_page_shows_what_init_writes(server):
    assert pipeline_text(server, SOURCE) == shown(server)


class Comments(BaseHTTPRequestHandler):
    """The comments of one pull request, as GitHub and GitLab list, add and replace them."""

    found: list[dict[str, Any]]

    def _read(self) -> str:
        assert self.headers["Authorization"] == "Bearer secret" or self.headers["PRIVATE-TOKEN"] == "secret"
        text: str = json.loads(self.rfile.read(int(self.headers["Content-Length"])))["body"]
        assert len(text) <= 65_000
        return text

    def _answer(self, data: object) -> None:
        body = json.dumps(data).encode()
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def do_GET(self) -> None:
        match = re.search(r"/repos/acme/signals/issues/7/comments\?|/projects/5/merge_requests/7/notes\?", self.path)
        assert match
        page = int(re.findall(r"[?&]page=(\d+)", self.path)[0])
        self._answer(self.found[(page - 1) * 100 : page * 100])

    def do_POST(self) -> None:
        assert self.path.endswith(("/repos/acme/signals/issues/7/comments", "/projects/5/merge_requests/7/notes"))
        self._add(self._read(), "github-actions[bot]")
        self._answer(self.found[-1])

    def _replace(self) -> None:
        assert re.search(r"/issues/comments/\d+$|/merge_requests/7/notes/\d+$", self.path)
        [comment] = [each for each in self.found if str(each["id"]) == self.path.rpartition("/")[2]]
        comment["body"] = self._read()
        self._answer(comment)

    do_PATCH = do_PUT = _replace  # noqa: N815 — names that the server calls

    @classmethod
    def _add(cls, body: str, login: str) -> None:
        cls.found.append({"id": len(cls.found) + 100, "body": body, "user": {"login": login}})

    def log_message(self, *_arguments: object) -> None:
        """Say nothing."""


@pytest.fixture
def comments() -> Iterator[tuple[str, list[dict[str, Any]]]]:
    Comments.found = []
    for number in range(130):  # the comment to replace is on the second page
        Comments._add(f"Remark {number}", "a user")
    Comments._add(f"{MARK} quoted by another user"[5:], "a user")
    with ThreadingHTTPServer(("127.0.0.1", 0), Comments) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{server.server_port}", Comments.found
        server.shutdown()
        thread.join()


@pytest.fixture
def clone(tmp_path, monkeypatch):
    """A clone in which a branch has left main."""
    if not (shutil.which("curl") and shutil.which("jq")):
        pytest.skip("curl and jq: install them")
    for name in ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", os.devnull)
    (tmp_path / "bin").mkdir()
    for name, text in {
        "sigcat": f'exec {shlex.quote(sys.executable)} -m sigcat.cli "$@"',
        "pip": "exit 0",
        "apt-get": "exit 0",
    }.items():
        (tmp_path / "bin" / name).write_text(f"#!/bin/sh\n{text}\n")
        (tmp_path / "bin" / name).chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}:{os.environ['PATH']}")
    monkeypatch.setenv("PYTHONPATH", str(ROOT / "app"))
    origin = tmp_path / "origin"
    git(tmp_path, "init", "--quiet", "--bare", "--initial-branch", "main", str(origin))
    folder = tmp_path / "clone"
    git(tmp_path, "clone", "--quiet", str(origin), str(folder))
    git(folder, "switch", "--quiet", "--create", "main")
    assert main(["init", str(folder)]) == 0
    commit(folder, "first")
    git(folder, "push", "--quiet", "origin", "main")
    git(folder, "switch", "--quiet", "--create", "topic")
    return folder


def git(folder, *arguments):
    identity = ["-c", "user.name=Test", "-c", "user.email=test@example.org"]
    done = subprocess.run(["git", *identity, *arguments], cwd=folder, check=True, capture_output=True, text=True)
    return done.stdout.strip()


def change_datatype(folder):
    overlay = folder / "overlays/cabin.vspec"
    overlay.write_text(overlay.read_text().replace("datatype: float", "datatype: double"))


def commit(folder, message):
    git(folder, "add", "--all")
    git(folder, "commit", "--quiet", "--message", message)


def run(folder, script, **environment):
    return subprocess.run(
        ["bash", "-e", "-o", "pipefail", "-c", script],
        cwd=folder, env={**os.environ, **environment}, capture_output=True, text=True, check=False, timeout=300,
    )  # fmt: skip


def run_github(folder, address):
    """Run the steps of the workflow, with what GitHub sets. Return the names of those that failed."""
    failed = []
    for step in yaml.safe_load(shown("github"))["jobs"]["signals"]["steps"]:
        if "run" in step:
            secrets = {"NUMBER": "7", "TOKEN": "secret"} if "env" in step else {}
            done = run(
                folder, step["run"], GITHUB_API_URL=address, GITHUB_REPOSITORY="acme/signals", GITHUB_BASE_REF="main",
                SIGCAT="sigcat", **secrets,
            )  # fmt: skip
            failed += [step["name"]] if done.returncode else []
            assert done.returncode in (0, 1), done.stderr
    return failed


def run_gitlab(folder, address):
    """Run the jobs of the pipeline, with what GitLab sets. Return the names of those that failed."""
    pipeline = yaml.safe_load(shown("gitlab"))
    failed = []
    for name in ("lint", "compatibility"):
        done = run(
            folder, "\n".join((*pipeline["default"]["before_script"], *pipeline[name]["script"])),
            CI_API_V4_URL=address, CI_PROJECT_ID="5", CI_MERGE_REQUEST_IID="7", SIGCAT_COMMENT_TOKEN="secret",
            CI_MERGE_REQUEST_DIFF_BASE_SHA=git(folder, "merge-base", "origin/main", "HEAD"), SIGCAT="sigcat",
        )  # fmt: skip
        failed += [name] if done.returncode else []
        assert done.returncode in (0, 1), done.stderr
    return failed


@pytest.mark.parametrize("run_pipeline", [run_github, run_gitlab])
def test_a_pull_request_has_one_comment_and_the_gate_closes_at_a_breaking_change(clone, comments, run_pipeline):
    address, found = comments
    before = len(found)
    (clone / "overlays/noise.vspec").write_text(NOISE)
    commit(clone, "more")
    assert run_pipeline(clone, address) == []
    assert [each["body"].startswith(MARK) for each in found[before:]] == [True]
    assert "- Added: `Vehicle.Cabin.AcmeNoise`" in found[-1]["body"]
    change_datatype(clone)
    commit(clone, "breaking")
    assert run_pipeline(clone, address)[-1].lower() == "compatibility"
    assert len(found) == before + 1
    assert "1 breaking" in found[-1]["body"]


def test_a_generated_file_that_was_never_committed_fails(clone):
    script = text_of(PIPELINE).split("## Keep generated files")[1].split("```sh\n")[1].split("```")[0]
    script = script.replace("examples/core_acc/function.yaml", "functions/cabin_air/function.yaml")
    assert run(clone, script).returncode == 1
    commit(clone, "generated")
    assert run(clone, script).returncode == 0
    change_datatype(clone)
    assert run(clone, script).returncode == 1
