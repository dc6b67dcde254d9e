"""The interface as OpenAPI: FastAPI's description of the routes, and what the guard in front of them adds.

Who may (from the table of rights), by which scheme, and each refusal that a route may give, in its one shape.
"""

from typing import Any

from fastapi import FastAPI
from pydantic import TypeAdapter

from bumpless_server.access.rights import Right, right_of
from bumpless_server.foresight.told import ForesightMessage
from bumpless_server.foresight.wanted import ForesightRequest
from bumpless_server.web.auth import COOKIE

VERSION = "1.0"  # the first number changes when a script that keeps to this document would break
PROBLEM = "application/problem+json"
SCHEMES = {
    "session": {"type": "apiKey", "in": "cookie", "name": COOKIE, "description": "From POST /api/login"},
    "token": {"type": "http", "scheme": "bearer", "description": "From `bumpless user token`"},
}
ABOUT = """What the console uses, and scripts may. Where the server is reached from its own machine alone and
no account was made, nobody has to log in. A request that changes something must come from the same origin.
Every refusal has one shape: a sentence, and each problem with its place."""
WHY = {
    400: "No request that can be read",
    401: "Nobody known asks: log in, or send a token that is in force",
    403: "Not for this role, or from a page of another origin",
    404: "There is no such thing",
    405: "Not this method",
    409: "Refused as things stand, by the server or the vehicle, with the reason",
    412: "Made from a revision that is no longer in force",
    413: "The body is too long",
    421: "By a host name that is not this server's",
    422: "Not valid, with each problem",
    423: "Somebody else holds control",
    429: "Too many wrong guesses",
    500: "An internal error; the server's log tells more",
    501: "This installation lacks what it takes",
    503: "Not possible now: no vehicle answers, or too much waits",
    507: "The disk has no room; nothing was kept",
}
ANYWHERE = (400, 405, 421, 422, 429, 500, 503)
COMMANDED = (409, 412)
PARAMETERS = "/api/parameters"


def described(app: FastAPI) -> dict[str, Any]:
    """The whole document."""
    told = FastAPI.openapi(app)
    told["info"] |= {"version": VERSION, "description": ABOUT}
    told["components"]["securitySchemes"] = SCHEMES
    content = {PROBLEM: {"schema": {"$ref": "#/components/schemas/Refused"}}}
    refused = {f"Refused{status}": {"description": why, "content": content} for status, why in WHY.items()}
    told["components"]["responses"] = refused
    for path, methods in told["paths"].items():
        for method, operation in methods.items():
            _complete(operation, method.upper(), path)
    return _with_sockets(told)


def install(app: FastAPI) -> None:
    """Serve this document instead of FastAPI's own."""
    kept: dict[str, Any] = {}

    def openapi() -> dict[str, Any]:
        if not kept:
            kept.update(described(app))
        return kept

    app.openapi = openapi


def _complete(operation: dict[str, Any], method: str, path: str) -> None:
    right = right_of(method, path)
    operation["security"] = [{scheme: []} for scheme in SCHEMES] if right.role is not None else []
    if right.role is not None:
        operation["x-role"] = right.role.name
    if right.control:
        operation["x-control"] = True
    answers = operation["responses"]
    for wild in ("4XX", "5XX", "422"):
        answers.pop(wild, None)
    for status in sorted(_refusals(operation, right, method, path)):
        answers[str(status)] = {"$ref": f"#/components/responses/Refused{status}"}


def _refusals(operation: dict[str, Any], right: Right, method: str, path: str) -> set[int]:
    """Every status but success that this route may answer with."""
    known: set[int] = set(ANYWHERE)
    if right.role is not None or path == "/api/login":
        known |= {401, 403}
    if right.control:
        known |= {423}
    if operation.get("parameters") or path in (PARAMETERS, "/api/vehicle", "/api/audit.jsonl"):
        known |= {404, 409}  # no such thing, or one that is just being recorded
    if method != "GET":
        known |= {403, 404, 409, 413, 507}
    if "/mission/" in path or path == PARAMETERS:
        known |= set(COMMANDED)
    if path.startswith("/api/control/"):
        known |= {423}
    if "report" in path:
        known |= {501}
    return known


def _with_sockets(told: dict[str, Any]) -> dict[str, Any]:
    """OpenAPI knows no WebSocket: what one asks and answers is added to the schemas by name."""
    place, schemas = "#/components/schemas/{model}", told["components"]["schemas"]
    asked = ForesightRequest.model_json_schema(ref_template=place)
    answered = TypeAdapter[Any](ForesightMessage).json_schema(mode="serialization", ref_template=place)
    for name, schema in (("ForesightRequest", asked), ("ForesightMessage", answered)):
        schemas |= schema.pop("$defs", {})
        schemas[name] = schema
    return told
