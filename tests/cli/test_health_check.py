"""The health check of the container asks the configured address."""

from pathlib import Path

import pytest

from sigcat.cli.health_check import ready_address


@pytest.fixture(autouse=True)
def project(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("sigcat.toml").write_text("[service]\nport = 9100\n")
    Path("other.toml").write_text("[service]\nport = 9200\n")


@pytest.mark.parametrize(
    ("words", "environment", "address"),
    [
        (["python", "/opt/sigcat/bin/sigcat", "serve"], {}, "127.0.0.1:9100"),
        (["docker-init", "--", "sigcat", "serve", "--port", "9300"], {}, "127.0.0.1:9300"),
        (["sigcat", "serve"], {"SIGCAT_PORT": "9400", "SIGCAT_HOST": "0.0.0.0"}, "127.0.0.1:9400"),
        (["sigcat", "serve", "--config", "other.toml"], {}, "127.0.0.1:9200"),
        (["sigcat", "serve", "--isolated", "--host", "::"], {}, "[::1]:8000"),
        (["uvicorn"], {}, "127.0.0.1:9100"),
    ],
)
def test_it_asks_the_configured_port(monkeypatch, words, environment, address):
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert ready_address(words) == f"http://{address}/health/ready"
