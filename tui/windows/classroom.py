"""The teacher's window: the class as a table, the screen of who is chosen, two screens beside each other.

It only draws the roster (`core/classroom/roster.py`) and sends orders; what it shows of a pupil the pupil has told.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from datetime import date
from functools import partial
from typing import TYPE_CHECKING

from rich.segment import Segment
from rich.style import Style
from textual import events

from day6_tui.core.classroom.note import Note
from day6_tui.core.classroom.order import MOST_SECONDS, Order
from day6_tui.core.classroom.roster import IDLE_SECONDS, Row
from day6_tui.core.session.display import Window
from day6_tui.tui.cells import cell_len, clip, fit, wrap
from day6_tui.tui.class_link import TeacherLink
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Piece
from day6_tui.tui.terminal_keys import encode
from day6_tui.tui.windows import WindowPane
from day6_tui.tui.windows.classroom_screen import ScreenPicture

if TYPE_CHECKING:
    from textual.timer import Timer

    from day6_tui.tui.menu import Entry

WATCH_SECONDS = 6.0
"""For which one order lets us see a screen; renewed three times in it."""
TICK_SECONDS = 1.0
LARGE_ROWS = 18
"""Rows of the inside with which a screen is seen without taking the whole desktop."""
PREVIEW_ROWS = 12
"""Rows of the inside that a screen below the table needs at least."""
NAME_COLUMNS, LESSON_COLUMNS = 12, 18
END_TYPING = "ctrl+right_square_bracket"
"""The key that ends typing for a pupil, as in telnet: every other one goes to the pupil."""

assert WATCH_SECONDS <= MOST_SECONDS


class ClassroomPane(WindowPane[TeacherLink]):
    """Keeps what is chosen and what is seen; everything else is the roster's."""

    takes_focus = True

    def __init__(self, window: Window[TeacherLink], look: Look) -> None:
        super().__init__(window, look)
        self._roster = self.model.roster
        self._chosen = ""
        self._compared = ""
        """Whose screen is to be seen beside the chosen one."""
        self._is_large = False
        self._types = False
        """Whether keys go to the chosen pupil."""
        self._is_frozen = False
        """Whether all were asked to look up last."""
        self._top = 0
        self._scrolled = 0
        """The first row of a screen that is seen large."""
        self._fills_desktop = False
        """Whether the window does because a screen is seen large."""
        self._said = ""
        """What an order came to, for the lower edge."""
        self._drawn: tuple[object, ...] = ()
        self._lines: list[list[Segment]] = []
        self._row_at: dict[int, str] = {}
        self._watched: tuple[str, ...] = ()
        self._screens: dict[str, ScreenPicture] = {}
        self._timer: Timer | None = None

    def on_mount(self) -> None:
        self.model.changed = self.look.wake
        self._timer = self.set_interval(TICK_SECONDS, self._tick)

    def on_unmount(self) -> None:
        self.model.changed = lambda: None
        self._roster.order(self._watched, Order("unwatch"))

    def _tick(self) -> None:
        self._watch()
        self.look.wake()

    # -- the frame -----------------------------------------------------------------------------------------------------

    @property
    def label(self) -> str:
        return self.look.texts("teacher.title")

    def status(self) -> list[Piece]:
        texts, colours, rows = self.look.texts, self.look.colours, self._roster.rows()
        here = sum(row.is_here for row in rows)
        hands = sum(row.is_here and row.raised is not None for row in rows)
        stuck = sum(row.is_stuck(self._roster.now) for row in rows)
        pieces = [Piece(f" {texts('teacher.here', here=here, all=len(rows))} ", colours.muted)]
        if hands:
            pieces.append(Piece(f"{texts('teacher.hands', count=hands)} ", colours.hint))
        if stuck:
            pieces.append(Piece(f"{texts('teacher.stuck', count=stuck)} ", colours.warning))
        if self._types:
            pieces.append(Piece(f"{texts('teacher.typing', name=self._chosen)} ", colours.error, self._end_typing))
        elif self._said:
            pieces.append(Piece(f"{self._said} ", colours.warning))
        return pieces

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        if self._types:
            return [("^]", texts("teacher.key.end_typing"))]
        if not self._roster.rows():
            return []
        first = ("Esc", texts("teacher.key.back")) if self._is_large else ("Enter", texts("teacher.key.large"))
        return [
            first,
            ("s", texts("teacher.key.say")),
            ("o", texts("teacher.key.open")),
            ("f", texts("teacher.key.thaw" if self._is_frozen else "teacher.key.freeze")),
            ("t", texts("teacher.key.type")),
            ("c", texts("teacher.key.compare")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        return [
            ("S O", texts("teacher.key.all")),
            ("Home", texts("teacher.key.first")),
            ("h", texts("teacher.key.lower")),
            ("e", texts("teacher.key.csv")),
            ("x", texts("teacher.key.end")),
        ]

    # -- what is seen --------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        rows = self._roster.rows()
        self._keep_chosen(rows)
        state = (
            self._roster.version,
            self.extent,
            self.look.texts.language,
            self.look.glyphs.name,
            self._chosen,
            self._compared,
            self._is_large,
            self._types,
            self._said,
            self._top,
            self._scrolled,
            int(self._roster.now / 10),
        )
        if state != self._drawn:
            self._drawn = state
            self._row_at = {}
            self._lines = self._draw(rows)
            self.touch_lines(range(self.inner_height))
            self.touch_status()
        return False

    def _keep_chosen(self, rows: list[Row]) -> None:
        names = [row.name for row in rows]
        if self._chosen not in names:
            self._chosen, self._is_large = (names[0] if names else ""), False
        if self._compared not in names or self._compared == self._chosen:
            self._compared = ""
        if self._types and not self._may_type():
            self._types = False

    def restyle(self) -> None:
        self._drawn = ()
        self._screens.clear()
        super().restyle()

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        return self._lines[y] if y < len(self._lines) else ()

    def _draw(self, rows: list[Row]) -> list[list[Segment]]:
        width, height = self.inner_width, self.inner_height
        if not rows:
            return self._invitation(width)
        if self._is_large:
            return self._draw_screens(width, height)
        table = min(len(rows) + 1, height if height < 2 * PREVIEW_ROWS else height // 2)
        lines = self._table(rows, width, table)
        if height - table >= PREVIEW_ROWS:
            lines += self._draw_screens(width, height - table)
        return lines

    def _invitation(self, width: int) -> list[list[Segment]]:
        texts, colours = self.look.texts, self.look.colours
        lines = [Segment(line, colours.text) for line in wrap(texts("teacher.empty"), max(2, width - 2))]
        command = Segment(f"  {self.model.invitation('anna')}", colours.strong)
        return [[], *([Segment(" ", colours.text), line] for line in lines), [], [command]]

    def _table(self, rows: list[Row], width: int, height: int) -> list[list[Segment]]:
        colours, texts = self.look.colours, self.look.texts
        at = [row.name for row in rows].index(self._chosen)
        room = max(1, height - 1)
        self._top = max(0, min(max(at - room + 1, min(self._top, at)), len(rows) - room))
        heads = (texts("teacher.head.name"), texts("teacher.head.lesson"), texts("teacher.head.state"))
        head = f"  {fit(heads[0], NAME_COLUMNS)} {fit(heads[1], LESSON_COLUMNS)} {heads[2]}"
        lines = [[Segment(fit(head, width), colours.muted)]]
        for row in rows[self._top : self._top + room]:
            self._row_at[len(lines)] = row.name
            lines.append(self._table_line(row, width))
        return lines

    def _table_line(self, row: Row, width: int) -> list[Segment]:
        colours, ellipsis = self.look.colours, self.look.glyphs.ellipsis
        mark = {self._chosen: self.look.glyphs.chevron, self._compared: "="}.get(row.name, " ")
        state, style = self._state(row)
        base = colours.choice if row.name == self._chosen else colours.text if row.is_here else colours.muted
        name = fit(clip(row.name, NAME_COLUMNS, ellipsis), NAME_COLUMNS)
        lesson = fit(clip(self._lesson(row.note), LESSON_COLUMNS, ellipsis), LESSON_COLUMNS)
        left = f"{fit(mark, 1)} {name} {lesson} "
        rest = max(0, width - cell_len(left))
        return [Segment(left, base), Segment(fit(clip(state, rest, ellipsis), rest), style)]

    def _lesson(self, note: Note | None) -> str:
        lesson = note.lesson if note is not None else None
        return f"{lesson.name} {lesson.step}/{lesson.all}" if lesson is not None else ""

    def _state(self, row: Row) -> tuple[str, Style]:
        """What needs the teacher most, in words."""
        texts, colours, now, note = self.look.texts, self.look.colours, self._roster.now, row.note
        if not row.is_here:
            return texts("teacher.state.gone"), colours.muted
        if note is None:
            return texts("teacher.state.silent"), colours.muted
        if row.raised is not None:
            return texts("teacher.state.hand", minutes=int((now - row.raised) / 60)), colours.hint
        if note.refused:
            return texts(note.refused), colours.warning
        if note.trouble is not None:
            title = note.trouble.title.get(texts.language) or note.trouble.line
            return title, colours.error if row.is_stuck(now) else colours.warning
        if note.frozen:
            return texts("teacher.state.frozen"), colours.muted
        if row.idle(now) >= IDLE_SECONDS:
            return texts("teacher.state.idle", minutes=int(row.idle(now) / 60)), colours.muted
        return " ".join(note.nodes), colours.node

    def _draw_screens(self, width: int, height: int) -> list[list[Segment]]:
        """The screen of the chosen pupil, or two beside each other."""
        names = [name for name in (self._chosen, self._compared) if name]
        if len(names) == 1:
            return self._draw_screen(names[0], width, height)
        half = (width - 1) // 2
        left, right = (self._draw_screen(name, half, height) for name in names)
        bar = Segment(self.look.glyphs.border.vertical, self.look.colours.frame)
        return [[*a, bar, *b] for a, b in zip(left, right, strict=True)]

    def _draw_screen(self, name: str, width: int, height: int) -> list[list[Segment]]:
        """Exactly `height` lines of `width` cells: what is known of a pupil, and the screen."""
        row, colours, texts = self._roster.row(name), self.look.colours, self.look.texts
        note = row.note if row is not None else None
        facts = [name]
        if note is not None and note.lesson is not None:
            title = note.lesson.title.get(texts.language) or note.lesson.name
            facts.append(f"{title} {note.lesson.step}/{note.lesson.all}")
            if note.lesson.hints:
                facts.append(texts("teacher.hints", count=note.lesson.hints))
        if note is not None and note.trouble is not None:
            facts.append(note.trouble.line)
        ellipsis = self.look.glyphs.ellipsis
        head = fit(clip("  ".join(facts), width, ellipsis), width)
        lines = [[Segment(head, colours.error if self._types and name == self._chosen else colours.strong)]]
        screen = note.screen if note is not None else None
        if screen is None:
            waiting = texts("teacher.no_screen" if row is not None and row.is_here else "teacher.state.gone")
            lines.append([Segment(fit(f" {clip(waiting, max(1, width - 1), ellipsis)}", width), colours.muted)])
        else:
            picture = self._screens.get(name)
            if picture is None or picture.source is not screen:
                picture = self._screens[name] = ScreenPicture(screen, colours.terminal)
            self._scrolled = min(self._scrolled, max(0, screen.rows - (height - 1)))
            lines += picture.lines(width, height - 1, self._scrolled if self._is_large else 0)
        blank = [Segment(" " * width, colours.text)]
        return [*lines, *([blank] * height)][:height]

    # -- watching ------------------------------------------------------------------------------------------------------

    def _watch(self) -> None:
        """Renew for the screens that are seen; end it for those that no longer are."""
        seen: list[str] = []
        if self.display and self._chosen and (self._is_large or self.inner_height >= 2 * PREVIEW_ROWS):
            seen = [name for name in (self._chosen, self._compared) if name]
        self._roster.order([name for name in self._watched if name not in seen], Order("unwatch"))
        self._roster.order(seen, Order("watch", seconds=WATCH_SECONDS))
        self._watched = tuple(seen)

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        if self._types:
            self._type(event)
            event.stop()
            event.prevent_default()
            return
        actions: dict[str, Callable[[], object]] = {
            "up": partial(self._scroll if self._is_large else self._move, -1),
            "down": partial(self._scroll if self._is_large else self._move, 1),
            "home": self._choose_first,
            "enter": self._enlarge,
            "escape": self._shrink,
            "s": partial(self._ask_to_say, False),
            "S": partial(self._ask_to_say, True),
            "o": partial(self._choose_what_to_open, False),
            "O": partial(self._choose_what_to_open, True),
            "f": self._freeze,
            "t": self._ask_to_type,
            "c": self._show_beside,
            "h": partial(self._order, Order("lower_hand")),
            "e": self._ask_for_file,
            "x": self._ask_to_end,
        }
        action = actions.get(event.character or "") or actions.get(event.key)
        if action is None or (event.key == "escape" and not self._is_large):
            return
        event.stop()
        event.prevent_default()
        self._said = ""
        action()
        self.look.wake()

    def on_click(self, event: events.Click) -> None:
        if self.hit(event.x, event.y) is not None or not self.is_inside(event):
            super().on_click(event)
            return
        name = self._row_at.get(event.y - self.inner_offset)
        if name is not None and not self._is_large:
            again = name == self._chosen
            self._choose(name)
            if again:
                self._enlarge()

    def _move(self, step: int) -> None:
        names = [row.name for row in self._roster.rows()]
        if names:
            self._choose(names[(names.index(self._chosen) + step) % len(names)])

    def _choose_first(self) -> None:
        """Go to who needs the teacher most."""
        if rows := self._roster.rows():
            self._choose(rows[0].name)

    def _choose(self, name: str) -> None:
        self._chosen = name
        self._watch()
        self.look.wake()

    def _enlarge(self) -> None:
        """Show the screen; in a small window this takes the whole desktop."""
        if self._chosen and not self._is_large:
            self._is_large, self._scrolled = True, 0
            if self.inner_height < LARGE_ROWS:
                self._fills_desktop = True
                self.post_message(self.Enlarged(self))
            self._watch()

    def _shrink(self) -> None:
        self._is_large, self._compared = False, ""
        if self._fills_desktop:
            self._fills_desktop = False
            self.post_message(self.Enlarged(self))
        self._watch()

    def _scroll(self, step: int) -> None:
        self._scrolled = max(0, self._scrolled + step)

    def _show_beside(self) -> None:
        """The next pupil beside this one; once more, the one after."""
        names = [row.name for row in self._roster.rows() if row.is_here and row.name != self._chosen]
        if names:
            at = names.index(self._compared) + 1 if self._compared in names else 0
            self._compared = names[at % len(names)]
            self._enlarge()
            self._watch()

    # -- orders --------------------------------------------------------------------------------------------------------

    def _order(self, order: Order, *, to_all: bool = False) -> None:
        names = self._roster.everybody() if to_all else [self._chosen]
        missed = self._roster.order([name for name in names if name], order)
        if missed:
            self._said = self.look.texts("teacher.missed", names=", ".join(missed))

    def _freeze(self) -> None:
        """Have all look up, or go on."""
        self._is_frozen = not self._is_frozen
        self._order(Order("freeze", on=self._is_frozen), to_all=True)

    def _ask_to_say(self, to_all: bool) -> None:
        texts = self.look.texts
        title = texts("teacher.say.all") if to_all else texts("teacher.say", name=self._chosen)

        def said(text: str) -> str | None:
            if not text.strip():
                return texts("teacher.say.nothing")
            self._order(Order("say", text=text.strip()[:1000]), to_all=to_all)
            return None

        if to_all or self._chosen:
            self.ask(title, "", said)

    def _choose_what_to_open(self, to_all: bool) -> None:
        from day6_tui.tui.menu import Menu

        if to_all or self._chosen:
            self.lay_over(Menu(self.look, "teacher.open", self._entries(to_all)))

    def _entries(self, to_all: bool) -> list[Entry]:
        from day6_tui.core.lessons import catalogue
        from day6_tui.tui.menu import Entry
        from day6_tui.tui.scenes import SCENES

        texts = self.look.texts
        lessons = [*catalogue.days(), *catalogue.drills()]
        found = [
            Entry(
                f"{each.name}  {each.title[texts.language]}",
                texts("teacher.open.lesson"),
                partial(self._order, Order("lesson", text=each.name), to_all=to_all),
            )
            for each in lessons
        ]
        return found + [
            Entry(name, texts("teacher.open.scene"), partial(self._order, Order("scene", text=name), to_all=to_all))
            for name in SCENES
        ]

    def _may_type(self) -> bool:
        row = self._roster.row(self._chosen)
        return row is not None and row.is_here and row.note is not None and row.note.may_type

    def _ask_to_type(self) -> None:
        """Ask the pupil; once allowed, type."""
        self._enlarge()
        if self._may_type():
            self._types, self._said = True, ""
        else:
            self._order(Order("ask_to_type"))
            self._said = self._said or self.look.texts("teacher.asked", name=self._chosen)

    def _type(self, event: events.Key) -> None:
        if event.key == END_TYPING:
            self._end_typing()
        elif keys := encode(event.key, event.character):
            self._order(Order("type", text=keys))

    def _end_typing(self) -> None:
        self._types = False
        self._order(Order("stop_typing"))
        self.look.wake()

    def _ask_to_end(self) -> None:
        from day6_tui.tui.question import Answer, Question

        texts, name = self.look.texts, self._chosen
        answer = Answer("y", texts("teacher.end.yes"), partial(self._roster.order, [name], Order("end")))
        title = texts("teacher.end", name=name)
        self.lay_over(Question(self.look, title, texts("teacher.end.text"), [answer], careful=True))

    # -- the report ----------------------------------------------------------------------------------------------------

    def _ask_for_file(self) -> None:
        self.ask(self.look.texts("teacher.csv"), f"class-{date.today():%Y-%m-%d}.csv", self._write)

    def _write(self, text: str) -> str | None:
        from pathlib import Path

        from day6_tui.core.lessons.tables import Exists, csv_bytes, write_table

        texts = self.look.texts
        path = self.model.home / Path(text.strip()).expanduser()
        heads = [texts(f"teacher.csv.{name}") for name in ("name", "lesson", "step", "steps")]
        rows = [(name, lesson, step or "", steps or "") for name, lesson, step, steps in self._roster.report()]
        try:
            write_table(path, csv_bytes(heads, rows), force=False)
        except Exists:
            return texts("teacher.csv.exists", file=path.name)
        except OSError as error:
            return error.strerror or str(error)
        self._said = texts("teacher.csv.written", file=path.name)
        return None
