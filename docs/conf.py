"""How Sphinx builds the site (`make docs`): Markdown by MyST, the look by Furo, nothing from the network."""

import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS / "extensions"))

project = "Bumpless"
author = "The Bumpless developers"
html_title = "Bumpless"
language = "en"

extensions = ["myst_parser", "mathml", "code_pages"]
exclude_patterns = ["extensions", "generate"]
nitpicky = True

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
myst_url_schemes = {"http": None, "https": None, "mailto": None, "code": None}

html_theme = "furo"
html_math_renderer = "mathml"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_show_sourcelink = False
html_copy_source = False
html_use_index = False
html_show_sphinx = False
html_show_copyright = False
html_favicon = "../console_web/public/favicon.svg"
