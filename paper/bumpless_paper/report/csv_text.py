"""A figure's data as CSV: one row per point, long form."""

import csv
import io

from bumpless_paper.report.content import Figure, Panel


def csv_of(figure: Figure) -> str:
    """Header panel,series,x,y for curves; body,vertex,<axes> for solids. Nine significant digits."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    if figure.panels and not isinstance(figure.panels[0], Panel):
        writer.writerow(["body", "vertex", "1", "2", "3"])
    else:
        writer.writerow(["panel", "series", "x", "y"])
    for panel in figure.panels:
        if isinstance(panel, Panel):
            for series in panel.series:
                for x, y in zip(series.x, series.y, strict=True):
                    writer.writerow([panel.y_label, series.name, f"{x:.9g}", f"{y:.9g}"])
        else:
            writer.writerow([panel.name, "axes", *panel.axes])
            for k, vertex in enumerate(panel.vertices):
                writer.writerow([panel.name, k, *(f"{value:.9g}" for value in vertex)])
    return out.getvalue()
