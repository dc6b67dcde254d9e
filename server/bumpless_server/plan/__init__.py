"""Documents that people make before they fly: missions and saved parameters."""
