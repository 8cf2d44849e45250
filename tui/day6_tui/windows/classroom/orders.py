"""What a teacher asks of one pupil or of all, and what it came to."""

from __future__ import annotations

from datetime import date
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.classroom.order import LONGEST_SAYING, Order
from day6_core.reason import reason
from day6_tui.classes.link import TeacherLink
from day6_tui.windows import WindowPane

if TYPE_CHECKING:
    from day6_tui.overlays.menu import MenuEntry

ALL = ""
"""In place of a pupil's name: everybody."""


class Orders:
    """Asks for what an order needs in prompts over the window, and sends it."""

    def __init__(self, window: WindowPane[TeacherLink]) -> None:
        self._window = window
        self._look = window.look
        self._roster = window.model.roster
        self.said = ""
        """What the last order came to."""

    # -- sending -------------------------------------------------------------------------------------------------------

    def send(self, name: str, order: Order) -> None:
        """Ask something of a pupil who shows what came of it: only what fails is told."""
        self.tell_missed(self._roster.order([name], order))

    def tell_missed(self, names: list[str]) -> None:
        """Tell who could not be reached, behind what is told already."""
        if names:
            texts = self._look.texts
            missed = texts("teacher.missed", names=texts("list.comma").join(map(self._with_reason, names)))
            self._tell(f"{self.said}; {missed}" if self.said else missed)

    def _with_reason(self, name: str) -> str:
        row = self._roster.row(name)
        return name if row is not None and row.is_here else self._look.texts("teacher.away", name=name)

    def _send_and_tell(self, name: str, order: Order) -> None:
        """Send an order that leaves no trace in the table, and tell whom it reached."""
        texts, rows = self._look.texts, self._roster.rows()
        names = [row.name for row in rows] if name == ALL else [name]
        missed = self._roster.order(names, order)
        if reached := len(names) - len(missed):
            self._tell(texts("teacher.sent.all", count=reached) if name == ALL else texts("teacher.sent", name=name))
        self.tell_missed(missed)

    def _tell(self, text: str) -> None:
        self.said = text
        self._look.wake()

    # -- the orders ----------------------------------------------------------------------------------------------------

    def freeze(self) -> None:
        """Have all look up, or go on."""
        self.tell_missed(self._roster.freeze(not self._roster.is_frozen))
        self._look.wake()

    def ask_to_say(self, name: str) -> None:
        """Ask for a sentence."""
        texts = self._look.texts
        title = texts("teacher.say.all") if name == ALL else texts("teacher.say", name=name)
        self._window.ask(title, "", partial(self._say, name))

    def _say(self, name: str, text: str) -> str | None:
        if not text.strip():
            return self._look.texts("teacher.say.nothing")
        self._send_and_tell(name, Order("say", text=text.strip()[:LONGEST_SAYING]))
        return None

    def choose_what_to_open(self, name: str) -> None:
        """Offer the lessons, drills and scenes."""
        from day6_tui.overlays.menu import Menu

        self._window.lay_over(Menu(self._look, "teacher.open", self._entries(name)))

    def _entries(self, name: str) -> list[MenuEntry]:
        from day6_core.lessons.catalogue import offer
        from day6_core.lessons.scene import scenes
        from day6_tui.overlays.menu import MenuEntry

        texts, open_there = self._look.texts, partial(self._send_and_tell, name)
        lessons = [
            MenuEntry(
                f"{each.name}  {each.title[texts.language]}",
                texts("teacher.open.lesson"),
                partial(open_there, Order("lesson", text=each.name)),
            )
            for each in offer().all
        ]
        return lessons + [
            MenuEntry(each, texts("teacher.open.scene"), partial(open_there, Order("scene", text=each)))
            for each in scenes()
        ]

    def ask_to_end(self, name: str) -> None:
        """Ask whether to end a pupil's desktop."""
        from day6_tui.overlays.question import Answer, Question

        texts, row = self._look.texts, self._roster.row(name)
        if row is None or not row.is_here:
            self.tell_missed([name])
            return
        answer = Answer("y", texts("teacher.end.yes"), partial(self.send, name, Order("end")))
        title, text = texts("teacher.end", name=name), texts("teacher.end.text")
        self._window.lay_over(Question(self._look, title, text, [answer], careful=True))

    # -- the report ----------------------------------------------------------------------------------------------------

    def ask_for_file(self) -> None:
        """Ask where the report and the log of the lesson go."""
        self._window.ask(self._look.texts("teacher.csv"), f"class-{date.today():%Y-%m-%d}.csv", self._write)

    def _write(self, text: str) -> str | None:
        from day6_core.lessons.tables import Exists
        from day6_tui.windows.classroom.report import write_report

        texts, home = self._look.texts, self._window.model.home
        try:
            names = write_report(home / Path(text.strip()).expanduser(), self._roster, texts)
        except Exists as error:
            return texts("teacher.csv.exists", file=Path(str(error)).name)
        except OSError as error:
            return reason(error)
        self._tell(texts("teacher.csv.written", files=texts("list.comma").join(names)))
        return None
