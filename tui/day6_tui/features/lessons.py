"""F5: opens the lessons, goes to them and back, and on to the next step when one is solved."""

from __future__ import annotations

import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.shell.user import login_name
from day6_tui.actions import Handlers
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.panes.pane import Pane, PaneMessage
from day6_tui.parts import Feature, Parts
from day6_tui.textual_private.survival import PersonMessage

if TYPE_CHECKING:
    from day6_core.lessons.document import Lesson
    from day6_tui.windows.lesson.lesson import LessonPane

OPENING_SECONDS = 3.0
"""How long a window may take to open: F5 pressed again meanwhile does not open a second one."""

PUPIL = "pupil"
"""The setting with the name of the pupil."""


class LessonAsked(PaneMessage, PersonMessage):
    """The lesson window asks: to go to the 'terminal', what was 'opened'."""

    def __init__(self, pane: Pane, what: str, *, lesson: Lesson | None = None) -> None:
        super().__init__(pane)
        self.what = what
        self.lesson = lesson


class Lessons(Feature):
    """Owns the lesson window of the desktop."""

    def __init__(self, parts: Parts, folder: Path | None = None) -> None:
        super().__init__(parts)
        self._folder = folder
        self._last: dict[str, str] = {}
        self._opening_until = 0.0
        self._wanted = False
        """Whether F5 was pressed before there was a desk."""
        self._named = False
        """Whether a certain lesson was asked for: then the keyboard stays in the terminal."""

    def actions(self) -> Handlers:
        return {"lessons": self.toggle, "pupil": self.ask_pupil}

    @property
    def pupil(self) -> str:
        """Whose progress is kept: as chosen, else who uses this computer."""
        return self._settings.text(PUPIL) or login_name()

    @property
    def pane(self) -> LessonPane | None:
        """The open window."""
        from day6_tui.windows.lesson.lesson import LessonPane

        return next((pane for pane in self._desktop.panes.values() if isinstance(pane, LessonPane)), None)

    def toggle(self) -> None:
        """Open the lessons; where they are open go on to the next step if this one is solved, else there or back."""
        pane = self.pane
        if pane is not None:
            self._opening_until = 0.0
        if pane is None:
            self.open()
        elif not self._desktop.is_shown(pane):
            self._desktop.go_to_pane(pane)
        elif pane.course.state.solved:
            pane.course.request(pane.course.next)
            if self._desktop.focused_pane is pane:
                self.back_to_work()
        elif self._desktop.focused_pane is pane:
            self.back_to_work()
        else:
            self._desktop.go_to_pane(pane)

    def open(self, first: str = "", *, demo: bool = False) -> None:
        """Open the window at a lesson, else at that of the last time; with `demo` it is played by itself."""
        desk, self._named = self._machine.desk, bool(first)
        if desk is None:
            self._wanted = True  # a quick key: the desk comes right after the first frame
            return
        if time.monotonic() < self._opening_until:
            return  # it is being opened
        self._opening_until = time.monotonic() + OPENING_SECONDS
        from day6_core.lessons.program import lessons_of

        self._wanted = False
        self._desktop.welcome.show_guide()
        self._machine.start(
            "lesson",
            lessons_of(
                desk,
                self.pupil,
                self._folder,
                first,
                self._look.texts.language if demo else "",
            ),
        )

    def is_coming(self) -> bool:
        """Whether the window was asked for and is not there yet, which takes a moment on a slow machine."""
        if not self._wanted and time.monotonic() >= self._opening_until:
            return False
        if self.pane is not None:
            self._opening_until = 0.0
        return self.pane is None

    def keeps_enter(self) -> bool:
        """Whether Enter is meant for the window that is coming, and for nothing that has the keyboard until then."""
        return self.is_coming() and not self._named and self._desktop.overlay is None

    def go_to(self, name: str) -> bool:
        """Open the window at a lesson, or have it show that; False if it is known to have no such lesson."""
        pane = self.pane
        if pane is None:
            self.open(name)
            return True
        if pane.course.offer.named(name) is None:
            return False
        pane.course.request(lambda: pane.course.open(name))
        return True

    def back_to_work(self) -> None:
        """Give the keyboard to what was used before the lesson: a terminal, an editor, RViz."""
        others = [self._desktop.slots[slot] for slot in self._desktop.recent]
        if (pane := next((each for each in others if each is not self.pane), None)) is not None:
            self._desktop.go_to_pane(pane)

    def handle(self, event: LessonAsked) -> None:
        """Do what the window asks for."""
        if event.what == "terminal":
            self.back_to_work()
        elif event.what == "opened" and (lesson := self.pane) is not None and lesson.takes_focus:
            self._desktop.focus_pane(lesson)  # something has to be chosen there; what is open over it stays

    @property
    def where(self) -> str:
        """The title of the lesson of the last time, for the welcome choices; '' if there was none."""
        return self._last.get(self._look.texts.language, "")

    def look_back(self) -> None:
        """The desk is here: do what waited for it, and find out, without keeping anybody waiting, which lesson was the last."""
        if self._wanted:
            self.open()
        desk, pupil = self._machine.desk, self.pupil
        if desk is None or self._folder is not None:
            return
        home = desk.home

        def read() -> None:
            from day6_core.lessons.progress import ProgressError, file_of, load

            try:
                self._last = load(file_of(home, pupil)).last_title
            except (ProgressError, OSError):
                return  # told when the lessons are opened
            if self._last:
                self._look.wake()

        threading.Thread(target=read, name="day6-last-lesson", daemon=True).start()

    def ask_pupil(self) -> None:
        """Ask for the pupil's name; progress is kept under it."""
        from day6_core.lessons.progress import name_mistake
        from day6_tui.overlays.prompt import Prompt

        texts = self._look.texts

        def take(name: str) -> str | None:
            if mistake := name_mistake(name):
                return texts(f"lesson.name.{mistake}")
            self._set(PUPIL, name.strip())
            if (pane := self.pane) is not None:
                pane.close()
                self._opening_until = 0.0
                self.open()
            return None

        self._desktop.open_overlay(
            Prompt(self._look, texts("lesson.name"), self.pupil, take, note=texts("lesson.name.note"))
        )

    def _set(self, name: str, value: str) -> None:
        try:
            self._settings.set(name, value)
        except OSError as error:
            reason = error.strerror or str(error)
            self._notices.show(self._look.texts("settings.not_kept", reason=reason), NOTICE_SECONDS)
