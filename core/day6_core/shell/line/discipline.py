"""The line discipline of a simulated terminal: echo, line editing in cooked mode, raw keys, and the keys that send signals.

Everything here runs on the scheduler's thread. As in a kernel there is one queue per terminal, so what is typed ahead reaches
the next reader, while the mode belongs to the reader in the foreground and cannot be left behind by a program that died.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from day6_core.session.streams import END_OF_INPUT, InputStream, KeyReceiver, OutputStream
from day6_core.session.task import Signal, sleep_until, wait_for
from day6_core.session.typed_text import END_OF_FILE, TypedText
from day6_core.width import char_width

if TYPE_CHECKING:
    from day6_core.shell.terminal import Terminal

INTERRUPT, SUSPEND, QUIT, ERASE, KILL_LINE, KILL_WORD = "\x03", "\x1a", "\x1c", "\x7f", "\x15", "\x17"
END = END_OF_FILE
MOST_TYPED_AHEAD = 4 * 1024 * 1024
"""Unread characters at which a terminal only beeps: a kernel keeps 4 kB, but pasted text must not be lost."""

READS_IN_A_ROW = 256
"""Keys or lines a program takes before other programs get a turn, including those whose timers are due."""

_RUN = re.compile(r"[^\x03\x04\b\n\r\x15\x17\x1a\x1c\x7f]+|.", re.DOTALL)
"""A unit of typing: text that only has to be stored, or one character with an effect."""


class Discipline:
    """The terminal's queue of typed text, and its readers."""

    def __init__(self, terminal: Terminal) -> None:
        self.terminal = terminal
        self.root = TtyInput(self)
        """The shell's end of the terminal; the ends of its jobs are forked from it."""
        self.arrived = Signal()
        """Set when there is more to read, or the focus moved."""
        self.hung_up = False
        self.sized = Signal()
        """Set when the window has another size; the line editor clears it."""
        self._ready = TypedText()
        self._line = ""
        """The unfinished line in cooked mode."""
        self.interrupts = 0
        """How often Ctrl-C was pressed at the foreground job: one that still runs ignores it."""
        self._receivers: set[KeyReceiver] = set()

    @property
    def front(self) -> TtyInput:
        """The foreground reader: from the shell down, the job each one waits for."""
        reader = self.root
        while reader.current is not None:
            reader = reader.current
        return reader

    def front_changed(self, before: TtyInput) -> None:
        """Adapt the queue to the mode of the new foreground reader."""
        after = self.front
        if before.is_raw != after.is_raw:
            (self.become_raw if after.is_raw else self.become_cooked)()
        self.interrupts = 0
        self._hand_on()
        self.arrived.set()

    # -- typing --------------------------------------------------------------------------------------------------------

    def type(self, text: str) -> None:
        """Handle what was typed, in the mode of the foreground reader."""
        front = self.front
        if front.receiver is not None:
            self._to_process(front.receiver, text)
            return
        for run in _RUN.findall(text):
            self._run(run)

    def _to_process(self, receiver: KeyReceiver, text: str) -> None:
        before, suspend, rest = text.partition(SUSPEND)
        signals = (suspend or INTERRUPT in text) and receiver.wants_signal_keys()
        self.interrupts += before.count(INTERRUPT) if signals else 0
        if suspend and signals:
            # The kernel ignores Ctrl-Z of a pty whose session has no shell in it: the shell is ours.
            if before:
                receiver.keys(before)
            self.terminal.write("^Z")
            self.terminal.shell.suspend()
            if rest:
                self.type(rest)
        else:
            receiver.keys(text)
            if signals:
                self.terminal.shell.interrupt_behind()

    def _run(self, key: str) -> None:
        front = self.front
        raw = front.is_raw
        if front.signals:
            if key in (INTERRUPT, QUIT):
                self._ready.take_all()
                self._line = ""
                if not raw:
                    self.terminal.write("^C" if key == INTERRUPT else "^\\")
                if key == INTERRUPT:
                    self.interrupts += 1
                    self.terminal.shell.interrupt_line()
                else:
                    self.terminal.shell.quit()
                return
            if key == SUSPEND:
                if not raw:
                    self.terminal.write("^Z")
                self.terminal.shell.suspend()
                return
        if len(self._ready) + len(self._line) > MOST_TYPED_AHEAD:
            self.terminal.write("\a")
        elif raw:
            self._ready.add(key)
            self.arrived.set()
        else:
            self._cooked(key)

    def _cooked(self, key: str) -> None:
        write = self.terminal.write
        if key in ("\r", "\n"):
            write("\r\n")
            self._finish_line("\n")
        elif key == END:
            self._finish_line(END)
        elif key in (ERASE, "\b"):
            if self._line:
                write(_erasing(self._line[-1]))
                self._line = self._line[:-1]
        elif key == KILL_LINE:
            write("".join(map(_erasing, self._line)))
            self._line = ""
        elif key == KILL_WORD:
            kept = self._line.rstrip().rpartition(" ")
            left = kept[0] + kept[1]
            write("".join(map(_erasing, self._line[len(left) :])))
            self._line = left
        else:
            self._line += key
            write(key if key.isprintable() else "".join(map(_echo, key)))

    def _finish_line(self, end: str) -> None:
        self._ready.add(self._line + end)
        self._line = ""
        self.arrived.set()

    @property
    def has_pending(self) -> bool:
        """Whether there is unread typed text."""
        return bool(self._ready or self._line)

    # -- reading -------------------------------------------------------------------------------------------------------

    def take_key(self) -> str | None:
        """The next key, None if there is none."""
        return self._ready.take_key()

    def take_plain(self) -> str:
        """The characters that come next, as far as they are plain text."""
        return self._ready.take_plain()

    def take_line(self) -> str | None:
        """The next line with its newline ('' for Ctrl-D at its beginning), None if there is none."""
        return self._ready.take_line()

    def take_up_to(self, mark: str) -> tuple[str, bool]:
        """Take what was typed before `mark`; return it and whether the mark was there, which is then removed."""
        return self._ready.take_up_to(mark)

    def become_raw(self) -> None:
        """Make the unfinished line readable key by key."""
        self._ready.add(self._line)
        self._line = ""

    def become_cooked(self) -> None:
        """Keys nobody read in raw mode are typed ahead for the next reader; the last, unfinished line can still be edited."""
        self._line = self._ready.take_unfinished() + self._line

    def hang_up(self) -> None:
        self.hung_up = True
        self.arrived.set()

    # -- processes -----------------------------------------------------------------------------------------------------

    def add_receiver(self, receiver: KeyReceiver) -> None:
        self._receivers.add(receiver)
        self._hand_on()

    def _hand_on(self) -> None:
        """Give what was typed ahead to the process in the foreground, if there is one; none in the background may have it."""
        receiver = self.front.receiver
        if receiver is None:
            return
        typed, self._line = self._ready.take_all() + self._line, ""
        if typed:
            receiver.keys(typed)

    def remove_receiver(self, receiver: KeyReceiver) -> None:
        self._receivers.discard(receiver)

    def resized(self) -> None:
        for receiver in list(self._receivers):
            receiver.resize(self.terminal.columns, self.terminal.rows)
        self.sized.set()
        self.arrived.set()


class TtyInput(InputStream):
    """One job's end of the terminal: its mode, and whether it may read."""

    def __init__(self, discipline: Discipline, parent: TtyInput | None = None) -> None:
        self.discipline = discipline
        self.parent = parent
        self.current: TtyInput | None = None
        """The fork that has this one's keys."""
        self.is_raw = False
        self.signals = True
        self.receiver: KeyReceiver | None = None
        self._reads = 0

    @property
    def terminal(self) -> Terminal:
        return self.discipline.terminal

    def isatty(self) -> bool:
        return True

    def fork(self) -> TtyInput:
        return TtyInput(self.discipline, self)

    def focus(self) -> None:
        if self.parent is not None:
            before = self.discipline.front
            self.parent.current = self
            self.discipline.front_changed(before)

    def unfocus(self) -> None:
        if self.parent is not None and self.parent.current is self:
            before = self.discipline.front
            self.parent.current = None
            self.discipline.front_changed(before)

    def terminal_of(self, *outputs: OutputStream) -> Terminal | None:
        mine = not outputs or any(output.terminal is self.terminal for output in outputs)
        return self.terminal if mine else None

    def pass_keys_to(self, receiver: KeyReceiver | None) -> None:
        # At once on the scheduler's thread, where keys arrive: what was typed before stays before what is typed next.
        self.terminal.desk.scheduler.call(lambda: self._pass_keys_to(receiver))

    def _pass_keys_to(self, receiver: KeyReceiver | None) -> None:
        before, self.receiver = self.receiver, receiver
        if before is not None:
            self.discipline.remove_receiver(before)
        if receiver is not None:
            self.discipline.add_receiver(receiver)

    def push_back(self, text: str) -> None:
        self.terminal.type_again(text)

    async def read_key(self) -> str:
        await self._take_turns()
        while True:
            if self.discipline.front is self:
                key = self.discipline.take_key()
                if key is not None:
                    return key
                if self.discipline.hung_up:
                    return END_OF_INPUT
            await self._more()

    async def read_line(self) -> str:
        await self._take_turns()
        while True:
            if self.discipline.front is self:
                line = self.discipline.take_line()
                if line is not None:
                    return line
                if self.discipline.hung_up:
                    return END_OF_INPUT
            await self._more()

    def take_plain(self) -> str:
        """Return the characters that have been typed behind the last key and are plain text, without waiting for more."""
        return self.discipline.take_plain() if self.discipline.front is self else ""

    async def read_up_to(self, mark: str) -> str:
        """Return what is typed before `mark`, which is taken away, or before the end of the input."""
        parts = []
        while True:
            if self.discipline.front is self:
                text, found = self.discipline.take_up_to(mark)
                parts.append(text)
                if found or self.discipline.hung_up:
                    return "".join(parts)
            await self._more()

    async def wait_for_resize_or_key(self) -> bool:
        """For the line editor: True when there is a key to read, False when the window changed its size."""
        discipline = self.discipline
        while True:
            if discipline.sized.is_set():
                discipline.sized.clear()
                return False
            if discipline.front is self and (discipline._ready or discipline.hung_up):
                return True
            await self._more()

    async def _take_turns(self) -> None:
        """Let other programs run in between when much was typed ahead."""
        self._reads += 1
        if self._reads % READS_IN_A_ROW == 0:
            await sleep_until(self.terminal.desk.clock.steady_ns())

    async def _more(self) -> None:
        self.discipline.arrived.clear()
        await wait_for(self.discipline.arrived)

    @contextlib.contextmanager
    def raw(self, *, signals: bool = True) -> Iterator[None]:
        self._set_mode(True, signals)
        try:
            yield
        finally:
            self._set_mode(False, True)

    def _set_mode(self, raw: bool, signals: bool) -> None:
        self.signals = signals
        if raw != self.is_raw:
            self.is_raw = raw
            if self.discipline.front is self:
                (self.discipline.become_raw if raw else self.discipline.become_cooked)()


def _echo(char: str) -> str:
    """How a typed character is shown: control characters as ^X."""
    return char if char >= " " or char == "\t" else "^" + chr(ord(char) + 64)


def _erasing(char: str) -> str:
    width = 2 if char < " " else char_width(char)
    return "\b \b" * width
