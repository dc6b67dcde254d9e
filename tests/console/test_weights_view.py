"""Mode weights: a draft that shows what differs, applied in one step, active only by the vehicle's word."""

import pytest
from playwright.sync_api import Page, expect

from bumpless.contract import bumpless_pb2 as pb
from tests.console import flight
from tests.console.conftest import show
from tests.console.contract_server import ContractServer
from tests.console.replies import as_json


@pytest.fixture
def weights(console: Page) -> Page:
    """The view of mode weights."""
    show(console, "Mode weights")
    expect(console.get_by_label("Hover: N_sw", exact=True)).to_have_value("40")
    return console


def tell(server: ContractServer, active: pb.Parameters, revision: int) -> None:
    """The vehicle says what it flies with."""
    server.keep_saying([*flight.hello(), *flight.parameters_status(active, revision)])


def test_the_draft_shows_what_differs_and_goes_back(weights: Page) -> None:
    """Protects badges, counts, undo, redo and revert."""
    field = weights.get_by_label("Hover: Q Z", exact=True)
    state = weights.get_by_label("Draft", exact=True).get_by_role("status")
    field.fill("6.5")
    weights.get_by_label("Forward: λ", exact=True).fill("0.01")
    weights.get_by_role("switch", name="Ramp").uncheck()
    expect(state).to_contain_text("3 changes in the draft")
    expect(weights.get_by_role("navigation")).to_contain_text("3")
    expect(weights.get_by_role("button", name="Hover: Q Z: active value 4, revert")).to_be_visible()

    weights.keyboard.press("Control+z")
    expect(weights.get_by_role("switch", name="Ramp")).to_be_checked()
    weights.keyboard.press("Control+Shift+z")
    expect(weights.get_by_role("switch", name="Ramp")).not_to_be_checked()
    weights.get_by_role("button", name="Hover: Q Z: active value 4, revert").click()
    expect(field).to_have_value("4")
    expect(state).to_contain_text("2 changes")
    weights.get_by_role("button", name="Revert all").click()
    expect(state).to_contain_text("The draft equals what the vehicle flies with.")
    weights.get_by_role("button", name="Undo").click()
    expect(state).to_contain_text("2 changes")


def test_applied_only_when_the_vehicle_says_so(weights: Page, server: ContractServer) -> None:
    """Protects the rule that the screen never shows a setting that the vehicle has not confirmed."""
    server.reply("PUT", "parameters", {"accepted": True, "reason": "", "revision": "2"})
    weights.get_by_label("Hover: Q Z", exact=True).fill("6.5")
    weights.get_by_role("button", name="Apply to vehicle").click()
    wanted = flight.parameters()
    wanted.hover.q_diagonal[2] = 6.5
    assert server.wait_for_call("PUT", "parameters").json() == as_json(wanted)
    draft = weights.get_by_label("Draft", exact=True)
    expect(draft).to_contain_text("Accepted, waiting for revision 2")
    expect(draft.get_by_role("status")).to_contain_text("1 change in the draft, not active yet")

    tell(server, wanted, 2)
    expect(draft).to_contain_text("Confirmed by the vehicle, revision 2")
    expect(draft.get_by_role("status")).to_contain_text("The draft equals what the vehicle flies with.")
    expect(weights.get_by_label("Hover: Q Z", exact=True)).to_have_value("6.5")


def test_a_vehicle_that_flies_other_values_is_called_out(weights: Page, server: ContractServer) -> None:
    """Protects against a confirmation that confirms something else."""
    server.reply("PUT", "parameters", {"accepted": True, "reason": "", "revision": 2})
    weights.get_by_label("Hover: Q Z", exact=True).fill("6.5")
    weights.get_by_role("button", name="Apply to vehicle").click()
    other = flight.parameters()
    other.hover.q_diagonal[2] = 5.0
    server.wait_for_call("PUT", "parameters")
    expect(weights.get_by_label("Draft", exact=True)).to_contain_text("waiting for revision 2")
    tell(server, other, 2)
    expect(weights.get_by_label("Draft", exact=True)).to_contain_text(
        "The vehicle flies other values in 1 field(s)"
    )


def test_a_new_node_that_counts_anew_ends_the_wait(weights: Page, server: ContractServer) -> None:
    """Protects against waiting for ever, unable to apply again, for a revision that died with its node."""
    tell(server, flight.parameters(), 7)
    draft = weights.get_by_label("Draft", exact=True)
    expect(draft).to_contain_text("Active: revision 7")  # or 1 would be no smaller than what was heard
    server.reply("PUT", "parameters", {"accepted": True, "reason": "", "revision": 8})
    weights.get_by_label("Hover: Q Z", exact=True).fill("6.5")
    weights.get_by_role("button", name="Apply to vehicle").click()
    expect(draft).to_contain_text("Accepted, waiting for revision 8")
    tell(server, flight.parameters(), 1)
    expect(draft).to_contain_text("The vehicle flies other values in 1 field(s)")
    expect(weights.get_by_role("button", name="Apply to vehicle")).to_be_enabled()


def test_a_refusal_stands_at_its_field(weights: Page, server: ContractServer) -> None:
    """Protects reason and place of a refusal; nothing becomes active."""
    rule = "must be between 1e-09 and 1000"
    problem = {"field": "forward.lambda", "value": "-1.0", "rule": rule}
    server.reply(
        "PUT", "parameters", {"detail": "one number is out of range", "problems": [problem]}, status=422
    )
    field = weights.get_by_label("Forward: λ", exact=True)
    field.fill("-1")
    expect(field).to_have_attribute("aria-invalid", "true")
    weights.get_by_role("button", name="Apply to vehicle").click()
    expect(weights.get_by_label("Draft", exact=True).get_by_role("alert")).to_contain_text(
        "one number is out of range"
    )
    expect(weights.locator(".field-problem")).to_have_text(rule)
    expect(weights.get_by_role("button", name="Forward: λ: active value 0.001, revert")).to_be_visible()


def test_what_is_no_number_cannot_be_applied(weights: Page) -> None:
    """Protects the vehicle from half-typed fields."""
    weights.get_by_label("Hover: Q Z", exact=True).fill("6")
    field = weights.get_by_label("Hover: N_sw", exact=True)
    field.fill("12.5")
    expect(weights.get_by_text("Must be a whole number.")).to_be_visible()
    expect(weights.get_by_role("button", name="Apply to vehicle")).to_be_disabled()
    field.fill("12")
    expect(weights.get_by_role("button", name="Apply to vehicle")).to_be_enabled()


def test_presets_are_loaded_into_the_draft_and_saved_from_it(weights: Page, server: ContractServer) -> None:
    """Protects presets from becoming active by themselves."""
    weights.get_by_role("button", name="Load calm-sea into the draft").click()
    expect(weights.get_by_label("Hover: N_sw", exact=True)).to_have_value("80")
    expect(weights.get_by_label("Draft", exact=True).get_by_role("status")).to_contain_text("2 changes")
    assert server.calls_of("PUT", "parameters") == []

    server.reply("PUT", "presets/rough-sea", {"name": "rough-sea"})
    server.reply("GET", "presets", [{"name": "calm-sea"}, {"name": "rough-sea"}])
    weights.get_by_label("Name of the preset").fill("rough-sea")
    weights.get_by_role("button", name="Save draft").click()
    assert server.wait_for_call("PUT", "presets/rough-sea").json()["hover"]["ramp_cycles"] == 80
    expect(weights.get_by_role("button", name="Load rough-sea into the draft")).to_be_visible()
