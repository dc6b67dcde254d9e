"""The page travels compressed when the browser takes it, and again only when it has changed."""

import gzip
from pathlib import Path

import httpx
import pytest
from starlette.applications import Starlette

from bumpless_server.web.compressed import accepted
from bumpless_server.web.routes.page import Page

SCRIPT = b"let x = 1;" * 200
FORMS = {"": SCRIPT, ".gz": gzip.compress(SCRIPT), ".br": b"as brotli would have it"}


@pytest.fixture
def http(tmp_path: Path) -> httpx.AsyncClient:
    """The page of a build with one script in three forms, and an image in one."""
    (tmp_path / "assets").mkdir()
    for ending, data in FORMS.items():
        (tmp_path / "assets" / f"app-1a2b.js{ending}").write_bytes(data)
    (tmp_path / "index.html").write_text("<title>x</title>")
    app = Starlette()
    app.mount("/", Page(directory=tmp_path, html=True))
    return httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url="http://test")


async def _raw(http: httpx.AsyncClient, path: str, **headers: str) -> tuple[httpx.Response, bytes]:
    async with http.stream("GET", path, headers={"accept-encoding": "", **headers}) as answer:
        return answer, b"".join([part async for part in answer.aiter_raw()])


@pytest.mark.parametrize(
    ("takes", "encoding", "form"),
    [
        ("gzip, deflate, br", "br", ".br"),
        ("gzip", "gzip", ".gz"),
        ("br;q=0, gzip", "gzip", ".gz"),
        ("", None, ""),
    ],
)
async def test_the_smallest_form_that_is_taken_is_sent(
    http: httpx.AsyncClient, takes: str, encoding: str | None, form: str
) -> None:
    """Protects the bytes, their type and what caches are told of them."""
    answer, body = await _raw(http, "/assets/app-1a2b.js", **{"accept-encoding": takes})
    assert body == FORMS[form]
    assert answer.headers.get("content-encoding") == encoding
    assert answer.headers["content-type"].startswith("text/javascript")
    assert answer.headers["vary"] == "Accept-Encoding"
    assert answer.headers["cache-control"] == "public, max-age=31536000, immutable"


async def test_each_form_has_its_own_etag_and_is_not_sent_twice(http: httpx.AsyncClient) -> None:
    """Protects a cache from taking one form for another."""
    whole, _ = await _raw(http, "/assets/app-1a2b.js")
    small, _ = await _raw(http, "/assets/app-1a2b.js", **{"accept-encoding": "br"})
    assert whole.headers["etag"] != small.headers["etag"]
    match = {"accept-encoding": "br", "if-none-match": small.headers["etag"]}
    again, body = await _raw(http, "/assets/app-1a2b.js", **match)
    assert (again.status_code, body) == (304, b"")
    other, _ = await _raw(http, "/assets/app-1a2b.js", **{"if-none-match": small.headers["etag"]})
    assert other.status_code == 200


async def test_the_page_itself_is_asked_for_anew(http: httpx.AsyncClient) -> None:
    """Protects an updated server from a browser that keeps yesterday's page."""
    answer, _ = await _raw(http, "/", **{"accept-encoding": "br"})
    assert answer.headers["cache-control"] == "no-cache"
    assert "content-encoding" not in answer.headers


def test_a_refused_encoding_is_not_taken() -> None:
    """Protects proxies that say what they cannot read."""
    assert accepted("br;q=0, gzip;q=0.5 , zstd; q=0.0") == {"gzip"}
    assert accepted("") == set()
