"""Editing one line at the prompt as readline does: its keys (`edit_line`), history, Ctrl-R, Tab, pasting, and the drawing.

The line is drawn with what a real readline would send to the terminal, so that it wraps, scrolls and is copied like any text.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.session.session import Session
from day6_core.shell.line.discipline import TtyInput
from day6_core.shell.line.edit_line import KEYS, EditLine
from day6_core.shell.line.layout import ShownLine, lay_out, near, shown
from day6_core.width import text_width

if TYPE_CHECKING:
    from day6_core.shell.line.completion import Completer
    from day6_core.shell.line.history import History
    from day6_core.shell.terminal import Terminal

_COLOUR = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)|\x07")
"""The parts of a prompt that take no cells: colours and the window's title."""
PASTE_ON, PASTE_OFF = "\x1b[?2004h", "\x1b[?2004l"
_PASTE_BEGIN, _PASTE_END = "\x1b[200~", "\x1b[201~"
MANY = 100
"""From this many completions bash asks before it lists them."""


class EndOfLines(Exception):
    """Ctrl-D on an empty line, or the terminal was closed."""


class LineEditor:
    """Reads lines from a terminal. One `read` at a time."""

    def __init__(self, session: Session, terminal: Terminal, history: History, completer: Completer) -> None:
        self._session = session
        self._terminal = terminal
        self._history = history
        self._completer = completer
        self._line = EditLine()
        self._prompt = ""
        self._browsing = 0
        """Index into the history; its length stands for the line being typed."""
        self._edited: dict[int, str] = {}
        """Lines changed while browsing, by index."""
        self._shown = ShownLine()
        self._column = 0
        """Column of the cursor."""
        self._tabs = 0
        self._done = False
        self._own_version = 0
        """Version of the terminal after our last write."""

    async def read(self, prompt: str) -> str | None:
        """Return the line without its newline; None after Ctrl-C. Raises EndOfLines."""
        stdin = self._session.stdin
        assert isinstance(stdin, TtyInput)
        self._line.set("")
        self._prompt, self._shown, self._tabs = prompt, ShownLine(), 0
        self._browsing = len(self._history.lines)
        self._edited = {}
        self._done = False
        with stdin.raw(signals=False):
            self._write(PASTE_ON)
            self._draw()
            try:
                while not self._done:
                    self._terminal.waiting_at_prompt = not self._line.text
                    if not await stdin.wait_for_resize_or_key():
                        self._draw_resized()
                        continue
                    key = await stdin.read_key()
                    self._start_again_below()
                    if key == "\x03":
                        self._finish("^C")
                        return None
                    if key == "" or (key == "\x04" and not self._line.text):
                        raise EndOfLines
                    await self._handle(key)
            finally:
                self._terminal.waiting_at_prompt = False
                if not self._done:
                    self._write(PASTE_OFF)
        return self._line.text

    async def _handle(self, key: str) -> None:
        self._tabs = self._tabs + 1 if key == "\t" else 0
        if key == "\t":
            await self._complete()
        elif key == "\x12":
            await self._search()
        elif key == _PASTE_BEGIN:
            await self._paste()
        elif change := KEYS.get(key):
            change(self._line)
        elif action := _KEYS.get(key):
            action(self)
        elif len(key) == 1 and key >= " ":
            stdin = self._session.stdin
            assert isinstance(stdin, TtyInput)
            self._line.insert(key + stdin.take_plain())
        if not self._done:
            self._draw_if_changed()

    # -- changing the line ---------------------------------------------------------------------------------------------

    def _accept(self) -> None:
        self._finish("")

    def _finish(self, mark: str) -> None:
        """Leave the line as it stands and go to the next row."""
        self._line.at = len(self._line.text)
        self._draw()
        self._write(mark + PASTE_OFF + "\r\n")
        self._shown = ShownLine()
        self._done = True

    def _clear_screen(self) -> None:
        self._write("\x1b[H\x1b[2J")
        self._shown = ShownLine()
        self._draw()

    def _older(self) -> None:
        self._browse(self._browsing - 1)

    def _newer(self) -> None:
        self._browse(self._browsing + 1)

    def _oldest(self) -> None:
        self._browse(0)

    def _newest(self) -> None:
        self._browse(len(self._history.lines))

    def _browse(self, index: int) -> None:
        lines = self._history.lines
        if not 0 <= index <= len(lines) or index == self._browsing:
            return
        self._edited[self._browsing] = self._line.text
        self._browsing = index
        self._line.text = self._edited.get(index, lines[index] if index < len(lines) else "")
        self._line.at = len(self._line.text)

    async def _paste(self) -> None:
        """Take keys as text up to the end mark; a newline inside does not run anything yet."""
        stdin = self._session.stdin
        assert isinstance(stdin, TtyInput)
        text = (await stdin.read_up_to(_PASTE_END)).replace("\r", "\n")
        single = "\n" not in text.rstrip("\n")
        self._line.insert(text.rstrip("\n") if single else text)

    # -- Tab and Ctrl-R ------------------------------------------------------------------------------------------------

    async def _complete(self) -> None:
        choices, start = await self._completer.complete(self._line.before)
        if not choices:
            self._write("\a")
            return
        typed = self._line.text[start : self._line.at]
        common = _common_start(choices)
        if len(choices) == 1:
            self._replace(start, choices[0] if choices[0].endswith(("/", "=")) else choices[0] + " ")
        elif len(common) > len(typed) or (common != typed and common.lower().startswith(typed.lower())):
            self._replace(start, common)
        elif self._tabs >= 2:
            self._list(choices)
        else:
            self._write("\a")

    def _replace(self, start: int, text: str) -> None:
        after = self._line.text[self._line.at :]
        if text.endswith(" ") and after.startswith(" "):
            after = after[1:]
        self._line.text = self._line.text[:start] + text + after
        self._line.at = start + len(text)

    def _list(self, choices: list[str]) -> None:
        names = [_last_part(choice) for choice in choices]
        columns = self._terminal.columns
        width = max(map(text_width, names)) + 2
        per_row = max(columns // width, 1)
        rows = -(-len(names) // per_row)
        lines = []
        for row in range(min(rows, MANY)):
            cells = names[row::rows]
            lines.append("".join(cell + " " * (width - text_width(cell)) for cell in cells).rstrip())
        if rows > MANY:
            lines.append(f"... {len(names)} possibilities")
        end = self._line.at
        self._line.at = len(self._line.text)
        self._draw()
        self._write("\r\n" + "\r\n".join(lines) + "\r\n")
        self._shown = ShownLine()
        self._line.at = end
        self._draw()

    async def _search(self) -> None:
        """Ctrl-R: find the last line that contains what is typed; Enter runs it, Escape and the arrows edit it."""
        prompt, text, at = self._prompt, self._line.text, self._line.at
        wanted, place = "", len(self._history.lines)
        found: int | None = None
        failed = ""
        while True:
            self._prompt = f"({failed}reverse-i-search)`{wanted}': "
            self._line.text = self._history.lines[found] if found is not None else text
            self._line.at = self._line.text.find(wanted) if found is not None else len(self._line.text)
            self._draw()
            key = await self._session.stdin.read_key()
            if key == "\x12":
                place = found if found is not None else place
            elif key in ("\x7f", "\b"):
                wanted, place = wanted[:-1], len(self._history.lines)
            elif len(key) == 1 and key >= " ":
                wanted += key
                place = len(self._history.lines) if found is None else found + 1
            else:
                break
            next_found = self._history.search(wanted, place) if wanted else None
            failed = "failed " if wanted and next_found is None else ""
            found = next_found if next_found is not None or not wanted else found
        self._prompt = prompt
        if key in ("\x07", "\x03"):
            self._line.text, self._line.at = text, at
        elif found is not None:
            self._browsing = found
        self._draw()
        if key not in ("\x07", "\x03", "\x1b"):
            await self._handle(key)

    # -- drawing -------------------------------------------------------------------------------------------------------

    def _write(self, text: str) -> None:
        self._terminal.write(text)
        self._own_version = self._terminal.version

    def _draw_resized(self) -> None:
        """Draw the line for the window's new size, without marking the terminal as having new output."""
        had_news = self._terminal.has_news
        if not self._start_again_below():
            self._draw()
        if not had_news:
            self._terminal.mark_seen()

    def _start_again_below(self) -> bool:
        """Show prompt and line again below what other programs (a background job) wrote into the line, if they did."""
        if self._terminal.version == self._own_version:
            return False
        if not self._terminal.at_line_start:
            self._write("\r\n")
        self._shown = ShownLine()
        self._draw()
        return True

    _drawn: tuple[str, str, int] = ("", "", 0)

    def _draw_if_changed(self) -> None:
        before_prompt, before_text, before_at = self._drawn
        text, at = self._line.text, self._line.at
        if (self._prompt, text, at) == self._drawn:
            return
        # The usual key press appends one character that fits: no need to draw the line again.
        appended = text[len(before_text) :]
        if (
            before_prompt == self._prompt
            and text.startswith(before_text)
            and before_at == len(before_text)
            and at == len(text)
            and appended.isprintable()
            and self._column + text_width(appended) < self._terminal.columns
        ):
            self._write(appended)
            self._column += text_width(appended)
            self._shown = self._shown.longer(appended)
            self._drawn = (self._prompt, text, at)
            return
        self._draw()

    def _draw(self) -> None:
        """Draw prompt and line again from the row the prompt begins in, and put the cursor where it belongs.

        Of what is higher than the window, the rows down to the cursor's are drawn, as far as they fit.
        """
        columns, height = self._terminal.columns, self._terminal.rows
        start, end = near(self._line.text, self._line.at, height)
        prompt = self._prompt if start == 0 else ""
        bare = _COLOUR.sub("", prompt)
        above = lay_out(bare, len(bare), columns)
        text = self._line.text[start:end]
        layout = lay_out(text, self._line.at - start, columns, indent=above.column)
        rows = above.row + len(layout.starts)
        row = above.row + layout.row
        at = self._line.at - start
        top = max(0, row - height + 1)
        last = min(rows, top + height) - 1
        if last < rows - 1:
            text = text[: layout.starts[last + 1 - above.row]].removesuffix("\n")
        if top > above.row:
            prompt = bare = ""
            text, at = text[layout.starts[top - above.row] :], at - layout.starts[top - above.row]
        elif top:
            prompt = bare = " " * above.column
            top = above.row
        up = self._shown.row(columns)
        self._shown = ShownLine(bare, text, at)
        text = (prompt + shown(text)).replace("\n", "\r\n")
        parts = [f"\x1b[{up}A" if up else "", "\r\x1b[J", text]
        if last == rows - 1 and layout.end_column == 0 and last and not text.endswith("\n"):
            parts.append(" \r")  # make the terminal really wrap
        if last > row:
            parts.append(f"\x1b[{last - row}A")
        parts.append("\r" + (f"\x1b[{layout.column}C" if layout.column else ""))
        self._write("".join(parts))
        self._column = layout.column
        self._drawn = (self._prompt, self._line.text, self._line.at)


_KEYS: dict[str, Callable[[LineEditor], None]] = {
    "\r": LineEditor._accept,
    "\n": LineEditor._accept,
    "\x0c": LineEditor._clear_screen,
    "\x10": LineEditor._older,
    "\x1b[A": LineEditor._older,
    "\x1bOA": LineEditor._older,
    "\x0e": LineEditor._newer,
    "\x1b[B": LineEditor._newer,
    "\x1bOB": LineEditor._newer,
    "\x1b<": LineEditor._oldest,
    "\x1b>": LineEditor._newest,
}


def _common_start(texts: list[str]) -> str:
    first, last = min(texts), max(texts)
    length = next((index for index, char in enumerate(first) if index >= len(last) or char != last[index]), len(first))
    return first[:length]


def _last_part(choice: str) -> str:
    """The part of a completion that is listed: the last part of a path."""
    if choice.startswith("/") and choice.count("/") == 1:
        return choice
    _, slash, tail = choice.rstrip("/").rpartition("/")
    return tail + ("/" if choice.endswith("/") else "") if slash and not choice.startswith("/") else choice
