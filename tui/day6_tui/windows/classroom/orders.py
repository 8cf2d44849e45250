"""What a teacher asks of one pupil or of all, and what it came to."""

from __future__ import annotations

from datetime import date
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.classroom.handed import LARGEST
from day6_core.classroom.order import LONGEST_LINK, LONGEST_SAYING, Order, is_link
from day6_core.places import meant_in
from day6_core.reason import reason
from day6_core.whole_file import open_at_once
from day6_tui.classes.handing import Handing
from day6_tui.classes.link import TeacherLink
from day6_tui.windows import WindowPane

if TYPE_CHECKING:
    from day6_tui.overlays.menu import MenuEntry

LARGEST_WORDS = "1 MB"
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
        self._tell_reached(name, self._roster.order(self._names(name), order))

    def _names(self, name: str) -> list[str]:
        return [row.name for row in self._roster.rows()] if name == ALL else [name]

    def _tell_reached(self, name: str, missed: list[str]) -> None:
        texts, names = self._look.texts, self._names(name)
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

    def ask_for_question(self, name: str) -> None:
        """Ask for a sentence that is to be answered."""
        texts = self._look.texts
        title = texts("teacher.ask.all") if name == ALL else texts("teacher.ask", name=name)
        self._window.ask(title, "", partial(self._ask, name))

    def _ask(self, name: str, text: str) -> str | None:
        if not text.strip():
            return self._look.texts("teacher.say.nothing")
        self._tell_reached(name, self._roster.ask(self._names(name), text.strip()[:LONGEST_SAYING]))
        return None

    def settle(self) -> None:
        """Wait for the answers to the last question no longer."""
        if questions := self._roster.questions.open:
            self._roster.settle(questions[-1].number)
        self._look.wake()

    def ask_for_link(self, name: str) -> None:
        """Ask for a link to hand over."""
        texts = self._look.texts
        title = texts("teacher.link.all") if name == ALL else texts("teacher.link", name=name)
        self._window.ask(title, "https://", partial(self._hand, name))

    def _hand(self, name: str, text: str) -> str | None:
        link = text.strip()
        if len(link) > LONGEST_LINK or not is_link(link):
            return self._look.texts("teacher.link.none")
        self._send_and_tell(name, Order("link", text=link))
        return None

    def ask_for_path(self, name: str) -> None:
        """Ask for a file to hand out."""
        texts = self._look.texts
        title = texts("teacher.file.all") if name == ALL else texts("teacher.file", name=name)
        self._window.ask(title, "", partial(self._hand_file, name), note=texts("teacher.file.note", most=LARGEST_WORDS))

    def _hand_file(self, name: str, text: str) -> str | None:
        home = self._window.model.home
        path = home / meant_in(home, text.strip())
        try:
            with open(path, "rb", opener=open_at_once) as file:
                data = file.read(LARGEST + 1)
        except (OSError, ValueError) as error:
            return reason(error)
        if len(data) > LARGEST:
            return self._look.texts("teacher.file.large", most=LARGEST_WORDS)
        names = self._names(name)
        here = [each for each in names if (row := self._roster.row(each)) is not None and row.is_here]
        away = [each for each in names if each not in here]
        handing = self._window.model.hand(path.name, data, here, partial(self._tell_handed, away))
        self._tell_handed(away, handing)
        return None

    def _tell_handed(self, away: list[str], handing: Handing) -> None:
        """How many have the file, and who has not, and why."""
        texts, count = self._look.texts, len(handing.reached)
        told = texts("teacher.file.handed", file=handing.file, count=count, all=len(handing.names) + len(away))
        failed = [
            texts("teacher.file.failed", name=name, reason=why or texts("teacher.file.silent"))
            for name, why in handing.failed
        ]
        if missed := [*failed, *map(self._with_reason, away)]:
            told = f"{told}; {texts('teacher.missed', names=texts('list.comma').join(missed))}"
        self._tell(told)

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
            names = write_report(home / meant_in(home, text.strip()), self._roster, texts)
        except Exists as error:
            return texts("teacher.csv.exists", file=Path(str(error)).name)
        except OSError as error:
            return reason(error)
        self._tell(texts("teacher.csv.written", files=texts("list.comma").join(names)))
        return None
