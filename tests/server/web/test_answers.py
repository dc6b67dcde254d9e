"""Every answer is a typed model, and what the console shares with the server is said once."""

import math
import re
from pathlib import Path
from typing import Any

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import TOPICS
from bumpless.contract.modes import MODES
from bumpless_server.scene import palette
from bumpless_server.web.answers.contract import Metrics, model_of, told
from bumpless_server.web.generate import house_ts, interface, modes_css
from bumpless_server.web.rates import fresh_for_s

SOURCES = Path(__file__).parents[3] / "console_web" / "src"
METHODS = {"get", "put", "post", "delete"}


def _answers() -> dict[str, Any]:
    """The schema of each route's good answer, "GET /api/runs" -> schema; what carries no JSON is left out."""
    found = {}
    for path, methods in interface()["paths"].items():
        for method in METHODS & methods.keys():
            for status, answer in methods[method]["responses"].items():
                content = answer.get("content", {})
                if status.startswith("2") and "application/json" in content:
                    found[f"{method.upper()} {path}"] = content["application/json"]["schema"]
    return found


def test_every_route_answers_with_a_model() -> None:
    """Protects the generated types from a route whose answer nobody declared: its schema would be empty."""
    answers = _answers()
    assert {"GET /api/missions", "PUT /api/parameters", "POST /api/scene/camera"} <= answers.keys()
    for route, schema in answers.items():
        item = schema["items"] if schema.get("type") == "array" else schema
        item = item["anyOf"][0] if "anyOf" in item else item  # a model, or null
        # a list of names says all that it is, and so does another program's file
        assert "$ref" in item or item.get("type") in ("string", "object"), route


def test_a_refusal_is_declared_for_every_subject() -> None:
    """Protects the one shape of refusals that the console reads."""
    told_ = interface()
    declared = told_["components"]["responses"]
    for path, methods in told_["paths"].items():
        for method in METHODS & methods.keys():
            answers = methods[method]["responses"]
            refusals = [one for status, one in answers.items() if not status.startswith("2")]
            assert len(refusals) > 5 and "4XX" not in answers, path
            for refused in refusals:
                known = declared[refused["$ref"].removeprefix("#/components/responses/")]
                schema = known["content"]["application/problem+json"]["schema"]
                assert schema["$ref"].endswith("/Refused"), path


def test_every_route_declares_who_may_use_it_and_by_which_scheme() -> None:
    """Protects: a client made from the document knows how to be let in; nothing is open by omission."""
    told_ = interface()
    assert told_["components"]["securitySchemes"].keys() == {"session", "token"}
    for path, methods in told_["paths"].items():
        for method in METHODS & methods.keys():
            operation = methods[method]
            open_ = operation["security"] == []
            assert open_ == (path in ("/api/health", "/api/login")) and ("x-role" in operation) != open_, path


def test_what_is_no_number_is_null() -> None:
    """Protects a list of runs from one vehicle's NaN: JSON has none, and a zero would be a lie."""
    metrics = told(pb.Metrics(residual_rms=math.nan, final_range_m=math.inf, d_u_fr=0.25), Metrics)
    shown = metrics.model_dump(mode="json")
    assert (shown["residual_rms"], shown["final_range_m"], shown["d_u_fr"]) == (None, None, 0.25)


def test_a_model_of_the_contract_has_every_field() -> None:
    """Protects the JSON from lagging behind the contract: the model is made from the message."""
    for message in (pb.Metrics, pb.Parameters, pb.ServerStatus, pb.Event):
        model = model_of(message)
        assert set(model.model_fields) == {field.name for field in message.DESCRIPTOR.fields}
    assert model_of(pb.ModeParameters).model_validate({"lambda": 0.5}).model_dump()["lambda"] == 0.5


def test_modes_reach_scripts_styles_and_scene_from_one_table() -> None:
    """Protects against a mode that is blue on one screen and green on another."""
    assert {look.mode for look in MODES} == set(pb.Mode.values()) - {pb.MODE_UNSPECIFIED}
    script, style = house_ts(), modes_css()
    for look in MODES:
        assert f'"colour": "{look.colour}"' in script
        assert f"--mode-{look.key}: {look.colour};" in style
        assert palette.css(palette.MODE_COLOUR[look.mode]) == look.colour


def test_no_source_of_the_console_repeats_a_mode_colour() -> None:
    """Protects the table from copies in the console's own sources."""
    colours = re.compile("|".join(look.colour for look in MODES), re.IGNORECASE)
    for path in SOURCES.rglob("*.[tc]s*"):
        if path.parent.name != "gen":
            assert not colours.search(path.read_text()), path.name


def test_each_topic_has_an_age_at_which_it_is_late() -> None:
    """Protects "nothing stale looks live" for every topic that the browser may show."""
    fresh = fresh_for_s()
    assert fresh.keys() == {f"tlm/{name}" for name in TOPICS} | {
        "server/status",
        "server/alarms",
        "server/control",
    }
    for topic in TOPICS.values():
        assert topic.rate_hz is None or fresh[f"tlm/{topic.name}"] >= 2 / topic.rate_hz
