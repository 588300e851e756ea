"""Settings from `[service]` of sigcat.toml and from the environment, which wins. What is not known is refused."""

import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from sigcat import codes
from sigcat.api.settings import Settings
from sigcat.api.validation import reason_of
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.names import did_you_mean

PREFIX = "SIGCAT_"
TABLE = "service"
OTHERS = (
    "SIGCAT_CONFIG", "SIGCAT_DATA", "SIGCAT_DEBUG", "SIGCAT_TOKEN", "SIGCAT_BROWSER", "SIGCAT_FUZZ", "SIGCAT_SLOW",
)  # fmt: skip
"""Variables that are not settings; the last three are for the tests."""
_SET_BY_KUBERNETES = ("SIGCAT_SERVICE_", "SIGCAT_PORT_")


def read_settings(
    table: Mapping[str, Any],
    environment: Mapping[str, str] | None = None,
    file: Path | None = None,
    options: Mapping[str, Any] | None = None,
) -> Settings:
    """The settings, of which `options` are those of the command line. Raises InputRefused with everything that is wrong with them; values of tokens are not repeated."""
    given = os.environ if environment is None else environment
    variables = {name: text for name, text in sorted(given.items()) if name.startswith(PREFIX) and name not in OTHERS}
    findings = [*_unknown(table, file), *_unknown_variables(variables)]
    known = {name.removeprefix(PREFIX).lower(): text for name, text in variables.items()}
    named = options or {}
    values = {**table, **known, **named}
    try:
        settings = Settings(**{name: value for name, value in values.items() if name in Settings.model_fields})
    except ValidationError as error:
        findings += [_wrong(each, _places(known, named), file) for each in error.errors()]
    if findings:
        raise InputRefused("The settings of the service cannot be used.", tuple(findings))
    return settings


def shown(settings: Settings) -> Iterator[tuple[str, str, str]]:
    """Name, value as TOML and description of every setting."""
    for name, field in Settings.model_fields.items():
        yield name, _toml(getattr(settings, name)), field.description or ""


def _unknown(table: Mapping[str, Any], file: Path | None) -> Iterator[Finding]:
    for name in table:
        if name not in Settings.model_fields:
            fix = did_you_mean(name, Settings.model_fields) or "`sigcat config` lists them."
            yield codes.SETTING_UNKNOWN.finding(
                f"Unknown setting {name!r} in [{TABLE}].", str(file or ""), pointer=name, fix=fix
            )


def _unknown_variables(variables: Mapping[str, str]) -> Iterator[Finding]:
    known = [f"{PREFIX}{name.upper()}" for name in Settings.model_fields]
    for name, text in variables.items():
        if name.startswith(_SET_BY_KUBERNETES) or text.startswith("tcp://"):
            fix = "Kubernetes sets it for a service named sigcat: put `enableServiceLinks: false` into the pod."
            yield codes.SETTING_UNKNOWN.finding(f"The environment has {name}.", fix=fix)
        elif name not in known:
            fix = did_you_mean(name, known) or "`sigcat config` lists the settings."
            yield codes.SETTING_UNKNOWN.finding(f"Unknown setting {name!r} for the environment.", fix=fix)


def _places(variables: Iterable[str], options: Iterable[str]) -> dict[str, str]:
    """Return where settings that are not in the file are set, as a user spells them."""
    return {name: f"{PREFIX}{name.upper()}" for name in variables} | {name: f"--{name}" for name in options}


def _wrong(error: Mapping[str, Any], places: Mapping[str, str], file: Path | None) -> Finding:
    name = str(error["loc"][0])
    message = f"{places.get(name, f'[{TABLE}] {name}')}: {reason_of(error)}."
    return codes.SETTING_UNFIT.finding(message, "" if name in places else str(file or ""), pointer=name)


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return str(value)
    if isinstance(value, str):
        return f'"{value}"'
    return f"[{', '.join(_toml(str(item)) for item in value)}]"
