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
from ._jobs import Cause, Diagnosis, Identification, Value, diagnose, identify, simulate
from ._model import Derivation, Model, derive

_core.set_folder(_os.path.dirname(_os.path.abspath(__file__)))

__version__ = _core.version.split()[-1]


def shipped_models() -> list:
    """Names of the shipped models."""
    return _core.shipped_models()


__all__ = ["Campaign", "Cause", "Channel", "Derivation", "Diagnosis", "Identification", "InputError", "ModalBasis",
           "Model", "NumericalFailure", "Record", "Value", "derive", "diagnose", "identify", "shipped_models",
           "simulate"]
