"""Multiple-scales models that compile into parameter estimators for nonlinear vibration tests.

    import secular
    campaign = secular.Campaign.read("measured")        # or secular.Campaign(channels, records, time_step_s=...)
    result = secular.identify(campaign, "two_mass_mode1")
    result["mu1"].value, result["mu1"].sd

Computing releases the interpreter's lock, and Ctrl-C stops it; one computation runs at a time, on several threads.
Nothing is printed: what there is to say is in a result's `notices`. The program `secular` calls the same functions.
"""

import os as _os

from . import _core
from ._campaign import Campaign, Channel, ModalBasis, Record
from ._errors import InputError, NumericalFailure
from ._files import Fault, Import, InspectedRecord, Inspection, Levels, Variable, import_files, inspect
from ._jobs import Cause, Diagnosis, Identification, Value, diagnose, identify, simulate
from ._model import Derivation, EvaluatedTerm, Evaluation, Model, derive, evaluate
from ._plan import Plan, PlannedDwell, Programme, WantedParameter, plan
from ._predict import Backbone, Branch, Curve, LargestResponse, MeasuredDwell, Prediction, SpecialPoint, Sweep, predict
from ._surveys import (ChannelSpectrum, Decomposition, ModalSurvey, Mode, Spectrum, SteadyLevel, Term, modal,
                       spectrum)

_core.set_folder(_os.path.dirname(_os.path.abspath(__file__)))

__version__ = _core.version.split()[-1]


def shipped_models() -> list:
    """Names of the shipped models."""
    return _core.shipped_models()


__all__ = ["Backbone", "Branch", "Campaign", "Cause", "Channel", "ChannelSpectrum", "Curve", "Decomposition",
           "Derivation", "Diagnosis", "EvaluatedTerm", "Evaluation", "Fault", "Identification", "Import", "InputError",
           "InspectedRecord", "Inspection", "LargestResponse", "Levels", "MeasuredDwell", "ModalBasis", "ModalSurvey",
           "Mode", "Model", "NumericalFailure", "Plan", "PlannedDwell", "Prediction", "Programme", "Record",
           "SpecialPoint", "Spectrum", "SteadyLevel", "Sweep", "Term", "Value", "Variable", "WantedParameter", "derive",
           "diagnose", "evaluate", "identify", "import_files", "inspect", "modal", "plan", "predict", "shipped_models",
           "simulate", "spectrum"]
