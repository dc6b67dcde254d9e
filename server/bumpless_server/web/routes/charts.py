"""Charts: overlays and depth grids of the site or of a mission."""

from typing import Annotated, Literal

from fastapi import APIRouter, Body, Query, Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import BaseModel, ConfigDict, Field

from bumpless.config.mission.origin import Origin
from bumpless_server.plan.charts.content import NotAChart, Said
from bumpless_server.plan.charts.shown import NotPlaced, shown
from bumpless_server.web.answers.charts import ChartShown, ChartSummary, ChartTiles
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.ledger import Done
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api", responses=REFUSALS)
_BYTES = {
    "requestBody": {
        "content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}},
        "required": True,
    }
}


class Owners(BaseModel):
    """Which missions a chart belongs to; none: the site."""

    model_config = ConfigDict(extra="forbid")
    title: str | None = Field(None, max_length=80)
    missions: list[str] | None = Field(None, max_length=100)


class Placed(BaseModel):
    """What the file is called, and how to read what it does not say itself."""

    model_config = ConfigDict(extra="forbid")
    file_name: str = Field(max_length=200)
    corners: str = Field(
        "",
        max_length=400,
        description="of a picture: four places 'a,b;a,b;a,b;a,b' of its top left, top right, bottom right "
        "and bottom left; latitude,longitude or, with local, north,east in m",
    )
    local: bool = Field(False, description="numbers are m of the missions' own frame, not on the earth")
    epsg: int | None = Field(
        None,
        ge=1024,
        le=99_999,
        description="system of a grid's x and y where the file does not say: its EPSG code",
    )
    depths: Literal["", "down", "up"] = Field(
        "", description="of a grid: numbers are depths (down) or heights (up); as they look when left out"
    )


@router.get("/charts")
def charts(console: Served, mission: str | None = None) -> list[ChartSummary]:
    """All charts; with `mission` those of the site and of that mission."""
    return [
        ChartSummary.of(chart)
        for chart in console.charts.all()
        if mission is None or not chart.missions or mission in chart.missions
    ]


@router.get("/charts/tiles")
def tiles(console: Served) -> ChartTiles:
    """Where a base map's tiles come from: nowhere, unless the settings name an address."""
    return ChartTiles(address=console.settings.tiles, attribution=console.settings.tiles_attribution)


@router.put("/charts/{name}", openapi_extra=_BYTES)
async def keep(
    console: Served, deed: Done, request: Request, name: str, placed: Annotated[Placed, Query()]
) -> ChartSummary:
    """Read a chart's bytes and keep them, new or in place of the one of that name.

    GeoJSON, KML and KMZ are drawn; a GeoTIFF with one band of depths or an ESRI ASCII grid is a depth grid; a
    GeoTIFF with colours, or a PNG, JPEG or WebP with `corners`, is a picture. What is none of these is
    refused (422) with the reason.
    """
    said = Said(placed.corners, placed.local, placed.depths, placed.epsg)
    data = await request.body()
    try:
        chart = await run_in_threadpool(console.charts.put, name, data, placed.file_name, said)
    except NotAChart as error:
        raise Refusal(422, f"{placed.file_name} {error}") from error
    deed.tell(file=placed.file_name, kind=chart.kind, bytes=len(data))
    return ChartSummary.of(chart)


@router.put("/charts/{name}/owners")
def own(console: Served, deed: Done, name: str, wanted: Owners = Body(...)) -> ChartSummary:
    """Give a chart a title, or to the missions that it belongs to."""
    missions = None if wanted.missions is None else tuple(dict.fromkeys(wanted.missions))
    before = console.charts.get(name)
    chart = console.charts.own(name, wanted.title, missions)
    deed.tell(title=[before.title, chart.title], missions=[list(before.missions), list(chart.missions)])
    return ChartSummary.of(chart)


@router.get("/charts/{name}/file", response_class=Response)
def file(console: Served, name: str) -> Response:
    """The chart's file, byte for byte."""
    chart = console.charts.get(name)
    return Response(
        console.charts.original(name),
        media_type="application/octet-stream",
        headers={"content-disposition": f'attachment; filename="{chart.saved_as}"'},
    )


@router.get("/charts/{name}/picture", response_class=Response)
def picture(console: Served, name: str) -> Response:
    """A picture as PNG."""
    data = console.charts.picture(name)
    return Response(data, media_type="image/png", headers={"cache-control": "no-cache"})


@router.get("/charts/{name}/shown")
def show(
    console: Served,
    name: str,
    latitude_deg: Annotated[float | None, Query(ge=-89, le=89)] = None,
    longitude_deg: Annotated[float | None, Query(ge=-180, le=180)] = None,
    heading_deg: Annotated[float, Query(ge=-360, le=360)] = 0.0,
) -> ChartShown:
    """A chart in metres of a mission's frame, whose origin the query tells.

    A chart that lies on the earth needs it (422 without); one in m of the local frame does not look at it.
    """
    origin = None
    if latitude_deg is not None and longitude_deg is not None:
        origin = Origin(latitude_deg=latitude_deg, longitude_deg=longitude_deg, heading_deg=heading_deg)
    try:
        return ChartShown.of(shown(console.charts, name, origin))
    except NotPlaced as error:
        raise Refusal(422, str(error)) from error


@router.delete("/charts/{name}", status_code=204)
def remove(console: Served, name: str) -> Response:
    """Delete a chart for good; missions that name it as their sea floor then say that it is missing."""
    console.charts.delete(name)
    return Response(status_code=204)
