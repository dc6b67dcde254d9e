"""Which pages are made, and by what."""

from pathlib import Path

from docs.generate import access, campaigns, cli, contract, equations, python_face, rest, settings, tuning

MADE = {
    "reference/access.md": access.page,
    "reference/campaign.md": campaigns.page,
    "reference/cli.md": cli.page,
    "reference/contract.md": contract.page,
    "reference/python.md": python_face.page,
    "reference/rest.md": rest.page,
    "reference/settings.md": settings.page,
}


def made(docs: Path) -> dict[str, str]:
    """Path below docs/ -> its text, for every page made or filled in from the code."""
    texts = {name: page() for name, page in MADE.items()}
    method = docs / "method.md"
    texts["method.md"] = equations.filled(method.read_text(encoding="utf-8"))
    found = docs / "tuning.md"
    texts["tuning.md"] = tuning.filled(found.read_text(encoding="utf-8"))
    return texts
