"""What the console's tests are told is what the real server would say: its own models read every reply."""

from fastapi.routing import APIRoute
from pydantic import TypeAdapter
from starlette.routing import Match

from bumpless_server.scene.cameras import Cameras
from bumpless_server.scene.proxy import Proxy
from bumpless_server.web.app import ROUTERS
from tests.console.contract_server import ContractServer
from tests.console.replies import default_replies

ROUTES = [
    route
    for router in (*ROUTERS, Proxy(lambda _request: None, Cameras()).router)
    for route in router.routes
    if isinstance(route, APIRoute)
]


def _route(method: str, path: str) -> APIRoute:
    scope = {"type": "http", "method": method, "path": f"/api/{path}"}
    return next(route for route in ROUTES if route.matches(scope)[0] == Match.FULL)


def test_every_reply_is_one_that_the_server_could_give() -> None:
    """Protects the browser tests from a fake that has drifted away from the interface."""
    server = ContractServer()
    try:
        default_replies(server)
    finally:
        server.stop()
    read = 0
    for (method, path), (_, body) in server.replies.items():
        model = _route(method, path).response_model
        if model is not None and not isinstance(body, bytes):
            TypeAdapter(model).validate_python(body)
            read += 1
    assert read >= 9
