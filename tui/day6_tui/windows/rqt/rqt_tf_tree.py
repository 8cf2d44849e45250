"""rqt_tf_tree's window: every frame below its parent, with age, rate, buffer length and broadcaster."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.strip import Strip

from day6_core.ros.programs.rqt_tf_tree.model import FrameLine, TfTree
from day6_core.ros.programs.tf2_tools.frame_tree import Frame
from day6_core.session.display import Window
from day6_core.session.harmless import one_line
from day6_tui.appearance.look import Look
from day6_tui.overlays.prompt import before_replacing
from day6_tui.panes.cells import cell_len, clip, fit
from day6_tui.panes.pane import Piece
from day6_tui.windows import WindowPane
from day6_tui.windows.parts.buttons import Button, button_line

INDENT = 3
"""Cells of a level of the tree."""

SIDEWAYS = 8
"""Columns by which an arrow key moves the names."""

WHEEL = 3
"""Lines by which the wheel moves."""

HEAD = 2
"""Lines above the tree: what can be clicked, and the names of the columns."""

_MOVES = {"up": -1, "down": 1}
_ENDS = {"home", "end"}
_PAGES = {"pageup": -1, "pagedown": 1}
_SIDES = {"left": -SIDEWAYS, "right": SIDEWAYS}


class Column(NamedTuple):
    """A column right of the names: the window has it from `least` columns on."""

    key: str
    width: int
    least: int


COLUMNS = (Column("age", 9, 26), Column("rate", 10, 38), Column("buffer", 10, 58), Column("broadcaster", 19, 78))


class RqtTfTreePane(WindowPane[TfTree]):
    """Draws `TfTree.snapshot`; keeps only which frame is chosen and what part of the tree is in sight."""

    def __init__(self, window: Window[TfTree], look: Look) -> None:
        super().__init__(window, look)
        self._drawn: tuple[object, ...] = ()
        self._lines: tuple[FrameLine, ...] = ()
        self._chosen = 0
        self._top = self._left = 0
        self._widest = 0
        """Cells of the longest name with what stands before it."""

    # -- frame ---------------------------------------------------------------------------------------------------------

    def status(self) -> list[Piece]:
        texts, colours, shot = self.look.texts, self.look.colours, self.model.snapshot
        name, why = self.model.saved
        trouble = [self.model.problem, f"{name}: {why}" if why and name not in why else why]
        pieces = [self._warning(one_line(text)) for text in trouble if text]
        if self._lines:
            pieces.insert(0, Piece(f" {self._chosen + 1}/{len(self._lines)} ", colours.muted))
        old = sum(map(shot.is_old, shot.frames))
        if old:
            pieces.append(self._warning(texts("tf_tree.old", count=old)))
        if name and not why:
            pieces.append(Piece(f" {texts('tf_tree.saved', name=one_line(name))} ", colours.muted))
        if self._lines:
            chosen = one_line(self._lines[self._chosen].name)  # in the tree there may be no room for all of it
            pieces.append(Piece(f"{chosen} ", colours.text))
        return pieces

    def _warning(self, text: str) -> Piece:
        return Piece(f" {self.look.glyphs.warning} {text} ", self.look.colours.warning)

    def status_right(self) -> list[Piece]:
        recorded = self.look.texts("tf_tree.recorded", time=f"{self.model.snapshot.recorded:.3f}")
        return [Piece(f" {recorded} ", self.look.colours.muted)] if self._lines else []

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        hints = [("r", texts("tf_tree.refresh")), ("w", texts("tf_tree.save"))]
        if self._widest > self._names_width:
            hints.append(("← →" if self.look.glyphs.unicode else "<- ->", texts("tf_tree.sideways")))
        return hints

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        return [("a", texts("tf_tree.auto")), ("c", texts("tf_tree.clear"))]

    # -- content -------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        state = (self.model.version, self.model.auto_refresh, self.extent, self.look.texts.language)
        if state != self._drawn:
            self._drawn = state
            self._take_lines()
            self.touch_lines(range(self.inner_height))
            self.touch_frame()
        return False

    def _take_lines(self) -> None:
        """Take the newest tree; the chosen frame stays chosen, wherever it is now."""
        before = self._lines[self._chosen].name if self._lines else None
        self._lines = self.model.snapshot.lines
        self._chosen = next(
            (at for at, line in enumerate(self._lines) if line.name == before),
            max(0, min(self._chosen, len(self._lines) - 1)),
        )
        self._widest = max((self._before(line) + self._told_width(line) for line in self._lines), default=0)
        self._scroll(0, 0)

    def restyle(self) -> None:
        self._drawn = ()
        super().restyle()

    @property
    def _columns(self) -> list[Column]:
        return [column for column in COLUMNS if self.inner_width >= column.least]

    @property
    def _names_width(self) -> int:
        return max(1, self.inner_width - sum(column.width for column in self._columns))

    @property
    def _about_rows(self) -> int:
        """Lines below the tree, about the chosen frame."""
        return 0 if self.inner_height < 12 else 2 if self.inner_width >= 84 else 3

    @property
    def _rows(self) -> int:
        """Lines for the tree."""
        return max(1, self.inner_height - HEAD - self._about_rows)

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if y == 0:
            return button_line(self, y, self._buttons(), width)
        if y == 1:
            return self._heads()
        if y >= HEAD + self._rows:
            about = self._about(width)
            below = y - HEAD - self._rows
            return [Segment(about[below], self.look.colours.muted)] if below < len(about) else []
        at = self._top + y - HEAD
        if at < len(self._lines):
            return self._row(at)
        if not self._lines and y == HEAD:
            return [Segment(clip(f" {self.look.texts('tf_tree.none')}", width), self.look.colours.muted)]
        return []

    def _buttons(self) -> list[Button]:
        """What the buttons of the original do."""
        texts = self.look.texts
        return [
            Button("r", texts("tf_tree.refresh"), self.model.request_refresh),
            Button("c", texts("tf_tree.clear"), self.model.request_clear),
            Button("a", texts("tf_tree.auto"), self._switch_auto, self.model.auto_refresh),
            Button("w", texts("tf_tree.save"), self._ask_file),
        ]

    def _heads(self) -> list[Segment]:
        texts, muted = self.look.texts, self.look.colours.muted
        heads = [(texts(f"tf_tree.columns.{column.key}"), column) for column in self._columns]
        cells = [Segment(self._cell(text, column), muted) for text, column in heads]
        return [Segment(fit(f" {texts('tf_tree.columns.frame')}", self._names_width), muted), *cells]

    def _row(self, at: int) -> list[Segment]:
        line, colours = self._lines[at], self.look.colours
        chosen = (colours.choice if self.has_focus_within else colours.strong) if at == self._chosen else None
        frame = None if line.again else line.frame
        old = frame is not None and self.model.snapshot.is_old(frame)
        named = chosen or (colours.warning if old else colours.node)
        names = self._names(line, chosen or colours.frame, named, chosen or self.background)
        cells = [
            Segment(self._cell(self._value(frame, column.key), column), chosen or self._style(frame, column.key))
            for column in self._columns
        ]
        return [*names, *cells]

    def _names(self, line: FrameLine, guides: Style, named: Style, blank: Style) -> Strip:
        """A line of the tree as far as it is in sight; where its name is not, the name at the side where it lies."""
        width, begin = self._names_width, self._before(line)
        name = self._told(line)
        mark = self.look.glyphs.ellipsis
        if self._left < begin + cell_len(name) and begin < self._left + width:
            name = clip(name, self._left + width - begin, mark)
            shown = Strip([Segment(" " + self._guides(line), guides), Segment(name, named)]).crop(self._left)
            return shown.adjust_cell_length(width, blank)
        text = clip(name, width // 2, mark)
        if begin >= self._left + width:
            pad = " " * (width - cell_len(text) - 2)
            return Strip([Segment(pad, blank), Segment(f"{mark} ", guides), Segment(text, named)])
        return Strip([Segment(f"{mark} ", guides), Segment(text, named)]).adjust_cell_length(width, blank)

    def _style(self, frame: Frame | None, key: str) -> Style:
        colours, shot = self.look.colours, self.model.snapshot
        if key == "age" and frame is not None and shot.is_old(frame):
            return colours.warning
        return colours.muted if frame is None or shot.age(frame) is None else colours.text

    def _cell(self, text: str, column: Column) -> str:
        """A text in its column: numbers to the right, names to the left."""
        shown = clip(text, column.width - 1, self.look.glyphs.ellipsis)
        pad = " " * (column.width - 1 - cell_len(shown))
        return f" {shown}{pad}" if column.key == "broadcaster" else f"{pad}{shown} "

    def _value(self, frame: Frame | None, key: str) -> str:
        if frame is None:
            return ""
        if key == "broadcaster":
            return frame.broadcaster
        age = self.model.snapshot.age(frame)
        if age is None:  # its rate and length mean nothing
            return self.look.texts("tf_tree.static") if key == "age" else ""
        value = {"age": age, "rate": frame.rate, "buffer": frame.buffer_length}[key]
        return f"{value:.2f}" if abs(value) < 10_000 else f"{value:.2g}"

    def _guides(self, line: FrameLine) -> str:
        branch, corner, through = ("├─ ", "└─ ", "│  ") if self.look.glyphs.unicode else ("|- ", "`- ", "|  ")
        if not line.ends:
            return ""
        above = "".join("   " if ends else through for ends in line.ends[:-1])
        return above + (corner if line.ends[-1] else branch)

    def _told(self, line: FrameLine) -> str:
        name = one_line(line.name)
        return f"{name} {self.look.texts('tf_tree.again')}" if line.again else name

    def _told_width(self, line: FrameLine) -> int:
        return cell_len(self._told(line))

    @staticmethod
    def _before(line: FrameLine) -> int:
        return 1 + INDENT * len(line.ends)

    def _about(self, width: int) -> list[str]:
        """What is known of the chosen frame, in the words of the original's labels."""
        if not self._lines:
            return []
        line = self._lines[self._chosen]
        if line.frame is None:
            return [clip(f" {self.look.texts('tf_tree.root', name=line.name)}", width, self.look.glyphs.ellipsis)]
        rows = [""]
        for piece in map(one_line, line.frame.label):
            if rows[-1] and cell_len(rows[-1]) + 2 + cell_len(piece) > width - 2:
                rows.append("")
            rows[-1] += f"{'  ' if rows[-1] else ' '}{piece}"
        return [clip(row, width, self.look.glyphs.ellipsis) for row in rows]

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def _press(self, key: str, character: str) -> bool:
        actions: dict[str, Callable[[], None]] = {
            "r": self.model.request_refresh,
            "c": self.model.request_clear,
            "a": self._switch_auto,
            "w": self._ask_file,
            "ctrl+s": self._ask_file,
        }
        if key in actions:
            actions[key]()
        elif key in _MOVES:
            self._choose(self._chosen + _MOVES[key])
        elif key in _PAGES:
            self._choose(self._chosen + _PAGES[key] * max(1, self._rows - 1))
        elif key in _ENDS:
            self._choose(0 if key == "home" else len(self._lines) - 1)
        elif key in _SIDES:
            self._scroll(0, _SIDES[key])
        else:
            return False
        return True

    def on_click(self, event: events.Click) -> None:
        """A click on a frame chooses it."""
        at = self._top + event.y - 1 - HEAD
        if self.is_inside(event) and HEAD < event.y <= HEAD + self._rows and at < len(self._lines):
            self._choose(at)
            event.stop()
            event.prevent_default()
        else:
            super().on_click(event)

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._scroll(*((0, notches * SIDEWAYS) if event.shift else (notches * WHEEL, 0)))

    def on_mouse_scroll_right(self, event: events.MouseScrollRight) -> None:
        event.stop()
        self._scroll(0, SIDEWAYS)

    def on_mouse_scroll_left(self, event: events.MouseScrollLeft) -> None:
        event.stop()
        self._scroll(0, -SIDEWAYS)

    def _choose(self, at: int) -> None:
        """Choose a line, and bring it and where its name begins into sight."""
        if not self._lines:
            return
        self._chosen = max(0, min(at, len(self._lines) - 1))
        line, room = self._lines[self._chosen], self._names_width
        begin = self._before(line)
        end = begin + min(self._told_width(line), room // 2)
        down = max(0, self._chosen - (self._top + self._rows - 1)) or min(0, self._chosen - self._top)
        aside = max(0, end - (self._left + room)) or min(0, begin - INDENT - self._left)
        self._scroll(down, aside)

    def _scroll(self, lines: int, columns: int) -> None:
        """Move what is in sight, as far as there is something."""
        self._top = max(0, min(self._top + lines, len(self._lines) - self._rows))
        self._left = max(0, min(self._left + columns, self._widest - self._names_width))
        if self.is_attached:
            self.touch_lines(range(self.inner_height))
            self.touch_status()

    def _switch_auto(self) -> None:
        self.model.set_auto_refresh(not self.model.auto_refresh)
        self.look.wake()

    def _ask_file(self) -> None:
        """Ask where to save the tree; the suffix says as what."""

        def taken(name: str) -> str | None:
            try:
                self.model.request_save(name)
            except ValueError as error:
                return str(error)
            return None

        texts = self.look.texts
        sure = before_replacing(self.look, self.model.path, taken)
        self.ask(texts("rqt.save"), "frames.pdf", sure, note=texts("tf_tree.save_note"))
