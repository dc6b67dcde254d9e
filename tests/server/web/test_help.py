"""Help: the built docs below /help/, with their own policy, behind the same guard; or a friendly word."""

from pathlib import Path

import httpx
import pytest
from fastapi import FastAPI

from bumpless_server.web.routes import help as help_pages
from docs import build


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The docs, built."""
    folder = tmp_path_factory.mktemp("site")
    build.make(folder)
    return folder


def asking(folder: Path) -> httpx.AsyncClient:
    """Ask an application that serves the help in `folder`."""
    app = FastAPI()
    help_pages.mount(app, folder)
    return httpx.AsyncClient(
        transport=httpx.ASGITransport(app), base_url="http://console", follow_redirects=True
    )


async def test_every_script_of_a_page_is_allowed_and_no_other(site: Path) -> None:
    """Protects: the theme works under the policy, and injected script does not."""
    async with asking(site) as client:
        answer = await client.get("/help/method.html")
    policy = answer.headers["content-security-policy"]
    scripts = policy.split("script-src ")[1].split(";")[0].split()
    assert answer.status_code == 200 and "unsafe-inline" not in scripts
    assert policy == build.policy(site)
    assert build.SCRIPT.findall(answer.content) and any(one.startswith("'sha256-") for one in scripts)


async def test_only_what_has_a_version_is_kept(site: Path) -> None:
    """Protects: after an update the browser shows the new pages, and still loads no style twice."""
    async with asking(site) as client:
        assert (await client.get("/help/")).headers["cache-control"] == "no-cache"
        kept = (await client.get("/help/_static/site.css?v=1")).headers["cache-control"]
        assert kept.endswith("immutable")
        assert (await client.get("/help/nowhere.html?v=1")).status_code == 404
        assert (await client.get("/help")).url.path == "/help/"


async def test_without_built_docs_help_says_how_to_get_them(tmp_path: Path) -> None:
    """Protects: Help is never a bare 404 on a machine that has not built the docs."""
    async with asking(tmp_path) as client:
        answer = await client.get("/help/")
    assert answer.status_code == 200 and "make docs" in answer.text
