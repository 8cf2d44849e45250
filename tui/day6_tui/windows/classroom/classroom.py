"""The teacher's window: the class as a table, and the screens that the teacher asks for.

It only draws the roster (`day6_core.classroom.roster`) and sends orders; what it shows of a pupil the pupil has told. Nobody
is watched whose screen is not drawn.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.widget import Widget

from day6_core.classroom.order import MOST_SECONDS, Order
from day6_core.classroom.roster import PupilRow
from day6_core.classroom.show import OWN
from day6_core.link.state import DoorState
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.bars.connections import door_words
from day6_tui.classes.link import TeacherLink
from day6_tui.panes.cells import cell_len, clip, wrap
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.terminals.keys import encode
from day6_tui.windows import WindowPane
from day6_tui.windows.classroom.keys import KEYS, hints
from day6_tui.windows.classroom.orders import ALL, Orders
from day6_tui.windows.classroom.screen import Screens, Sight
from day6_tui.windows.classroom.table import ClassTable, places_for
from day6_tui.windows.classroom.typing import Typing
from day6_tui.windows.classroom.words import ColouredWords, answer_of

if TYPE_CHECKING:
    from textual.timer import Timer

WATCH_SECONDS = 6.0
"""For which one order lets us see a screen; renewed several times in it."""
TICK_SECONDS = 1.0
HIDDEN_SECONDS = 2.5
"""Without a frame, after which the window counts as one that nobody sees."""
LARGE_ROWS, LARGE_COLUMNS = 18, 78
"""The inside with which a screen is seen without taking the whole desktop."""
SIDEWAYS = 8
"""Columns of a step to the side."""
WHEEL_ROWS = 3
MOST_TOLD = 2
"""Of those who were turned away."""
EXAMPLE = "anna"
"""The name in the command that invites."""
END_TYPING = "ctrl+right_square_bracket"
"""The key that ends typing for a pupil, as in telnet. Every other one goes to the pupil's terminal, but for those that belong to
the desktop in every terminal (F1 to F9, Alt with digits and arrows, Ctrl-Q)."""

assert WATCH_SECONDS <= MOST_SECONDS


class ClassroomPane(WindowPane[TeacherLink]):
    """Keeps what is chosen and what is seen; everything else is the roster's."""

    needs = PaneNeeds(Extent(56, 10), Extent(78, 20), Extent(118, 36), 2.0)

    takes_focus = True
    key_weight = 5
    """A teacher needs these keys more often than F4 and F8."""

    def __init__(self, window: Window[TeacherLink], look: Look) -> None:
        super().__init__(window, look)
        self._roster = self.model.roster
        self._table = ClassTable(look, self._roster.questions, is_room=self.model.is_room)
        self._screens = Screens(look)
        self._typing = Typing(self._roster)
        self._orders = Orders(self)
        self._chosen = ""
        self._compared = ""
        """Whose screen is to be seen beside the chosen one."""
        self._is_large = False
        self._has_preview = False
        """Whether the screen of who is chosen is wanted below the table."""
        self._fills_desktop = False
        """Whether the window does because a screen is seen large."""
        self._drawn: tuple[object, ...] = ()
        self._lines: list[list[Segment]] = []
        self._invitation_at = range(0)
        """The lines in which the command to join stands."""
        self._seen: tuple[str, ...] = ()
        """Whose screens are drawn."""
        self._watched: tuple[str, ...] = ()
        self._renewed = self._pulled = 0.0
        self._timer: Timer | None = None

    def on_mount(self) -> None:
        self._timer = self.set_interval(TICK_SECONDS, self._tick)
        self.model.broadcast.cover = self._hide_screens

    def on_unmount(self) -> None:
        self._typing.end()
        self._roster.order(self._watched, Order("unwatch"))

    def _hide_screens(self) -> None:
        """The own screen is about to be shown: what is not to be seen there is gone before the first picture."""
        if self.is_attached:
            self.pull(time.monotonic())

    def _tick(self) -> None:
        self.look.wake()
        if time.monotonic() - self._pulled > HIDDEN_SECONDS:
            self._watch(())

    # -- the frame -----------------------------------------------------------------------------------------------------

    @property
    def label(self) -> str:
        return self.look.texts("teacher.title")

    def status(self) -> list[Piece]:
        counts, now = self._counts(), self._happening()
        has_room = sum(cell_len(piece.text) for piece in (*counts, *now)) <= self.inner_width
        return [*(counts if has_room else ()), *now]

    def _counts(self) -> list[Piece]:
        texts, colours, rows = self.look.texts, self.look.colours, self._roster.rows()
        here, hands = sum(row.is_here for row in rows), self.model.hands
        stuck = sum(row.is_stuck(self._roster.now) for row in rows)
        pieces = [Piece(f" {texts('teacher.here', here=here, all=len(rows))} ", colours.muted)]
        if hands:
            text = texts("teacher.hand") if hands == 1 else texts("teacher.hands", count=hands)
            pieces.append(Piece(f" {text} ", colours.hint))
        if stuck:
            pieces.append(Piece(f" {texts('teacher.stuck', count=stuck)} ", colours.warning))
        return pieces

    def _happening(self) -> list[Piece]:
        """What the teacher does to the class, and what came of the last order."""
        texts, colours, pieces = self.look.texts, self.look.colours, []
        if self._roster.is_frozen:
            pieces.append(Piece(f" {texts('teacher.frozen')} ", colours.error, self._orders.freeze))
        pieces += self._shown()
        if self._typing.is_on:
            text = texts("teacher.typing", name=self._typing.name)
            pieces.append(Piece(f" {text} ", colours.error, self._end_typing))
        elif self._typing.over:
            pieces.append(Piece(f" {self._over()} ", colours.error, self._end_typing))
        elif self._orders.said:
            pieces.append(Piece(f" {self._orders.said} ", colours.strong))
        return pieces

    def _shown(self) -> list[Piece]:
        """What the class sees, or shall see; a click ends it."""
        texts, colours, stage, pieces = self.look.texts, self.look.colours, self.model.broadcast.stage, []
        for key, show, style in (("shown", stage.on, colours.error), ("to_show", stage.wanted, colours.hint)):
            if show is not None:
                what = ".own" if show.source == OWN else ".full" if show.full else ""
                text = texts(f"teacher.{key}{what}", name=show.source)
                pieces.append(Piece(f" {text} ", style, stage.stop))
        return pieces

    def status_right(self) -> list[Piece]:
        arrows = self._screens.beyond if self._is_large else ""
        return [Piece(f" {arrows} ", self.look.colours.hint)] if arrows else []

    def key_hints(self) -> list[tuple[str, str]]:
        if self._typing.is_on:
            view = "typing"
        elif self._typing.over:
            view = "over"
        elif self._is_large:
            view = "large"
        else:
            view = "table" if self._roster.rows() else "empty"
        return hints(KEYS[view], self.look, is_frozen=self._roster.is_frozen)

    def more_key_hints(self) -> list[tuple[str, str]]:
        told = {key for key, _ in self.key_hints()}
        all_keys = dict.fromkeys(each for view in ("table", "large", "more", "typing") for each in KEYS[view])
        return [each for each in hints(all_keys, self.look, is_frozen=self._roster.is_frozen) if each[0] not in told]

    # -- what is seen --------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        self._pulled = now
        rows = self._roster.rows()
        self._keep_chosen(rows)
        self._typing.follow()
        self._begin_if_agreed()
        state = (
            self._roster.version,
            self._roster.is_frozen,
            int(self._roster.now / 10),
            self.model.door,
            self.model.turned_away,
            self.extent,
            self.look.texts.language,
            self.look.glyphs.name,
            (self._chosen, self._compared, self._is_large, self._has_preview, self._orders.said),
            (self._typing.name, self._typing.over, self._typing.awaited),
            (self.model.broadcast.stage.on, self.model.broadcast.stage.wanted),
            (self._table.position, self._screens.top, self._screens.left),
        )
        if state != self._drawn:
            self._drawn = state
            self._lines = self._draw(rows)
            self.touch_lines(range(self.inner_height))
            self.touch_status()
        if self._seen != self._watched or now - self._renewed >= TICK_SECONDS:
            self._renewed = now
            self._watch(self._seen)
        return False

    def _keep_chosen(self, rows: list[PupilRow]) -> None:
        names = [row.name for row in rows]
        if self._chosen not in names:
            self._chosen, self._is_large = (names[0] if names else ""), False
        if self._compared not in names or self._compared == self._chosen:
            self._compared = ""

    def restyle(self) -> None:
        self._drawn = ()
        self._screens.restyle()
        super().restyle()

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        return self._lines[y] if y < len(self._lines) else ()

    def _draw(self, rows: list[PupilRow]) -> list[list[Segment]]:
        width, height = self.inner_width, self.inner_height
        self._seen, self._invitation_at, self._table.row_at = (), range(0), {}
        if not rows:
            return self._draw_empty(width)
        if self._is_large:
            self._seen = tuple(name for name in (self._chosen, self._compared) if name)
            return self._draw_screens(width, height)
        told, joining = [*self._draw_question(width), *self._draw_turned_away(width)], self._draw_joining(width)
        place = places_for(len(rows), len(told) + len(joining), height, preview=self._has_preview)
        now, is_frozen = self._roster.now, self._roster.is_frozen
        lines = self._table.draw(rows, self._chosen, width, place.table, now, is_frozen=is_frozen)
        if place.preview:
            self._seen = (self._chosen,)
            lines.append([Segment(self.look.glyphs.border.horizontal * width, self.look.colours.frame)])
            lines += self._draw_screens(width, place.preview - 1)
        lines += [[]] * (height - place.told - len(lines))
        lines += [*told, *joining][: place.told]
        self._invitation_at = range(height - place.told + len(told), height)
        return lines

    def _draw_empty(self, width: int) -> list[list[Segment]]:
        """How somebody joins, or why nobody can."""
        texts, colours, room = self.look.texts, self.look.colours, max(2, width - 2)
        if shut := self._shut():
            lines = _paragraph(shut, room, colours.warning)
        else:
            lines = [*_paragraph(texts("teacher.empty"), room, colours.text), []]
            lines += _paragraph(self.model.invitation(EXAMPLE), room, colours.strong)
            self._invitation_at = range(1, len(lines) + 1)
        return [[], *lines, [], *self._draw_turned_away(width)]

    def _draw_joining(self, width: int) -> list[list[Segment]]:
        """How to join, below the table, in few words."""
        texts, colours = self.look.texts, self.look.colours
        if shut := self._shut():
            return [[Segment(line, colours.warning)] for line in wrap(shut, width)]
        text = texts("teacher.join", command=self.model.invitation(EXAMPLE))
        return [[Segment(line, colours.muted)] for line in wrap(text, width)]

    def _shut(self) -> str:
        """Why nobody can join now; '' if everybody can."""
        texts, door = self.look.texts, self.model.door
        if door is not None and door.state == DoorState.OPEN:
            return ""
        if door is None or door.state == DoorState.OPENING:
            return texts("teacher.opening")
        key, _, words = door_words(door, self.look.glyphs.ellipsis)
        if door.state == DoorState.IN_USE:
            return texts("teacher.port_in_use", port=words["port"])
        return texts("teacher.shut", reason=door.reason or texts(key, **words))

    def _draw_question(self, width: int) -> list[list[Segment]]:
        """What was asked last, and how many answered what: the counts are not cut."""
        texts, questions = self.look.texts, self._roster.questions.open
        if not questions:
            return []
        question = questions[-1]
        counts = [f"{texts(f'class.reply.{kind}')} {count}" for kind, count in question.counts().items()]
        text = f"  {f' {self.look.glyphs.dot} '.join([*counts, texts('teacher.reply.silent', count=len(question.silent))])}"
        asked = clip(question.text, max(0, width - cell_len(text)), self.look.glyphs.ellipsis)
        return [[Segment(asked, self.look.colours.muted), Segment(clip(text, width), self.look.colours.strong)]]

    def _draw_turned_away(self, width: int) -> list[list[Segment]]:
        texts, style, ellipsis = self.look.texts, self.look.colours.warning, self.look.glyphs.ellipsis
        told = [texts(f"teacher.turned.{each.why}", name=each.name) for each in self.model.turned_away[-MOST_TOLD:]]
        return [[Segment(clip(text, width, ellipsis), style)] for text in told]

    def _draw_screens(self, width: int, height: int) -> list[list[Segment]]:
        if self.model.broadcast.shows_own:  # no pupil has agreed to be seen there
            self._seen = ()
            return [*_paragraph(self.look.texts("teacher.hidden"), width, self.look.colours.hint), *([[]] * height)][
                :height
            ]
        rows = [row for name in self._seen if (row := self._roster.row(name)) is not None]
        typed_at = self._typing.name if self._typing.is_on else ""
        sights = [Sight(row, self._remark(row), row.name == typed_at) for row in rows]
        return self._screens.draw(sights, width, height)

    def _remark(self, row: PupilRow) -> ColouredWords | None:
        """What came of the wish to type, or of the last order."""
        texts, colours = self.look.texts, self.look.colours
        if row.name == self._typing.name:
            if self._typing.over:
                return ColouredWords(self._over(), colours.error)
            refused = row.note.refused if row.note is not None else ""
            return ColouredWords(texts(refused), colours.warning) if refused else None
        answer = answer_of(row.note, self.look) if row.note is not None and row.is_here else None
        if row.name == self._typing.awaited and (answer is None or (row.note is not None and row.note.asked)):
            return ColouredWords(texts("teacher.awaited"), colours.hint)
        return answer

    def _over(self) -> str:
        return self.look.texts(f"teacher.over.{self._typing.over}", name=self._typing.name)

    # -- watching ------------------------------------------------------------------------------------------------------

    def _watch(self, names: tuple[str, ...]) -> None:
        """Renew for the screens that are seen; end it for those that no longer are."""
        self._roster.order([name for name in self._watched if name not in names], Order("unwatch"))
        self._roster.order(names, Order("watch", seconds=WATCH_SECONDS))
        self._watched = names

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        if self._typing.name:
            self._take_key_of_pupil(event)
            event.stop()
            event.prevent_default()
            return
        view = self._in_large() if self._is_large else self._in_table()
        order = self._asked().get(event.character or "")
        action = order or view.get(event.character or "") or view.get(event.key)
        if action is None:
            return
        event.stop()
        event.prevent_default()
        self._orders.said = ""
        if order is not None:
            self._typing.wait_no_longer()
        action()
        self.look.wake()

    def _take_key_of_pupil(self, event: events.Key) -> None:
        """Send a key; after typing was cut short none does anything until the teacher has seen that."""
        if event.key == END_TYPING or (self._typing.over and event.key == "escape"):
            self._end_typing()
        elif self._typing.is_on and (keys := encode(event.key, event.character)):
            self._orders.tell_missed(self._typing.send(keys))

    def _asked(self) -> Mapping[str, Callable[[], object]]:
        """What can be asked of the pupils now."""
        orders, name = self._orders, self._chosen
        press = self.model.broadcast.press
        of_all: dict[str, Callable[[], object]] = {
            "f": orders.freeze,
            "i": self._invite,
            "e": orders.ask_for_file,
            "m": partial(press, OWN, full=False),
            "M": partial(press, OWN, full=True),
        }
        if not name:
            return of_all
        return of_all | {
            "s": partial(orders.ask_to_say, name),
            "S": partial(orders.ask_to_say, ALL),
            "a": partial(orders.ask_for_question, name),
            "A": partial(orders.ask_for_question, ALL),
            "w": orders.settle,
            "l": partial(orders.ask_for_link, name),
            "L": partial(orders.ask_for_link, ALL),
            "g": partial(orders.ask_for_path, name),
            "G": partial(orders.ask_for_path, ALL),
            "o": partial(orders.choose_what_to_open, name),
            "O": partial(orders.choose_what_to_open, ALL),
            "r": partial(press, name, full=False),
            "R": partial(press, name, full=True),
            "t": self._ask_to_type,
            "c": self._show_beside,
            "h": partial(orders.send, name, Order("lower_hand")),
            "x": partial(orders.ask_to_end, name),
        }

    def _in_table(self) -> Mapping[str, Callable[[], object]]:
        page = self._table.page
        return {
            "up": partial(self._move, -1),
            "down": partial(self._move, 1),
            "pageup": partial(self._move, -page),
            "pagedown": partial(self._move, page),
            "home": partial(self._move, -len(self._roster.rows())),
            "end": partial(self._move, len(self._roster.rows())),
            "enter": self._enlarge,
            "v": self._turn_preview,
            "d": self._forget,
            "delete": self._forget,
        }

    def _in_large(self) -> Mapping[str, Callable[[], object]]:
        scroll, screens = self._screens.scroll, self._screens
        return {
            "up": partial(scroll, -1),
            "down": partial(scroll, 1),
            "left": partial(scroll, 0, -SIDEWAYS),
            "right": partial(scroll, 0, SIDEWAYS),
            "pageup": partial(scroll, -screens.page),
            "pagedown": partial(scroll, screens.page),
            "home": screens.scroll_home,
            "end": screens.scroll_end,
            "n": partial(self._go_on, 1),
            "p": partial(self._go_on, -1),
            "escape": self._shrink,
        }

    def on_click(self, event: events.Click) -> None:
        if self.hit(event.x, event.y) is not None or not self.is_inside(event):
            super().on_click(event)
            return
        line = event.y - self.inner_offset
        name = self._table.row_at.get(line)
        if line in self._invitation_at:
            self._invite()
        elif name is not None:
            again = name == self._chosen
            self._choose(name)
            if again:
                self._enlarge()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        (self._screens.scroll if self._is_large else self._table.scroll)(notches * WHEEL_ROWS)
        self.look.wake()

    # -- who is chosen and seen ----------------------------------------------------------------------------------------

    def _move(self, step: int) -> None:
        names = [row.name for row in self._roster.rows()]
        if names:
            self._choose(names[max(0, min(names.index(self._chosen) + step, len(names) - 1))])

    def _choose(self, name: str) -> None:
        self._chosen = name
        self._table.reveal()
        self.look.wake()

    def _enlarge(self) -> None:
        """Show the screen; in a small window this takes the whole desktop."""
        if self._chosen and not self._is_large:
            self._is_large = True
            self._screens.scroll_home()
            if self.inner_height < LARGE_ROWS or self.inner_width < LARGE_COLUMNS:
                self._fills_desktop = True
                self.post_message(self.Enlarged(self))

    def _shrink(self) -> None:
        self._is_large, self._compared = False, ""
        self._typing.wait_no_longer()
        self._table.reveal()
        is_whole = isinstance(self.parent, Widget) and self.parent.size == self.size
        if self._fills_desktop and is_whole:  # and nobody has put it back meanwhile
            self.post_message(self.Enlarged(self))
        self._fills_desktop = False

    def _go_on(self, step: int) -> None:
        """To the next or previous pupil who is here, in the order of the table."""
        rows = self._roster.rows()
        at = next(at for at, row in enumerate(rows) if row.name == self._chosen)
        others = rows[at + 1 :] if step > 0 else rows[:at][::-1]
        name = next((row.name for row in others if row.is_here and row.name != self._compared), None)
        if name is not None:
            self._typing.wait_no_longer()
            self._chosen = name
            self._screens.scroll_home()

    def _turn_preview(self) -> None:
        """Show the screen of who is chosen below the table, or no longer."""
        rows = len(self._roster.rows())
        self._has_preview = not self._has_preview
        if rows and self._has_preview and not places_for(rows, 0, self.inner_height, preview=True).preview:
            self._has_preview = False
            self._orders.said = self.look.texts("teacher.no_room")

    def _show_beside(self) -> None:
        """The next pupil beside this one; once more, the one after."""
        names = [row.name for row in self._roster.rows() if row.is_here and row.name != self._chosen]
        if names:
            at = names.index(self._compared) + 1 if self._compared in names else 0
            self._compared = names[at % len(names)]
            self._enlarge()
            self._screens.scroll_home()
        else:
            self._orders.said = self.look.texts("teacher.alone")

    def _forget(self) -> None:
        """Take the row of somebody who is gone out of the table."""
        row, names = self._roster.row(self._chosen), [row.name for row in self._roster.rows()]
        if row is not None and row.is_here:
            self._orders.said = self.look.texts("teacher.not_gone", name=row.name)
        elif row is not None:
            self._move(1 if row.name != names[-1] else -1)
            self._roster.forget(row.name)

    def _invite(self) -> None:
        """Show the command to join, to be copied; or why nobody can join."""
        from day6_tui.classes.invitation import Invitation

        if shut := self._shut():
            self._orders.said = shut
        else:
            command = self.model.invitation(EXAMPLE)
            self.lay_over(Invitation(self.look, self.look.texts("teacher.invite.text"), command))

    # -- typing --------------------------------------------------------------------------------------------------------

    def _ask_to_type(self) -> None:
        """Type for who is chosen, if allowed; else ask, and begin with the yes as long as the teacher looks on."""
        if self.model.broadcast.shows_own:
            self._orders.said = self.look.texts("teacher.hidden")
        elif self._chosen and self._typing.may_begin(self._chosen):
            self._enlarge()
            self._typing.begin(self._chosen)
        elif self._chosen:
            missed = self._typing.ask(self._chosen)
            self._orders.tell_missed(missed)
            if not missed:
                self._enlarge()

    def _begin_if_agreed(self) -> None:
        """A yes begins nothing where the teacher has gone on to something else."""
        name = self._typing.awaited
        if name and name == self._chosen and self._is_large and self.has_focus and self._typing.may_begin(name):
            self._typing.begin(name)

    def _end_typing(self) -> None:
        self._typing.end()
        self.look.wake()


def _paragraph(text: str, width: int, style: Style) -> list[list[Segment]]:
    return [[Segment(f" {line}", style)] for line in wrap(text, width)]
