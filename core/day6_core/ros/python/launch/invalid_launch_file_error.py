"""The error for a launch file that cannot be loaded."""

from __future__ import annotations

from collections.abc import Sequence


class InvalidLaunchFileError(Exception):
    """Raised with the errors of all ways of loading the file; `extension` is '' for a file of unknown kind."""

    def __init__(self, extension: str = "", *, likely_errors: Sequence[Exception] | None = None) -> None:
        self._extension = extension
        self._likely_errors = likely_errors
        if not extension or not likely_errors:
            self._error_message = "The launch file may have a syntax error, or its format is unknown"
            return
        number = "multiple exceptions" if len(likely_errors) > 1 else "exception"
        lines = [f"Caught {number} when trying to load file of format [{extension}]:"]
        lines += [f" - {type(error).__name__}: {error}" for error in likely_errors]
        self._error_message = "\n".join(lines)
        self.__cause__ = likely_errors[0]

    def __str__(self) -> str:
        return self._error_message
