"""The page at /scene/: viser's self-contained client with our script and style put in front.

Query: `theme=dark|light` (dark when absent), `quality=full|light` (light: one pixel per point or fewer,
for browsers without a GPU).
"""

import json
from functools import cache
from importlib import resources
from pathlib import Path

from bumpless_server.scene.palette import LEGEND, css

# viser's client decodes itself in WebAssembly and keeps its socket in a blob worker.
POLICY = "; ".join(
    [
        "default-src 'none'",
        "script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'",
        "worker-src blob:",
        "style-src 'self' 'unsafe-inline'",
        "img-src 'self' data: blob:",
        "connect-src 'self' data: blob:",
        "font-src 'self' data:",
        "frame-ancestors 'self'",
        "base-uri 'none'",
        "form-action 'none'",
    ]
)


@cache
def page_html() -> str:
    """The whole page; built once."""
    import viser

    client = (Path(viser.__file__).parent / "client" / "build" / "index.html").read_text(encoding="utf-8")
    files = resources.files("bumpless_server.scene") / "assets"
    style = (files / "scene.css").read_text(encoding="utf-8")
    legend = json.dumps([[css(rgb), name] for rgb, name in LEGEND], ensure_ascii=False)
    script = (files / "scene.js").read_text(encoding="utf-8").replace("__LEGEND__", legend)
    head = f"<head><script>{script}</script><style>{style}</style>"
    return client.replace("<head>", head, 1).replace(
        "<title>Viser</title>", "<title>Bumpless scene</title>", 1
    )
