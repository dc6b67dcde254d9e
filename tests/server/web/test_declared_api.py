"""What may stand in files, over HTTP: enough to build a form and to check a text in an editor."""

from collections.abc import Callable

import jsonschema

from bumpless_server.settings import Settings
from tests.server.serving import serving


def test_fields_and_schemas_are_served(make_settings: Callable[..., Settings]) -> None:
    """Protects: the planner's forms, completion and margins come from the one declaration."""
    with serving(make_settings(manage_node=False)) as server:
        for kind, path in (
            ("mission", "legs[].speed_mps"),
            ("vehicle", "actuators[].span_m"),
            ("parameters", "hover.lambda"),
        ):
            told = {entry["path"]: entry for entry in server.http.get(f"/api/fields/{kind}").json()}
            assert told[path]["label"] and told[path]["type"] == "number"
            jsonschema.Draft202012Validator.check_schema(server.http.get(f"/api/schemas/{kind}").json())
        assert server.http.get("/api/fields/other").status_code == 422
