"""Our own log: into a file, or nowhere."""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TextIO

from day6_core.reason import reason
from day6_core.whole_file import append_private


class _LogFile(logging.FileHandler):
    """A log readable by this user alone; it ignores a full disk, because an error must not be printed over the screen."""

    def _open(self) -> TextIO:  # type: ignore[override]
        append_private(Path(self.baseFilename), b"")
        return open(self.baseFilename, "a", encoding=self.encoding)

    def handleError(self, record: logging.LogRecord) -> None:
        """Called instead of raising when a line could not be written."""


def keep_log_off_the_screen(environ: Mapping[str, str] | None = None) -> None:
    """Send our own log to the file $DAY6_LOG, or nowhere: Python's default, stderr, is the screen."""
    file = (os.environ if environ is None else environ).get("DAY6_LOG")
    handler: logging.Handler = logging.NullHandler()
    if file:
        try:
            handler = _LogFile(file, encoding="utf-8")
        except OSError as error:
            print(f"day6-tui: DAY6_LOG: {file}: {reason(error)}", file=sys.stderr)
    handler.setFormatter(logging.Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s"))
    logging.getLogger().addHandler(handler)
