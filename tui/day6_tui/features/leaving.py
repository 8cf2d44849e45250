"""Leaving the desktop: not before the user knows what would be lost or ended."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from textual.app import App

from day6_tui.overlays.modal import Modal
from day6_tui.panes.cells import clip
from day6_tui.parts import Feature, Parts
from day6_tui.terminals.view import tab_name
from day6_tui.windows import WindowPane

NAME_WIDTH = 40
"""Cells for the name of a program that still runs."""

MOST_NAMES = 6


class Leaving(Feature):
    """Ends the application, of which it only uses `exit`, or leaves it by `detach` where that is possible."""

    def __init__(
        self, parts: Parts, app: App[None], detach: Callable[[], object] | None, joined: Callable[[], int]
    ) -> None:
        super().__init__(parts)
        self._app = app
        self._detach = detach
        self._joined = joined
        """How many pupils are joined to this desktop."""
        self._asked: Modal | None = None
        """The question whether to end what runs."""
        self._question: Modal | None = None
        """The question whether to end at all."""

    def asks(self) -> bool:
        """Whether the user is being asked if the desktop shall end."""
        return self._question is not None and self._desktop.overlay is self._question

    def lost(self) -> list[str]:
        """What the windows cannot keep if the desktop ends now, each with the reason."""
        return [lost for pane in self._desktop.panes.values() if (lost := pane.loses_at_the_end())]

    def running(self) -> list[str]:
        """The programs that run in the terminals, by their short names."""
        panes = [pane for pane in self._desktop.terminals() if pane.has_terminal]
        commands = [command for pane in panes for command in pane.view.terminal.running]
        return [clip(tab_name(command), NAME_WIDTH) for command in commands]

    def press_quit(self) -> None:
        """^Q: a window with a file closes its file; anywhere else it ends the desktop."""
        pane = self._desktop.focused_pane
        if self._desktop.overlay is None and isinstance(pane, WindowPane) and pane.closes_on_quit:
            pane.close()
        else:
            self.quit()

    def quit(self) -> None:
        """End the desktop. Ask first if a text would be lost because there is no room for a copy of it, or programs run, or
        pupils are joined.

        Asked a second time while that question is open, it ends the programs, and the class.
        """
        lost, running, joined = self.lost(), self.running(), self._joined()
        asked_twice = self._asked is not None and self._desktop.overlay is self._asked
        if not lost and (asked_twice or not (running or joined)):
            self._app.exit()
            return
        from day6_tui.overlays.question import Answer, Question

        texts = self._look.texts
        if lost:
            what = texts("list.comma").join(lost)
            what += " " * what[-1].isascii()  # between a Latin name and the Chinese behind it
            title, text, yes = texts("quit.title"), texts("quit.lost", what=what).rstrip(), texts("quit.anyway")
        else:
            text = "\n".join([*self._about_running(running), *self._about_class(joined)])
            title, yes = texts("quit.running" if running else "quit.class"), texts("quit.leave")
        answers = [Answer("y", yes, self._app.exit)]
        if self._detach is not None:
            answers.append(Answer("d", texts("quit.detach"), self._detach))
        question = Question(self._look, title, text, answers, careful=bool(lost))
        self._asked, self._question = None if lost else question, question
        self._desktop.open_overlay(question)

    def _about_running(self, running: list[str]) -> Iterator[str]:
        if running:
            texts = self._look.texts
            names = texts("list.comma").join(running[:MOST_NAMES])
            more = texts("quit.more", count=len(running) - MOST_NAMES) if len(running) > MOST_NAMES else ""
            yield texts("quit.runs" if len(running) == 1 else "quit.run", what=names + more)

    def _about_class(self, joined: int) -> Iterator[str]:
        if joined:
            texts = self._look.texts
            yield texts("quit.joined.one") if joined == 1 else texts("quit.joined", count=joined)

    def end_by_signal(self, why: str = "") -> None:
        """End after a closed terminal, `kill` or by a teacher: the user is not asked, but told what is lost, and why."""
        lost = self.lost()
        if lost:
            told = self._look.texts("quit.was_lost", what="; ".join(lost))
            self._app.exit(return_code=1, message=f"{why}\n{told}" if why else told)
        elif why:
            self._app.exit(message=why)
        else:
            self._app.exit()
