"""The RViz window: the Displays panel on the left, the 3-D view on the right, a status bar below.

The panel is a `DisplaysPanel` of Textual's widgets; the picture, a `View3D`, and the text below it, a `StatusBar`, are painted.
This module puts them together, draws them, and does what keys (`WindowKeys`) and clicks ask for.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path

from rich.segment import Segment
from textual import events, on
from textual.app import ComposeResult
from textual.geometry import NULL_OFFSET, NULL_SPACING, Region, Size
from textual.layout import ArrangeResult, Layout, WidgetPlacement
from textual.widget import Widget

from day6_core.ros.programs.rviz2.model.config import write_config
from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.manager import QUALITIES, RViz
from day6_core.ros.programs.rviz2.model.properties import BOOL, GROUP, STATUS, BadValue, Property
from day6_core.ros.programs.rviz2.model.selection import placed_corner
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, Status, StatusList
from day6_core.ros.programs.rviz2.model.tools.tool import Tool
from day6_core.ros.programs.rviz2.model.views import VIEWS, SavedView
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows import WindowPane
from day6_tui.windows.rviz import dialogs
from day6_tui.windows.rviz.buttons import PanelButton
from day6_tui.windows.rviz.displays import DisplaysPanel
from day6_tui.windows.rviz.drawer import NARROW, NOTHING, Division, Drawer, divide
from day6_tui.windows.rviz.extent import frame, outline
from day6_tui.windows.rviz.framing import Framing
from day6_tui.windows.rviz.hand import Hand
from day6_tui.windows.rviz.hints import ARROWS
from day6_tui.windows.rviz.keys import WindowKeys
from day6_tui.windows.rviz.painting import WindowPainter
from day6_tui.windows.rviz.problems import ProblemLine
from day6_tui.windows.rviz.status_bar import StatusBar, in_ascii
from day6_tui.windows.rviz.toolbar import LOWEST_WINDOW
from day6_tui.windows.rviz.tree import PropertyTree
from day6_tui.windows.rviz.view import View3D
from day6_tui.windows.rviz.view_mouse import ViewMouse

LOWEST_WITH_PROBLEMS = 12
"""Rows inside a window that has a line for a problem; in a lower one it takes that of the description."""


class _PanelInTheFrame(Layout):
    """Places the panel inside the frame; the rest is painted."""

    name = "rviz"

    def arrange(self, parent: Widget, children: list[Widget], size: Size, greedy: bool = True) -> ArrangeResult:
        assert isinstance(parent, RVizPane)
        region = parent.panel_region(size)
        return [WidgetPlacement(region, NULL_OFFSET, NULL_SPACING, child) for child in children if region]


class RVizPane(WindowPane[RViz]):
    """The window of an `RViz`; keeps only view state: which part has the focus, and what was last drawn."""

    needs = PaneNeeds(Extent(56, 14), Extent(72, 28), Extent(110, 40), 3.0)
    about = "robot"

    def __init__(self, window: Window[RViz], look: Look) -> None:
        super().__init__(window, look)
        self.rviz = window.model
        self.view = View3D(self.rviz, look)
        self.panel = DisplaysPanel(self.rviz, look)
        self._layout_of_panel = _PanelInTheFrame()
        self.status_bar = StatusBar(self.rviz, self.panel.properties, self.view, look)
        self.problems = ProblemLine(self.rviz, look)
        self.framing = Framing(self.rviz, self.view)
        self.drawer = Drawer(empty=all(display.type == "Grid" for display in self.rviz.displays))
        self._hand = Hand(self.rviz, self.view)
        self._mouse = ViewMouse(self.rviz, self.view, self._hand, lambda: self.view_place)
        self._keys = WindowKeys(self, self._hand)
        self._painter = WindowPainter(self)
        self.divided = NOTHING
        """How the window was divided when it was last laid out."""
        self._seen_tool: object = None
        self._panel_keys = True
        """Whether the keys go to the panel, if it is open; else to the view."""
        self._shown_frame: tuple[str, ...] = ()
        self.used = False
        """Whether the view was turned; until then, the status bar says that RViz is ready."""

    def compose(self) -> ComposeResult:
        yield self.panel

    # -- geometry ------------------------------------------------------------------------------------------------------

    @property
    def layout(self) -> Layout:
        return self._layout_of_panel

    def panel_region(self, size: Size) -> Region:
        """Where the panel is in a window of this size; empty while it is folded away."""
        width, height = max(0, size.width - 2), max(0, size.height - 2)
        is_open, top = self.drawer.is_open(width), _bar_lines(height)
        below = self._word_lines(height, is_open=is_open)
        panel = divide(width, height - top - below, panel_open=is_open).panel
        return panel.translate((self.inner_offset, self.inner_offset + top)) if panel else Region()

    @property
    def word_lines(self) -> int:
        """Lines of the status bar, with that of a problem."""
        return self._word_lines(self.inner_height, is_open=self.panel_open)

    def _word_lines(self, height: int, *, is_open: bool) -> int:
        told = 1 if not is_open and self.problems.status is not None and height >= LOWEST_WITH_PROBLEMS else 0
        return (2 if height >= 18 else 1) + told

    @property
    def body_height(self) -> int:
        return max(0, self.inner_height - self.top - self.word_lines)

    @property
    def top(self) -> int:
        """Lines above panel and view: the toolbar's."""
        return _bar_lines(self.inner_height)

    @property
    def panel_open(self) -> bool:
        """Whether the panel is not folded away."""
        return self.drawer.is_open(self.inner_width)

    @property
    def on_panel(self) -> bool:
        """Whether the keys go to the panel; else to the view."""
        return self._panel_keys and self.panel_open

    @property
    def division(self) -> Division:
        """How the room below the toolbar is divided."""
        return divide(self.inner_width, self.body_height, panel_open=self.panel_open)

    @property
    def view_place(self) -> Region:
        """Where the view is in the pane."""
        return self.division.view.translate((self.inner_offset, self.inner_offset + self.top))

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._lay_out()

    def restyle(self) -> None:
        self.panel.properties.take_look(self.look)
        self.view.forget()
        self.status_bar.forget()
        super().restyle()

    def _lay_out(self) -> None:
        self.divided = self.division
        self.view.resize(*self.divided.view.size)

    # -- the keyboard --------------------------------------------------------------------------------------------------

    @property
    def focus_target(self) -> Widget:
        if not self.on_panel or not self.panel.is_attached:
            return self
        return self.panel.value_line or self.panel.properties

    def focus(self, scroll_visible: bool = True) -> RVizPane:
        target = self.focus_target
        if target is self:
            super().focus(scroll_visible)
        else:
            target.focus(scroll_visible)
        return self

    def pass_keyboard(self) -> None:
        """The part that shall have the keyboard gets it, if the window has it."""
        if self.has_focus_within:
            self.screen.set_focus(self.focus_target, scroll_visible=False)

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        if not self.inner_width or not self.body_height:
            return False
        self._lay_out()
        if (self.screen.focused is self) is self.on_panel:
            self.pass_keyboard()
        self._follow_scene()
        changed, due = self.view.pull(now)
        picture, at = self.divided.view.translate((0, self.top)), self.inner_offset
        self.view.show(self, picture.translate((at, at)), covered=1 if self.framing.offered else 0)
        on_panel = self.on_panel and self.has_focus_within
        if self.panel_open and self.panel.properties.is_attached:
            self.panel.pull(active=on_panel)
        self.redraw_lines((picture.y + row for row in changed), across=range(picture.x, picture.right))
        self._follow_tool()
        if (menu := self.rviz.menu) is not None:
            self.rviz.menu = None
            # An overlay cannot come while a frame is made.
            self.app.call_later(dialogs.show_menu, self, menu)
        due = self._pull_words(now, on_panel=on_panel) or due
        title = tuple(piece.text for piece in (*self._subject(), *self.status(), *self.status_right()))
        if title != self._shown_frame:
            self._shown_frame = title
            self.touch_frame()
        return due

    def _follow_scene(self) -> None:
        """What there is to see, and what is wrong with it, divides the window."""
        before, divides = self.divided, self.drawer.empty
        if self.drawer.empty and self.panel.value_line is None and self.rviz.statuses.level < ERROR:
            self.drawer.empty = not outline(self.rviz.scene)
        if self.problems.pull(folded=not self.panel_open):
            self.touch_lines(range(self.top + self.body_height, self.inner_height))
            divides = True
        if divides and self.division != before:
            self._rearranged()
        if self.framing.pull():
            self.touch_lines([self.top + self.division.view.bottom - 1])

    def _pull_words(self, now: float, *, on_panel: bool) -> bool:
        changed, due = self.status_bar.pull(now, self.inner_width - 2, self.word_lines, on_panel=on_panel)
        if changed:
            self.touch_lines(range(self.top + self.body_height, self.inner_height))
        return due

    def _follow_tool(self) -> None:
        """Show which tool is in use; the keys' cursor belongs to the one before."""
        tools = self.rviz.tools
        if (seen := (tools.current, tuple(tools.tools))) != self._seen_tool:
            self._seen_tool, self.view.cursor = seen, None
            if tools.current is not tools.interact:
                self._keys.controls.forget()
            if self.top:
                self.touch_lines([0])

    def show_message(self, text: str, seconds: float = 4.0) -> None:
        """Show a message in the status bar for a while."""
        self.status_bar.show_message(text, seconds)

    # -- drawing -------------------------------------------------------------------------------------------------------

    def title(self) -> list[Piece]:
        return [*super().title(), *self._subject()]

    def _subject(self) -> list[Piece]:
        """What the upper edge says besides the tabs: those are looked after like every pane's."""
        colours = self.look.colours
        statuses = self.rviz.statuses
        style = colours.muted if statuses.level == OK else colours.warning
        pieces = [Piece("* " if self.rviz.modified else " ", colours.muted)]
        if not self.panel_open:
            pieces += [
                Piece(f" {self.look.glyphs.chevron} Displays ", colours.key, self.toggle_panel),
                Piece(" ", colours.muted),
            ]
        pieces.append(Piece(f"Fixed Frame {self.rviz.fixed_frame} ", style, self._to_fixed))
        return pieces

    def close(self) -> None:
        """Close the window; RViz asks first whether to save what was changed."""
        if self.rviz.modified:
            dialogs.leave(self)
        else:
            self.window.close_by_user()

    def loses_at_the_end(self) -> str:
        return self.look.texts("rviz.unsaved") if self.rviz.modified else ""

    def kept_view(self) -> str:
        rviz = self.rviz
        config = rviz.save()
        if self.framing.holds:  # so that the robot is framed again, whatever the size of the window is then
            config["Visualization Manager"]["Views"]["Current"] = rviz.view.save_start()
        kept = {"config": write_config(config), "file": str(rviz.config_file or ""), "modified": rviz.modified}
        return json.dumps(kept, ensure_ascii=False)

    def take_view(self, view: str) -> None:
        kept = json.loads(view)
        if (
            not isinstance(kept, dict)
            or not isinstance(kept.get("config"), str)
            or not isinstance(kept.get("file"), str)
        ):
            raise ValueError("no view of RViz")
        rviz, file = self.rviz, kept["file"]
        config = rviz.check_text(kept["config"])

        def load() -> None:
            rviz.load_config(config, Path(file) if file else None)
            rviz.modified = kept.get("modified") is True

        self.request(load)

    def _to_fixed(self) -> None:
        self.to_panel()
        self.choose(self.rviz.fixed)
        self.edit()

    def status(self) -> list[Piece]:
        tool = self.rviz.tools.current
        text = "RViz is ready."
        if self._hand.tool is not None or self.used:
            text = tool.status if tool is not None else self.rviz.view.help
        return [Piece(f" {text} ", self.look.colours.muted)]

    def status_right(self) -> list[Piece]:
        pieces = [Piece(f" {self.rviz.view.type} ", self.look.colours.node, self.next_view)]
        if self.rviz.quality.value != QUALITIES[0]:
            pieces.append(Piece(f"{self.rviz.quality.value} ", self.look.colours.topic, self.next_quality))
        if self.status_bar.rate:
            pieces.append(Piece(f"{self.status_bar.rate} fps ", self.look.colours.muted))
        return pieces

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        self._lay_out()
        return self._painter.line(y, width)

    @property
    def problem_told(self) -> bool:
        """Whether the first line of words is about what is wrong; in a low window a message comes first."""
        told = self.problems.status is not None
        return told and (self.inner_height >= LOWEST_WITH_PROBLEMS or not self.status_bar.pressing)

    def to_problem(self) -> None:
        """Go to the line of the tree that says what is wrong."""
        self.to_panel()
        if self.problems.status is not None:
            self.choose(self.problems.status)

    # -- choosing and editing ------------------------------------------------------------------------------------------

    def choose(self, prop: Property) -> None:
        """Open the tree down to a property and choose it."""
        self.panel.properties.choose(prop)
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
        prop = self.panel.properties.prop
        if prop is None:
            return
        if isinstance(prop, SavedView):
            self.request(partial(self.rviz.use_view, prop))
        elif prop.kind == BOOL and not isinstance(prop, Display):
            self.toggle(prop)
        elif prop.kind in (GROUP, STATUS) or prop.read_only or isinstance(prop, Display):
            self.open_branch(prop, not prop.expanded)
        else:
            dialogs.edit(self, prop)

    def open_branch(self, prop: Property, on: bool) -> None:
        """Open or close a branch."""
        if prop.children:
            prop.expanded = on
            self.panel.properties.refill()
            self.look.wake()

    def request(self, action: Callable[[], object]) -> None:
        """Let the program do something."""
        self.rviz.message = None
        self.rviz.request(action)

    def next_view(self) -> None:
        names, rviz = list(VIEWS), self.rviz
        # Which one is next is found out when it is done: keys may come faster.
        self.request(lambda: rviz.set_view(names[(names.index(rviz.view.type) + 1) % len(names)]))

    def save_view(self) -> None:
        """Keep the view: its line below Views leads back to it."""
        self.request(self.rviz.save_view)
        self.show_message(self.look.texts("rviz.view_saved", name=self.rviz.view.type), 8.0)

    def next_quality(self) -> None:
        quality = self.rviz.quality

        def work() -> None:
            self.rviz.edit(quality, QUALITIES[(QUALITIES.index(quality.value) + 1) % len(QUALITIES)])
            self.app.call_later(lambda: self.show_message(self.look.texts("rviz.quality", name=quality.value)))

        self.request(work)

    def use_tool(self, tool: Tool) -> None:
        """Use a tool, or the default one if it is in use already; the view gets the keys."""
        self.used = True
        self.to_view()
        self.request(partial(self.rviz.tools.toggle, tool))

    # -- what keys do --------------------------------------------------------------------------------------------------

    def focus_robot(self) -> None:
        """Look at what is selected, else at what there is: the robot, or everything solid."""
        scene = self.rviz.scene
        selected = [placed_corner(*box, bits) for box in self.rviz.selection.bounds(scene) for bits in range(8)]
        if not (points := selected or outline(scene)):
            self.show_message(self.look.texts("rviz.nothing_to_focus"))
            return
        if self.inner_width < NARROW:
            self.to_view()
        frame(self.rviz.view, points, self.view.aspect)
        self.look.wake()

    def from_above(self) -> None:
        self.rviz.view.from_above()
        self.look.wake()

    def zero(self) -> None:
        self.rviz.view.zero()
        self.look.wake()

    def toggle_panel(self) -> None:
        """Fold the panel away, or bring it back."""
        if self.panel_open:
            self.drawer.want(self.inner_width, on=False)
            self._rearranged()
        else:
            self.to_panel()

    def to_panel(self) -> None:
        """Give the keys to the panel."""
        self._panel_keys = True
        self.drawer.want(self.inner_width, on=True)
        self._rearranged()

    def to_view(self) -> None:
        """Give the keys to the view; in a narrow window it gets all of it."""
        self._panel_keys = False
        if self.inner_width < NARROW:
            self.drawer.want(self.inner_width, on=False)
        self._rearranged()

    def _rearranged(self) -> None:
        self._lay_out()
        self.panel.refresh(layout=True)
        self.pass_keyboard()
        self.status_bar.hurry()
        self.touch()
        self.look.wake()

    @property
    def unclear(self) -> str:
        """The chosen status, or the worst one of the chosen display; while the panel is folded, the one that is told."""
        prop = self.panel.properties.prop if self.on_panel else self.problems.status
        while prop is not None and not isinstance(prop, Display | Status):
            prop = prop.parent
        if prop is None:
            return ""
        status = prop.statuses if isinstance(prop, Display) else prop
        if isinstance(status, StatusList):
            status = max(status.lines, key=lambda line: line.level, default=status)
        return str(status.value) if status.level > OK else ""

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        if self.panel.value_line is not None:
            return [("Enter", texts("rviz.key.edit")), ("Esc", texts("question.back"))]
        unicode = self.look.glyphs.unicode
        arrows = "←↑↓→" if unicode else ARROWS
        named = [(arrows if key == ARROWS else key, texts(words)) for key, words in self._keys.hints()]
        return named if unicode else [(key, in_ascii(text)) for key, text in named]

    def _press(self, key: str, character: str) -> bool:
        return self._keys.press(key)

    def push(self, name: str) -> None:
        """Do what the button of this name does."""
        display, prop = self.panel.properties.chosen_display, self.panel.properties.prop
        if name == "add":
            dialogs.add(self)
        elif isinstance(prop, SavedView):
            if name == "rename":
                dialogs.rename(self, prop)
            elif name == "remove":
                self.request(partial(self.rviz.remove_view, prop))
        elif display is None:
            pass  # it is gone since
        elif name == "rename":
            dialogs.rename(self, display)
        else:
            act = self.rviz.duplicate_display if name == "duplicate" else self.rviz.remove_display
            self.request(partial(act, display))

    @on(PanelButton.Pressed)
    def press_button(self, event: PanelButton.Pressed) -> None:
        event.stop()
        if self.screen.focused is not event.button:  # a click on it may be the first one in this window
            self._panel_keys = True
            self.screen.set_focus(self.focus_target, scroll_visible=False)
        self.push(event.button.id or "")
        self.look.wake()

    @on(PropertyTree.Clicked)
    def click_line(self, event: PropertyTree.Clicked) -> None:
        event.stop()
        self._panel_keys = True
        if event.part == "opener":
            self.open_branch(event.prop, not event.prop.expanded)
        elif event.part == "box":
            self.toggle(event.prop)
        else:
            self.edit()
        self.look.wake()

    @on(PropertyTree.Moved)
    def follow_cursor(self, event: PropertyTree.Moved) -> None:
        event.stop()
        self.status_bar.hurry()
        self.look.wake()

    def on_descendant_focus(self, event: events.DescendantFocus) -> None:
        """A click, or Textual itself, gave the keyboard to a part of the panel."""
        if self.screen.focused is event.widget and self.panel_open:
            self._panel_keys = True

    def on_mouse_down(self, event: events.MouseDown) -> None:
        if not self._mouse.press(event):
            return
        event.stop()
        self._panel_keys = False
        self.screen.set_focus(self, scroll_visible=False)
        self.used = True
        self.capture_mouse()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if self._mouse.move(event):
            event.stop()
            self.used = True
            self.look.wake()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        if self._mouse.release(event):
            event.stop()
            self.release_mouse()
            self.look.wake()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._mouse.wheel(event, notches)
        self.look.wake()


def _bar_lines(height: int) -> int:
    """Lines of the toolbar in a window that is `height` lines high inside."""
    return 1 if height >= LOWEST_WINDOW else 0
