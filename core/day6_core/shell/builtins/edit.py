"""nano, gedit, vim, code …: all open the same editor window on the given files."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from day6_core.places import data_folder
from day6_core.session.session import Session
from day6_core.session.task import Signal
from day6_core.shell.editing.model import CannotEdit, Editor

IN_THE_TERMINAL = ("nano", "vim", "vi")
"""Editors that really run in the terminal, so that what is typed there goes to them."""


async def edit(session: Session) -> int:
    """Open a window on a file or folder and stay until it is closed, as nano and gedit do."""
    words = [word for word in session.argv[1:] if not word.startswith(("-", "+"))]
    if session.display is None:
        session.print_error(f"{session.name}: there is no screen to edit on; the desktop of day6-tui has one")
        return 1
    path = session.cwd / (words[0] if words else ".")
    model = Editor(
        path if path.is_dir() else path.parent,
        _state_folder(),
        session.name,
        Path(session.env.get("HOME", "/")),
        session.env,
    )
    if not path.is_dir():
        try:
            model.open(path)
        except CannotEdit as error:
            session.print_error(f"{session.name}: {error}")
            return 1
    if session.name in IN_THE_TERMINAL:
        session.stdin.pass_keys_to(model)
        session.defer(partial(_give_keys_back, session, model))
    session.display.open("editor", session.name, model)
    await session.wait(Signal())  # closing the window interrupts the program
    return 0


def _give_keys_back(session: Session, model: Editor) -> None:
    session.stdin.pass_keys_to(None)
    if unread := model.take_typed():
        session.stdin.push_back(unread)


def _state_folder() -> Path:
    """The folder in which copies of unsaved texts survive a crash."""
    return data_folder() / "unsaved"
