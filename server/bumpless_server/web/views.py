"""The console's views, declared once: the page's navigation, the docs and the tests read this table."""

from dataclasses import dataclass


@dataclass(frozen=True)
class View:
    """One view; its address is `#/id`."""

    id: str
    name: str
    about: str


VIEWS = (
    View("live", "Live", "What the vehicle does now: scene, mode, plots, wrench, actuators, events."),
    View(
        "plan",
        "Plan",
        "A mission drawn and flown ahead: what will happen, with what chance, and what to mend.",
    ),
    View("missions", "Missions", "Mission files: what they are for, their plan and text, upload and start."),
    View("weights", "Mode weights", "What the vehicle is tuned with, edited as a draft and applied at once."),
    View("runs", "Runs", "Recorded flights with their metrics and files."),
    View("system", "System", "What was not taken as it came, who did what, and who may."),
)
HELP = "/help/"  # the docs, served beside the console
