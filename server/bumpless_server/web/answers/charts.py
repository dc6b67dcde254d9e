"""Charts as the API tells them: overlays and depth grids, and what a planner draws of them."""

from datetime import datetime
from typing import Literal

from bumpless_server.plan.charts.content import Feature
from bumpless_server.plan.charts.shown import Shown
from bumpless_server.plan.charts.store import Chart
from bumpless_server.web.answers.contract import Answer

Place = tuple[float, float]  # north and east of the mission's frame, m


class ChartSummary(Answer):
    """A stored chart. `geographic`: it can be shown only where the mission has an origin."""

    name: str
    title: str
    kind: Literal["features", "picture", "depths"]
    format: str  # "a GeoTIFF"
    file_name: str  # as it was uploaded
    size: int  # bytes
    sha256: str  # of these bytes
    stored: datetime
    geographic: bool
    missions: list[str]  # that it belongs to; none: to the site, so to all
    notes: list[str]  # what was made of the file, and what did not carry over

    @classmethod
    def of(cls, chart: Chart) -> "ChartSummary":
        """As it is stored."""
        return cls(
            name=chart.name,
            title=chart.title or chart.name,
            kind=chart.kind,
            format=chart.format,
            file_name=chart.file_name,
            size=chart.size,
            sha256=chart.sha256,
            stored=chart.stored,
            geographic=chart.geographic,
            missions=list(chart.missions),
            notes=list(chart.notes),
        )


class ChartFeature(Answer):
    """A shape of an overlay. An area's first part is its outline, the others are holes in it."""

    kind: Literal["point", "line", "area"]
    name: str
    colour: str  # "#rrggbb" where the file says one, else ""
    parts: list[list[Place]]

    @classmethod
    def of(cls, feature: Feature) -> "ChartFeature":
        """As it was placed."""
        parts = [list(part) for part in feature.parts]
        return cls(kind=feature.kind, name=feature.name, colour=feature.colour, parts=parts)


class ChartDepths(Answer):
    """A depth grid for drawing, thinned to some 100 rows: bilinear between the middles of its cells."""

    rows: int
    columns: int
    depth_m: list[float | None]  # row by row; null: not known
    least_m: float
    deepest_m: float


class ChartShown(Answer):
    """A chart in the frame of a mission: the one of its three contents that it has."""

    name: str
    kind: Literal["features", "picture", "depths"]
    # of a picture's or a grid's first row: left and right; then of its last row: right and left
    corners: tuple[Place, Place, Place, Place] | None
    features: list[ChartFeature]
    depths: ChartDepths | None
    picture: str  # address of the PNG; "" where there is none

    @classmethod
    def of(cls, shown: Shown) -> "ChartShown":
        """As it was placed."""
        chart, depths = shown.chart, shown.depths
        return cls(
            name=chart.name,
            kind=chart.kind,
            corners=shown.corners,
            features=[ChartFeature.of(one) for one in shown.features],
            depths=ChartDepths.model_validate(depths, from_attributes=True) if depths else None,
            picture=f"/api/charts/{chart.name}/picture" if chart.kind == "picture" else "",
        )


class ChartTiles(Answer):
    """Where tiles of a base map come from; "" when none are wanted, as is the default."""

    address: str  # "https://.../{z}/{x}/{y}.png"
    attribution: str
