"""The fields of a mission file, from its JSON Schema."""

from collections.abc import Iterator
from typing import Any

from bumpless.config.mission import mission_json_schema
from docs.generate.markdown import NOTE, code, table

HEAD = """# Mission file

Every field of a mission, with its range. [Planning](../planning.md) says how to write one. The same as JSON
Schema: [mission.schema.json](../../missions/mission.schema.json), which editors use to complete and check.

"""


def page() -> str:
    """Markdown: a table for each object of a mission file."""
    return NOTE + HEAD + "\n".join(chapters("Mission", mission_json_schema()))


def chapters(name: str, schema: dict[str, Any], path: str = "") -> Iterator[str]:
    """A chapter for an object and one for each object within it."""
    required = schema.get("required", [])
    properties = {key: _plain(one) for key, one in schema["properties"].items()}
    rows = [
        (code(path + key), _kind(one), "yes" if key in required else "", one.get("description", ""))
        for key, one in properties.items()
    ]
    yield f"## {name}\n\n" + table(("field", "what it may be", "required", "meaning"), rows)
    for key, one in properties.items():
        inner, mark = (one["items"], "[].") if one.get("type") == "array" and "items" in one else (one, ".")
        inner = _plain(inner)
        if inner.get("type") == "object" and inner.get("properties"):
            yield from chapters(path + key, inner, path + key + mark)


def _plain(schema: dict[str, Any]) -> dict[str, Any]:
    """A schema that may be null, without the null."""
    for word in ("anyOf", "oneOf"):
        options = [one for one in schema.get(word, []) if one.get("type") != "null"]
        if len(options) == 1:
            return {**options[0], **{key: value for key, value in schema.items() if key != word}}
    return schema


def _kind(schema: dict[str, Any]) -> str:
    if "enum" in schema:
        return " or ".join(code(one) for one in schema["enum"])
    if "const" in schema:
        return code(schema["const"])
    kind = schema.get("type", "")
    kinds = [one for one in ([kind] if isinstance(kind, str) else kind) if one != "null"]
    name = {"integer": "whole number", "string": "text", "array": "list", "boolean": "true or false"}
    if kinds == ["array"]:
        return _row(schema)
    return " or ".join(name.get(one, one) for one in kinds) + _range(schema)


def _row(schema: dict[str, Any]) -> str:
    if "prefixItems" in schema:
        return "list: " + "; ".join(_kind(_plain(one)) for one in schema["prefixItems"])
    low, high = schema.get("minItems"), schema.get("maxItems")
    count = (
        f"{low}"
        if low == high
        else f"{low if low is not None else 0} to {high if high is not None else 'any'}"
    )
    inner = _plain(schema.get("items", {}))
    return f"list of {count}" + ("" if inner.get("type") == "object" else f": {_kind(inner)}")


def _range(schema: dict[str, Any]) -> str:
    low, high = schema.get("minimum"), schema.get("maximum")
    if low is not None and high is not None:
        return f", {low:g} to {high:g}"
    return f", at least {low:g}" if low is not None else f", at most {high:g}" if high is not None else ""
