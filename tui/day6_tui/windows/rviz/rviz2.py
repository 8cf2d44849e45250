"""The RViz window: the Displays panel on the left, the 3-D view on the right, a status bar below.

The panel is a `DisplaysPanel` of Textual's widgets; the picture, a `View3D`, and the text below it, a `StatusBar`, are painted.
This module puts them together and handles keys and mouse.
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
from day6_core.ros.programs.rviz2.model.status import OK, Status, StatusList
from day6_core.ros.programs.rviz2.model.tools.tool import Tool
from day6_core.ros.programs.rviz2.model.views import VIEWS, SavedView
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, fit
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows import WindowPane
from day6_tui.windows.rviz import dialogs
from day6_tui.windows.rviz.buttons import LABELS, PanelButton
from day6_tui.windows.rviz.control_keys import ControlKeys
from day6_tui.windows.rviz.displays import DisplaysPanel
from day6_tui.windows.rviz.dragging import Dragging
from day6_tui.windows.rviz.extent import around, extent
from day6_tui.windows.rviz.hand import Hand
from day6_tui.windows.rviz.hints import ARROWS, panel_hints, view_hints
from day6_tui.windows.rviz.offer import FocusOffer
from day6_tui.windows.rviz.sizes import NARROW, Division, divide
from day6_tui.windows.rviz.status_bar import StatusBar, in_ascii
from day6_tui.windows.rviz.toolbar import LOWEST_WINDOW, names_in
from day6_tui.windows.rviz.tree import PropertyTree
from day6_tui.windows.rviz.view import View3D

TURN = 0.1309
"""Radians an arrow key turns the view: 7.5 degrees."""

SHIFT = 0.06
"""Fraction of the picture's height by which Shift and an arrow key pan it."""

_ARROWS = {"left": (-1, 0), "right": (1, 0), "up": (0, -1), "down": (0, 1)}
_FOLDS = {"▸": "◂", "»": "«", ">": "<"}
"""The arrow that opens -> the one that folds."""

_END = 1_000_000


class _PanelAtTheLeft(Layout):
    """Places the panel inside the frame; the rest is painted."""

    name = "rviz"

    def arrange(self, parent: Widget, children: list[Widget], size: Size, greedy: bool = True) -> ArrangeResult:
        assert isinstance(parent, RVizPane)
        region = parent.panel_region(size)
        return [WidgetPlacement(region, NULL_OFFSET, NULL_SPACING, child) for child in children if region]


class RVizPane(WindowPane[RViz]):
    """The window of an `RViz`; keeps only view state: which part has the focus, and what was last drawn."""

    needs = PaneNeeds(Extent(56, 14), Extent(72, 28), Extent(110, 40), 3.0)

    def __init__(self, window: Window[RViz], look: Look) -> None:
        super().__init__(window, look)
        self.rviz = window.model
        self.view = View3D(self.rviz, look)
        self.panel = DisplaysPanel(self.rviz, look)
        self._layout_of_panel = _PanelAtTheLeft()
        self.status_bar = StatusBar(self.rviz, self.panel.properties, self.view, look)
        self.offer = FocusOffer(self.rviz)
        self._dragging = Dragging(self.view)
        self._hand = Hand(self.rviz, self.view)
        self._control_keys = ControlKeys(self.rviz)
        self._seen_tool: object = None
        only_grid = all(display.type == "Grid" for display in self.rviz.displays)
        self._panel_open = {"wide": True, "narrow": only_grid}
        """Whether the panel is open, in windows of either kind: in a narrow one a robot that is there comes first."""
        self._panel_keys = True
        """Whether the keys go to the panel, if it is open; else to the view."""
        self._shown_frame: tuple[str, ...] = ()
        self._used = False
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
        is_open = self._panel_open["narrow" if width < NARROW else "wide"]
        top = _bar_lines(height)
        return Region(1, 1 + top, divide(width, panel_open=is_open).panel, max(0, height - top - _word_lines(height)))

    @property
    def word_lines(self) -> int:
        """Lines of the status bar."""
        return _word_lines(self.inner_height)

    @property
    def body_height(self) -> int:
        return max(0, self.inner_height - self.top - self.word_lines)

    @property
    def top(self) -> int:
        """Lines above panel and view: the toolbar's."""
        return _bar_lines(self.inner_height)

    @property
    def _kind(self) -> str:
        return "narrow" if self.inner_width < NARROW else "wide"

    @property
    def panel_open(self) -> bool:
        """Whether the panel is not folded away."""
        return self._panel_open[self._kind]

    @panel_open.setter
    def panel_open(self, on: bool) -> None:
        self._panel_open[self._kind] = on

    @property
    def on_panel(self) -> bool:
        """Whether the keys go to the panel; else to the view."""
        return self._panel_keys and self.panel_open

    @property
    def division(self) -> Division:
        """How the columns are divided."""
        return divide(self.inner_width, panel_open=self.panel_open)

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._lay_out()

    def restyle(self) -> None:
        self.panel.properties.take_look(self.look)
        self.view.forget()
        self.status_bar.forget()
        super().restyle()

    def _lay_out(self) -> None:
        self.view.resize(self.division.view, self.body_height)

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

    def _pass_keyboard(self) -> None:
        """The part that shall have the keyboard gets it, if the window has it."""
        if self.has_focus_within:
            self.screen.set_focus(self.focus_target, scroll_visible=False)

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        if not self.inner_width or not self.body_height:
            return False
        self._lay_out()
        if (self.screen.focused is self) is self.on_panel:
            self._pass_keyboard()
        left = self.division.view_left
        spans, due = self.view.pull(now)
        top = self.top
        self.view.show(self, left + self.inner_offset, top + self.inner_offset)
        if self.panel_open and self.panel.properties.is_attached:
            self.panel.pull(active=self._panel_active)
        if self.offer.pull(self.view.aspect):
            self.touch_lines([top + self.body_height - 1])
        if spans:
            self.touch_spans([(row + top, first + left, end + left) for row, first, end in spans])
        self._follow_tool()
        if (menu := self.rviz.menu) is not None:
            self.rviz.menu = None
            # An overlay cannot come while a frame is made.
            self.app.call_later(dialogs.show_menu, self, menu)
        due = self._pull_words(now) or due
        title = tuple(piece.text for piece in (*self.title(), *self.status(), *self.status_right()))
        if title != self._shown_frame:
            self._shown_frame = title
            self.touch_frame()
        return due

    @property
    def _panel_active(self) -> bool:
        """Whether the panel has the keyboard."""
        return self.on_panel and self.has_focus_within

    def _pull_words(self, now: float) -> bool:
        on_panel = self._panel_active
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
                self._control_keys.forget()
            if self.top:
                self.touch_lines([0])

    def show_message(self, text: str, seconds: float = 4.0) -> None:
        """Show a message in the status bar for a while."""
        self.status_bar.show_message(text, seconds)

    # -- drawing -------------------------------------------------------------------------------------------------------

    def title(self) -> list[Piece]:
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
        return [*super().title(), *pieces]

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
        kept = {"config": write_config(rviz.save()), "file": str(rviz.config_file or ""), "modified": rviz.modified}
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
        self._to_panel()
        self.choose(self.rviz.fixed)
        self.edit()

    def status(self) -> list[Piece]:
        tool = self.rviz.tools.current
        text = "RViz is ready."
        if self._hand.tool is not None or self._used:
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
        if y < self.top:
            return self._toolbar_line(y, width)
        y -= self.top
        if y >= self.body_height:
            return self._words_line(y - self.body_height, width)
        self._lay_out()
        columns = self.division.panel
        segments = [Segment(" " * columns, self.background), self._edge_cell(y, columns)]
        if self.view.columns:
            segments += self._offer_line(y) or self.view.line(y)
        return segments

    def _toolbar_line(self, y: int, width: int) -> list[Segment]:
        """The tools: a click chooses one, as its letter does."""
        colours, tools = self.look.colours, self.rviz.tools
        segments, end = [], 0
        for name in names_in(tools.tools, tools.current, width):
            segments.append(Segment(" " * (name.column - end), colours.muted))
            chosen = name.tool is tools.current
            key, words = (colours.choice, colours.choice) if chosen else (colours.key, colours.text)
            segments += [Segment(name.letter, key), Segment(f" {name.words}" if name.words else "", words)]
            end = name.end
            left = self.inner_offset + name.column
            self.add_hit(y + self.inner_offset, left, left + name.end - name.column, partial(self.use_tool, name.tool))
        return segments

    def _edge_cell(self, y: int, column: int) -> Segment:
        """The edge between panel and view, with an arrow in its middle that folds and unfolds the panel."""
        colours, glyphs = self.look.colours, self.look.glyphs
        left = self.inner_offset + column
        self.add_hit(y + self.top + self.inner_offset, left, left + 1, self.toggle_panel)
        if abs(y - self.body_height // 2) <= 1:
            arrow = _FOLDS.get(glyphs.chevron, "<") if self.panel_open else glyphs.chevron
            return Segment(arrow if y == self.body_height // 2 else " ", colours.key)
        on_view = self.has_focus and not self.on_panel
        return Segment(glyphs.border.vertical, colours.frame_focus if on_view else colours.frame)

    def _offer_line(self, y: int) -> list[Segment]:
        """The lowest line of the view while it offers to look at the robot."""
        if y != self.body_height - 1 or not self.offer.open:
            return []
        text = fit(f" f  {self.look.texts('rviz.offer')} ", self.view.columns, self.look.glyphs.ellipsis)
        first = self.inner_offset + self.division.view_left
        self.add_hit(y + self.top + self.inner_offset, first, first + cell_len(text), self.focus_robot)
        return [Segment(text, self.look.colours.choice)]

    def _words_line(self, line: int, width: int) -> list[Segment]:
        colours = self.look.colours
        text = self.status_bar.lines[line] if line < len(self.status_bar.lines) else ""
        return [Segment(fit(f" {text}", width, self.look.glyphs.ellipsis), colours.muted)]

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
        self._used = True
        self._to_view()
        self.request(partial(self.rviz.tools.toggle, tool))

    # -- what keys do --------------------------------------------------------------------------------------------------

    def focus_robot(self) -> None:
        """Look at what is selected, else at what there is: the robot, or everything solid."""
        found = around(self.rviz.selection.bounds(self.rviz.scene)) or extent(self.rviz.scene)
        if found is None:
            self.show_message(self.look.texts("rviz.nothing_to_focus"))
            return
        if self._kind == "narrow":
            self._to_view()
        centre, radius = found
        self.rviz.view.look_at(centre, radius / min(1.0, max(0.2, self.view.aspect)))
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
            self.panel_open = False
            self._rearranged()
        else:
            self._to_panel()

    def _to_panel(self) -> None:
        self.panel_open = self._panel_keys = True
        self._rearranged()

    def _to_view(self) -> None:
        """Give the keys to the view; in a narrow window it gets all of it."""
        self._panel_keys = False
        if self._kind == "narrow":
            self.panel_open = False
        self._rearranged()

    def _rearranged(self) -> None:
        self._lay_out()
        self.panel.refresh(layout=True)
        self._pass_keyboard()
        self.status_bar.hurry()
        self.touch()
        self.look.wake()

    @property
    def unclear(self) -> str:
        """The chosen status, or the worst one of the chosen display."""
        prop = self.panel.properties.prop if self.on_panel else None
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
        hints = panel_hints() if self.on_panel else view_hints(self.rviz, self._control_keys)
        unicode = self.look.glyphs.unicode
        arrows = "←↑↓→" if unicode else ARROWS
        named = [(arrows if key == ARROWS else key, texts(words)) for key, words in hints]
        return named if unicode else [(key, in_ascii(text)) for key, text in named]

    def _press(self, key: str, character: str) -> bool:
        return self._everywhere_key(key) or (self._panel_key(key) if self.on_panel else self._view_key(key))

    def _everywhere_key(self, key: str) -> bool:
        if (tool := self.rviz.tools.with_key(key)) is not None:
            self.use_tool(tool)
            return True
        actions: dict[str, Callable[[], object]] = {
            "tab": self._other_part,
            "shift+tab": self._to_buttons,
            "d": self.toggle_panel,
            "f": self.focus_robot,
            "4": self.from_above,
            "z": self.zero,
            "v": self.next_view,
            "k": self.save_view,
            "l": self.next_quality,
            "r": lambda: self.request(self.rviz.reset),
            "slash": self._find,
            "ctrl+n": lambda: dialogs.add(self),
            "a": lambda: dialogs.add(self),
            "ctrl+s": lambda: dialogs.save(self),
            "ctrl+o": lambda: dialogs.load(self),
            "w": lambda: dialogs.save_as(self),
            "e": lambda: dialogs.screenshot(self),
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
        if self.on_panel:
            self._to_view()
        else:
            self._to_panel()

    def _find(self) -> None:
        self._to_panel()
        dialogs.find(self)

    def _to_buttons(self) -> None:
        """Go to the buttons, and from there to the tree."""
        on_buttons = self.on_panel and self.panel.buttons.chosen is not None
        if not self.on_panel:
            self._to_panel()
        if on_buttons or not self.panel.buttons.display:
            self._pass_keyboard()
        else:
            self.panel.choose_button()

    def _panel_key(self, key: str) -> bool:
        """A key was pressed while the panel has the keyboard; False if it means nothing here."""
        tree, buttons = self.panel.properties, self.panel.buttons
        if buttons.chosen is not None:
            return self._button_key(key, buttons.chosen)
        if key == "down" and buttons.display and tree.at_the_end:
            self.panel.choose_button()
            return True
        page = max(1, tree.size.height - 1)
        steps = {"up": -1, "down": 1, "pageup": -page, "pagedown": page, "home": -_END, "end": _END}
        if key in steps:
            tree.move(steps[key])
            return True
        action = self._tree_actions().get(key)
        if action is not None:
            action()
        return action is not None

    def _button_key(self, key: str, button: PanelButton) -> bool:
        if key in ("left", "right"):
            self.panel.choose_button(1 if key == "right" else -1)
        elif key in ("up", "escape"):
            self._pass_keyboard()
        elif key in ("enter", "space"):
            button.press()
        else:
            return key == "down"
        return True

    def _tree_actions(self) -> dict[str, Callable[[], object]]:
        """Key -> what it does to the chosen line, and to the display it belongs to."""
        prop, display = self.panel.properties.prop, self.panel.properties.chosen_display
        if prop is None:
            return {}
        actions: dict[str, Callable[[], object]] = {
            "right": partial(self.open_branch, prop, True),
            "left": partial(self._close_or_up, prop),
            "enter": self.edit,
            "space": partial(self.toggle, prop) if prop.kind == BOOL else lambda: None,
        }
        if display is not None or isinstance(prop, SavedView):
            names = {label.key: label.name.lower() for label in LABELS}
            actions |= {key: partial(self._push, name) for key, name in {**names, "delete": "remove"}.items()}
        if display is not None:
            for step, key in ((-1, "shift+up"), (1, "shift+down")):
                actions[key] = partial(self.request, partial(self.rviz.move_display, display, step))
        return actions

    def _close_or_up(self, prop: Property) -> None:
        if prop.expanded and prop.children:
            self.open_branch(prop, False)
        elif prop.parent is not None and prop.parent.parent is not None:
            self.choose(prop.parent)

    def _push(self, name: str) -> None:
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
        self._push(event.button.id or "")
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

    def _view_key(self, key: str) -> bool:
        self._used = True
        shifted, _, plain = key.rpartition("+")
        if plain in _ARROWS and shifted in ("", "shift"):
            self._arrow_key(*_ARROWS[plain], bool(shifted))
        elif plain in ("pageup", "pagedown"):
            nearer = 1 if plain == "pageup" else -1
            if not self._control_keys.step(0, 0, nearer, fine=bool(shifted)):
                self._zoom(nearer)
        elif key == "home":
            self.rviz.view.zero()
        elif key == "escape":
            if not self._control_keys.leave():
                self._leave_tool()
        elif key in ("x", "X"):
            if not self._control_keys.next(1 if key == "x" else -1):
                self.show_message(self.look.texts("rviz.no_controls"))
        elif key == "enter":
            return self._control_keys.enter() or self._hand.enter()
        else:
            return key == "space" and self._control_keys.space()
        return True

    def _arrow_key(self, right: int, down: int, shift: bool) -> None:
        view = self.rviz.view
        if self._control_keys.step(right, -down, 0, fine=shift) or self._hand.arrow(right, down, fine=shift):
            return
        self.view.turned()
        if shift:
            view.pan(right * SHIFT, down * SHIFT)
        else:
            view.rotate(right * TURN, down * TURN)

    def _leave_tool(self) -> None:
        """Back to the default tool; from there to the panel."""
        tools = self.rviz.tools
        if tools.current is tools.default:
            self._to_panel()
        self.request(tools.to_default)  # a letter pressed just before may not have been worked off yet

    def _zoom(self, steps: float) -> None:
        self.view.turned()
        self.rviz.view.zoom(steps)

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def _cell(self, event: events.MouseEvent) -> tuple[int, int]:
        return event.x - self.inner_offset, event.y - self.inner_offset - self.top

    def _place(self, event: events.MouseEvent) -> tuple[float, float]:
        """The place in the view, in cells: of a terminal that reports whole cells only, the middle of one."""
        x, y = (each + 0.5 if each == int(each) else each for each in (event.pointer_x, event.pointer_y))
        return x - self.inner_offset - self.division.view_left, y - self.inner_offset - self.top

    def _in_view(self, event: events.MouseEvent) -> bool:
        x, y = self._cell(event)
        return self.division.view_left <= x < self.inner_width and 0 <= y < self.body_height

    def on_mouse_down(self, event: events.MouseDown) -> None:
        if not self._in_view(event):
            return
        if not self._hand.begin(event, *self._place(event)) and not self._dragging.begin(event):
            return
        event.stop()
        self._panel_keys = False
        self.screen.set_focus(self, scroll_visible=False)
        self._used = True
        self.capture_mouse()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if self._dragging.held:
            event.stop()
            self._dragging.move(event, self.rviz.view)
            self.look.wake()
        elif self._hand.held or (self._in_view(event) and self._hand.hovering is not None):
            event.stop()
            self._used = True
            self._hand.move(event, *self._place(event))
            self.look.wake()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        if not self._dragging.held and not self._hand.held:
            return
        event.stop()
        if self._hand.held:
            self._hand.end(event, *self._place(event))
        else:
            self._dragging.end()
        self.release_mouse()
        self.look.wake()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        if self._in_view(event) and not self._hand.wheel(-notches):
            self.rviz.view.wheel(-notches, bool(event.shift))
        self.look.wake()


def _bar_lines(height: int) -> int:
    """Lines of the toolbar in a window that is `height` lines high inside."""
    return 1 if height >= LOWEST_WINDOW else 0


def _word_lines(height: int) -> int:
    """Lines of the status bar in a window that is `height` lines high inside."""
    return 2 if height >= 18 else 1
