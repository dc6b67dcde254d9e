"""Runs beside each other, as the API tells them."""

from typing import Literal

from bumpless.review.compare import Comparison
from bumpless.review.figures import moments
from bumpless_server.web.answers.contract import Answer, Number


class ComparedRun(Answer):
    """One of the runs; `moments` are mission times, s, that runs can be laid over each other at."""

    id: str
    mission: str
    outcome: str
    reason: str
    moments: dict[str, float]


class ComparedFigure(Answer):
    """One figure of every run; `changes` against the first."""

    key: str
    label: str
    unit: str
    decimals: int
    about: str
    values: list[Number]
    changes: list[Literal["better", "worse", "same", ""]]


class ComparedSetting(Answer):
    """What is not the same in all runs."""

    kind: Literal["mission", "parameters", "software"]
    name: str
    values: list[str]


class ComparisonAnswer(Answer):
    """Figures and differences of two to six runs."""

    runs: list[ComparedRun]
    figures: list[ComparedFigure]
    settings: list[ComparedSetting]

    @classmethod
    def of(cls, ids: list[str], comparison: Comparison) -> "ComparisonAnswer":
        """What was compared, by the ids that were asked for."""
        return cls(
            runs=[
                ComparedRun(
                    id=name,
                    mission=s.info.mission,
                    outcome=s.outcome,
                    reason=s.reason,
                    moments=moments(s.metrics),
                )
                for name, s in zip(ids, comparison.subjects, strict=True)
            ],
            figures=[
                ComparedFigure(
                    key=row.figure.key,
                    label=row.figure.label,
                    unit=row.figure.unit,
                    decimals=row.figure.decimals,
                    about=row.figure.about,
                    values=list(row.values),
                    changes=list(row.changes),
                )
                for row in comparison.figures
            ],
            settings=[
                ComparedSetting(kind=row.kind, name=row.name, values=list(row.values))
                for row in comparison.settings
            ],
        )
