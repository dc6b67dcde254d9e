"""The planner's list of missions in a real browser: tags, archive, and what is for another vehicle."""

from playwright.sync_api import Page, expect

from tests.console.contract_server import ContractServer
from tests.console.planner import stored
from tests.console.test_planner import TEXT, planned

__all__ = ["planned"]  # the fixture


def test_missions_are_tagged_found_by_tag_and_put_away(planned: Page, server: ContractServer) -> None:
    """Protects order in many missions: tags filter, the archive hides, and no byte of a file changes."""
    ours = stored("harbour", TEXT, tags=["harbour"], archived=False)
    other = stored("lake", TEXT, tags=["trials"], archived=False)
    old = stored("old", TEXT, tags=[], archived=True)
    server.reply("GET", "missions", [ours, other, old])
    server.reply("PUT", "missions/lake/marks", other)
    planned.get_by_role("button", name="Open …").click()
    missions = planned.get_by_label("Missions to open")
    expect(missions.locator(".library-row")).to_have_count(2)
    missions.get_by_role("button", name="trials", exact=True).click()
    expect(missions.locator(".library-row")).to_have_count(1)
    missions.get_by_role("button", name="More of lake").click()
    missions.get_by_label("Tags of lake").fill("trials, deep ,")
    missions.get_by_role("button", name="Keep tags").click()
    assert server.wait_for_call("PUT", "missions/lake/marks").json() == {"tags": ["trials", "deep"]}
    missions.get_by_role("button", name="Put into the archive").click()
    assert server.wait_for_call("PUT", "missions/lake/marks", 2).json() == {"archived": True}
    missions.get_by_role("button", name="Archive (1)").click()
    expect(missions.locator(".library-row")).to_have_count(1)
    expect(missions.locator(".library-row")).to_contain_text("old")


def test_a_mission_for_another_vehicle_says_so(planned: Page, server: ContractServer) -> None:
    """Protects from the wrong file: greyed, last in the list, with the reason."""
    server.reply("GET", "missions", [stored("pods", TEXT, vehicle="twinpod"), stored("harbour", TEXT)])
    planned.get_by_role("button", name="Open …").click()
    row = planned.get_by_label("Missions to open").locator(".library-open").last
    expect(row).to_contain_text("for twinpod")
    expect(row).to_have_attribute("title", "It is for twinpod; on the bus is ts100")
