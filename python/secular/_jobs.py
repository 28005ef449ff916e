"""Numbers of a model from a campaign, what the model lacks, and virtual tests."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _checks, _core
from ._campaign import Campaign, as_campaign
from ._errors import NumericalFailure
from ._model import Model, model_source
from ._result import Result, html_table


@dataclass(frozen=True)
class Value:
    """A number with its error bar, or the reason why there is none.

    value, sd, ci95: in `unit`; None where the data do not identify it. doubtful: may be off by more than its error bar.
    why: in words, what there is to say against it; empty: nothing. definition, case: of a
    lump. fields: all that estimate.json says.
    """

    name: str
    value: Optional[float]
    sd: Optional[float]
    ci95: Optional[Tuple[float, float]]
    unit: str
    identifiable: bool
    significant: bool
    doubtful: bool
    fixed: bool
    why: str
    definition: str = ""
    case: str = ""
    fields: dict = field(default_factory=dict, repr=False, compare=False)


def _why(entry: dict) -> str:
    if entry.get("fixed"):
        return "given"
    if entry["value"] is None:
        others = entry.get("entangled_with", [])
        return "not identifiable" + (", entangled with " + ", ".join(others) if others else "")
    if entry.get("doubtful"):
        return "doubtful: " + "; ".join(entry["doubtful_because"])
    return "" if entry["significant"] else "does not differ from zero at 95 %"


def _value(entry: dict) -> Value:
    interval = entry["ci95"]
    return Value(entry["name"], entry["value"], entry["sd"], tuple(interval) if interval else None, entry["unit"],
                 entry["identifiable"], entry["significant"], entry.get("doubtful", False), entry.get("fixed", False),
                 _why(entry), entry.get("definition", ""), entry.get("case", ""), entry)


class _Estimated(Result):
    """What an identification and a diagnosis have in common.

    status: "done", where the program would exit with 0; "not converged"; "mostly left out" (numbers from less than half
    of the records); "failed" (there are no numbers). disturbances: what the records hold beside the motion.
    """

    def __init__(self, core, reason: str = ""):
        super().__init__(core, reason)
        if core is not None and core.mostly_left_out:
            self.status, self.reason = "mostly left out", core.mostly_left_out
        self.disturbances: list[dict] = self.data.get("disturbances", [])

    def to_html(self) -> str:
        """The report that the program writes, one self-contained page."""
        return self._found().report("Python")

    def plot(self, figure=None):
        """Draws the report's first figure with matplotlib, into `figure` where one is given. Returns the figure."""
        from ._plot import draw

        return draw(self._found().figure(), figure)


class Identification(_Estimated):
    """Estimates of a model's parameters (docs/reading_an_estimate.md says what they mean).

    values, lumps: lists of Value; result["mu1"] is that of one symbol. names, estimates, standard_deviations, units: of
    `values`, NaN where there is no number. covariance: array over covariance_names, the values that were estimated.
    plot(): measured against model.
    """

    def __init__(self, core, reason: str = ""):
        super().__init__(core, reason)
        if self.data.get("quality", {}).get("converged") is False:
            ended = "the fit did not come to an end"
            self.status, self.reason = "not converged", f"{ended}; {self.reason}" if self.reason else ended
        self.values = [_value(entry) for entry in self.data.get("estimates", [])]
        self.lumps = [_value(entry) for entry in self.data.get("lumps", [])]
        covariance = self.data.get("covariance", {"names": [], "matrix": []})
        self.covariance_names: list[str] = covariance["names"]
        size = len(self.covariance_names)
        self.covariance = np.array(covariance["matrix"], dtype=float).reshape(size, size)

    @property
    def names(self) -> list[str]:
        return [value.name for value in self.values]

    @property
    def units(self) -> list[str]:
        return [value.unit for value in self.values]

    @property
    def estimates(self) -> np.ndarray:
        return np.array([value.value for value in self.values], dtype=float)

    @property
    def standard_deviations(self) -> np.ndarray:
        return np.array([value.sd for value in self.values], dtype=float)

    def __contains__(self, name: object) -> bool:
        return name in self.names

    def __getitem__(self, name: str) -> Value:
        for value in self.values:
            if value.name == name:
                return value
        raise KeyError(name)

    def to_pandas(self):
        """A data frame with one row for each value: value, sd, low, high (95 %), unit, doubtful, why."""
        import pandas

        low, high = zip(*[value.ci95 or (np.nan, np.nan) for value in self.values]) if self.values else ((), ())
        return pandas.DataFrame(
            {"value": self.estimates, "sd": self.standard_deviations, "low": low, "high": high, "unit": self.units,
             "doubtful": [value.doubtful for value in self.values], "why": [value.why for value in self.values]},
            index=pandas.Index(self.names, name="name"))

    def _rows(self):
        return [(v.name, "" if v.value is None else f"{v.value:.6g}", "" if v.sd is None else f"{v.sd:.2g}", v.unit,
                 v.why) for v in self.values]

    def _repr_html_(self) -> str:
        return html_table(f"Identification: {self.status} {self.reason}", ("", "value", "sd", "unit", ""), self._rows())

    def __repr__(self) -> str:
        lines = [f"<secular.Identification: {self.status}{', ' + self.reason if self.reason else ''}"]
        return "\n".join(lines + ["  {:<12} {:>12} ± {:<8} {:<14} {}".format(*row) for row in self._rows()]) + ">"


@dataclass(frozen=True)
class Cause:
    """An effect that the model may lack.

    effect: its name in the catalogue; mode: the equation it acts in; probability: of 1; symbol, coefficient, sd: its
    strength, None where it has none; closed: the share of the gap that it closes.
    """

    effect: str
    mode: str
    probability: float
    symbol: str
    coefficient: Optional[float]
    sd: Optional[float]
    closed: Optional[float]


class Diagnosis(_Estimated):
    """Where model and measurement disagree, and why (docs/reading_a_diagnosis.md).

    verdict: "no_gap", "cause" (`cause` names it), "set" (one of `causes_left`), "approximate" (`causes_left` act like
    it) or "unknown" (unknown_because). gap_detected, p_value: whether there is a gap at all. causes: list of Cause, the
    most probable first. closed, closed_ci95: share of the gap that the best explanation closes, with its 95 % interval.
    plot(): what the equation of motion leaves, as the model is and with the best explanation.
    """

    def __init__(self, core, reason: str = ""):
        super().__init__(core, reason)
        gap = self.data.get("gap", {})
        self.verdict: Optional[str] = self.data.get("verdict")
        self.cause: Optional[str] = self.data.get("cause")
        self.causes_left: list[str] = self.data.get("set", [])
        self.unknown_because: str = self.data.get("unknown_because", "")
        self.gap_detected: Optional[bool] = gap.get("detected")
        self.p_value: Optional[float] = gap.get("p_value")
        self.closed: Optional[float] = gap.get("closed")
        self.closed_ci95: Optional[Tuple[float, float]] = tuple(gap["closed_ci95"]) if gap else None
        self.causes = [Cause(entry["effect"], entry["mode"], entry["probability"], entry.get("symbol", ""),
                             entry.get("coefficient"), entry.get("sd"), entry.get("closed"))
                       for entry in self.data.get("causes", [])]

    def to_pandas(self):
        """A data frame with one row for each cause."""
        import pandas

        return pandas.DataFrame([vars(cause) for cause in self.causes],
                                columns=["effect", "mode", "probability", "symbol", "coefficient", "sd", "closed"])

    def _head(self) -> str:
        return f"{self.status} {self.reason}" if self.verdict is None else \
            f"verdict {self.verdict}{': ' + self.cause if self.cause else ''}"

    def _rows(self):
        return [(f"{100 * cause.probability:.3g} %", cause.effect, cause.mode, cause.symbol,
                 "" if cause.coefficient is None else f"{cause.coefficient:.5g}") for cause in self.causes]

    def _repr_html_(self) -> str:
        return html_table(f"Diagnosis: {self._head()}", ("probability", "effect", "mode", "symbol", "coefficient"),
                           self._rows())

    def __repr__(self) -> str:
        rows = ["  {:>8}  {:<24} {:<8} {} {}".format(*row).rstrip() for row in self._rows()]
        return "\n".join([f"<secular.Diagnosis: {self._head()}", *rows]) + ">"


_SELECTION = {"band": "band_hz", "from": "from_s", "to": "to_s"}


def given_parameters(parameters) -> Tuple[str, Optional[str]]:
    """(name, text of JSON) or (file, None)."""
    if isinstance(parameters, Identification):
        return "the identification", parameters.to_json()
    if isinstance(parameters, Mapping):
        return "the parameters", json.dumps(_checks.numbers_by_symbol("parameters", parameters))
    return _checks.path("parameters", parameters), None


@_checks.in_keywords(_SELECTION)
def identify(campaign: Union[Campaign, str, os.PathLike], model: Union[Model, str, os.PathLike], *,
             case: Union[str, Sequence[str], None] = None, fix: Optional[Mapping[str, float]] = None,
             by: Optional[str] = None, records: Optional[str] = None, band_hz: Optional[Tuple[float, float]] = None,
             from_s: Optional[float] = None, to_s: Optional[float] = None, refine: bool = False, bootstrap: int = 0,
             seed: int = 1, threads: Optional[int] = None, interpret: bool = False) -> Identification:
    """Estimates of a model's parameters; what `secular identify` does.

    case: names of cases, chosen from the records without it. fix: symbol to known value. by: "full-equations" or
    "modulation-equations", chosen from the records without it; "both-equations" refines free decays. records: shell pattern of files to use; band_hz: (low,
    high); from_s, to_s: the part of every record to use, s of its own time. refine: maximum likelihood with errors in
    everything measured. bootstrap: resamples of the conditions, with `seed`. threads: all without it, the result does
    not depend on it. interpret: no compiled code. Raises InputError; a failure of the computation is the result's
    status.
    """
    options = dict(_checks.selection(records, band_hz, from_s, to_s, threads, interpret),
                   cases=_checks.names("case", case), fix=_checks.numbers_by_symbol("fix", fix),
                   by=_checks.optional(_checks.one_of, "by", by, "full-equations", "modulation-equations",
                                        "both-equations"),
                   refine=_checks.flag("refine", refine), bootstrap=_checks.whole("bootstrap", bootstrap, 0, 100000),
                   seed=_checks.seed(seed))
    try:
        return Identification(_core.identify(as_campaign(campaign)._core, model_source(model), options))
    except NumericalFailure as failure:
        return Identification(None, str(failure))


@_checks.in_keywords(_SELECTION)
def diagnose(campaign: Union[Campaign, str, os.PathLike], model: Union[Model, str, os.PathLike], *,
             parameters: Union[Identification, Mapping[str, float], str, os.PathLike, None] = None,
             without: Sequence[str] = (), records: Optional[str] = None,
             band_hz: Optional[Tuple[float, float]] = None, from_s: Optional[float] = None,
             to_s: Optional[float] = None, threads: Optional[int] = None, interpret: bool = False) -> Diagnosis:
    """Where model and measurement disagree, and which effect does it; what `secular diagnose` does.

    parameters: whose gap is asked for: an Identification, symbol to number, or a file; without it those that fit best.
    without: effects of the catalogue that are not to be considered. The rest as in `identify`.
    """
    given = None if parameters is None else given_parameters(parameters)
    options = dict(_checks.selection(records, band_hz, from_s, to_s, threads, interpret),
                   without=_checks.names("without", without))
    try:
        return Diagnosis(_core.diagnose(as_campaign(campaign)._core, model_source(model), given, options))
    except NumericalFailure as failure:
        return Diagnosis(None, str(failure))


@_checks.in_keywords({})
def simulate(experiment: Union[str, os.PathLike], *, seed: int = 1, threads: Optional[int] = None,
             interpret: bool = False, report: Union[str, os.PathLike, None] = None) -> Campaign:
    """A virtual test on the full equations of motion; what `secular simulate` does.

    experiment: a file, or "experiments/NAME" of a shipped one (docs/simulating.md). seed: of the measurement noise.
    report: a new file for a page that says what was simulated, and draws the records. Raises InputError.
    """
    source, page = _checks.path("experiment", experiment), _checks.optional(_checks.new_file, "report", report)
    campaign = _core.simulate(source, _checks.seed(seed), _checks.threads(threads),
                              _checks.flag("interpret", interpret))
    if page is not None:
        text = _core.simulation_report(campaign, source, seed)  # before the file: none stands where this fails
        with open(page, "x", encoding="utf-8") as stream:
            stream.write(text)
    return Campaign._of(campaign)
