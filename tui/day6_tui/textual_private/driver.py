"""Textual's driver for Linux and macOS, with keyboard input that survives every error, and an orderly end if it cannot.

Textual starts two threads: one reads the terminal, the other writes to it (`tui.output`). If one of them fails, the
desktop ends as if the user had quit: programs end, texts are kept, the terminal is restored; only the exit status differs.
"""

from __future__ import annotations

import contextlib
import logging
import os
import select
import time
from collections.abc import Mapping
from typing import TYPE_CHECKING

from textual import events
from textual.message import Message

from day6_core.reason import fault
from day6_core.virtual.surroundings import in_real_time

try:
    from textual.drivers.linux_driver import LinuxDriver
except ImportError:  # Windows: Textual has another driver there, and this one is not used
    from textual.driver import Driver as LinuxDriver  # type: ignore[assignment]

from day6_tui.appearance.glyphs import terminal_environ
from day6_tui.pixels.app import PictureApp
from day6_tui.pixels.ask import IS_READY, READY, Answered
from day6_tui.screen.line import may_ask
from day6_tui.screen.shown import may_erase
from day6_tui.screen.trouble import TerminalTrouble
from day6_tui.textual_private.hooks import HookedApp
from day6_tui.textual_private.keyboard import InputDecoder, KeyboardParser, is_possible

if TYPE_CHECKING:
    from day6_tui.cast.recorder import Recorder
    from day6_tui.pixels.pictures import Pictures

READ_SIZE = 65536
FAILED = 1
HUNG_UP = 129
"""Exit status when the terminal went away: 128 + SIGHUP, as a shell reports it."""

MOST_FAILURES = 100
"""Consecutive reads that may fail."""

ANSWER_SECONDS = 0.4
"""How long the end waits for an answer that is under way."""

_log = logging.getLogger(__name__)


class TerminalDriver(LinuxDriver):
    """Reads the keyboard; no input makes it fail."""

    recorder: Recorder | None = None
    """Is given everything that is written, while the screen is recorded."""
    _reported: frozenset[str] = frozenset()
    _environ: Mapping[str, str] | None = None
    """The variables of the terminal where they are not those of this process."""
    _away = False
    """Whether the terminal was left for another one."""

    def write(self, data: str) -> None:
        """Write to the terminal, if there is one."""
        if not self._away:
            if self.recorder is not None:
                self.recorder.write(data)
            is_time = self._count(data)  # first: the answer to a question in it may come before `write` returns
            super().write(data)
            if is_time:
                self.ask()

    def _count(self, data: str) -> bool:
        """Tell the line what is written; return whether it is time to ask the terminal."""
        if (app := self._hooked) is None:
            return False
        count = len(data) if data.isascii() else len(data.encode(errors="replace"))
        return app.line.wrote(count, asks=data.endswith(READY))

    def ask(self) -> None:
        """Ask the terminal how far it has read."""
        if (app := self._hooked) is not None and not self._away:
            app.line.asked()
            super().write(READY)

    @property
    def _hooked(self) -> HookedApp | None:
        return self._app if isinstance(self._app, HookedApp) else None

    def start_application_mode(self) -> None:
        """Take the terminal; nothing is known of what it shows, and of the way to it."""
        if (app := self._hooked) is not None:
            environ = terminal_environ() if self._environ is None else self._environ
            app.line.begin(may_ask=may_ask(environ))
            app.drawing.shown.begin(erases=may_erase(environ))
        super().start_application_mode()  # type: ignore[no-untyped-call,unused-ignore]
        if app is not None and app.line.may_ask:
            self.ask()

    def suspend_application_mode(self) -> None:
        if not self._away:
            super().suspend_application_mode()

    def resume_application_mode(self) -> None:
        if not self._away:
            super().resume_application_mode()

    def leave_terminal(self) -> None:
        """Restore the terminal and write nothing more, until `take_terminal`."""
        self.suspend_application_mode()
        self._away = True
        self._in_band_window_resize = False

    def take_terminal(self, environ: Mapping[str, str]) -> None:
        """Take the terminal, which may be another one now: that of these variables."""
        self._away, self._environ = False, environ
        self.resume_application_mode()

    def suspend_job(self) -> None:
        """Leave the terminal and stop this process, as Ctrl-Z does."""
        self._sigtstp_application()

    def resume_job(self) -> None:
        """Take over the terminal again after any stop, even one that did not begin with `suspend_job`."""
        if not self._must_signal_resume:
            self.suspend_application_mode()
            self._must_signal_resume = True
        self._sigcont_application()

    def _run_input_thread(self) -> None:
        in_real_time()
        try:
            self.run_input_thread()
        except Exception as error:
            _log.exception("the terminal's input failed")
            self._end(FAILED, f"day6-tui: {fault(error)}")

    def run_input_thread(self) -> None:
        """Read until the application ends."""
        decoder, parser = InputDecoder(), KeyboardParser(self._debug)
        failures = 0
        while not self.exit_event.is_set():
            if self._output_is_gone():
                self._end(HUNG_UP)
                return
            data = self._read()
            if data == b"":
                self._end(HUNG_UP)
                return
            try:
                self._take(decoder, parser, data or b"")
                failures = 0
            except Exception:
                _log.exception("reading a key failed")
                failures += 1
                if failures == MOST_FAILURES:
                    raise
                parser = KeyboardParser(self._debug)  # the old one may stand anywhere

    def _read(self) -> bytes | None:
        """Return what the terminal sent, None if there was nothing for a moment, b'' if it is gone."""
        if not select.select([self.fileno], [], [], 0.1)[0]:
            return None
        try:
            return os.read(self.fileno, READ_SIZE)
        except (BlockingIOError, InterruptedError):
            return None
        except OSError:
            return b""

    def _take(self, decoder: InputDecoder, parser: KeyboardParser, data: bytes) -> None:
        text = decoder.decode(data)
        if decoder.fault:
            self._report(decoder.fault)
        for message in parser.feed(text) if text else ():
            if isinstance(message, events.Resize) and not (self._in_band_window_resize and is_possible(message)):
                parser.mouse_pixels = False
                parser.terminal_size = None
                continue
            if isinstance(message, Answered) and self._is_for_line(message.text):
                continue
            if isinstance(message, Answered) and (pictures := self._pictures) is not None:
                pictures.hear(message.text)
            if isinstance(message, (events.Key, events.Paste)) and self._hooked is not None:
                self._hooked.key_read()
            self.process_message(message)
        for message in parser.tick():
            self.process_message(message)

    def process_message(self, message: Message) -> None:
        if self._hooked is None or self._hooked.lets_in(message):
            super().process_message(message)

    def press_again(self, message: Message) -> None:
        """Take something as if the terminal had sent it."""
        super().process_message(message)

    def _is_for_line(self, answer: str) -> bool:
        """Whether it was the line that asked."""
        app = self._hooked
        if app is None or answer != IS_READY:
            return False
        is_ours = app.line.answered()
        app.heard()
        return is_ours

    @property
    def _pictures(self) -> Pictures | None:
        return self._app.look.pictures if isinstance(self._app, PictureApp) else None

    def stop_application_mode(self) -> None:
        """Leave the terminal as it was, without our pictures."""
        self._wait_for_answers()
        if (pictures := self._pictures) is not None and (text := pictures.farewell()):
            self.write(text)
        self.write("\x1b[m")
        if self._mouse_pixels:  # Textual leaves it on
            self.write("\x1b[?1016l")
            self._mouse_pixels = False
        super().stop_application_mode()

    def _wait_for_answers(self) -> None:
        """Wait a moment for answers that are under way: they would be typed into the shell."""
        end = time.monotonic() + ANSWER_SECONDS
        app, pictures = self._hooked, self._pictures
        while (app is not None and app.line.waits) or (pictures is not None and pictures.waiting):
            if time.monotonic() > end:
                return
            time.sleep(0.01)

    def _report(self, fault: str) -> None:
        if fault not in self._reported:
            self._reported |= {fault}
            self.send_message(TerminalTrouble("input.gbk" if fault == "gbk" else "input.not_utf8"))

    def _output_is_gone(self) -> bool:
        writer = self._writer_thread
        return writer is not None and (not writer.is_alive() or bool(getattr(writer._file, "gone", False)))

    def _end(self, status: int, message: str | None = None) -> None:
        with contextlib.suppress(RuntimeError):  # the loop is closed: it ends already
            self._loop.call_soon_threadsafe(lambda: self._app.exit(return_code=status, message=message))
