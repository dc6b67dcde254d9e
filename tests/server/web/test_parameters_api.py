"""Tuning over HTTP: shown is what the vehicle confirmed; what is out of range never reaches it."""

import json

from tests.server.serving import Running


def test_active_parameters_are_the_vehicles_own_and_change_through_it(running: Running) -> None:
    """A change is active once the vehicle has said so, with a new revision."""
    before = running.http.get("/api/parameters").json()
    assert before["active"] == before["defaults"]
    wanted = before["active"]
    wanted["hover"]["lambda"] = 0.5
    answer = running.http.put("/api/parameters", json=wanted)
    assert answer.json()["accepted"] and answer.json()["revision"] == before["revision"] + 1
    after = running.until(
        lambda: (p := running.http.get("/api/parameters").json())["revision"] > before["revision"] and p
    )
    assert after["active"]["hover"]["lambda"] == 0.5
    assert after["defaults"]["hover"]["lambda"] != 0.5


def test_every_number_has_its_range_for_the_screen(running: Running) -> None:
    """The form can be built from the answer alone."""
    told = running.http.get("/api/parameters").json()
    for one in told["ranges"]:
        section, name = one["path"].split(".")
        assert name in told["active"][section]
        assert one["min"] < one["max"] and one["label"] and one["unit"]


def test_what_is_wrong_is_refused_with_every_problem(running: Running) -> None:
    """Out of range, missing, unknown, of the wrong kind: field and rule, and nothing is changed."""
    good = running.http.get("/api/parameters").json()
    bad = running.http.get("/api/parameters").json()["active"]
    bad["forward"]["lambda"] = -1
    bad["supervisor"]["range_fr_lower_m"] = 1e9
    answer = running.http.put("/api/parameters", json=bad)
    fields = {problem["field"] for problem in answer.json()["problems"]}
    assert answer.status_code == 422 and {"forward.lambda", "supervisor.range_fr_lower_m"} <= fields

    for change, field in (
        (lambda p: p["reverse"].pop("ramp_cycles"), "reverse.ramp_cycles"),
        (lambda p: p["bumpless"].update(magic=True), "bumpless.magic"),
        (lambda p: p.update(hover=3), "hover"),
        (lambda p: p["forward"]["q_diagonal"].pop(), "forward.q_diagonal"),
    ):
        bad = running.http.get("/api/parameters").json()["active"]
        change(bad)
        answer = running.http.put("/api/parameters", json=bad)
        assert answer.status_code == 422
        assert answer.json()["problems"][0]["field"] == field
    huge = running.http.get("/api/parameters").json()["active"]
    huge["hover"]["lambda"] = 10**400
    for text in (b"[]", b"{", b"null", b"\xff", b"[" * 100_000, json.dumps(huge).encode()):
        assert running.http.put("/api/parameters", content=text).status_code == 422
    assert running.http.get("/api/parameters").json()["revision"] == good["revision"]


def test_presets_are_kept_checked_and_forgotten(running: Running) -> None:
    """A preset is a whole valid set; saving changes nothing on the vehicle."""
    active = running.http.get("/api/parameters").json()["active"]
    assert running.http.put("/api/presets/gentle", json={"parameters": active}).status_code == 200
    assert running.http.get("/api/presets/gentle").json()["parameters"] == active
    assert [p["name"] for p in running.http.get("/api/presets").json()] == ["gentle"]
    active["forward"]["lambda"] = -1
    assert running.http.put("/api/presets/gentle", json=active).status_code == 422
    assert running.http.put("/api/presets/..hidden", json=active).status_code == 422
    assert running.http.delete("/api/presets/gentle").status_code == 204
    assert running.http.delete("/api/presets/gentle").status_code == 404
    assert running.http.get("/api/presets/gentle").status_code == 404
