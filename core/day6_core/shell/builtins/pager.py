"""less, more, man: a text page by page."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from day6_core.language import language_of
from day6_core.session.session import Session
from day6_core.session.streams import InputStream, TerminalSide
from day6_core.shell.builtins.options import reason
from day6_core.shell.builtins.text import text_named
from day6_core.width import char_width

_QUIT = ("q", "Q", "\x03", "")
_STEPS = {"j": 1, "\r": 1, "\x1b[B": 1, "k": -1, "\x1b[A": -1}


async def less(session: Session) -> int:
    """Show files or standard input; if the output is not a terminal, copy it there."""
    names = [word for word in session.argv[1:] if not word.startswith(("-", "+"))]
    texts = []
    status = 0
    for name in names:
        path = session.cwd / name
        try:
            if path.is_dir():
                session.print_error(f"{name} is a directory")
                status = 1
                continue
            texts.append(await text_named(session, name))
        except OSError as error:
            session.print_error(f"{name}: {reason(error)}")
            status = 1
    if not names:
        if session.stdin.isatty():
            session.print_error(f'Missing filename ("{session.name} --help" for help)')
            return 1
        texts.append(await session.stdin.read_all())
    if texts:
        await show_pages(session, "".join(texts), names[0] if names else "")
    return status


async def man(session: Session) -> int:
    from day6_core.shell.manual import page

    words = [word for word in session.argv[1:] if not word.startswith("-") and not word.isdigit()]
    if not words:
        session.print_error("What manual page do you want?\nFor example, try 'man man'.")
        return 1
    status = 0
    for name in words:
        text = page(name, language_of(session.env))
        if text is None:
            session.print_error(f"No manual entry for {name}")
            status = 16
        else:
            await show_pages(session, text, f"Manual page {name}(1)")
    return status


async def show_pages(session: Session, text: str, name: str) -> None:
    """Page a text in a terminal, even one that came through a pipe; elsewhere print it."""
    keys = session.stdin if session.stdin.isatty() else session.stdout.keyboard()
    terminal = None if keys is None else keys.terminal_of(session.stdout)
    if keys is None or terminal is None:
        session.stdout.write(text if text.endswith("\n") or not text else text + "\n")
        return
    pager = _Pager(session, terminal, text.expandtabs().split("\n"), name)
    session.stdout.control("\x1b[?1049h")
    try:
        with keys.raw(signals=False):
            pager.show()
            while (key := await keys.read_key()) not in _QUIT:
                await pager.press(key, keys)
                pager.show()
    finally:
        session.stdout.control("\x1b[?1049l")


class _Pager:
    """The visible part of the lines, and the last search."""

    def __init__(self, session: Session, terminal: TerminalSide, lines: Sequence[str], name: str) -> None:
        self._session, self._terminal, self._name = session, terminal, name
        lines = lines[:-1] if lines and not lines[-1] else lines
        self._lines = [row for line in lines for row in _rows_of(line, max(2, terminal.columns))]
        self._top = 0
        self._sought = ""

    @property
    def _height(self) -> int:
        return max(1, self._terminal.rows - 1)

    def show(self) -> None:
        """Draw the page and the line below it."""
        page = self._lines[self._top : self._top + self._height]
        page = page + ["~"] * (self._height - len(page))
        at_end = self._top + self._height >= len(self._lines)
        below = "(END)" if at_end else (self._name if self._top == 0 and self._name else ":")
        self._session.stdout.control("\x1b[H\x1b[2J")
        self._session.stdout.write("\r\n".join(page) + f"\r\n\x1b[7m{below}\x1b[0m")

    async def press(self, key: str, keys: InputStream) -> None:
        """Do what a key of less means."""
        page = self._height
        if key in (" ", "f", "\x1b[6~"):
            self._go(self._top + page)
        elif key in ("b", "\x1b[5~"):
            self._go(self._top - page)
        elif key in ("g", "<", "\x1b[H"):
            self._go(0)
        elif key in ("G", ">", "\x1b[F"):
            self._go(len(self._lines))
        elif key in _STEPS:
            self._go(self._top + _STEPS[key])
        elif key == "/":
            self._sought = await self._ask(keys)
            self._find(self._top)
        elif key == "n":
            self._find(self._top + 1)

    def _go(self, line: int) -> None:
        self._top = max(0, min(line, len(self._lines) - self._height))

    def _find(self, first: int) -> None:
        for at in range(first, len(self._lines)):
            if self._sought and self._sought.lower() in self._lines[at].lower():
                self._go(at)
                return

    async def _ask(self, keys: InputStream) -> str:
        text = ""
        self._session.stdout.control("\r\x1b[K/")
        while True:
            key = await keys.read_key()
            if key in ("\r", "", "\x03", "\x1b"):
                return text if key == "\r" else ""
            if key in ("\x7f", "\b"):
                text = text[:-1]
            elif key.isprintable():
                text += key
            self._session.stdout.control("\r\x1b[K/")
            self._session.stdout.write(text)


def _rows_of(line: str, width: int) -> Iterator[str]:
    """Cut a line into pieces that fill at most `width` cells."""
    row, used = "", 0
    for character in line:
        cells = char_width(character)
        if used + cells > width:
            yield row
            row, used = "", 0
        row += character
        used += cells
    yield row
