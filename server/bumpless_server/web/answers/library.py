"""The mission library as the API tells it: versions, drafts, the bin, templates."""

from datetime import datetime
from typing import Self

from bumpless_server.plan.bin import Binned
from bumpless_server.plan.drafts import Draft
from bumpless_server.plan.templates import Template
from bumpless_server.plan.versions import Version
from bumpless_server.web.answers.contract import Answer


class VersionAnswer(Answer):
    """A saved state of a mission."""

    id: str
    saved: datetime
    size: int
    sha256: str

    @classmethod
    def of(cls, version: Version) -> Self:
        """As it is kept."""
        return cls(**vars(version))


class VersionText(Answer):
    """A saved state of a mission, whole."""

    id: str
    sha256: str
    yaml: str


class Difference(Answer):
    """What changed between two states of a mission."""

    before: str  # id of a saved version
    after: str  # of another; "": the file as it is
    unified: str  # a unified diff; "" where nothing did


class DraftAnswer(Answer):
    """Work in progress; its name may have no mission yet."""

    name: str
    saved: datetime
    size: int
    sha256: str
    yaml: str

    @classmethod
    def of(cls, draft: Draft) -> Self:
        """As it is kept."""
        return cls(
            name=draft.name,
            saved=draft.saved,
            size=len(draft.data),
            sha256=draft.sha256,
            yaml=draft.data.decode("utf-8", errors="replace"),
        )


class BinnedAnswer(Answer):
    """A deleted mission, to be restored by its id."""

    id: str
    name: str
    deleted: datetime
    size: int

    @classmethod
    def of(cls, binned: Binned) -> Self:
        """As it is kept."""
        return cls(**vars(binned))


class TemplateAnswer(Answer):
    """Something to begin from."""

    name: str
    title: str
    summary: str
    vehicle: str
    yaml: str

    @classmethod
    def of(cls, template: Template) -> Self:
        """As it ships."""
        return cls(**vars(template))
