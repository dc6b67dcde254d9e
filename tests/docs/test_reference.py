"""The docs know everything that a user can set, call, send or read, and say something of it."""

import re
from pathlib import Path
from typing import get_type_hints

import pytest

from bumpless.campaign.declaration import Campaign
from bumpless.campaign.quantities import QUANTITIES
from bumpless.config.declare import fields_of
from bumpless.config.mission import mission_json_schema
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract import keys
from bumpless_server.settings import PREFIX, Settings
from docs.generate import cli, contract, pages, rest

DOCS = Path(__file__).resolve().parents[2] / "docs"
ROW = re.compile(r"^\| (.*) \|$", re.MULTILINE)


def text(name: str) -> str:
    """A committed page."""
    return (DOCS / name).read_text(encoding="utf-8")


def rows(page: str) -> dict[str, list[str]]:
    """First cell -> all cells, over every table of a page."""
    cells = ([cell.strip() for cell in line.split(" | ")] for line in ROW.findall(page))
    return {row[0]: row for row in cells}


def test_the_committed_pages_are_what_the_code_says() -> None:
    """Protects: a setting, option, route, topic or field that changes reaches the docs (`make gen`)."""
    made = pages.made(DOCS)
    assert [name for name, wanted in made.items() if text(name) != wanted] == []


def test_every_setting_is_told_with_its_meaning() -> None:
    """Protects: no setting that only its author understands."""
    told = rows(text("reference/settings.md"))
    for name, field in Settings.model_fields.items():
        row = told[f"`{PREFIX}{name.upper()}`"]
        assert field.description and row[3] == field.description


def test_every_command_and_option_has_help() -> None:
    """Protects: `bumpless COMMAND --help` and its page leave no option without a word."""
    page = text("reference/cli.md")
    for name, function in cli.commands().items():
        assert f"## {name}\n" in page and cli.help_of(name) in page
        for parameter, hint in get_type_hints(function, include_extras=True).items():
            told = [note.help for note in getattr(hint, "__metadata__", ()) if hasattr(note, "help")]
            assert parameter == "return" or (told and told[0]), f"bumpless {name}: {parameter} has no help"


def test_every_route_is_told_with_its_meaning() -> None:
    """Protects: no route without a docstring, which is its line in the reference."""
    told = rows(text("reference/rest.md"))
    for method, path, operation in rest.operations(rest.document()):
        assert operation.get("description"), f"{method} {path} has no docstring"
        assert f"`{method} {path}`" in told


@pytest.mark.parametrize("topic", keys.TOPICS)
def test_every_topic_is_told_and_its_message_has_a_word(topic: str) -> None:
    """Protects: a topic in the table of keys has its key, message and meaning in the docs."""
    page = text("reference/contract.md")
    name = keys.TOPICS[topic].message.__name__
    assert keys.telemetry("<vehicle>", topic) in page
    meaning = page.split(f"## {name}\n")[1].split("|")[0].strip()
    assert len(meaning.split()) > 2, f"the .proto says nothing above message {name}"


def test_every_field_of_the_contract_is_told() -> None:
    """Protects: a field added to any message is in the reference."""
    page = text("reference/contract.md")
    for name, message in pb.DESCRIPTOR.message_types_by_name.items():
        told = rows(page.split(f"## {name}\n")[1].split("\n## ")[0])
        assert {f"{field.number}" for field in message.fields} <= set(told), name
        assert all(told[f"{field.number}"][1] == f"`{field.name}`" for field in message.fields)
    assert all(f"## {name}\n" in page for name in pb.DESCRIPTOR.enum_types_by_name)


def test_the_way_to_command_a_vehicle_is_told_by_hand_too() -> None:
    """Protects: who builds a vehicle learns what each verb asks, not only its message."""
    told = rows(text("vehicle_contract.md"))
    assert {f"`{verb}`" for verb in keys.COMMANDS} <= set(told)
    assert "request" in contract.page()


def test_every_field_of_a_mission_is_told_with_its_meaning() -> None:
    """Protects: a field of a mission file has a range and a sentence in the reference."""
    told = rows(text("reference/mission.md").partition("\n## ")[0])
    for name, schema in mission_json_schema()["properties"].items():
        assert told[f"`{name}`"][6].startswith(schema["description"].split(",")[0])


def test_every_field_and_quantity_of_a_campaign_is_told_with_its_meaning() -> None:
    """Protects: what a campaign can declare and draw can be looked up, in the words of the code."""
    first, _, rest = text("reference/campaign.md").partition("\n## ")
    told, drawn = rows(first), rows(rest)
    for key, field in fields_of(Campaign).items():
        assert told[f"`{key}`"][6].startswith(field.note.label)
    for name, quantity in QUANTITIES.items():
        assert drawn[f"`{name}`"][-1] == quantity.about
