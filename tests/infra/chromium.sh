#!/bin/sh
# Makes sure that a Chromium is there for the browser tests; tests/conftest.py looks for the same names.
set -eu
for name in "${BUMPLESS_CHROMIUM:-chromium}" chromium chromium-browser google-chrome google-chrome-stable; do
    if command -v "$name" >/dev/null 2>&1; then exit 0; fi
done
as_root=""
if [ "$(id -u)" -ne 0 ]; then as_root="sudo -n"; fi
if ! command -v apt-get >/dev/null 2>&1 || ! $as_root true 2>/dev/null; then
    echo "The browser tests need Chromium. Install it (Debian: apt-get install chromium)," >&2
    echo "or name one: BUMPLESS_CHROMIUM=/path/to/chromium make test" >&2
    exit 1
fi
echo "Installing Chromium for the browser tests ..."
$as_root apt-get update -qq
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    chromium fonts-dejavu-core libegl-mesa0 libgl1-mesa-dri >/dev/null
