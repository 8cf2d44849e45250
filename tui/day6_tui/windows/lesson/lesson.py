"""The lesson window: the list of lessons, or one step; the pupil works in the terminal beside it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events

from day6_core.lessons.document import HINTS
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.features.lessons import LessonAsked
from day6_tui.panes.cells import cell_len
from day6_tui.panes.host import PaneHost
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import LESSON
from day6_tui.windows import WindowPane
from day6_tui.windows.lesson.page import Action, LessonEntry, PageRow, list_rows, of_the_end, step_page

if TYPE_CHECKING:
    from day6_core.lessons.course import Course
    from day6_core.lessons.state import State


class LessonPane(WindowPane["Course"]):
    """Draws the course, scrolls, and hands on what the pupil chooses."""

    needs = LESSON

    def __init__(self, window: Window[Course], look: Look) -> None:
        super().__init__(window, look)
        self.course = window.model
        self.chosen = 0
        """The lesson in the list that Enter opens."""
        self._top = 0
        self._news: dict[str, object] = {}
        """What was last shown of the things that come up while the pupil works."""
        self._leaving = False
        """Whether a command is being typed for a terminal: the focus moves a moment later than quick fingers."""
        self._picked = ""
        """Letters of answers that were pressed. Enter gives the last one: they may as well be the beginning of a command."""
        self._notes = False
        """Whether the notes for the teacher are shown."""
        self._follow = True
        """Whether the chosen lesson has to be brought into sight."""
        self._rows: list[PageRow] = []
        self._pinned: list[PageRow] = []
        """What stays in sight below the rows that scroll."""
        self._entries: list[LessonEntry] = []
        self._built_for: object = None
        """What the rows were made of."""
        self._touched_for: object = None
        """What everything was last drawn for."""
        self._shown: object = self
        """The lesson and step whose page was built last: at first none."""

    # -- what is shown -------------------------------------------------------------------------------------------------

    @property
    def label(self) -> str:
        lesson = self.course.state.lesson
        return self.look.texts("lesson.title") if lesson is None else lesson.title[self.look.texts.language]

    @property
    def takes_focus(self) -> bool:  # type: ignore[override]
        """A list waits for a choice and a question for an answer; other steps are done in the terminal."""
        state = self.course.state
        is_question = state.step is not None and all(check.name == "answer" for check in state.step.checks)
        return state.lesson is None or is_question or self.keeps_focus

    @property
    def keeps_focus(self) -> bool:  # type: ignore[override]
        """While something is typed for a hall the keys that hold it and set its pace are needed here."""
        return self.course.demonstration is not None

    @property
    def inherits(self) -> bool:  # type: ignore[override]
        """After an editor was closed the terminal is what a step is done in."""
        return self.takes_focus

    def loses_at_the_end(self) -> str:
        kept = self.course.kept
        return self.look.texts("lesson.unsaved", reason=kept.failed) if kept.failed and kept.unsaved else ""

    def kept_view(self) -> str:
        return self.course.state.lesson.name if self.course.state.lesson is not None else ""

    def pull(self, now: float) -> bool:
        if self._key() != self._touched_for:
            self.touch()
        return False

    def touch(self) -> None:
        # The course may go on before this is drawn, and between the rows and the edge: then `pull` has all drawn once more.
        self._touched_for = self._key()
        super().touch()

    @staticmethod
    def _place(state: State) -> object:
        return (state.lesson.name, state.index) if state.lesson is not None else None

    def _key(self) -> tuple[object, ...]:
        return (
            self.course.version,
            self.inner_width,
            self.inner_height,
            self.look.texts.language,
            self.look.colours,
            self.look.glyphs,
            self.chosen,
            self._top,
            self._notes,
            self._picked,
            self.has_focus,
        )

    def _choose_last(self, left: object) -> None:
        """Stand on the lesson or drill that was `left`, or after one that is finished, else on that of the last time."""
        finished = self.course.state.finished
        names = [lesson.name for lesson in self.course.offer.all]
        shown = left[0] if isinstance(left, tuple) else self.course.progress.last
        last = finished.name if finished is not None else shown
        if last in names:
            self.chosen = names.index(last)
            if finished is not None and self.chosen + 1 < len(names):
                self.chosen += 1
        self._follow = True

    @property
    def _scrolling(self) -> int:
        """Lines in which rows scroll: those above what is pinned and the line before that."""
        return self.inner_height - len(self._pinned) - bool(self._pinned)

    @property
    def _more(self) -> bool:
        return self._top + self._scrolling < len(self._rows)

    def _settle(self) -> None:
        """The rows are those of what there is to show now: asked by whichever line is drawn first."""
        if self._key() != self._built_for:
            self._build(self.inner_width)

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        self._settle()
        below = y - self._scrolling
        if self._pinned and not below:
            return self._divider(y, width)
        rows, at = (self._pinned, below - 1) if self._pinned and below > 0 else (self._rows, self._top + y)
        if at >= len(rows):
            return []
        row = rows[at]
        if row.action is not None:
            self.add_hit(y + self.inner_offset, 1, 1 + width, row.action)
        return row.line

    def _divider(self, y: int, width: int) -> Iterable[Segment]:
        """The line above the task; it tells of what goes on below it."""
        colours, line = self.look.colours, self.look.glyphs.border.horizontal
        told = self._more_words() if self._more else ""
        if told:
            self.add_hit(y + self.inner_offset, 1, 1 + width, self._page_down)
        rest = max(0, width - 3 - cell_len(told))
        return [Segment(f" {line * rest}", colours.frame), Segment(told, colours.muted), Segment(line, colours.frame)]

    def _more_words(self) -> str:
        return f" {'' if self.has_focus else 'F5 '}{self.look.texts('lesson.more')} "

    def _build(self, width: int) -> None:
        version = self.course.version  # before what it counts: the course goes on meanwhile
        state = self.course.state
        if self._place(state) != self._shown:
            left, self._shown = self._shown, self._place(state)
            self._picked = ""
            self._top = 0
            self._news = {}
            if state.step is None:
                self._choose_last(left)
        self._pinned, self._entries = [], []
        if state.step is None:
            self._rows, self._entries = list_rows(self.course, self.look, width, self.chosen, self._open_entry)
            if self._follow:
                self._follow = False
                self._keep_chosen_in_sight()
        else:
            page = step_page(
                self.course,
                state,
                self.look,
                width,
                self._doing,
                notes=self._notes,
                here=self.has_focus,
                picked=self._picked[-1:],
            )
            self._rows, self._pinned = page.laid_out(self.inner_height)
            self._show_news(state)
        self._top = max(0, min(self._top, len(self._rows) - self._scrolling))
        self._built_for = (version, *self._key()[1:])

    def _show_news(self, state: State) -> None:
        """Scroll to what has just come up: a hint, a question, what stands in the way."""
        news: dict[str, object] = {
            "problem": (state.missing, state.leftovers, state.problem, state.mistakes),
            "question": all(verdict.ok for verdict in state.verdicts if verdict.wanted.key != "answer"),
            "answer": state.answer,
            "hint": state.hints,
            "notes": self._notes,
        }
        for what, now in news.items():
            rows = [at for at, row in enumerate(self._rows) if row.news == what]
            if rows and self._news.get(what, now) != now and rows[-1] >= self._top + self._scrolling:
                self._top = min(rows[0], rows[-1] - self._scrolling + 1)
        self._news = news

    def _keep_chosen_in_sight(self) -> None:
        if self.chosen < len(self._entries):
            row = self._entries[self.chosen].row
            first = 0 if self.chosen == 0 else row
            if first < self._top:
                self._top = first
            elif row >= self._top + self.inner_height:
                self._top = row - self.inner_height + 1

    def status(self) -> list[Piece]:
        texts, colours, state = self.look.texts, self.look.colours, self.course.state
        if state.lesson is None:
            pupil = self.course.progress.pupil
            return [Piece(f" {pupil} ", colours.muted)] if pupil else []
        exam, demonstration = self.course.exam, self.course.demonstration
        far = texts("lesson.step", number=state.index + 1, all=len(state.lesson.steps))
        if exam is not None:
            far = texts("lesson.exam.step", number=len(exam.results) + 1, all=len(exam.drills))
        pieces = [Piece(f" {far} ", colours.muted)]
        if demonstration is not None:
            key = "lesson.demo.held" if demonstration.held else "lesson.demo"
            speed = f"{demonstration.speed:g}"
            pieces.append(Piece(f" {texts(key, speed=speed)} ", colours.accent, demonstration.hold))
        elif state.working:
            pieces.append(Piece(f" {texts('lesson.working')} ", colours.accent))
        return pieces

    def status_right(self) -> list[Piece]:
        self._settle()
        texts, colours, state = self.look.texts, self.look.colours, self.course.state
        if state.solved:
            told = texts("lesson.next.key", next=texts(of_the_end("lesson.key.next", state)))
            return [Piece(f" {told} ", colours.choice, self._go_on)]
        if self._more and not self._pinned:
            return [Piece(self._more_words(), colours.muted, self._page_down)]
        if state.lesson is None or state.hints >= HINTS:
            return []
        there = "" if self.has_focus else "F5 "
        return [Piece(f" {there}{texts('lesson.hint.key')} ", colours.accent, self._doing("hint"))]

    def key_hints(self) -> list[tuple[str, str]]:
        texts, state, drills = self.look.texts, self.course.state, self.course.offer.drills
        if state.step is None:
            chance = [("R", texts("lesson.key.random")), ("X", texts("lesson.key.exam"))] if drills else []
            return [("↑↓", texts("lesson.key.choose")), ("Enter", texts("lesson.key.open")), *chance]
        if self.course.demonstration is not None:
            return [
                ("Space", texts("lesson.key.hold")),
                ("→", texts("lesson.key.on")),
                ("[ ]", texts("lesson.key.speed")),
                ("D", texts("lesson.key.stop")),
            ]
        keys = [("Enter", texts(of_the_end("lesson.key.next", state)))] if state.solved else []
        if not state.solved and state.hints < HINTS:
            keys.append(("h", texts("lesson.key.hint")))
        if not state.solved and state.hints >= HINTS and state.step.command:
            keys.append(("Enter", texts("lesson.key.type")))
        if state.leftovers:
            keys.append(("C", texts("lesson.key.clear")))
        if state.missing:
            keys.append(("P", texts("lesson.key.prepare")))
        return [*keys, ("←→", texts("lesson.key.steps")), ("L", texts("lesson.key.list"))]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        keys = [
            ("PgUp PgDn", texts("lesson.key.scroll")),
            ("S", texts("lesson.key.solution")),
            ("D", texts("lesson.key.demo")),
            ("T", texts("lesson.key.notes")),
            ("R", texts("lesson.key.again")),
            ("Esc", texts("lesson.key.terminal")),
        ]
        return [each for each in keys if each[0] not in "DTR" or self.course.searching() != "exam"]

    # -- what is done --------------------------------------------------------------------------------------------------

    def _doing(self, what: str) -> Action:
        """What a click or a key does."""
        course = self.course
        word, _, rest = what.partition(" ")
        table: dict[str, Callable[[], object]] = {
            "hint": course.hint,
            "prepare": course.prepare,
            "answer": lambda: course.choose(rest),
            "next": course.next,
            "back": course.back,
            "again": course.again,
            "list": course.close,
            "solution": course.show_solution,
            "demo": lambda: course.demonstrate(self.look.texts.language),
            "random": course.random_drill,
            "clear": course.clear_up,
            "exam": course.start_exam,
        }
        return lambda: course.request(table[word])

    def _next(self) -> None:
        self.course.request(self.course.next)

    def _go_on(self) -> None:
        self.post_message(LessonAsked(self, "next"))  # and to where that is done

    def _open_entry(self, number: int) -> None:
        self.chosen = number
        if number < len(self._entries):
            name = self._entries[number].name
            self.course.request(lambda: self.course.open(name))
        self.touch()

    def _page_down(self) -> None:
        self._scroll(max(1, self._scrolling - 1))

    def _scroll(self, rows: int) -> None:
        self._top = max(0, min(self._top + rows, len(self._rows) - self._scrolling))
        self.touch()

    def _enter(self) -> None:
        state = self.course.state
        if state.step is None:
            self._open_entry(self.chosen)
        elif self._picked and not state.solved:
            letter, self._picked = self._picked[-1], ""
            self.course.request(lambda: self.course.choose(letter))
        elif state.solved:
            self._go_on()
        elif state.hints >= HINTS and state.step.command:
            self.post_message(self.CommandChosen(self, state.step.command))  # Return is the pupil's

    def on_key(self, event: events.Key) -> None:
        state = self.course.state
        page = max(1, self._scrolling - 1)
        letters = {answer.letter for answer in state.step.pages["zh"].answers} if state.step is not None else set()
        in_list = {
            "down": lambda: self._choose(1),
            "up": lambda: self._choose(-1),
            "R": self._doing("random"),
            "X": self._doing("exam"),
        }
        in_step: dict[str, Callable[[], object]] = {
            "down": lambda: self._scroll(1),
            "up": lambda: self._scroll(-1),
            "right": self._next,
            "left": self._doing("back"),
            "h": self._doing("hint"),
            "L": self._doing("list"),
            "P": self._doing("prepare"),
            "C": self._doing("clear"),
            "R": self._doing("again"),
            "S": self._doing("solution"),
            "D": self._doing("demo"),
            "T": self._toggle_notes,
        }
        if (demonstration := self.course.demonstration) is not None:
            in_step |= {
                "space": demonstration.hold,
                "right": demonstration.go_on,
                "left_square_bracket": lambda: demonstration.change_speed(-1),
                "right_square_bracket": lambda: demonstration.change_speed(1),
            }
        both: dict[str, Callable[[], object]] = {
            "enter": self._enter,
            "pagedown": lambda: self._scroll(page),
            "pageup": lambda: self._scroll(-page),
            "escape": lambda: self.post_message(LessonAsked(self, "terminal")),
        }
        if self._leaving:
            action: Callable[[], object] | None = self._typing(event)
        elif event.character is not None and event.character in letters:
            action = partial(self._pick, event.character)
        else:
            key = event.character if event.character is not None and event.character.isalpha() else event.key
            action = both.get(key) or (in_list if state.step is None else in_step).get(key)
            if action is None and event.character is not None and event.character.isprintable():
                self._leaving = True
                action = self._typing(event)
        if action is not None:
            event.stop()
            event.prevent_default()
            action()
            self.look.wake()

    def _typing(self, event: events.Key) -> Action:
        """A command is typed where there is no terminal: it goes to the one used last, as from the welcome page."""
        letters, self._picked = self._picked, ""
        keys = [*(events.Key(letter, letter) for letter in letters), event]
        # At once, not by a message: the next key may already go to the terminal.
        return lambda: self.parent.type_at_terminal(keys) if isinstance(self.parent, PaneHost) else None

    def on_blur(self, event: events.Blur) -> None:
        self._leaving = False

    def _pick(self, letter: str) -> None:
        self._picked += letter
        self.touch()

    def _toggle_notes(self) -> None:
        """The teacher's notes say what the fault is: not in an exam."""
        self._notes = not self._notes and self.course.searching() != "exam"
        self.touch()

    def _choose(self, step: int) -> None:
        count = len(self._entries)
        if count:
            self.chosen = max(0, min(self.chosen + step, count - 1))
            self._follow = True
            self.touch()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._scroll(3 * notches)
