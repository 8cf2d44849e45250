"""Lets the desktop end when its terminal is gone: Textual's output thread survives that the terminal takes no more.

The thread dies of the first write that fails, and nobody takes from its queue any more; when the queue is full the application
waits for room in it for ever, also on its way out. So a terminal window that was closed in the wrong moment left a desktop
behind, with all its programs.
"""

from __future__ import annotations

from typing import IO, Any

from textual.drivers._writer_thread import WriterThread


class Leaky:
    """A file that takes what nobody can read any more."""

    def __init__(self, file: IO[str]) -> None:
        self._file = file
        self._gone = False

    def write(self, text: str) -> int:
        self._try(self._file.write, text)
        return len(text)

    def flush(self) -> None:
        self._try(self._file.flush)

    def _try(self, function: Any, *arguments: str) -> None:
        if not self._gone:
            try:
                function(*arguments)
            except UnicodeEncodeError:
                # A character that the terminal's encoding lacks costs this character, not the screen.
                encoding = getattr(self._file, "encoding", None) or "ascii"
                function(*(text.encode(encoding, "replace").decode(encoding) for text in arguments))
            except (OSError, ValueError):  # hung up, or the file was closed
                self._gone = True


def install() -> None:
    """Use it for every writer thread that is started from now on."""
    if WriterThread.run is not _run:
        WriterThread.run = _run  # type: ignore[method-assign]


_original_run = WriterThread.run


def _run(self: WriterThread) -> None:
    self._file = Leaky(self._file)  # type: ignore[assignment]
    _original_run(self)
