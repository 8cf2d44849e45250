"""The RViz window: the Displays panel on the left, the 3-D view on the right, a status bar below.

The panel's lines are a `Tree`, the picture is a `View3D`, the text below it a `StatusBar`; this module puts them together and
handles keys and mouse.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial

from rich.segment import Segment
from textual import events

from day6_tui.core.ros.programs.rviz2.model.display import Display
from day6_tui.core.ros.programs.rviz2.model.manager import QUALITIES, RViz
from day6_tui.core.ros.programs.rviz2.model.properties import BOOL, GROUP, STATUS, BadValue, Property
from day6_tui.core.ros.programs.rviz2.model.status import OK
from day6_tui.core.ros.programs.rviz2.model.views import NOMINAL_HEIGHT, VIEWS
from day6_tui.core.session.display import Window
from day6_tui.tui.cells import fit
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Piece
from day6_tui.tui.windows import WindowPane
from day6_tui.tui.windows.rviz import dialogs, panel
from day6_tui.tui.windows.rviz.status_bar import StatusBar, in_ascii
from day6_tui.tui.windows.rviz.tree import Tree
from day6_tui.tui.windows.rviz.view import View3D

NARROWEST_PANEL, WIDEST_PANEL, NARROWEST_VIEW = 30, 56, 24

TURN = 0.1309
"""Radians an arrow key turns the view: 7.5 degrees."""

SHIFT = 0.06
"""Fraction of the picture's height by which Shift and an arrow key pan it."""

_ARROWS = {"left": (-1, 0), "right": (1, 0), "up": (0, -1), "down": (0, 1)}
_BUTTONS = {1: "left", 2: "middle", 3: "right"}
_END = 1_000_000


class RVizPane(WindowPane[RViz]):
    """The window of an `RViz`; keeps only view state: which part has the focus, and what was last drawn."""

    def __init__(self, window: Window[RViz], look: Look) -> None:
        super().__init__(window, look)
        self.rviz = window.model
        self.view = View3D(self.rviz, look)
        self.displays = Tree(self.rviz)
        self.status_bar = StatusBar(self.rviz, self.displays, self.view, look)
        self.on_panel = True
        """Whether the keys go to the panel; else to the view."""
        self.panel_open = True
        self._shown_lines: dict[int, tuple[object, ...]] = {}
        self._shown_frame: tuple[str, ...] = ()
        self._used = False
        """Whether the view was turned; until then, the status bar says that RViz is ready."""
        self._drag: tuple[str, bool, bool, int, int] | None = None

    # -- geometry ------------------------------------------------------------------------------------------------------

    @property
    def word_lines(self) -> int:
        """Lines of the status bar."""
        return 2 if self.inner_height >= 18 else 1

    @property
    def body_height(self) -> int:
        return max(0, self.inner_height - self.word_lines)

    @property
    def panel_width(self) -> int:
        """Columns of the panel, 0 while it is folded away."""
        width = self.inner_width
        if not self.panel_open:
            return 0
        wanted = max(NARROWEST_PANEL, min(WIDEST_PANEL, width * 2 // 5))
        return wanted if width - wanted - 1 >= NARROWEST_VIEW else width

    @property
    def view_left(self) -> int:
        """The first column of the view, which is hidden if the panel takes all the space."""
        width = self.panel_width
        return width + 1 if width else 0

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._lay_out()

    def restyle(self) -> None:
        self.view.forget()
        self.status_bar.forget()
        super().restyle()

    def _lay_out(self) -> None:
        columns = max(0, self.inner_width - self.view_left)
        self.view.resize(columns, self.body_height)
        self.displays.fit(self.body_height)

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        if not self.inner_width or not self.body_height:
            return False
        self._lay_out()
        left = self.view_left
        spans, due = self.view.pull(now)
        self._pull_panel()
        if spans:
            self.touch_spans([(row, first + left, end + left) for row, first, end in spans])
        due = self._pull_words(now) or due
        title = tuple(piece.text for piece in (*self.title(), *self.status(), *self.status_right()))
        if title != self._shown_frame:
            self._shown_frame = title
            self.touch_frame()
        return due

    def _pull_panel(self) -> None:
        self.displays.follow()
        if not self.panel_width:
            return
        changed = []
        for row in range(self.body_height):
            state = self._line_state(row)
            if self._shown_lines.get(row) != state:
                self._shown_lines[row] = state
                changed.append(row)
        if changed:
            self.touch_lines(changed)

    def _line_state(self, row: int) -> tuple[object, ...]:
        """What a row of the panel looks like depends on this."""
        line = self.displays.line(row)
        if line is None:
            return ()
        prop = line.prop
        display = prop.statuses.level if isinstance(prop, Display) else 0
        focused = self.on_panel and self.has_focus
        chosen = prop is self.displays.prop
        return (prop, line.depth, prop.name, prop.value, prop.expanded, line.can_open, display, chosen, focused)

    def _pull_words(self, now: float) -> bool:
        on_panel = self.on_panel and self.has_focus and bool(self.panel_width)
        changed, due = self.status_bar.pull(now, self.inner_width - 2, self.word_lines, on_panel=on_panel)
        if changed:
            self.touch_lines(range(self.body_height, self.inner_height))
        return due

    def show_message(self, text: str, seconds: float = 4.0) -> None:
        """Show a message in the status bar for a while."""
        self.status_bar.show_message(text, seconds)

    # -- drawing -------------------------------------------------------------------------------------------------------

    def title(self) -> list[Piece]:
        colours = self.look.colours
        statuses = self.rviz.statuses
        style = colours.muted if statuses.level == OK else colours.warning
        star = "*" if self.rviz.modified else ""
        pieces = [
            Piece(star + " ", colours.muted),
            Piece(f"Fixed Frame {self.rviz.fixed_frame} ", style, self._to_fixed),
        ]
        return [*super().title(), *pieces]

    def _to_fixed(self) -> None:
        self.panel_open = self.on_panel = True
        self.choose(self.rviz.fixed)
        self.edit()

    def status(self) -> list[Piece]:
        text = self.rviz.view.help if self._used else "RViz is ready."
        return [Piece(f" {text} ", self.look.colours.muted)]

    def status_right(self) -> list[Piece]:
        pieces = [Piece(f" {self.rviz.view.type} ", self.look.colours.node, self.next_view)]
        if self.rviz.quality.value != QUALITIES[0]:
            pieces.append(Piece(f"{self.rviz.quality.value} ", self.look.colours.topic, self.next_quality))
        if self.status_bar.rate:
            pieces.append(Piece(f"{self.status_bar.rate} fps ", self.look.colours.muted))
        return pieces

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if y >= self.body_height:
            return self._words_line(y - self.body_height, width)
        if not self.displays.lines:
            self.displays.refresh()
        self._lay_out()
        segments: list[Segment] = []
        if panel_width := self.panel_width:
            line = self.displays.line(y)
            if line is not None:
                focused, chosen = self.on_panel and self.has_focus, line.prop is self.displays.prop
                segments += panel.segments_of(line, panel_width, self.look, chosen, focused)
            else:
                segments.append(Segment(" " * panel_width, self.background))
            if panel_width < width:
                style = (
                    self.look.colours.frame_focus if self.has_focus and not self.on_panel else self.look.colours.frame
                )
                segments.append(Segment(self.look.glyphs.border.vertical, style))
        if self.view.columns:
            segments += self.view.line(y)
        return segments

    def _words_line(self, line: int, width: int) -> list[Segment]:
        colours = self.look.colours
        text = self.status_bar.lines[line] if line < len(self.status_bar.lines) else ""
        return [Segment(fit(f" {text}", width, self.look.glyphs.ellipsis), colours.muted)]

    # -- choosing and editing ------------------------------------------------------------------------------------------

    def choose(self, prop: Property) -> None:
        """Open the tree down to a property and choose it."""
        self.displays.choose(prop)
        self.status_bar.hurry()
        self.touch()

    def toggle(self, prop: Property) -> None:
        """Turn a check box over."""
        if not prop.read_only:
            self.set(prop, not prop.value)

    def set(self, prop: Property, value: object) -> str | None:
        """Give a property a value; returns what is wrong with it."""
        try:
            self.rviz.edit(prop, value)
        except BadValue as error:
            return self.look.texts(error.key, **error.parameters)
        self.rviz.message = None
        self.status_bar.hurry()
        self.look.wake()
        return None

    def edit(self) -> None:
        """Change the chosen property in the way that fits it."""
        prop = self.displays.prop
        if prop is None:
            return
        if prop.kind == BOOL and not isinstance(prop, Display):
            self.toggle(prop)
        elif prop.kind in (GROUP, STATUS) or prop.read_only or isinstance(prop, Display):
            self.open_branch(prop, not prop.expanded)
        else:
            dialogs.edit(self, prop)

    def open_branch(self, prop: Property, on: bool) -> None:
        """Open or close a branch."""
        if prop.children:
            prop.expanded = on
            self.displays.refresh()
            self.look.wake()

    def request(self, action: Callable[[], object]) -> None:
        """Let the program do something."""
        self.rviz.message = None
        self.rviz.request(action)

    def next_view(self) -> None:
        names = list(VIEWS)
        name = names[(names.index(self.rviz.view.type) + 1) % len(names)]
        self.request(partial(self.rviz.set_view, name))

    def next_quality(self) -> None:
        name = QUALITIES[(QUALITIES.index(self.rviz.quality.value) + 1) % len(QUALITIES)]
        self.set(self.rviz.quality, name)
        self.show_message(self.look.texts("rviz.quality", name=name))

    # -- what keys do --------------------------------------------------------------------------------------------------

    def focus_robot(self) -> None:
        """Look at what there is: the robot, or everything solid."""
        found = dialogs.extent(self.rviz.scene)
        if found is None:
            self.show_message(self.look.texts("rviz.nothing_to_focus"))
        else:
            aspect = self.view.columns / max(1, self.view.rows) / 2
            centre, radius = found
            self.rviz.view.look_at(centre, radius / min(1.0, max(0.2, aspect)))
            self.look.wake()

    def from_above(self) -> None:
        self.rviz.view.from_above()
        self.look.wake()

    def zero(self) -> None:
        self.rviz.view.zero()
        self.look.wake()

    def toggle_panel(self) -> None:
        self.panel_open = not self.panel_open
        self.on_panel = self.panel_open
        self._lay_out()
        self.touch()

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        hints = [("Tab", texts("rviz.key.view" if self.on_panel else "rviz.key.panel"))]
        if self.on_panel:
            hints += [("Enter", texts("rviz.key.edit")), ("^N", texts("rviz.key.add")), ("f", texts("rviz.key.focus"))]
        else:
            arrows = "←↑↓→" if self.look.glyphs.unicode else "arrows"
            hints += [(arrows, texts("rviz.key.turn")), ("+ -", texts("rviz.key.zoom"))]
            hints += [("f", texts("rviz.key.focus")), ("4", texts("rviz.key.above"))]
        return hints if self.look.glyphs.unicode else [(key, in_ascii(text)) for key, text in hints]

    def on_key(self, event: events.Key) -> None:
        key = event.key
        used = self._everywhere_key(key) or (self._panel_key(key) if self.on_panel else self._view_key(key))
        if used:
            event.stop()
            event.prevent_default()
            self.look.wake()

    def _everywhere_key(self, key: str) -> bool:
        actions: dict[str, Callable[[], object]] = {
            "tab": self._other_part,
            "d": self.toggle_panel,
            "f": self.focus_robot,
            "4": self.from_above,
            "z": self.zero,
            "v": self.next_view,
            "p": self.next_quality,
            "r": lambda: self.request(self.rviz.reset),
            "ctrl+n": lambda: dialogs.add(self),
            "a": lambda: dialogs.add(self),
            "ctrl+s": lambda: dialogs.save(self),
            "ctrl+o": lambda: dialogs.load(self),
            "w": lambda: dialogs.save_as(self),
            "g": lambda: dialogs.screenshot(self),
            "plus": lambda: self._zoom(1),
            "equals_sign": lambda: self._zoom(1),
            "minus": lambda: self._zoom(-1),
        }
        action = actions.get(key)
        if action is None:
            return False
        action()
        return True

    def _other_part(self) -> None:
        if not self.panel_open:
            self.panel_open = True
            self.on_panel = True
        else:
            self.on_panel = not self.on_panel
            if self.panel_width == self.inner_width:
                self.panel_open = self.on_panel
        self.status_bar.hurry()
        self.touch()

    def _panel_key(self, key: str) -> bool:
        page = max(1, self.body_height - 1)
        steps = {"up": -1, "down": 1, "pageup": -page, "pagedown": page, "home": -_END, "end": _END}
        prop = self.displays.prop
        if key in steps:
            self.displays.move(steps[key])
            self.status_bar.hurry()
            return True
        if prop is None:
            return False
        display = self.displays.display
        if key == "right":
            self.open_branch(prop, True)
        elif key == "left":
            self._close_or_up(prop)
        elif key == "enter":
            self.edit()
        elif key == "space":
            if prop.kind == BOOL:
                self.toggle(prop)
        elif display is not None and key in ("ctrl+x", "delete"):
            self.request(partial(self.rviz.remove_display, display))
        elif display is not None and key == "ctrl+d":
            self.request(partial(self.rviz.duplicate_display, display))
        elif display is not None and key == "ctrl+r":
            dialogs.rename(self, display)
        elif display is not None and key in ("shift+up", "shift+down"):
            self.request(partial(self.rviz.move_display, display, -1 if key == "shift+up" else 1))
        else:
            return False
        return True

    def _close_or_up(self, prop: Property) -> None:
        if prop.expanded and prop.children:
            self.open_branch(prop, False)
        elif prop.parent is not None and prop.parent.parent is not None:
            self.choose(prop.parent)

    def _view_key(self, key: str) -> bool:
        view = self.rviz.view
        self._used = True
        shifted, _, arrow = key.rpartition("+")
        if arrow in _ARROWS and shifted in ("", "shift"):
            right, down = _ARROWS[arrow]
            if shifted:
                view.pan(right * SHIFT, down * SHIFT)
            else:
                view.rotate(right * TURN, down * TURN)
        elif key in ("pageup", "pagedown"):
            self._zoom(1 if key == "pageup" else -1)
        elif key == "home":
            view.zero()
        elif key == "escape" and self.panel_open:
            self.on_panel = True
        else:
            return False
        return True

    def _zoom(self, steps: float) -> None:
        self.rviz.view.zoom(steps)

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def _cell(self, event: events.MouseEvent) -> tuple[int, int]:
        return event.x - self.inner_offset, event.y - self.inner_offset

    def _in_view(self, event: events.MouseEvent) -> bool:
        x, y = self._cell(event)
        return self.view_left <= x < self.inner_width and 0 <= y < self.body_height and bool(self.view.columns)

    def on_mouse_down(self, event: events.MouseDown) -> None:
        button = _BUTTONS.get(event.button)
        if button is None or not self._in_view(event):
            return
        event.stop()
        if not self.has_focus:
            self.focus(scroll_visible=False)
        self.on_panel = False
        self._used = True
        self._drag = (button, bool(event.shift), bool(event.ctrl), event.screen_x, event.screen_y)
        self.view.dragging = True
        self.capture_mouse()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if self._drag is None:
            return
        event.stop()
        button, shift, control, x, y = self._drag
        self._drag = (button, shift, control, event.screen_x, event.screen_y)
        # The height of the picture is 600 pixels to RViz's rules; a cell is half as wide as high.
        step = NOMINAL_HEIGHT / max(1, self.view.rows)
        dx, dy = (event.screen_x - x) * step / 2, (event.screen_y - y) * step
        aspect = self.view.columns / max(1, self.view.rows) / 2
        if control and button == "left":
            # The way the article pans the picture.
            button, shift = "middle", False
        elif control and button == "middle":
            button = "left"
        self.rviz.view.drag(button, shift, dx, dy, aspect)
        self.look.wake()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        if self._drag is not None:
            event.stop()
            self._drag = None
            self.view.dragging = False
            self.release_mouse()
            self.look.wake()

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        self._scroll(event, 1)

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        self._scroll(event, -1)

    def _scroll(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        if self._in_view(event):
            self.rviz.view.wheel(notches, bool(event.shift))
        else:
            self.displays.scroll(-3 * notches)
        self.look.wake()

    def on_click(self, event: events.Click) -> None:
        x, y = self._cell(event)
        if not (0 <= x < self.panel_width and 0 <= y < self.body_height):
            super().on_click(event)
            return
        event.stop()
        self.on_panel = True
        line = self.displays.line(y)
        if line is None:
            return
        self.displays.chosen = self.displays.top + y
        zone = panel.zones(line, self.panel_width)
        if line.can_open and zone.opener <= x <= zone.opener + 1:
            self.open_branch(line.prop, not line.prop.expanded)
        elif zone.box is not None and zone.box <= x < zone.box + 3:
            self.toggle(line.prop)
        elif x >= zone.value or event.chain > 1:
            self.edit()
        self.look.wake()
