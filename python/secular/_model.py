"""Models and what is derived from them."""

from __future__ import annotations

import json
import os
import re
from dataclasses import dataclass
from typing import Mapping, Optional, Sequence, Union

from . import _checks, _core
from ._result import Result, html_table


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


@_checks.in_keywords({"with": "with_effects"})
def derive(model: Union[Model, str, os.PathLike], case: Optional[str] = None, *,
           with_effects: Sequence[str] = ()) -> Derivation:
    """Expands a model's resonance cases (second-order multiple scales).

    case: one of them; all without it. with_effects: "NAME[:MODE[:OTHER[:FORM]]]" of effects of the catalogue that are
    added to the equations of motion.
    """
    return Derivation(_core.derive(model_source(model), _checks.optional_text("case", case) or "",
                                   _checks.names("with_effects", with_effects)))


@dataclass(frozen=True)
class EvaluatedTerm:
    """One term: value (complex) times the powers of its symbols times exp(i phase).

    powers: "A_v", "conj_A_v", "abs_A_v", "F", ... to the exponent. phase: of a modulation term multiples of detunings
    times t (`slow_phase`), of a harmonic multiples of frequencies. order: power of eps, of a harmonic.
    """

    value: complex
    powers: Mapping[str, int]
    phase: Mapping[str, int]
    order: Optional[int] = None


class Evaluation(Result):
    """Numbers of a derivation.

    case, omega_policy; modulation: coordinate to the list of EvaluatedTerm of dA/dt (true time, eps = 1); harmonics:
    coordinate to the list of EvaluatedTerm beyond A exp(i omega t).
    """

    def __init__(self, core):
        super().__init__(core)
        self.case: str = self.data["case"]
        self.omega_policy: str = self.data["omega_policy"]
        self.modulation = {mode: [EvaluatedTerm(complex(*term["value"]), term["powers"], term["slow_phase"])
                                  for term in terms]
                           for mode, terms in self.data["modulation"].items()}
        self.harmonics = {mode: [EvaluatedTerm(complex(*term["value"]), term["powers"], term["phase"], term["order"])
                                 for term in terms] for mode, terms in self.data["harmonics"].items()}

    def to_pandas(self):
        """A data frame with one row for each term."""
        import pandas

        return pandas.DataFrame([{"of": of, "mode": mode, "value": term.value, "powers": term.powers,
                                  "phase": term.phase, "order": term.order}
                                 for of, table in (("modulation", self.modulation), ("harmonics", self.harmonics))
                                 for mode, terms in table.items() for term in terms])

    def _rows(self):
        def product(table):
            return " ".join(name if power == 1 else f"{name}^{power}" for name, power in table.items())

        return [(f"dA_{mode}/dt", product(term.powers), " + ".join(f"{n} {name}" for name, n in term.phase.items()),
                 f"{term.value:.6g}") for mode, terms in self.modulation.items() for term in terms]

    def _repr_html_(self) -> str:
        return html_table(f"Modulation of case {self.case}", ("of", "product", "phase / t", "value"), self._rows())

    def __repr__(self) -> str:
        rows = ["  {:<10} {:<24} {:<12} {}".format(*row) for row in self._rows()]
        return "\n".join([f"<secular.Evaluation of case {self.case}", *rows]) + ">"


@_checks.in_keywords({"at": "values"})
def evaluate(model: Union[Model, str, os.PathLike], case: str,
             values: Union[Mapping[str, float], str, os.PathLike], *, omega_policy: str = "nominal") -> Evaluation:
    """Numbers of a derivation: modulation terms and harmonics; what `secular evaluate` does.

    values: a number for every symbol, or a JSON file of them. omega_policy: "nominal", the excitation's frequency
    inside coefficients has its resonant value, or "kept". Raises InputError.
    """
    given = ("the values", _checks.numbers_by_symbol("values", values)) if isinstance(values, Mapping) else \
        (_checks.path("values", values), None)
    kept = _checks.one_of("omega_policy", omega_policy, "nominal", "kept") == "kept"
    return Evaluation(_core.evaluate(model_source(model), _checks.text("case", case), given, kept))
