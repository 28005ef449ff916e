"""Models and what is derived from them."""

from __future__ import annotations

import json
import os
import re
from typing import Optional, Sequence, Union

from . import _checks, _core


class Model:
    """A model: the name of a shipped one (`secular.shipped_models()`), a path, or the text of a model file.

    name; cases: names of its resonance cases; natural_frequencies: symbol to nominal value, rad/s (NaN: none given).
    """

    def __init__(self, model: Union[str, os.PathLike]):
        self.source = _checks.path("model", model)
        outline = _core.outline(self.source)
        self.name: str = outline["name"]
        self.cases: list[str] = outline["cases"]
        self.natural_frequencies: dict[str, float] = dict(zip(outline["natural_frequencies"], outline["nominal"]))

    def derive(self, case: Optional[str] = None, *, with_effects: Sequence[str] = ()) -> "Derivation":
        """See secular.derive."""
        return derive(self, case, with_effects=with_effects)

    def __repr__(self) -> str:
        return f"<secular.Model {self.name!r}: cases {', '.join(self.cases)}>"


def model_source(model: Union[Model, str, os.PathLike]) -> str:
    return model.source if isinstance(model, Model) else _checks.path("model", model)


class Derivation:
    """The expansion of a model's cases: text, latex (a document), html (a page), data (what `--format json` prints).

    certified: put back into the equations of motion, every expansion leaves nothing up to its order.
    """

    def __init__(self, core):
        self._core = core
        self.data: dict = json.loads(core.document("json"))
        self.certified: bool = core.certified
        self.notices: list[str] = core.warnings

    @property
    def text(self) -> str:
        return self._core.document("text")

    @property
    def latex(self) -> str:
        return self._core.document("latex")

    @property
    def html(self) -> str:
        return self._core.document("html")

    def _repr_latex_(self) -> str:
        """The modulation equations of every case."""
        sections = re.findall(r"\\subsection\*\{Solvability[^}]*\}(.*?)(?=\\subsection|\\section|\\end\{document\})",
                              self.latex, re.DOTALL)
        return "\n".join(match.group(0) for section in sections
                         for match in re.finditer(r"\\begin\{align\*\}.*?\\end\{align\*\}", section, re.DOTALL))

    def modulation(self, case: Optional[str] = None) -> dict:
        """dA/dt by coordinate as SymPy expressions of A_<coordinate>, the excitation and the model's symbols.

        case: may be left out where there is one. All orders together, in true time; needs SymPy.
        """
        found = [entry for entry in self.data["cases"] if case in (None, entry["case"])]
        if len(found) != 1:
            raise KeyError(f"one of {[entry['case'] for entry in self.data['cases']]} was expected")
        return {coordinate: sum(_sympy_term(term) for term in terms)
                for coordinate, terms in found[0]["modulation"].items()}


def _sympy_term(term: dict):
    import sympy

    def expression(text: str):
        names = {"Pi": sympy.pi, "abs": sympy.Abs, "conj": sympy.conjugate, "sqrt": sympy.sqrt}
        for name in set(re.findall(r"[A-Za-z_]\w*", text)) - names.keys():
            names[name] = sympy.Symbol(name) if name.startswith("A_") else sympy.Symbol(name, real=True)
        return sympy.parse_expr(text.replace("^", "**"), local_dict=names)

    time = sympy.Symbol("t", real=True)
    phase = sum(multiple * sympy.Symbol(name, real=True) for name, multiple in term["slow_phase"].items())
    value = expression(term["real"]) + sympy.I * expression(term["imaginary"])
    return value * expression(term["powers"]) * sympy.exp(sympy.I * phase * time)


def derive(model: Union[Model, str, os.PathLike], case: Optional[str] = None, *,
           with_effects: Sequence[str] = ()) -> Derivation:
    """Expands a model's resonance cases (second-order multiple scales).

    case: one of them; all without it. with_effects: "NAME[:MODE[:OTHER[:FORM]]]" of effects of the catalogue that are
    added to the equations of motion.
    """
    return Derivation(_core.derive(model_source(model), _checks.optional_text("case", case) or "",
                                   _checks.names("with_effects", with_effects)))
