"""Steady responses of a model with numbers."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _checks, _core
from ._campaign import Campaign, as_campaign
from ._jobs import Identification, given_parameters
from ._model import Model, model_source
from ._result import Report, html_table, shown


@dataclass(frozen=True)
class SpecialPoint:
    """Where stability changes or branches meet: kind "saddle_node", "threshold", "hopf", "pitchfork",
    "transcritical", "branch_point" or "double_zero".

    parameter: of what is varied (rad/s where it is a frequency). amplitude: by mode, peak, in the coordinate's unit.
    outside_expansion: the expansion's range ends before it. fields: all that prediction.json says.
    """

    kind: str
    parameter: float
    amplitude: np.ndarray
    outside_expansion: bool
    fields: dict = field(repr=False, compare=False)


@dataclass(frozen=True, eq=False)
class Branch:
    """Steady responses that hang together, point by point.

    parameter: array (points,) of what is varied, rad/s where it is a frequency. amplitude: array points x modes, peak,
    in the coordinates' units; phase: the same, rad, at the excitation's peak. stable, outside_expansion: arrays
    (points,) of bool. eigenvalues: by point, complex, 1/s. special_points: list of SpecialPoint, solutions that
    differ in phase alone once. ends: why the branch begins and ends where it does. A closed branch may pass through
    solutions that differ in phase alone, one behind the other: amplitudes come again, phases do not.
    """

    at_rest: bool
    closed: bool
    parameter: np.ndarray
    amplitude: np.ndarray
    phase: np.ndarray
    stable: np.ndarray
    outside_expansion: np.ndarray
    eigenvalues: Sequence[np.ndarray]
    special_points: Sequence[SpecialPoint]
    ends: Tuple[str, str]


@dataclass(frozen=True, eq=False)
class Curve:
    """Special points of one kind in the plane of two parameters (`vary`, `against`).

    first, second: arrays (points,), rad/s where they are frequencies; amplitude: array points x modes, peak.
    special_points: cusps and double zeros, as prediction.json says them.
    """

    kind: str
    closed: bool
    first: np.ndarray
    second: np.ndarray
    amplitude: np.ndarray
    outside_expansion: np.ndarray
    special_points: Sequence[dict]


@dataclass(frozen=True, eq=False)
class Backbone:
    """Free vibration of one mode: arrays (points,) of peak amplitude, frequency (rad/s) and growth (1/s)."""

    mode: str
    amplitude: np.ndarray
    frequency: np.ndarray
    growth: np.ndarray
    outside_expansion: np.ndarray


@dataclass(frozen=True, eq=False)
class Sweep:
    """Dwells of the full equations of motion, one behind the other: direction "up" or "down".

    parameter, settled: arrays (dwells,); amplitude: array dwells x modes, peak. jumps: list of what prediction.json
    says of each.
    """

    direction: str
    parameter: np.ndarray
    amplitude: np.ndarray
    settled: np.ndarray
    jumps: Sequence[dict]


@dataclass(frozen=True, eq=False)
class MeasuredDwell:
    """A dwell of a campaign: its parameter; amplitude and sd_between_ensembles by mode, peak."""

    record: str
    group: str
    parameter: float
    amplitude: np.ndarray
    sd_between_ensembles: np.ndarray


@dataclass(frozen=True)
class LargestResponse:
    """The largest stable response of a mode within the expansion's range.

    kind: "peak" (the amplitude is level there), "range_end" (of what is varied), "stability_end" (beyond it the
    response is unstable) or "search_end". parameter: of what is varied, rad/s where it is a frequency; amplitude:
    peak, in the coordinate's unit. parameter_sd, amplitude_sd: one standard deviation, None where there is none.
    """

    mode: str
    kind: str
    parameter: float
    amplitude: float
    parameter_sd: Optional[float]
    amplitude_sd: Optional[float]


def _amplitudes(points: Sequence[dict], key: str = "amplitude") -> np.ndarray:
    return np.array([[mode[key] for mode in point["modes"]] for point in points], dtype=float)


def _array(points: Sequence[dict], key: str, kind: type = float) -> np.ndarray:
    return np.array([point[key] for point in points], dtype=kind)


def _branch(entry: dict, name: str) -> Branch:
    points = entry["points"]
    special = [SpecialPoint(at["kind"], at[name], _amplitudes([at])[0], at["outside_expansion"], at)
               for at in entry["special_points"]]
    eigenvalues = [np.array([complex(*value) for value in point["eigenvalues"]]) for point in points]
    return Branch(entry["at_rest"], entry["closed"], _array(points, name), _amplitudes(points),
                  _amplitudes(points, "phase"), _array(points, "stable", bool),
                  _array(points, "outside_expansion", bool), eigenvalues, special,
                  (entry["ends"][0]["reason"], entry["ends"][1]["reason"]))


class Prediction(Report):
    """Steady responses, their stability and bifurcations (docs/predicting.md).

    model, case; parameters: symbol to number; units: symbol to unit, of an estimate or a measured campaign;
    coordinate_unit: the same, of amplitudes ("" where nothing says it); varied, against: names of what is varied ("" for none); modes: names of
    the coordinates, by column of the amplitudes. largest: list of LargestResponse, one a mode; branches: list of Branch; curves: list of Curve (`curve` was asked
    for); backbones: list of Backbone (a case without excitation); sweeps: list of Sweep; measured: list of
    MeasuredDwell. complete: every branch that was begun was followed to its end. Figures: "response" and "phases", or
    "plane" and "amplitude", or "backbone_MODE".
    """

    def __init__(self, core, reason: str = ""):
        super().__init__(core, reason)
        data = self.data
        varied = [entry["name"] for entry in data.get("varied", [])] + ["", ""]
        self.model: str = data["model"]
        self.case: str = data["case"]
        self.parameters: dict[str, float] = data["parameters"]
        self.units: dict[str, str] = data.get("units", {})
        self.coordinate_unit: str = data.get("coordinate_unit", "")
        self.varied: str = varied[0]
        self.against: str = varied[1]
        self.complete: bool = data.get("complete", True)
        self.branches = [_branch(entry, self.varied) for entry in data.get("branches", [])]
        self.largest = [LargestResponse(entry["mode"], entry["kind"], entry[self.varied], entry["amplitude"],
                                        entry.get(self.varied + "_sd"), entry.get("amplitude_sd"))
                        for entry in data.get("largest", [])]
        self.curves = [Curve(entry["kind"], entry["closed"], _array(entry["points"], self.varied),
                             _array(entry["points"], self.against), _amplitudes(entry["points"]),
                             _array(entry["points"], "outside_expansion", bool), entry["special_points"])
                       for entry in data.get("curves", [])]
        self.backbones = [Backbone(entry["mode"], *(_array(entry["points"], key)
                                                    for key in ("amplitude", "frequency", "growth")),
                                   _array(entry["points"], "outside_expansion", bool))
                          for entry in data.get("backbones", [])]
        self.sweeps = [Sweep(entry["direction"], _array(entry["points"], self.varied),
                             _array(entry["points"], "amplitude"), _array(entry["points"], "settled", bool),
                             entry["jumps"]) for entry in data.get("simulated_sweeps", [])]
        self.measured = [MeasuredDwell(entry["record"], entry["group"], entry[self.varied],
                                       np.array(entry["amplitude"]), np.array(entry["sd_between_ensembles"]))
                         for entry in data.get("measured", [])]
        self.modes: list[str] = self._modes()

    def _modes(self) -> list[str]:
        for entry in [*self.data.get("branches", []), *self.data.get("curves", [])]:
            for point in entry["points"]:
                return [mode["mode"] for mode in point["modes"]]
        return [backbone.mode for backbone in self.backbones]

    def to_csv(self) -> str:
        """The text of prediction.csv: every point, one line each."""
        return self._found().texts["prediction.csv"]

    def to_pandas(self):
        """A data frame with the rows of prediction.csv."""
        import io

        import pandas

        return pandas.read_csv(io.StringIO(self.to_csv()))

    def _rows(self) -> list[tuple]:
        rows = [(f"branch {number}{', at rest' if branch.at_rest else ''}", special.kind, shown(special.parameter, 7),
                 ", ".join(shown(a) for a in special.amplitude) + (
                     "  (outside of the expansion's range)" if special.outside_expansion else ""))
                for number, branch in enumerate(self.branches, 1) for special in branch.special_points]
        rows += [(f"largest of {at.mode}", at.kind, shown(at.parameter, 7), shown(at.amplitude) + (
            "" if at.amplitude_sd is None else f" +- {shown(at.amplitude_sd, 2)}")) for at in self.largest]
        rows += [(f"curve {number}", curve.kind, f"{len(curve.first)} points", "")
                 for number, curve in enumerate(self.curves, 1)]
        rows += [(f"backbone of {line.mode}", "", f"{line.frequency[0]:.7g} to {line.frequency[-1]:.7g} rad/s",
                  f"up to {line.amplitude[-1]:.5g}") for line in self.backbones]
        return rows

    def _repr_html_(self) -> str:
        return html_table(f"Prediction of {self.model}, case {self.case}",
                          ("where", "kind", self.varied, "peak amplitude"), self._rows())

    def __repr__(self) -> str:
        rows = ["  {:<18} {:<12} {:>14}  {}".format(*row).rstrip() for row in self._rows()]
        return "\n".join([f"<secular.Prediction: {self.model}, case {self.case}", *rows]) + ">"


def _range(argument: str, value) -> Optional[Tuple[str, float, float]]:
    if value is None:
        return None
    if isinstance(value, (str, Mapping)) or not np.iterable(value) or len(given := list(value)) != 3:
        raise _checks.refused(argument, f"is {value!r}", "give (name, from, to)")
    return (_checks.text(argument, given[0]), _checks.real(argument, given[1]), _checks.real(argument, given[2]))


@_checks.in_keywords({"band": "band_hz", "from": "from_s", "to": "to_s"})
def predict(model: Union[Model, str, os.PathLike],
            parameters: Union[Identification, Mapping[str, float], str, os.PathLike], *, case: Optional[str] = None,
            vary: Optional[Tuple[str, float, float]] = None, at: Optional[Mapping[str, float]] = None,
            hz: bool = False, curve: Optional[str] = None, against: Optional[Tuple[str, float, float]] = None,
            largest: Optional[float] = None, sweep: Union[str, Sequence[str], None] = None, sweep_steps: int = 60,
            measured: Union[Campaign, str, os.PathLike, None] = None, records: Optional[str] = None,
            band_hz: Optional[Tuple[float, float]] = None, from_s: Optional[float] = None,
            to_s: Optional[float] = None, threads: Optional[int] = None) -> Prediction:
    """Steady responses, their stability and bifurcations; what `secular predict` does.

    parameters: an Identification, symbol to number, a file, or the name of a shipped one ("predictions/table_5_4").
    case: may be left out where there is one; without excitation its backbones are computed. vary: (name, from, to), in
    rad/s where it is a frequency, in Hz with `hz`. at: other numbers: symbols, the excitation's amplitude and
    frequency. curve: "saddle_node", "threshold", "hopf" or "peak" in the plane of `vary` and `against`. largest: peak
    amplitude up to which responses are looked for; chosen without it. sweep: "up", "down" or both: simulated sweeps of
    the full equations, of sweep_steps dwells. measured: a campaign whose dwells at this excitation are drawn, the part
    of it that records, band_hz, from_s and to_s say. Raises InputError.
    """
    _checks.only_with("measured", measured, dict(records=records, band_hz=band_hz, from_s=from_s, to_s=to_s))
    directions = _checks.names("sweep", sweep)
    for direction in directions:
        _checks.one_of("sweep", direction, "up", "down")
    curves = ("saddle_node", "threshold", "hopf", "peak")
    options = dict(_checks.window(records, band_hz, from_s, to_s), case=_checks.optional_text("case", case) or "",
                   vary=_range("vary", vary), against=_range("against", against),
                   at=_checks.numbers_by_symbol("at", at), hz=_checks.flag("hz", hz),
                   curve=_checks.optional(_checks.one_of, "curve", curve, *curves) or "",
                   largest=_checks.optional(_checks.positive, "largest", largest) or 0.0, sweep=directions,
                   sweep_steps=_checks.whole("sweep_steps", sweep_steps, 2, 100000), threads=_checks.threads(threads))
    campaign = None if measured is None else as_campaign(measured)._core
    return Prediction(_core.predict(model_source(model), given_parameters(parameters), campaign, options))
