"""What records say by themselves: modes, and sums of tones and decays."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _checks, _core
from ._campaign import Campaign, ModalBasis, as_campaign
from ._errors import NumericalFailure
from ._result import Report, html_table, shown


@dataclass(frozen=True, eq=False)
class Mode:
    """A mode of vibration.

    natural_frequency_hz, damping_ratio with standard deviations and 95 % intervals (None where one degree of freedom or
    none tells them). pole: complex, rad/s. shape: complex array by channel, sum of squares one; shape_sd: of its real
    and imaginary parts, array 2 x channels. modal_mass, modal_mass_sd: kg, None where nothing tells it. motion:
    "decays", "grows" or "undetermined". fields: all that modal.json says.
    """

    name: str
    natural_frequency_hz: float
    natural_frequency_sd_hz: float
    natural_frequency_interval_hz: Optional[Tuple[float, float]]
    damping_ratio: float
    damping_ratio_sd: float
    damping_ratio_interval: Optional[Tuple[float, float]]
    pole: complex
    shape: np.ndarray
    shape_sd: np.ndarray
    modal_mass: Optional[float]
    modal_mass_sd: Optional[float]
    motion: str
    fields: dict = field(repr=False, compare=False)


def _interval(entry: Optional[Sequence[float]]) -> Optional[Tuple[float, float]]:
    return None if entry is None else (entry[0], entry[1])


def _mode(entry: dict) -> Mode:
    shape = entry["mode_shape"]
    return Mode(entry["name"], entry["natural_frequency_hz"], entry["natural_frequency_sd_hz"],
                _interval(entry["natural_frequency_interval_hz"]), entry["damping_ratio"], entry["damping_ratio_sd"],
                _interval(entry["damping_ratio_interval"]), complex(*entry["pole_rad_per_s"]),
                np.array(shape["real"]) + 1j * np.array(shape["imaginary"]),
                np.array([shape["real_sd"], shape["imaginary_sd"]], dtype=float), entry.get("modal_mass_kg"),
                entry.get("modal_mass_sd_kg"),
                entry["motion"], entry)


class ModalSurvey(Report):
    """Natural frequencies, damping and mode shapes.

    status: "failed" where no mode stands out of the noise. modes: list of Mode; result["v1"] is that of one. channels:
    names of the responses, unit: theirs. modal_assurance: array modes x modes. mass_normalised_shapes: array channels x
    modes, kg^(-1/2), None unless every mode has its mass; modal_basis(): the same for a Campaign. Figures:
    "stabilisation", "shapes", "amplitude_MODE", "response_GROUP".
    """

    def __init__(self, core, reason: str = ""):
        super().__init__(core, reason)
        self.channels: list[str] = self.data.get("channels", [])
        self.unit: str = self.data.get("unit", "")
        self.modes = [_mode(entry) for entry in self.data.get("modes", [])]
        self.modal_assurance = np.array(self.data.get("modal_assurance", []), dtype=float)
        shapes = self.data.get("mass_normalised_shapes")
        self.mass_normalised_shapes: Optional[np.ndarray] = None if shapes is None else np.array(shapes, dtype=float)

    def __getitem__(self, name: str) -> Mode:
        for mode in self.modes:
            if mode.name == name:
                return mode
        raise KeyError(f"{name}: the modes are {', '.join(mode.name for mode in self.modes)}")

    def modal_basis(self) -> ModalBasis:
        """For secular.Campaign(..., modal_basis=...). ValueError unless every mode has its mass."""
        if self.mass_normalised_shapes is None:
            raise ValueError("the modal masses are not known: impacts with a force channel tell them, or modal_masses")
        return ModalBasis(self.channels, [mode.name for mode in self.modes], self.mass_normalised_shapes)

    def to_pandas(self):
        """A data frame with one row for each mode."""
        import pandas

        columns = ["natural_frequency_hz", "natural_frequency_sd_hz", "damping_ratio", "damping_ratio_sd",
                   "modal_mass", "modal_mass_sd", "motion"]
        return pandas.DataFrame([[getattr(mode, column) for column in columns] for mode in self.modes],
                                index=[mode.name for mode in self.modes], columns=columns)

    def _head(self) -> str:
        return f"{self.status} {self.reason}" if self._core is None else \
            f"{len(self.modes)} modes of {len(self.channels)} channels"

    def _rows(self) -> list[tuple]:
        return [(mode.name, f"{mode.natural_frequency_hz:.6g}", f"{mode.natural_frequency_sd_hz:.2g}",
                 f"{100 * mode.damping_ratio:.4g}", f"{100 * mode.damping_ratio_sd:.2g}", shown(mode.modal_mass))
                for mode in self.modes]

    def _repr_html_(self) -> str:
        return html_table(f"Modal survey: {self._head()}",
                          ("mode", "frequency, Hz", "sd", "damping, %", "sd", "modal mass, kg"), self._rows())

    def __repr__(self) -> str:
        rows = ["  {:<4} {:>9} ± {:<8} Hz  damping {:>7} ± {:<7} %  {}".format(*row).rstrip() for row in self._rows()]
        return "\n".join([f"<secular.ModalSurvey: {self._head()}", *rows]) + ">"


@_checks.in_keywords({"window": "window_s", "force-window": "force_window_s", "driving-point": "driving_points",
                      "modal-mass": "modal_masses", "band": "band_hz", "from": "from_s", "to": "to_s"})
def modal(campaign: Union[Campaign, str, os.PathLike], *, order: int = 40, modes: Optional[int] = None,
          window_s: Optional[float] = None, overlap: float = 0.33, fit_below: Optional[float] = None,
          force_window_s: Optional[float] = None, exponential_window: Optional[float] = None,
          driving_points: Optional[Mapping[str, str]] = None, modal_masses: Union[float, Sequence[float], None] = None,
          records: Optional[str] = None, band_hz: Optional[Tuple[float, float]] = None,
          from_s: Optional[float] = None, to_s: Optional[float] = None) -> ModalSurvey:
    """Natural frequencies, damping and mode shapes from impacts or free decays; what `secular modal` does.

    order: largest of the stabilisation diagram. modes: keep so many, the strongest. window_s, overlap: of the windows
    of a free decay. fit_below: regression against amplitude up to this one. force_window_s: the force counts for so
    long, s; exponential_window: exp(-D t) on force and responses, D in 1/s; both chosen without them. driving_points:
    group to the channel where it is struck, "-CHANNEL" against it. modal_masses: kg, by mode, where records do not tell
    them. The rest as in `identify`. Raises InputError.
    """
    if driving_points is not None and not isinstance(driving_points, Mapping):
        raise _checks.refused("driving_points", "are no dictionary", "give a dictionary of group to channel")
    points = {_checks.text("driving_points", group): _checks.text("driving_points", channel)
              for group, channel in (driving_points or {}).items()}
    options = dict(_checks.window(records, band_hz, from_s, to_s), order=_checks.whole("order", order, 4, 400),
                   modes=_checks.optional(_checks.whole, "modes", modes, 1, 200) or 0,
                   window_s=_checks.optional(_checks.not_negative, "window_s", window_s) or 0.0,
                   overlap=_checks.within("overlap", overlap, 0, 0.95),
                   fit_below=_checks.optional(_checks.not_negative, "fit_below", fit_below) or 0.0,
                   force_window_s=_checks.optional(_checks.not_negative, "force_window_s", force_window_s) or 0.0,
                   exponential_window=_checks.optional(_checks.not_negative, "exponential_window", exponential_window),
                   driving_points=points, modal_masses=_checks.reals("modal_masses", modal_masses))
    try:
        return ModalSurvey(_core.modal(as_campaign(campaign)._core, options))
    except NumericalFailure as failure:
        return ModalSurvey(None, str(failure))


@dataclass(frozen=True)
class Term:
    """One term of a decomposition.

    family: "circular" (a steady tone), "hyperbolic", "Nyquist-hyperbolic", "product" (a decaying or growing tone) or
    "constant". frequency_hz (a rate over 2 pi for hyperbolic ones) and amplitude (|p + i q|, the channel's unit): means
    over the ensembles, with their scatter; sd None where nothing tells it. p, q: of cosine and sine at the first sample
    of the first ensemble.
    """

    family: str
    ensembles: int
    frequency_hz: float
    frequency_sd_hz: Optional[float]
    amplitude: float
    amplitude_sd: Optional[float]
    p: float
    q: float


@dataclass(frozen=True)
class Decomposition:
    """What one way of estimation makes of one channel: correlation is gamma^2, signal_to_noise_db its ratio."""

    method: str
    ensembles: int
    correlation: Optional[float]
    signal_to_noise_db: Optional[float]
    terms: Sequence[Term]


@dataclass(frozen=True)
class ChannelSpectrum:
    """decompositions: by method, the last is maximum likelihood; terms: its terms. fields: all of spectrum.json."""

    name: str
    unit: str
    decompositions: Sequence[Decomposition]
    fields: dict = field(repr=False, compare=False)

    @property
    def terms(self) -> Sequence[Term]:
        return self.decompositions[-1].terms if self.decompositions else []


@dataclass(frozen=True, eq=False)
class SteadyLevel:
    """Steady responses of a file at one level: arrays (points,); force None where the file has none."""

    series: str
    name: str
    frequency_hz: np.ndarray
    response: np.ndarray
    force: Optional[np.ndarray]


def _term(entry: dict) -> Term:
    first = entry["first_ensemble"]
    return Term(entry["family"], entry["ensembles"], entry["frequency_hz"], entry["frequency_sd_hz"],
                entry["amplitude"], entry["amplitude_sd"], first["p"], first["q"])


def _channel(entry: dict) -> ChannelSpectrum:
    methods = [Decomposition(method["name"], method["ensembles"], method["correlation"], method["signal_to_noise_db"],
                             [_term(term) for term in method["terms"]]) for method in entry["methods"]]
    return ChannelSpectrum(entry["name"], entry["unit"], methods, entry)


class Spectrum(Report):
    """Tones and decays of one record, and how many there are (docs/spectra.md).

    source; channels: list of ChannelSpectrum, result["v"] is that of one; conclusions: what the numbers say.
    singular_values: "temporal", "biased", "unbiased" and "spatial" to arrays, the largest first. Of a file of steady
    responses there are `levels` instead, a list of SteadyLevel. Figures: "history", "spectrum", "modes", "delays",
    "covariance", "channels", "relation_CHANNEL"; of steady responses the names of their series.
    """

    def __init__(self, core, reason: str = ""):
        super().__init__(core, reason)
        self.source: str = self.data["source"]
        self.channels = [_channel(entry) for entry in self.data.get("channels", [])]
        self.conclusions: list[str] = self.data.get("conclusions", [])
        self.singular_values: dict[str, np.ndarray] = {
            kind: np.array(values, dtype=float) for kind, values in self.data.get("singular_values", {}).items()}
        self.levels = [SteadyLevel(series["name"], level["name"], np.array(level["frequency_hz"]),
                                   np.array(level["response"]), np.array(level["force"]) if level["force"] else None)
                       for series in self.data.get("series", []) for level in series["levels"]]

    def __getitem__(self, name: str) -> ChannelSpectrum:
        for channel in self.channels:
            if channel.name == name:
                return channel
        raise KeyError(f"{name}: the channels are {', '.join(channel.name for channel in self.channels)}")

    def to_pandas(self):
        """A data frame with one row for each term of each way of estimation."""
        import pandas

        return pandas.DataFrame([{"channel": channel.name, "method": way.method, **vars(term), "unit": channel.unit}
                                 for channel in self.channels for way in channel.decompositions for term in way.terms])

    def _rows(self) -> list[tuple]:
        return [(channel.name, term.family, f"{term.frequency_hz:.8g}", shown(term.frequency_sd_hz, 2),
                 f"{term.amplitude:.6g}", shown(term.amplitude_sd, 2), channel.unit)
                for channel in self.channels for term in channel.terms]

    def _repr_html_(self) -> str:
        return html_table(f"Spectrum of {self.source}",
                          ("channel", "term", "frequency, Hz", "sd", "amplitude", "sd", "unit"), self._rows())

    def __repr__(self) -> str:
        rows = ["  {:<10} {:<12} {:>12} ± {:<8} Hz  {:>12} ± {:<8} {}".format(*row).rstrip() for row in self._rows()]
        return "\n".join([f"<secular.Spectrum of {self.source}", *rows]) + ">"


@_checks.in_keywords({"channel": "channels", "ensemble": "ensemble_s", "sample-rate": "sample_rate_hz",
                      "band": "band_hz", "from": "from_s", "to": "to_s"})
def spectrum(source: Union[Campaign, str, os.PathLike], *, channels: Union[str, Sequence[str], None] = None,
             order: Optional[int] = None, ensemble_s: Optional[float] = None, overlap: float = 0.0, delays: int = 60,
             offset: bool = False, time: Optional[str] = None, sample_rate_hz: Optional[float] = None,
             records: Optional[str] = None, band_hz: Optional[Tuple[float, float]] = None,
             from_s: Optional[float] = None, to_s: Optional[float] = None) -> Spectrum:
    """Circular-hyperbolic decomposition of one record; what `secular spectrum` does.

    source: a Campaign, a campaign folder (the first record that `records` takes) or a data file. channels: every
    response without it. order: terms; without it as many as a test finds tones. ensemble_s, overlap: how the record is
    cut; one ensemble without it. delays: of the principal components. offset: a constant beside the terms. time,
    sample_rate_hz: of a file, the variable that holds its time, or Hz where none does. The rest as in `identify`.
    Raises InputError.
    """
    campaign = source._core if isinstance(source, Campaign) else None
    options = dict(_checks.window(records, band_hz, from_s, to_s), channels=_checks.names("channels", channels),
                   order=_checks.optional(_checks.whole, "order", order, 1, 40) or 0,
                   ensemble_s=_checks.optional(_checks.positive, "ensemble_s", ensemble_s) or 0.0,
                   overlap=_checks.within("overlap", overlap, 0, 0.95),
                   delays=_checks.whole("delays", delays, 4, 400), offset=_checks.flag("offset", offset),
                   time=_checks.optional_text("time", time) or "",
                   sample_rate_hz=_checks.optional(_checks.positive, "sample_rate_hz", sample_rate_hz) or 0.0)
    name = source.name if isinstance(source, Campaign) else _checks.path("source", source)
    return Spectrum(_core.spectrum(name, campaign, options))
