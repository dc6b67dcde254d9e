"""The HTTP interface, from the OpenAPI document that the server makes of its routes."""

import tempfile
from pathlib import Path
from typing import Any

from bumpless_server.settings import Settings
from docs.generate.markdown import NOTE, cell, code, table

HEAD = """# HTTP interface

What the console itself uses, and scripts may. Where people log in, a request needs the session cookie that
`POST /api/login` gives, or a token: `Authorization: Bearer bmp_...` (`bumpless user token`). Which role each
route takes: [Who may do what](access.md). A request that changes something must come from the same origin. A
refused request answers with `{"detail": "...", "problems": [...]}`; each problem names field, value and rule.
The running server gives this as OpenAPI at `/openapi.json`.

"""
STREAM = """## Stream

`/api/stream` is a WebSocket. Each binary message is one `bumpless.StreamFrame` of the
[contract](contract.md): the newest message of each topic since the last frame, and all events. Their
payloads are the bus's bytes, unchanged.

"""


def document() -> dict[str, Any]:
    """The OpenAPI document of a server that was never started."""
    from bumpless_server.web.app import create_app

    with tempfile.TemporaryDirectory() as folder:
        return create_app(Settings(data_dir=Path(folder), scene="off", manage_node=False)).openapi()


def operations(openapi: dict[str, Any]) -> list[tuple[str, str, dict[str, Any]]]:
    """(METHOD, path, operation) of every route."""
    return [
        (method.upper(), path, operation)
        for path, methods in openapi["paths"].items()
        for method, operation in methods.items()
    ]


def page() -> str:
    """Markdown: one row per route, then the objects they take and give."""
    openapi = document()
    rows = [
        (f"`{method} {path}`", operation.get("description", ""), _given(operation), _answer(operation))
        for method, path, operation in operations(openapi)
    ]
    text = NOTE + HEAD + table(("route", "what it does", "takes", "answers"), rows) + "\n" + STREAM
    return text + "\n".join(_object(*one) for one in sorted(_objects(openapi).items()))


def _objects(openapi: dict[str, Any]) -> dict[str, Any]:
    schemas = openapi.get("components", {}).get("schemas", {})
    return {name: schema for name, schema in schemas.items() if not name.endswith("ValidationError")}


def _given(operation: dict[str, Any]) -> str:
    names = [
        code(one["name"]) + ("" if one.get("required") else " (optional)")
        for one in operation.get("parameters", [])
        if one["in"] == "query"
    ]
    body = operation.get("requestBody", {}).get("content", {})
    return ", ".join(names + [told(one.get("schema", {})) or "a body" for one in body.values()])


def _answer(operation: dict[str, Any]) -> str:
    for status, answer in sorted(operation["responses"].items()):
        if status.startswith("2"):
            schemas = [told(one.get("schema", {})) for one in answer.get("content", {}).values()]
            return " ".join([status, *filter(None, schemas)])
    return ""


def told(schema: dict[str, Any]) -> str:
    """A JSON Schema in a few words, objects by link."""
    if "$ref" in schema:
        name = schema["$ref"].rsplit("/", 1)[-1]
        return f"[{name}](#{name.lower()})"
    if "anyOf" in schema:
        return " or ".join(told(one) for one in schema["anyOf"])
    if schema.get("type") == "array":
        return f"list of {told(schema.get('items', {})) or 'any'}"
    if "enum" in schema:
        return " or ".join(code(one) for one in schema["enum"])
    return str(schema.get("type", ""))


def _object(name: str, schema: dict[str, Any]) -> str:
    required = schema.get("required", [])
    rows = [
        (code(field), told(one), "yes" if field in required else "", cell(one.get("description", "")))
        for field, one in schema.get("properties", {}).items()
    ]
    head = f"## {name}\n\n{schema.get('description', '')}\n\n"
    return head + (table(("field", "type", "required", "meaning"), rows) if rows else f"{told(schema)}\n")
