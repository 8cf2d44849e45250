"""F5: opens the lessons, goes to them and back, and on to the next step when one is solved."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.reason import reason
from day6_core.shell.user import login_name
from day6_tui.actions import Handlers
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.features.step_view import EDITOR, TERMINAL, TYPED_INTO, kind_of, show_step
from day6_tui.panes.arranging import Arranging
from day6_tui.panes.pane import Pane, PaneMessage, Piece
from day6_tui.parts import Feature, Parts
from day6_tui.textual_private.survival import PersonMessage

if TYPE_CHECKING:
    from day6_core.session.session import Main, Session
    from day6_core.shell.desk import Desk
    from day6_tui.windows.lesson.lesson import LessonPane

KEPT_SECONDS = 3.0
"""How long Enter is kept for a window that is coming."""

PUPIL = "pupil"
"""The setting with the name of the pupil."""


class LessonAsked(PaneMessage, PersonMessage):
    """The lesson window asks to go to the 'terminal', or on to the 'next' step."""

    def __init__(self, pane: Pane, what: str) -> None:
        super().__init__(pane)
        self.what = what


class Lessons(Feature):
    """Owns the lesson window of the desktop."""

    def __init__(self, parts: Parts, arranging: Arranging, folder: Path | None = None) -> None:
        super().__init__(parts)
        self._arranging = arranging
        self._folder = folder
        self._at: object = None
        """The lesson and step that were on the screen at the last frame."""
        self._slots: frozenset[int] = frozenset()
        """The panes that there were then."""
        self._goes_on = False
        """Whether the person has asked for the next step: the keyboard goes where that is done."""
        self._last: dict[str, str] = {}
        self._asked_at: float | None = None
        """When the window was asked for that is not there yet; its program runs, or there is no desk to run it."""
        self._begin: Callable[[], None] | None = None
        """What opens the window, as soon as it was said that it comes."""
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
        found = next((pane for pane in self._desktop.panes.values() if pane.window.kind == "lesson"), None)
        if found is None:
            return None  # asked at every frame: nothing is imported before there is one
        from day6_tui.windows.lesson.lesson import LessonPane

        return found if isinstance(found, LessonPane) else None

    def toggle(self) -> None:
        """Open the lessons; where they are open go on to the next step if this one is solved, else there or back."""
        pane = self.pane
        if pane is None:
            self.open()
            return
        self._asked_at = None
        self.follow()  # the step may have begun since the last frame: what is asked for now is asked of this one
        if pane.course.state.solved:
            self._go_on(pane)
        elif self._desktop.focused_pane is pane:
            self.back_to_work()
        else:
            self._desktop.go_to_pane(pane)

    def _go_on(self, pane: LessonPane) -> None:
        self._goes_on = True
        self.back_to_work()  # quick fingers type before the step is there
        pane.course.request(pane.course.next)

    def pieces(self) -> list[Piece]:
        """For the upper line: that the step is solved, where its page is covered."""
        pane, colours = self.pane, self._look.colours
        if pane is None or not pane.course.state.solved or self._desktop.is_shown(pane):
            return []
        words = self._look.texts("lesson.done.key")
        return [Piece(f" {words} ", colours.choice, self.toggle), Piece("  ", colours.bar)]

    def open(self, first: str = "", *, demo: bool = False) -> None:
        """Open the window at a lesson, else at that of the last time; with `demo` it is played by itself.

        What is typed counts from now on, also before the window is there.
        """
        desk, self._named = self._machine.desk, bool(first)
        if self._asked_at is None:
            self._asked_at = time.monotonic()
        elif not self._wanted:
            return  # it is being opened
        self._wanted = desk is None
        if desk is None:
            return  # a quick key: the desk comes right after the first frame
        language = self._look.texts.language if demo else ""
        self._desktop.welcome.show_guide()
        self._begin = partial(self._machine.start, "lesson", self._program(desk, first, language, desk.clock.now_ns()))

    def begin(self) -> None:
        """That the window comes has been said: begin with what takes a moment, and on a slow machine seconds of imports."""
        begin, self._begin = self._begin, None
        if begin is not None:
            begin()

    def _program(self, desk: Desk, first: str, demo: str, since_ns: int) -> Main:
        asked_at = self._asked_at

        async def main(session: Session) -> int | None:
            try:
                from day6_core.lessons.program import lessons_of

                return await lessons_of(desk, self.pupil, self._folder, first, demo, since_ns)(session)
            finally:
                if self._asked_at == asked_at:  # it is no other one that is coming
                    self._asked_at = None

        return main

    def is_coming(self) -> bool:
        """Whether the window was asked for and is not there yet, which takes a moment on a slow machine."""
        if self._asked_at is not None and self.pane is not None:
            self._asked_at = None
        return self._asked_at is not None

    def keeps_enter(self) -> bool:
        """Whether Enter is meant for the window that is coming, and for nothing that has the keyboard until then."""
        since = self._asked_at if self.is_coming() else None
        is_soon = since is not None and (self._wanted or time.monotonic() < since + KEPT_SECONDS)
        return is_soon and not self._named and self._desktop.overlay is None

    def go_to(self, name: str) -> bool:
        """Open the window at a lesson, or have it show that; False if it is known to have no such lesson.

        Several names, with blanks between them, are the drills of an exam.
        """
        pane, names = self.pane, name.split()
        if pane is None:
            self.open(name)
            return True
        course = pane.course
        if not all(map(course.offer.named, names)):
            return False
        course.request(lambda: course.start_exam(names) if len(names) > 1 else course.open(name))
        return True

    def back_to_work(self) -> None:
        """Give the keyboard to what the step is done in."""
        if (pane := self._work()) is not None:
            self._desktop.go_to_pane(pane)

    def _work(self) -> Pane | None:
        """What the step is done in: the window it names first if that is open, else the terminal or editor used last."""
        step = self.pane.course.state.step if self.pane is not None else None
        first = step.see[0] if step is not None else TERMINAL
        used = [self._desktop.slots[slot] for slot in self._desktop.recent]
        kinds = [(first, EDITOR), TYPED_INTO]
        return next((pane for these in kinds for pane in used if kind_of(pane) in these), None)

    def handle(self, event: LessonAsked) -> None:
        """Do what the window asks for."""
        if event.what == "next" and self.pane is not None:
            self._go_on(self.pane)
        elif event.what == "terminal":
            self.back_to_work()

    def follow(self) -> None:
        """Where a step has begun or a pane was opened: have on the screen what the step speaks of, and the keyboard there."""
        pane, desktop = self.pane, self._desktop
        if pane is None or not desktop.size.width:
            self._at = None
            return
        state, slots = pane.course.state, frozenset(desktop.slots)
        at = (state.lesson.name, state.index) if state.lesson is not None else ()
        if (at, slots) == (self._at, self._slots):
            return
        begins, new = at != self._at, [desktop.slots[slot] for slot in sorted(slots - self._slots)]
        self._at, self._slots = at, slots
        work = next((each for each in new if kind_of(each) in TYPED_INTO), self._work())
        if begins:
            new = []
            self._give_keyboard(pane, work)
        if work is not None and not desktop.enlarged and not self._arranging.speaks:
            show_step(desktop, pane, state.step.see if state.step is not None else (TERMINAL,), work, new)

    def _give_keyboard(self, pane: LessonPane, work: Pane | None) -> None:
        """A step has begun: where something has to be chosen the keyboard is in its window, what is open over it stays."""
        if self._goes_on:
            self._desktop.enlarged = False
        if pane.takes_focus:
            self._desktop.focus_pane(pane)
        elif self._goes_on and work is not None:
            self._desktop.focus_pane(work)
        self._goes_on = False

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
                self._asked_at = None
                self.open()
            return None

        self._desktop.open_overlay(
            Prompt(self._look, texts("lesson.name"), self.pupil, take, note=texts("lesson.name.note"))
        )

    def _set(self, name: str, value: str) -> None:
        try:
            self._settings.set(name, value)
        except OSError as error:
            self._notices.show(self._look.texts("settings.not_kept", reason=reason(error)), NOTICE_SECONDS)
