"""What every room's tests share: deterministic Hypothesis, and one real Chromium per module."""

import os
import shutil
from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest
from hypothesis import settings

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytest_plugins = ["tests.flights", "tests.slow"]

settings.register_profile("bumpless", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("bumpless")

CHROMIUM_NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
CHROMIUM_FLAGS = [
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    # No graphics card is assumed: Mesa's software renderer draws the scene.
    "--use-angle=gl-egl",
    "--ignore-gpu-blocklist",
]


@pytest.fixture(scope="session")
def chromium_path() -> str:
    """Path of the system's Chromium, or the one that BUMPLESS_CHROMIUM names."""
    for name in (os.environ.get("BUMPLESS_CHROMIUM", ""), *CHROMIUM_NAMES):
        path = shutil.which(name) if name else None
        if path:
            return path
    pytest.fail("no Chromium found: run `make test`, or name one in BUMPLESS_CHROMIUM", pytrace=False)


@pytest.fixture(scope="module")
def browser(chromium_path: str) -> Iterator["Browser"]:
    """One headless Chromium per test module; closed before async tests of other modules run."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        instance = playwright.chromium.launch(executable_path=chromium_path, args=CHROMIUM_FLAGS)
        yield instance
        instance.close()


@pytest.fixture
def page(browser: "Browser") -> Iterator["Page"]:
    """A fresh page in its own context at 1440 x 900; fails the test on an uncaught script error."""
    context = browser.new_context(viewport={"width": 1440, "height": 900}, device_scale_factor=1)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    yield page
    context.close()
    assert not errors, f"uncaught errors in the page: {errors}"
