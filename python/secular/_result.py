"""What results of all jobs have in common."""

from __future__ import annotations

import html
import json
from typing import Any, Optional, Sequence

from ._errors import NumericalFailure


class Result:
    """What results have in common.

    status: "done", where the program would exit with 0, or "failed" (there are no numbers); reason: why. notices: what
    there is to know of the records and the run, one line each. data: the content of the file that the program writes.
    """

    def __init__(self, core: Any, reason: str = ""):
        self._core = core
        self.reason = reason
        self.status = "failed" if core is None else "done"
        self.data: dict = json.loads(core.json()) if core is not None else {}
        self.notices: list[str] = core.notices if core is not None else []

    def _found(self) -> Any:
        if self._core is None:
            raise NumericalFailure(self.reason)
        return self._core

    def to_json(self) -> str:
        """The text of the file that the program writes, or prints with --json."""
        return self._found().json()


class Report(Result):
    """A result whose command writes a report.

    figures: names of the report's figures, for plot().
    """

    @property
    def figures(self) -> list[str]:
        return [] if self._core is None else self._core.figures

    def to_html(self) -> str:
        """The report that the program writes, one self-contained page."""
        return self._found().report("Python")

    def plot(self, name: Optional[str] = None, figure: Any = None) -> Any:
        """Draws a figure of the report with matplotlib.

        name: one of `figures`; the first without it. figure: of matplotlib, to draw into. Returns the figure.
        """
        from ._plot import draw

        core = self._found()
        return draw(core.figure(core.figures[0] if name is None else name), figure)


def html_table(caption: str, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    def line(cells, tag):
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"

    return (f"<table><caption>{html.escape(caption.strip())}</caption>" + line(heads, "th")
            + "".join(line(row, "td") for row in rows) + "</table>")


def shown(value: Any, digits: int = 5) -> str:
    """A number for a table; empty: there is none."""
    return "" if value is None else f"{value:.{digits}g}"
