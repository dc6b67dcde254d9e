"""Pages made from the code: `python -m docs.generate` writes them, `--check` says which are out of date.

One module per page; each has `page() -> str`, the page's Markdown. Nothing here needs a running server, a
compiled cycle or the network. The pages are committed, so that a reader without tools has them too.
"""
