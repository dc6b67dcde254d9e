"""Charts of the site and of missions: overlays to draw, and depth grids that missions keep clear of."""
