"""The choice that a command offers where a name was left out, since Lyrical: real ROS starts fzf for it, this is our own.

It works like fzf: what is typed narrows the list, the arrows move, Enter takes, Esc and Ctrl-C leave.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from day6_core.ros.differences import value

if TYPE_CHECKING:
    from argparse import Namespace

    from day6_core.session.session import Session
    from rclpy.node import Node

ROWS = 10
"""Names that are shown at once."""
_UP = ("\x1b[A", "\x1bOA", "\x10", "\x0b")
_DOWN = ("\x1b[B", "\x1bOB", "\x0e")
_LEAVE = ("", "\x1b", "\x03", "\x07", "\x04")


class NothingChosen(Exception):
    """The user has left the choice: the command ends and does nothing."""


def may_be_left_out() -> str | None:
    """Return argparse's `nargs` of a name that this distribution lets the user choose."""
    return "?" if value("ros2.chooses") else None


async def choose(session: Session, names: Sequence[str], prompt: str) -> str:
    """Return the name that the user takes. Raises NothingChosen, also where there is no terminal to choose in."""
    if not session.stdin.isatty() or not session.stdout.isatty():
        session.print_error("Error: Interactive selection requires a TTY terminal.")
        raise NothingChosen
    choice = _Choice(session, list(names), prompt)
    with session.stdin.raw(signals=False):
        try:
            while True:
                choice.show()
                key = await session.stdin.read_key()
                if key in _LEAVE:
                    raise NothingChosen
                if key in ("\r", "\n") and choice.found:
                    return choice.found[choice.at]
                choice.press(key)
        finally:
            choice.clear()


async def choose_topic(session: Session, args: Namespace, node: Node, prompt: str) -> str:
    """Return the topic that the user takes. Raises RuntimeError if there is none, NothingChosen."""
    from day6_core.ros.ros2.cli.node import topics

    names = [name for name, _ in topics(node, hidden=getattr(args, "include_hidden_topics", False))]
    if not names:
        raise RuntimeError("No topics available to select from.")
    return await choose(session, names, prompt)


async def choose_node(session: Session, node: Node, prompt: str, *, hidden: bool) -> str:
    """Return the node that the user takes. Raises RuntimeError if there is none, NothingChosen."""
    from day6_core.ros.ros2.cli.node import node_names

    names = node_names(node, hidden=hidden)
    if not names:
        raise RuntimeError("No nodes available to select from.")
    return await choose(session, names, prompt)


def matching(names: Sequence[str], query: str) -> list[str]:
    """Return the names with the letters of each word in their order, the closest together first; capitals mean capitals."""
    words = query.split()
    fold = query == query.lower()
    ranked = []
    for number, name in enumerate(names):
        spans = [_span(name.lower() if fold else name, word) for word in words]
        if None not in spans:
            ranked.append((sum(filter(None, spans)), len(name) if words else 0, number, name))
    return [name for *_, name in sorted(ranked)]


def _span(name: str, word: str) -> int | None:
    """Return the length of the shortest part of a name with the letters of a word in their order, None without one."""
    best: int | None = None
    for start in (at for at, letter in enumerate(name) if letter == word[0]):
        at = start
        for letter in word[1:]:
            at = name.find(letter, at + 1)
            if at < 0:
                return best
        best = min(best or len(name), at - start + 1)
    return best


class _Choice:
    """What was typed, which names fit it, and at which of them the mark is."""

    def __init__(self, session: Session, names: list[str], prompt: str) -> None:
        self._session, self._names, self._prompt = session, names, prompt
        self._query = ""
        self._drawn = False
        self.found = names
        self.at = 0

    def press(self, key: str) -> None:
        """Do what a key means."""
        if key in _UP or key in _DOWN:
            self.at += 1 if key in _DOWN else -1
        elif key in ("\x7f", "\x08"):
            self._query = self._query[:-1]
        elif key == "\x15":
            self._query = ""
        elif key.isprintable():
            self._query += key
        self.found = matching(self._names, self._query)
        self.at = max(0, min(self.at, len(self.found) - 1))

    def show(self) -> None:
        """Draw the line with what was typed, the numbers, and the names around the mark."""
        first = max(0, min(self.at - ROWS // 2, len(self.found) - ROWS))
        shown = self.found[first : first + ROWS]
        width = max(8, self._session.stdout.columns - 3)
        lines = [f"  {len(self.found)}/{len(self._names)}"]
        lines += [f"{'>' if first + row == self.at else ' '} {name[:width]}" for row, name in enumerate(shown)]
        self.clear()
        out = self._session.stdout
        out.write("\r\n" + "\r\n".join(lines))
        out.control(f"\x1b[{len(lines)}A\r")
        out.write(f"{self._prompt} {self._query}")
        self._drawn = True

    def clear(self) -> None:
        """Take away what was drawn."""
        if self._drawn:
            self._session.stdout.control("\r\x1b[J")
            self._drawn = False
