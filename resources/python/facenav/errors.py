"""The one exception of this package."""


class FaceNavError(ValueError):
    """A file or a value that cannot be used. Its message is one line: where, and what was expected."""

    def __init__(self, where, what):
        super().__init__(f"{where}: {what}" if where else what)
