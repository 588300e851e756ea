"""Read the vehicles of a project: `[[vehicle]]`, with `[[vehicle.state]]` for what changes in its life.

```toml
[[vehicle]]
id = "coupe"
catalogue = "body"                    # default: the first catalogue
without = ["Vehicle.Cabin.Sunroof"]   # paths and wildcards
with = ["overlays/trailer.vspec"]
instances = {"Vehicle.Cabin.Seat" = 1}
attributes = {steering = "left"}

[[vehicle.state]]
id = "ota-2"
release = "OTA 2"
without = []
```

A state builds on the one before it, the first one on the vehicle. Each list replaces the one before.
"""

import datetime as dt
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.model.vehicle import Setting, Vehicle
from sigcat.findings import first_at
from sigcat.limits import INSTANCE_ROWS, VEHICLES
from sigcat.names import did_you_mean
from sigcat.project.project_file import Reading, paths_of

_FACTS = ("sop", "year", "release")
_CONFIGURATION: Mapping[str, type] = {"instances": dict, "attributes": dict, "without": list, "with": list}
STATE_KEYS: Mapping[str, type] = {"id": str, **dict.fromkeys(_FACTS, object), **_CONFIGURATION}
VEHICLE_KEYS: Mapping[str, type] = {"id": str, "title": str, "catalogue": str, "state": list, **STATE_KEYS}
_INSTANCE = r"\w+(?:\[\d+,\d+\])?"
_ID = r"[A-Za-z0-9][A-Za-z0-9._-]{0,63}"


class _Configured(NamedTuple):
    """The configuration of a vehicle, or of one of its states."""

    labels: Mapping[str, str] = {}
    instances: Mapping[str, Setting] = {}
    defaults: Mapping[str, Setting] = {}
    without: tuple[Setting, ...] = ()
    overlays: tuple[Path, ...] = ()


def read_vehicles(listed: Any, catalogues: Sequence[str], reading: Reading) -> tuple[Vehicle, ...]:
    """Return the vehicles, one for each state. `catalogues` are the ids that they may name, the default one first."""
    if not isinstance(listed, list):
        return ()
    vehicles: list[Vehicle] = []
    known: dict[str, int] = {}
    for number, values in enumerate(listed):
        if not isinstance(values, dict):
            reading.report(codes.SETTING_UNFIT, "`vehicle` must be tables: [[vehicle]].", "", 0, "vehicle")
            break
        table = f"vehicle[{number}]"
        reading.check(values, VEHICLE_KEYS, table)
        vehicle_id = _id_of(values, table, "vehicle", known, reading)
        vehicles += _states(values, vehicle_id, table, _catalogue_of(values, table, catalogues, reading), reading)
        if len(vehicles) > VEHICLES:
            message = f"The vehicles have more than {VEHICLES:,} states."
            reading.report(codes.SETTING_UNFIT, message, table, 0, fix="Split the project.")
            break
    return tuple(vehicles)


def _states(
    values: Mapping[str, Any], vehicle_id: str, table: str, catalogue: str, reading: Reading
) -> Iterator[Vehicle]:
    title = values.get("title")
    line = reading.lines.line(reading.place(table))
    vehicle = Vehicle(vehicle_id, title if isinstance(title, str) else vehicle_id, catalogue, str(reading.file), line)
    configured = _configured(values, table, _Configured(), reading)
    listed = values.get("state")
    if not listed or not isinstance(listed, list):
        yield _with(vehicle, configured)
        return
    known: dict[str, int] = {}
    for number, state in enumerate(listed):
        if not isinstance(state, dict):
            reading.report(codes.SETTING_UNFIT, "`state` must be tables: [[vehicle.state]].", table, 0, "state")
            return
        below = f"{table}.state[{number}]"
        below = below if reading.lines.position(reading.place(below))[1] else table
        reading.check(state, STATE_KEYS, below)
        configured = _configured(state, below, configured, reading)
        name = _id_of(state, below, "state", known, reading)
        yield _with(vehicle._replace(state=name, line=reading.lines.line(reading.place(below))), configured)


def _with(vehicle: Vehicle, configured: _Configured) -> Vehicle:
    return vehicle._replace(
        labels=tuple(configured.labels.items()),
        instances=tuple(configured.instances.values()),
        defaults=tuple(configured.defaults.values()),
        without=configured.without,
        overlays=configured.overlays,
    )


def _id_of(values: Mapping[str, Any], table: str, kind: str, known: dict[str, int], reading: Reading) -> str:
    name = values.get("id")
    if name is None:
        reading.report(codes.CATALOGUE_INCOMPLETE, f"The {kind} has no `id`.", table, 0)
    elif isinstance(name, str) and not re.fullmatch(_ID, name):
        message = f"`id` must be letters, digits, '.', '_' and '-', not {name[:80]!r}."
        reading.report(codes.SETTING_UNFIT, message, table, 0, "id")
    elif name == "all":
        message = "`id` must not be 'all', which names every vehicle in `--vehicles all`."
        reading.report(codes.SETTING_UNFIT, message, table, 0, "id")
    elif isinstance(name, str) and name in known:
        message = f"Two {kind}s have the id {name!r}, {first_at(str(reading.file), known[name])}."
        reading.report(codes.ID_GIVEN_TWICE, message, table, 0, "id")
    elif isinstance(name, str):
        known[name] = reading.lines.position(reading.place(table), 0, "id")[0]
    return name if isinstance(name, str) else ""


def _catalogue_of(values: Mapping[str, Any], table: str, catalogues: Sequence[str], reading: Reading) -> str:
    name = values.get("catalogue", catalogues[0])
    if isinstance(name, str) and name not in catalogues:
        fix = did_you_mean(name, catalogues) or f"Known are {', '.join(catalogues)}."
        message = f"Unknown catalogue {name[:80]!r}."
        reading.report(codes.VEHICLE_NODE_UNKNOWN, message, table, 0, "catalogue", fix, name)
    return name if isinstance(name, str) else ""


def _configured(values: Mapping[str, Any], table: str, before: _Configured, reading: Reading) -> _Configured:
    attributes = values.get("attributes")
    named = dict(_flat(attributes)) if isinstance(attributes, dict) else {}
    facts = {name: values[name] for name in _FACTS if name in values}
    facts |= {name: value for name, value in named.items() if "." not in name}
    paths = {name: value for name, value in named.items() if "." in name}
    instances = values.get("instances")
    return _Configured(
        {**before.labels, **dict(_labels(facts, table, reading))},
        {**before.instances, **dict(_instances(instances if isinstance(instances, dict) else {}, table, reading))},
        {**before.defaults, **dict(_defaults(paths, table, reading))},
        tuple(_without(values["without"], table, reading)) if "without" in values else before.without,
        paths_of(values, "with", table, 0, reading) if "with" in values else before.overlays,
    )


def _labels(facts: Mapping[str, Any], table: str, reading: Reading) -> Iterator[tuple[str, str]]:
    for name, value in facts.items():
        if isinstance(value, bool):
            yield name, "yes" if value else "no"
        elif isinstance(value, str | int | float | dt.date):
            yield name, str(value)
        else:
            key = name if name in _FACTS else f"attributes.{name}"
            message = f"`{name}` must be text, a number, a date, true or false, not {repr(value)[:60]}."
            _report(message, table, key, reading)


def _instances(named: Mapping[str, Any], table: str, reading: Reading) -> Iterator[tuple[str, Setting]]:
    for path, value in _flat(named):
        key = f"instances.{path}"
        if isinstance(value, int) and not isinstance(value, bool) and not 1 <= value <= INSTANCE_ROWS:
            _report(f"The rows of {path!r} must be from 1 to {INSTANCE_ROWS:,}, not {value}.", table, key, reading)
        elif isinstance(value, bool) or not isinstance(value, int | str | list):
            _report(f"The instances of {path!r} must be a number of rows, or a list.", table, key, reading)
        elif isinstance(value, list) and not _is_list_of_instances(value):
            message = f"The instances of {path!r} must be a list of different names such as 'Left' or 'Row[1,2]', or of such lists."
            _report(message, table, key, reading)
        else:
            yield path, _setting(path, value, table, key, reading)


def _is_list_of_instances(value: list[Any]) -> bool:
    levels = [entry for entry in value if isinstance(entry, list)]
    return all(map(_are_names, (*levels, [entry for entry in value if not isinstance(entry, list)])))


def _are_names(names: list[Any]) -> bool:
    """Whether all are names of instances, each once."""
    are_texts = all(isinstance(name, str) and re.fullmatch(_INSTANCE, name) for name in names)
    return are_texts and len(set(names)) == len(names)


def _defaults(paths: Mapping[str, Any], table: str, reading: Reading) -> Iterator[tuple[str, Setting]]:
    for path, value in paths.items():
        key = f"attributes.{path}"
        items = value if isinstance(value, list) else [value]
        if all(isinstance(item, str | int | float) for item in items):
            yield path, _setting(path, value, table, key, reading)
        else:
            message = f"The value of {path!r} must be text, a number, true or false, or a list of these."
            _report(message, table, key, reading)


def _without(listed: Any, table: str, reading: Reading) -> Iterator[Setting]:
    for path in listed if isinstance(listed, list) else ():
        if isinstance(path, str):
            yield Setting(path, True, *reading.lines.position(reading.place(table), 0, "without", path))
        else:
            _report("`without` must be a list of paths and wildcards.", table, "without", reading)


def _setting(path: str, value: Any, table: str, key: str, reading: Reading) -> Setting:
    return Setting(path, _frozen(value), *reading.lines.position_below(reading.place(table), key))


def _frozen(value: Any) -> Any:
    return tuple(_frozen(item) for item in value) if isinstance(value, list) else value


def _flat(named: Mapping[str, Any], above: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the values by path; a path without quotation marks is tables in tables."""
    for name, value in named.items():
        if isinstance(value, dict):
            yield from _flat(value, f"{above}{name}.")
        else:
            yield f"{above}{name}", value


def _report(message: str, table: str, key: str, reading: Reading) -> None:
    line, column = reading.lines.position_below(reading.place(table), key)
    reading.findings.append(codes.SETTING_UNFIT.finding(message, str(reading.file), line, column, pointer=key))
