"""Figures of the reports, drawn with matplotlib."""

from __future__ import annotations

# The colours of the reports (report/figure.hpp: SeriesRole).
_COLOURS = {"data": "#0072b2", "held_out": "#009e73", "model": "#d55e00", "unstable": "#d55e00", "hopf": "#7b3294",
            "alternative": "#e69f00", "reference": "#888888"}
_DASHES = {"unstable": "--", "hopf": ":"}
# Series of one group share a marker and differ from other groups by it.
_MARKERS = "osD^v<>p"


def _label(axis: dict) -> str:
    return f"{axis['label']} ({axis['unit']})" if axis["unit"] else axis["label"]


def _outlines(x: list, y: list) -> list:
    """The closed outlines of a region: x and y of each; a value that is no number ends one."""
    outlines: list = [([], [])]
    for a, b in zip(x, y):
        if a == a and b == b:
            outlines[-1][0].append(a)
            outlines[-1][1].append(b)
        elif outlines[-1][0]:
            outlines.append(([], []))
    return [outline for outline in outlines if outline[0]]


def _draw_series(axes, series: dict) -> None:
    colour, label = _COLOURS[series["role"]], series["name"] or None
    marker = _MARKERS[(series["group"] or 0) % len(_MARKERS)]
    face = "none" if series["role"] == "held_out" else colour
    line = _DASHES.get(series["role"], "-")
    style, x, y = series["style"], series["x"], series["y"]
    if style == "band":
        low = [a - b for a, b in zip(y, series["y_error"])]
        high = [a + b for a, b in zip(y, series["y_error"])]
        axes.fill_between(x, low, high, color=colour, alpha=0.25, linewidth=0, label=label)
    elif style == "region":
        for i, (a, b) in enumerate(_outlines(x, y)):
            axes.fill(a, b, color=colour, alpha=0.25, linewidth=0, label=None if i else label)
    elif style == "error_bars":
        axes.errorbar(x, y, yerr=series["y_error"], color=colour, marker=marker, markersize=4, markerfacecolor=face,
                      linestyle="none", capsize=2, label=label)
    else:
        axes.plot(x, y, color=colour, label=label, markersize=4, markerfacecolor=face,
                  linestyle="none" if style == "points" else line, marker="" if style == "line" else marker)


def draw(content: dict, figure=None):
    """A figure of the core (see _core.pyi) as a matplotlib figure, panels below one another."""
    from matplotlib import pyplot

    panels = content["panels"]
    if figure is None:
        figure = pyplot.figure(figsize=(8, 1.5 + 2.5 * len(panels)), layout="constrained")
    all_axes = figure.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0]
    for axes, panel in zip(all_axes, panels):
        for series in panel["series"]:
            _draw_series(axes, series)
        if panel["zero_line"]:
            axes.axhline(0, color="black", linewidth=0.8)
        axes.set_ylabel(_label(panel["y"]))
        if panel["y"]["logarithmic"]:
            axes.set_yscale("log")
        if panel["title"]:
            axes.set_title(panel["title"])
        if any(series["name"] for series in panel["series"]):
            axes.legend(fontsize="small")
    all_axes[-1].set_xlabel(_label(content["x"]))
    if content["x"]["logarithmic"]:
        all_axes[-1].set_xscale("log")
    figure.suptitle(content["title"])
    return figure
