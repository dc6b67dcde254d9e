"""The mission library over HTTP: what was saved comes back as it was, and nothing that was saved is lost."""

import hashlib
from collections.abc import Callable, Iterator

import pytest

from bumpless.config.mission import missions_folder
from bumpless_server.settings import Settings
from tests.server.serving import Running, serving

DOCKING = (missions_folder() / "docking.yaml").read_bytes()
LONGER = DOCKING.replace(b"duration_s: 90", b"duration_s: 95")


@pytest.fixture
def alone(make_settings: Callable[..., Settings]) -> Iterator[Running]:
    """A server without a vehicle, with one mission of ours."""
    with serving(make_settings(manage_node=False)) as server:
        server.http.put("/api/missions/mine", content=DOCKING).raise_for_status()
        yield server


def test_every_saved_version_stays_readable(alone: Running) -> None:
    """Protects: saving over a mission loses nothing; its history says when and gives each text back."""
    alone.http.put("/api/missions/mine", content=LONGER).raise_for_status()
    alone.http.put("/api/missions/mine", content=LONGER).raise_for_status()
    history = alone.http.get("/api/missions/mine/history").json()
    assert [v["sha256"] for v in history] == [hashlib.sha256(d).hexdigest() for d in (LONGER, DOCKING)]
    assert history[0]["saved"] >= history[1]["saved"]
    first = alone.http.get(f"/api/missions/mine/history/{history[1]['id']}").json()
    assert first["yaml"].encode() == DOCKING
    assert alone.http.get("/api/missions/mine/history/..%2Fx").status_code == 404


def test_what_changed_between_two_versions_can_be_read(alone: Running) -> None:
    """Protects: a script reads what somebody changed without fetching both texts."""
    alone.http.put("/api/missions/mine", content=LONGER).raise_for_status()
    newest, first = (v["id"] for v in alone.http.get("/api/missions/mine/history").json())
    told = alone.http.get("/api/missions/mine/difference", params={"before": first}).json()
    assert "-duration_s: 90" in told["unified"] and "+duration_s: 95" in told["unified"]
    same = alone.http.get("/api/missions/mine/difference", params={"before": newest}).json()
    assert same["unified"] == ""
    back = {"before": newest, "after": first}
    assert "+duration_s: 90" in alone.http.get("/api/missions/mine/difference", params=back).json()["unified"]
    assert alone.http.get("/api/missions/mine/difference", params={"before": "x"}).status_code == 404


def test_a_save_over_somebody_elses_work_is_refused(alone: Running) -> None:
    """Protects: two operators editing one mission do not overwrite each other unseen."""
    base = hashlib.sha256(DOCKING).hexdigest()
    alone.http.put("/api/missions/mine", params={"base": base}, content=LONGER).raise_for_status()
    late = alone.http.put("/api/missions/mine", params={"base": base}, content=DOCKING + b"# late\n")
    assert late.status_code == 409 and "changed" in late.json()["detail"]
    assert alone.http.get("/api/missions/mine/file").content == LONGER


def test_a_deletion_can_be_undone(alone: Running) -> None:
    """Protects: a deleted mission comes back byte for byte, under another name where its own is taken."""
    binned = alone.http.delete("/api/missions/mine").json()
    assert alone.http.get("/api/missions/mine").status_code == 404
    assert [one["id"] for one in alone.http.get("/api/mission-bin").json()] == [binned["id"]]
    alone.http.put("/api/missions/mine", content=LONGER).raise_for_status()
    restored = alone.http.post(f"/api/mission-bin/{binned['id']}/restore").json()
    assert restored["name"] == "mine-2" and restored["yaml"].encode() == DOCKING
    assert alone.http.get("/api/mission-bin").json() == []
    assert alone.http.post(f"/api/mission-bin/{binned['id']}/restore").status_code == 404


def test_a_renamed_mission_takes_all_that_belongs_to_it(alone: Running) -> None:
    """Protects: history, draft and tags are a mission's, not a file name's."""
    alone.http.put("/api/missions/mine/marks", json={"tags": ["pier", "pier", " "]}).raise_for_status()
    alone.http.put("/api/missions/mine/draft", content=b"version: 1\n").raise_for_status()
    assert alone.http.post("/api/missions/mine/rename", json={"to": "docking"}).status_code == 409
    renamed = alone.http.post("/api/missions/mine/rename", json={"to": "ours"}).json()
    assert (renamed["name"], renamed["tags"]) == ("ours", ["pier"])
    assert len(alone.http.get("/api/missions/ours/history").json()) == 1
    assert alone.http.get("/api/missions/ours/draft").json()["yaml"] == "version: 1\n"
    assert alone.http.get("/api/missions/mine/draft").status_code == 404
    copied = alone.http.post("/api/missions/ours/duplicate", json={"to": "copy"})
    assert copied.status_code == 201 and copied.json()["sha256"] == renamed["sha256"]


def test_an_archived_mission_is_listed_as_such(alone: Running) -> None:
    """Protects: putting a mission away changes no byte of it, and can be taken back; shipped ones too."""
    for name in ("mine", "docking"):
        before = alone.http.get(f"/api/missions/{name}").json()["sha256"]
        alone.http.put(f"/api/missions/{name}/marks", json={"archived": True}).raise_for_status()
        listed = {m["name"]: m for m in alone.http.get("/api/missions").json()}[name]
        assert listed["archived"] and listed["sha256"] == before and listed["size"] > 0
        alone.http.put(f"/api/missions/{name}/marks", json={"archived": False}).raise_for_status()
        assert not alone.http.get(f"/api/missions/{name}").json()["archived"]


def test_a_draft_holds_anything_until_its_mission_is_saved(alone: Running) -> None:
    """Protects: half-typed work survives a reload, is listed, and is gone once it was saved."""
    half = "legs: [\r\n\t° half"
    kept = alone.http.put("/api/missions/new one/draft", content=half.encode())
    assert kept.status_code == 422  # a draft's name becomes a file's
    kept = alone.http.put("/api/missions/mine/draft", content=half.encode()).json()
    assert kept["yaml"] == half and [d["name"] for d in alone.http.get("/api/drafts").json()] == ["mine"]
    assert alone.http.put("/api/missions/mine", content=half.encode()).status_code == 422
    assert alone.http.get("/api/missions/mine/draft").status_code == 200
    alone.http.put("/api/missions/mine", content=LONGER).raise_for_status()
    assert alone.http.get("/api/missions/mine/draft").status_code == 404
    assert alone.http.delete("/api/missions/mine/draft").status_code == 404


@pytest.mark.parametrize(
    ("change", "valid"),
    [
        (lambda data: data.replace(b"\n", b"\r\n"), True),
        (lambda data: b"\xef\xbb\xbf" + data, True),
        (lambda data: data.replace(b"heading_deg: 0", b"heading_deg: 007"), True),
    ],
)
def test_bytes_stay_bytes(alone: Running, change: Callable[[bytes], bytes], valid: bool) -> None:
    """Protects: line ends, BOM and leading zeros: one hash and one verdict in API, file and text."""
    data = change(DOCKING)
    saved = alone.http.put("/api/missions/mine", content=data)
    assert saved.status_code == 200 and saved.json()["valid"] is valid
    assert saved.json()["sha256"] == hashlib.sha256(data).hexdigest()
    assert saved.json()["yaml"].encode() == data
    assert alone.http.get("/api/missions/mine/file").content == data


def test_a_file_in_another_encoding_has_its_hash_and_its_verdict(alone: Running) -> None:
    """Protects: what is no UTF-8 is told apart by its bytes' hash and refused with the byte's place."""
    data = DOCKING + b"# \xe9\n"
    (alone.console.data.missions / "latin.yaml").write_bytes(data)
    listed = {m["name"]: m for m in alone.http.get("/api/missions").json()}["latin"]
    assert not listed["valid"] and listed["sha256"] == hashlib.sha256(data).hexdigest()
    refused = alone.http.put("/api/missions/mine", content=data)
    assert refused.status_code == 422 and "UTF-8" in refused.json()["problems"][0]["rule"]


def test_templates_are_whole_missions_for_the_console_s_vehicle(alone: Running) -> None:
    """Protects: a new mission begins from something that is valid as it stands."""
    for vehicle in (None, "bluerov2_heavy"):
        found = alone.http.get("/api/mission-templates", params={"vehicle": vehicle} if vehicle else {})
        assert {t["vehicle"] for t in found.json()} == {vehicle or "ts100"} and len(found.json()) >= 3
        for template in found.json():
            saved = alone.http.put(f"/api/missions/{template['name']}", content=template["yaml"])
            assert saved.status_code == 200


def test_shipped_missions_stay_where_they_are(alone: Running) -> None:
    """Protects: nothing that came with the package is renamed, replaced or deleted from a page."""
    assert alone.http.put("/api/missions/docking", content=LONGER).status_code == 409
    assert alone.http.delete("/api/missions/docking").status_code == 409
    assert alone.http.post("/api/missions/docking/rename", json={"to": "x"}).status_code == 409
    assert alone.http.post("/api/missions/docking/duplicate", json={"to": "x"}).status_code == 201
