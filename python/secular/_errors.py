"""What a call raises."""


class InputError(ValueError):
    """Something that the caller can change: a campaign, a model, an argument.

    file: path, or name, of what is wrong; place: where in it ("line 12, key unit"), may be empty;
    fault: what is wrong; remedy: what would be right, may be empty.
    """

    def __init__(self, message, file="", place="", fault="", remedy=""):
        super().__init__(message)
        self.file, self.place, self.fault, self.remedy = file, place, fault, remedy


class NumericalFailure(RuntimeError):
    """A computation ran and came to no result. `identify` and `diagnose` say so in the result's `status` instead."""
