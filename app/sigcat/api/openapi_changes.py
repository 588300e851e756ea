"""Changes of an OpenAPI document that break clients generated from an older one."""

import re
from collections.abc import Iterator, Mapping
from typing import Any

from sigcat.api.openapi_document import operations

Schema = Mapping[str, Any]
_MAJOR = re.compile(r"^/api/(v\d+)/")
_DEEPEST = 12


def breaking_changes(old: Schema, new: Schema) -> list[str]:
    """Return one sentence for each break of clients of `old`. A major version that `new` lacks is not compared."""
    after = {(path, method): operation for path, method, operation in operations(new)}
    majors = {major(path) for path, _ in after}
    found: list[str] = []
    for path, method, before in operations(old):
        name = f"{method.upper()} {path}"
        operation = after.get((path, method))
        if major(path) not in majors:
            continue
        if operation is None:
            found.append(f"{name}: the operation is gone.")
            continue
        if operation["operationId"] != before["operationId"]:
            found.append(f"{name}: its id was {before['operationId']!r} and is {operation['operationId']!r}.")
        found += [f"{name}: {change}" for change in _parameters(before, operation, old, new)]
        found += [f"{name}: {change}" for change in _body(before, operation)]
        found += [f"{name}: {change}" for change in _responses(before, operation, old, new)]
    if all(major(path) in majors for path, _, _ in operations(old)):
        found += [f"The schema {name!r} is gone." for name in _schemas(old) if name not in _schemas(new)]
    return list(dict.fromkeys(found))


def _schemas(document: Schema) -> Schema:
    schemas: Schema = document.get("components", {}).get("schemas", {})
    return schemas


def major(path: str) -> str:
    """`v1` of `/api/v1/…`; nothing of an address without a version."""
    match = _MAJOR.match(path)
    return match[1] if match else ""


def _parameters(before: Schema, after: Schema, old: Schema, new: Schema) -> Iterator[str]:
    earlier = {(each["in"], each["name"]): each for each in before.get("parameters", [])}
    later = {(each["in"], each["name"]): each for each in after.get("parameters", [])}
    for key in earlier.keys() - later.keys():
        yield f"the parameter {key[1]!r} is gone."
    if [key for key in earlier if key in later] != [key for key in later if key in earlier]:
        yield "the order of the parameters is another one."
    for key, parameter in later.items():
        known = earlier.get(key)
        if parameter.get("required") and not (known and known.get("required")):
            yield f"the parameter {key[1]!r} is required now."
        if known:
            accepted = _accepted(known.get("schema", {}), parameter.get("schema", {}), old, new)
            yield from (f"the parameter {key[1]!r} {change}" for change in accepted)


def _accepted(before: Schema, after: Schema, old: Schema, new: Schema) -> Iterator[str]:
    """Report values that a parameter no longer takes."""
    earlier, later = _values(before, old), _values(after, new)
    if later and (lost := sorted((earlier or {"any text"}) - later)):
        yield f"no longer takes {', '.join(lost)}."
    if _kinds(before, old) - _kinds(after, new) - {"null"}:
        yield f"takes {_kinds_in_words(_kinds(after, new))}, and took {_kinds_in_words(_kinds(before, old))}."


def _body(before: Schema, after: Schema) -> Iterator[str]:
    was, now = before.get("requestBody", {}), after.get("requestBody", {})
    if now.get("required") and not was.get("required"):
        yield "a body is required now."
    for media_type in was.get("content", {}).keys() - now.get("content", {}).keys():
        yield f"a body of {media_type} is no longer taken."


def _responses(before: Schema, after: Schema, old: Schema, new: Schema) -> Iterator[str]:
    for status, response in before["responses"].items():
        later = after["responses"].get(status)
        if later is None:
            if status.startswith("2"):
                yield f"the answer {status} was removed."
            continue
        for name in response.get("headers", {}).keys() - later.get("headers", {}).keys():
            yield f"the answer {status} no longer has the header {name}."
        for media_type, content in response.get("content", {}).items():
            now = later.get("content", {}).get(media_type)
            if now is None:
                yield f"the answer {status} is no longer {media_type}."
            else:
                yield from _answered(content.get("schema", {}), now.get("schema", {}), old, new, status)


def _answered(before: Schema, after: Schema, old: Schema, new: Schema, at: str, depth: int = 0) -> Iterator[str]:
    """Report content of an answer that is no longer guaranteed."""
    was, now = _resolved(before, old), _resolved(after, new)
    if depth > _DEEPEST or not was:
        return
    if _kinds(after, new) - _kinds(before, old):
        yield f"{at} may be {_kinds_in_words(_kinds(after, new))} now; it was {_kinds_in_words(_kinds(before, old))}."
    earlier, later = _values(before, old), _values(after, new)
    if earlier and (added := sorted((later or {"any text"}) - earlier)):
        yield f"{at} may be {', '.join(added)} now."
    for name, schema in was.get("properties", {}).items():
        below = f"{at}.{name}" if " " in at else f"{at} {name}"
        if name not in now.get("properties", {}):
            yield f"{below} is gone."
            continue
        if name in was.get("required", []) and name not in now.get("required", []):
            yield f"{below} may be absent now."
        yield from _answered(schema, now["properties"][name], old, new, below, depth + 1)
    if "items" in was and "items" in now:
        yield from _answered(was["items"], now["items"], old, new, f"{at}[]", depth + 1)


def _resolved(schema: Schema, document: Schema) -> Schema:
    """The schema that a reference names; of alternatives, the one that is not null."""
    for _ in range(_DEEPEST):
        if "$ref" in schema:
            schema = document["components"]["schemas"][schema["$ref"].rpartition("/")[2]]
        elif "anyOf" in schema:
            rest = [each for each in schema["anyOf"] if each.get("type") != "null"]
            schema = rest[0] if rest else {}
        else:
            break
    return schema


def _kinds(schema: Schema, document: Schema) -> frozenset[str]:
    """Types that a value may have; nothing means any."""
    if "anyOf" in schema:
        return frozenset(kind for each in schema["anyOf"] for kind in _kinds(each, document))
    kind = _resolved(schema, document).get("type", ())
    return frozenset([kind] if isinstance(kind, str) else kind)


def _values(schema: Schema, document: Schema) -> set[str]:
    resolved = _resolved(schema, document)
    holder = _resolved(resolved["items"], document) if "items" in resolved else resolved
    return {str(value) for value in holder.get("enum", ([holder["const"]] if "const" in holder else []))}


def _kinds_in_words(kinds: frozenset[str]) -> str:
    return " or ".join(sorted(kinds)) or "anything"
