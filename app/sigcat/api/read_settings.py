"""Settings from `[service]` of sigcat.toml and from the environment, which wins. What is not known is refused."""

import os
from collections.abc import Iterator, Mapping
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
OTHERS = ("SIGCAT_CONFIG", "SIGCAT_DATA", "SIGCAT_DEBUG", "SIGCAT_BROWSER", "SIGCAT_FUZZ")
"""Variables that are not settings; the last two are for the tests."""
_SET_BY_KUBERNETES = ("SIGCAT_SERVICE_", "SIGCAT_PORT_")


def read_settings(
    table: Mapping[str, Any], environment: Mapping[str, str] | None = None, file: Path | None = None
) -> Settings:
    """The settings. Raises InputRefused with everything that is wrong with them; values of tokens are not repeated."""
    given = os.environ if environment is None else environment
    variables = {name: text for name, text in sorted(given.items()) if name.startswith(PREFIX) and name not in OTHERS}
    findings = [*_unknown(table, file), *_unknown_variables(variables)]
    known = {name.removeprefix(PREFIX).lower(): text for name, text in variables.items()}
    values = {**table, **known}
    try:
        settings = Settings(**{name: value for name, value in values.items() if name in Settings.model_fields})
    except ValidationError as error:
        findings += [_wrong(each, known, file) for each in error.errors()]
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
            yield codes.SETTING_UNKNOWN.finding(f"There is no setting {name!r} in [{TABLE}].", str(file or ""), fix=fix)


def _unknown_variables(variables: Mapping[str, str]) -> Iterator[Finding]:
    known = [f"{PREFIX}{name.upper()}" for name in Settings.model_fields]
    for name, text in variables.items():
        if name.startswith(_SET_BY_KUBERNETES) or text.startswith("tcp://"):
            fix = "Kubernetes sets it for a service named sigcat: put `enableServiceLinks: false` into the pod."
            yield codes.SETTING_UNKNOWN.finding(f"The environment has {name}.", fix=fix)
        elif name not in known:
            fix = did_you_mean(name, known) or "`sigcat config` lists the settings."
            yield codes.SETTING_UNKNOWN.finding(f"There is no setting {name!r} for the environment.", fix=fix)


def _wrong(error: Mapping[str, Any], from_environment: Mapping[str, str], file: Path | None) -> Finding:
    name = str(error["loc"][0])
    where = f"{PREFIX}{name.upper()}" if name in from_environment else f"[{TABLE}] {name}"
    return codes.SETTING_UNFIT.finding(
        f"{where}: {reason_of(error)}.",
        "" if name in from_environment else str(file or ""),
    )


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return str(value)
    if isinstance(value, str):
        return f'"{value}"'
    return f"[{', '.join(_toml(str(item)) for item in value)}]"
