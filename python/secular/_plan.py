"""Tests that determine chosen parameters best."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Mapping, Optional, Sequence, Tuple, Union

from . import _checks, _core
from ._campaign import Campaign
from ._errors import InputError, NumericalFailure
from ._jobs import Identification, given_parameters
from ._model import Model, model_source
from ._result import Report, html_table, shown


@dataclass(frozen=True)
class PlannedDwell:
    """A dwell: frequency_hz, amplitude (peak, in the excitation's unit), ensembles to record, settle_s before.

    responds: it has a stable response; response: its peak by coordinate.
    """

    frequency_hz: float
    amplitude: float
    ensembles: int
    settle_s: float
    needed_s: Optional[float]
    responds: bool
    response: Mapping[str, float]


@dataclass(frozen=True)
class Programme:
    """Dwells with their time (s): as programmed, and with settling as the plan has it. sd: predicted, by unknown."""

    dwells: Sequence[PlannedDwell]
    time_s: float
    settled_time_s: Optional[float]
    sd: Mapping[str, Optional[float]]


@dataclass(frozen=True)
class WantedParameter:
    """A number to be determined: its rough value, the sd that the plan promises, and that of the programme in use."""

    name: str
    value: float
    unit: str
    sd: Optional[float]
    sd_in_use: Optional[float]


def _programme(entry: Optional[dict]) -> Optional[Programme]:
    if entry is None:
        return None
    return Programme([PlannedDwell(**dwell) for dwell in entry["dwells"]], entry["time_s"], entry["settled_time_s"],
                     entry["sd"])


class Plan(Report):
    """A test (docs/planning_a_test.md).

    status: "failed" where the search took longer than limit_s. model, case; wanted: list of WantedParameter; dwells:
    list of PlannedDwell; units: of their "amplitude" and "response"; time_s; programme, in_use: Programme (in_use: of `against`, or None). candidates: how many
    dwells it was chosen from. Figure: "dwells".
    """

    def __init__(self, core, reason: str = "", model_is_text: bool = False):
        super().__init__(core, reason)
        data = self.data
        self._model_is_text = model_is_text
        self.model: str = data.get("model", "")
        self.case: str = data.get("case", "")
        self.candidates: int = data.get("candidates", 0)
        self.wanted = [WantedParameter(**entry) for entry in data.get("wanted", [])]
        self.programme: Optional[Programme] = _programme(data.get("plan"))
        self.in_use: Optional[Programme] = _programme(data.get("in_use"))
        self.units: dict[str, str] = data.get("units", {})
        self.dwells: Sequence[PlannedDwell] = self.programme.dwells if self.programme else []
        self.time_s: Optional[float] = self.programme.time_s if self.programme else None

    def to_toml(self) -> str:
        """The text of plan.toml: an experiment for `simulate`."""
        found = self._found()
        if self._model_is_text:
            remedy = "write the model to a file and plan with its path"
            fault = "is a text, which an experiment cannot name"
            raise InputError(f"model: {fault}; {remedy}", "model", "", fault, remedy)
        return found.texts["plan.toml"]

    def save_experiment(self, file: Union[str, os.PathLike]) -> Path:
        """Writes that file, a new one."""
        with open(file, "x", encoding="utf-8") as stream:
            stream.write(self.to_toml())
        return Path(file)

    def to_pandas(self):
        """A data frame with one row for each dwell."""
        import pandas

        return pandas.DataFrame([{**vars(dwell), **{f"response {name}": size for name, size in dwell.response.items()}}
                                 for dwell in self.dwells]).drop(columns="response", errors="ignore")

    def _head(self) -> str:
        return f"{self.status} {self.reason}" if self.programme is None else \
            f"{len(self.dwells)} dwells, {self.time_s:.0f} s"

    def _rows(self) -> list[tuple]:
        return [(wanted.name, shown(wanted.value), shown(wanted.sd, 3), shown(wanted.sd_in_use, 3), wanted.unit)
                for wanted in self.wanted]

    def _repr_html_(self) -> str:
        return html_table(f"Plan: {self._head()}", ("parameter", "rough value", "sd", "sd in use", "unit"),
                          self._rows())

    def __repr__(self) -> str:
        rows = ["  {:<12} {:>12} ± {:<9} {:<9} {}".format(*row).rstrip() for row in self._rows()]
        return "\n".join([f"<secular.Plan: {self._head()}", *rows]) + ">"


@_checks.in_keywords({"for": "wanted", "range-frequency": "frequency_hz", "range-amplitude": "amplitude",
                      "budget-s": "budget_s", "settle-limit": "settle_limit_s", "limit": "limit_s",
                      "sample-rate": "sample_rate_hz"})
def plan(model: Union[Model, str, os.PathLike],
         parameters: Union[Identification, Mapping[str, float], str, os.PathLike],
         wanted: Union[str, Sequence[str]], *, frequency_hz: Tuple[float, float], amplitude: Tuple[float, float],
         case: Optional[str] = None, fix: Union[str, Sequence[str], None] = None, criterion: str = "D",
         budget_s: Optional[float] = None, against: Union[Campaign, str, os.PathLike, None] = None,
         records: Optional[str] = None, noise: float = 0.05, excitation_noise: float = 0.05,
         dwell_scatter: float = 0.0, ensembles: Sequence[int] = (2, 5, 10, 20, 40), ensemble_s: float = 4.0,
         sample_rate_hz: float = 256.0, least: Optional[int] = None, settled: float = 1e-3,
         settle_limit_s: float = 600.0, frequencies: int = 40, levels: int = 8, limit_s: float = 600.0) -> Plan:
    """Dwells that determine chosen numbers best; what `secular plan` does.

    parameters: rough values, as in `predict`. wanted: lumps or natural frequencies. frequency_hz, amplitude: (low,
    high) of the excitation, Hz and peak. fix: lumps or natural frequencies that are known. criterion: "D" determinant,
    "A" relative variances, "c" one parameter. budget_s: laboratory time, s; without it what `against` needs is reached
    sooner. against: the programme in use: a campaign (the part of it that `records` names), or an experiment file.
    noise, excitation_noise: standard deviations of a sample of the modal acceleration and of the excitation.
    dwell_scatter: relative, of amplitudes from dwell to dwell. ensembles: how many a dwell may have; ensemble_s,
    sample_rate_hz: of each. least: dwells. settled: share of a disturbance that may be left; slower ones than
    settle_limit_s are no candidates. frequencies, levels: of the grid. limit_s: wall time of the search. Raises
    InputError.
    """
    _checks.only_with("against", against, dict(records=records))
    campaign = against._core if isinstance(against, Campaign) else None
    name = "" if against is None or campaign is not None else _checks.path("against", against)
    options = dict(_checks.window(records), case=_checks.optional_text("case", case) or "",
                   wanted=_checks.not_empty("wanted", _checks.names("wanted", wanted)), fix=_checks.names("fix", fix),
                   criterion=_checks.one_of("criterion", criterion, "D", "A", "c"),
                   frequency_hz=_checks.pair("frequency_hz", frequency_hz),
                   amplitude=_checks.pair("amplitude", amplitude),
                   budget_s=_checks.optional(_checks.positive, "budget_s", budget_s), against=name,
                   noise=_checks.positive("noise", noise),
                   excitation_noise=_checks.not_negative("excitation_noise", excitation_noise),
                   dwell_scatter=_checks.not_negative("dwell_scatter", dwell_scatter),
                   ensembles=_checks.whole_numbers("ensembles", ensembles, 1, 10000),
                   ensemble_s=_checks.positive("ensemble_s", ensemble_s),
                   sample_rate_hz=_checks.positive("sample_rate_hz", sample_rate_hz),
                   least=_checks.optional(_checks.whole, "least", least, 1, 1000),
                   settled=_checks.within("settled", settled, 1e-9, 0.5),
                   settle_limit_s=_checks.positive("settle_limit_s", settle_limit_s),
                   frequencies=_checks.whole("frequencies", frequencies, 2, 1000),
                   levels=_checks.whole("levels", levels, 1, 200), limit_s=_checks.positive("limit_s", limit_s))
    source = model_source(model)
    try:
        found = _core.plan(source, given_parameters(parameters), campaign, options)
    except NumericalFailure as failure:
        return Plan(None, str(failure))
    return Plan(found, model_is_text="\n" in source)
