"""The area between the bars: every terminal and every window is a pane in one tree of splits (`splits`)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache, partial

from textual import events, on
from textual.geometry import NULL_OFFSET, NULL_SPACING, Region, Size
from textual.layout import ArrangeResult, Layout, WidgetPlacement
from textual.message import Message
from textual.widget import Widget

from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.features.welcome import WelcomePane
from day6_tui.panes import splits
from day6_tui.panes.border_mouse import FrameMouse
from day6_tui.panes.host import PaneHost
from day6_tui.panes.pane import Pane, Piece
from day6_tui.panes.placement import GUIDE, LESSON, OTHER, TELEOP, TERMINAL, WIDE, PaneNeeds, Room, put
from day6_tui.panes.splits import Extent, PanePlace, Tree
from day6_tui.panes.tabs import Tab, tab_pieces
from day6_tui.terminals.pane import TerminalPane
from day6_tui.windows import BrokenPane, WindowPane, make_window


class _DesktopLayout(Layout):
    """Places every pane as the desktop's tree says; a pane that is behind another gets no place."""

    name = "desktop"

    def arrange(self, parent: Widget, children: list[Widget], size: Size, greedy: bool = True) -> ArrangeResult:
        assert isinstance(parent, Desktop)
        found = parent.plan(size.width, size.height)
        placements = []
        for child in children:
            place = found.places.get(child.slot) if isinstance(child, Pane) and parent.holds(child) else None
            if place is not None:
                placements.append(WidgetPlacement(Region(*place), NULL_OFFSET, NULL_SPACING, child))
        return placements


def _pane_of(widget: Widget) -> Pane | None:
    """The pane that a focused widget is or belongs to (such as the text of an editor)."""
    return next((found for found in widget.ancestors_with_self if isinstance(found, Pane)), None)


class Desktop(PaneHost):
    """Owns the panes, the tree of their places and what is enlarged; windows belong to the display, terminals to the desk."""

    DEFAULT_CSS = "Desktop { width: 1fr; height: 1fr; overflow: hidden; }"

    BLANK = True  # the panes cover it

    class ListAsked(Message):
        """The user wants to see all panes."""

    class Dragging(Message):
        """A pane is over a place where it can be dropped."""

        def __init__(self, pane: Pane, target: Pane, side: str) -> None:
            super().__init__()
            self.pane = pane
            self.target = target
            self.side = side

    def __init__(self, look: Look, welcome: WelcomePane) -> None:
        super().__init__(welcome, id="desktop")
        self._layout_of_panes = _DesktopLayout()
        self.look = look
        self.welcome = welcome
        self.split_tree = Tree()
        self.slots: dict[int, Pane] = {}
        """All panes by their number, the guide included while it has a place."""
        self.panes: dict[int, WindowPane[object]] = {}
        """The panes of the open windows, by window number, oldest first."""
        self.recent: list[int] = []
        """The numbers of all panes, the one used last first."""
        self.enlarged = False
        """Whether the focused pane fills the desktop."""
        self.guided = True
        """Whether the guide is shown beside a terminal that is alone."""
        self._guide_yields = False
        """On a small screen the guide makes room for a terminal whose text no longer fits."""
        self._last_focus: Pane | None = None
        self._mouse = FrameMouse(self)
        self._made_room: tuple[int, Tree, object] | None = None
        """The window for which the others made room, and how they stood before: there they go back when it closes.

        At last what the tree then looks like if nobody has moved anything, nor opened or closed another pane.
        """
        self._planned: tuple[Size, splits.Layout] | None = None
        """The places at a size, until something changes."""

    @property
    def layout(self) -> Layout:
        return self._layout_of_panes

    # -- what is shown -------------------------------------------------------------------------------------------------

    def holds(self, pane: Pane) -> bool:
        return self.slots.get(pane.slot) is pane

    def terminals(self) -> Iterator[TerminalPane]:
        """The panes of the terminals, by their numbers."""
        return (pane for _, pane in sorted(self.slots.items()) if isinstance(pane, TerminalPane))

    def plan(self, width: int, height: int) -> splits.Layout:
        """The places of the panes at a size."""
        if self._planned is None or self._planned[0] != (width, height):
            self._planned = Size(width, height), self._plan(width, height)
        return self._planned[1]

    def _plan(self, width: int, height: int) -> splits.Layout:
        self._turn_guide(width)
        focused = self.focused_pane
        if self.enlarged and focused is not None and self.holds(focused):
            stack = self.split_tree.stack_of(focused.slot)
            return splits.Layout({focused.slot: PanePlace(0, 0, width, height)}, {focused.slot: list(stack.keys)})
        return self.split_tree.lay_out(width, height, self.needs, self.recent)

    def plan_now(self) -> splits.Layout:
        return self.plan(*self.outer_size)  # it has no border; `size` costs twenty times as much

    def shown(self) -> list[Pane]:
        """The visible panes."""
        return [self.slots[slot] for slot in self.plan_now().places]

    def is_shown(self, pane: Pane) -> bool:
        return self.holds(pane) and pane.slot in self.plan_now().places

    def needs(self, slot: int) -> PaneNeeds:
        """What a pane needs to be useful."""
        pane = self.slots.get(slot)
        found = pane.needs if isinstance(pane, TerminalPane | WindowPane) else GUIDE
        beside = self.size.width - LESSON.good.columns
        if found.least.columns + LESSON.least.columns > self.size.width and beside >= OTHER.least.columns:
            return found.within(beside) if self._has_lesson else found
        return found

    def room(self, keyboard: Pane | None = None) -> Room:
        """What is known of the panes when one of them gets a place; that a terminal drives changes its size, not its place."""

        @cache  # many places are tried
        def needs(slot: int) -> PaneNeeds:
            found = self.needs(slot)
            return TERMINAL if found is TELEOP else found

        def family(slot: int) -> list[object]:
            pane = self.slots.get(slot)
            if not isinstance(pane, WindowPane):
                return []
            labels = [pane.about, pane.window.command if pane.window.is_launched else 0]
            return [label for label in labels if label]

        driven = {pane.slot for pane in self.terminals() if pane.drives}
        slot = keyboard.slot if keyboard is not None else None
        return Room(Extent(*self.size), needs, self.recent, slot, family, driven)

    @property
    def _has_lesson(self) -> bool:
        return any(isinstance(pane, WindowPane) and pane.window.kind == "lesson" for pane in self.slots.values())

    def tabs(self, pane: Pane, room: int) -> list[Piece]:
        """The names of the panes that share a place with `pane`, its own among them."""
        keys = self.plan_now().stacks.get(pane.slot, [pane.slot])
        beside = [self.slots[key] for key in keys if key in self.slots]
        if pane not in beside:
            return []
        tabs = [
            Tab(
                str(each.slot) if each.slot else "",
                each.label,
                each.has_news and each is not pane,
                partial(self.focus_pane, each),
            )
            for each in beside
        ]
        return tab_pieces(
            self.look, tabs, beside.index(pane), focused=pane.has_focus_within, room=room, list_all=self._ask_for_list
        )

    def more(self, pane: Pane) -> list[Piece]:
        """How many panes an enlarged one covers."""
        if not self.enlarged:
            return []
        covered = len(self.slots) - sum(map(len, self.plan_now().stacks.values()))
        return [Piece(f" +{covered} ", self.look.colours.title, self._ask_for_list)] if covered else []

    def _ask_for_list(self) -> None:
        self.post_message(self.ListAsked())

    # -- panes come and go ---------------------------------------------------------------------------------------------

    def add(self, pane: Pane, *, beside: Pane | None = None, side: str = "", takes_focus: bool = False) -> None:
        """Show a new pane at a `side` of another one, or where most of all panes is seen."""
        pane.slot = next(number for number in range(1, len(self.slots) + 2) if number not in self.slots)
        self.slots[pane.slot] = pane
        keyboard = self.focused_pane
        self.recent.insert(0 if takes_focus or not self.recent else 1, pane.slot)
        self._settle_guide()
        if beside is not None and self.holds(beside):
            self.split_tree.add(pane.slot, beside.slot, side)
        else:
            self._find_place(pane, keyboard)
            if not takes_focus and keyboard is not None and self.holds(keyboard):
                self.split_tree.bring_to_front(keyboard.slot)  # where there was no other place
        self._settle_guide()
        if not pane.is_attached:
            self.mount(pane)
        self.rearrange()

    def _find_place(self, pane: Pane, keyboard: Pane | None) -> None:
        """Put a pane where most is seen; the others make room for a window that is too large for every place there is."""
        covers = isinstance(pane, WindowPane) and pane.covers_keyboard
        before = self.split_tree
        self.split_tree = put(before, pane.slot, self.room(None if covers else keyboard))
        if self.split_tree is not before:
            without = self.split_tree.copy()
            without.remove(pane.slot)
            self._made_room = pane.slot, before, without.shape

    def close_guide(self) -> None:
        """The guide is not wanted any more."""
        self.guided = False
        self._settle_guide()
        if (heir := self._heir()) is not None:
            self.focus_pane(heir)

    def drop(self, pane: Pane) -> None:
        """Take a pane away; if it had the keyboard, the one used before gets it."""
        if not self.holds(pane):
            return
        had_keyboard = self.focused_pane is pane
        self.close_overlay_about(pane)
        self._take_out(pane)
        pane.remove()
        if had_keyboard:
            self.enlarged = False
        self._settle_guide()
        if had_keyboard and (heir := self._heir()) is not None:
            self.focus_pane(heir)
        self.rearrange()

    def _take_out(self, pane: Pane) -> None:
        """Forget the place of a pane."""
        self.split_tree.remove(pane.slot)
        if self._made_room is not None and self._made_room[0] == pane.slot:
            if self.split_tree.shape == self._made_room[2]:
                self.split_tree = self._made_room[1]
            self._made_room = None
        del self.slots[pane.slot]
        self.recent.remove(pane.slot)
        self._planned = None

    def _heir(self) -> Pane | None:
        """Who gets the keyboard when its owner has gone: the visible pane used last."""
        places = self.plan_now().places
        shown = [self.slots[slot] for slot in self.recent if slot in places]
        return next((pane for pane in shown if pane.inherits), shown[0] if shown else None)

    def show_windows(self, windows: list[Window[object]]) -> list[WindowPane[object]]:
        """Make the panes agree with the display's list; return the new ones that have no place of their own."""
        open_numbers = {window.number for window in windows}
        for number in [number for number in self.panes if number not in open_numbers]:
            self.drop(self.panes.pop(number))
        unseen: list[WindowPane[object]] = []
        newest: Pane | None = None
        for window in windows:
            if window.number not in self.panes:
                pane = make_window(window, self.look)
                self.panes[window.number] = pane
                self.add(pane)
                if pane.takes_focus:
                    newest = pane
                elif not self.is_shown(pane):
                    unseen.append(pane)
        if newest is not None:
            # Where nobody had the keyboard yet, the newest pane counts as its owner by now.
            self.call_after_refresh(self._focus_new, newest, self.focused_pane)
        return unseen

    def break_window(self, pane: WindowPane[object], error: Exception) -> None:
        """Show the reason in place of a window that failed while being drawn."""
        broken = BrokenPane(pane.window, self.look, error)
        broken.slot = pane.slot
        self.panes[pane.window.number] = broken
        self.slots[pane.slot] = broken
        pane.remove()
        self.mount(broken)
        self.rearrange()

    def arrange_as(self, tree: Tree) -> None:
        """Arrange the panes as in a tree; those it does not have come where most is seen."""
        self.enlarged, self._made_room = False, None
        for slot in list(tree.keys):
            if slot not in self.slots:
                tree.remove(slot)
        for slot in [slot for slot in self.recent if slot not in tree.keys]:
            lately = [each for each in self.recent if each in tree.keys or each == slot]
            room = replace(self.room(self.slots[lately[0]]), recent=lately)
            tree = put(tree, slot, room)
        self.split_tree = tree
        pane = self.focused_pane
        if pane is not None:
            tree.bring_to_front(pane.slot)
        self.rearrange()

    # -- the guide -----------------------------------------------------------------------------------------------------

    def _settle_guide(self) -> None:
        """The guide is there beside a terminal that is alone, and nowhere else."""
        others = [pane for pane in self.slots.values() if pane is not self.welcome]
        wanted = self.guided and len(others) == 1 and isinstance(others[0], TerminalPane)
        there = self.holds(self.welcome)
        if there and not wanted:
            if self.focused_pane is self.welcome:
                self._last_focus = others[0] if others else None
            self._take_out(self.welcome)
        elif wanted and not there and others[0].slot in self.split_tree.keys:
            self._planned = None
            self.slots[self.welcome.slot] = self.welcome
            self.recent.append(self.welcome.slot)
            self.split_tree.add(self.welcome.slot, others[0].slot, "tab" if self._guide_yields else "above")
            self.split_tree.bring_to_front(others[0].slot)
        self.welcome.display = wanted

    def _turn_guide(self, width: int) -> None:
        """The guide is on the right of its terminal if there is room, else above it."""
        root = self.split_tree.root
        if isinstance(root, splits.Split) and len(self.slots) == 2 and self.holds(self.welcome):
            across = width >= WIDE
            if root.across != across:
                root.across, root.shares = across, None
                root.parts.reverse()

    def yield_to_full_terminals(self) -> None:
        """On a small screen the guide (not the choices of the start) makes room once text has scrolled out of its terminal."""
        if self._guide_yields or not self.holds(self.welcome) or self.size.width >= WIDE:
            return
        if self.welcome.guide and (terminal := next(self.terminals(), None)) is not None and terminal.view.history:
            self._guide_yields = True
            self.split_tree.move(self.welcome.slot, terminal.slot, "tab")
            self.split_tree.bring_to_front(self.focused_pane.slot if self.focused_pane is not None else terminal.slot)
            self.rearrange()

    # -- focus and size ------------------------------------------------------------------------------------------------

    def rearrange(self) -> None:
        """Lay out the panes again."""
        self._planned = None
        # Asked of a child: a widget's own arrangement is only forgotten when a child's layout changes.
        self.welcome.refresh(layout=True)
        for pane in (self.welcome, *self.slots.values()):
            pane.touch()
        self._tell_sizes_of_hidden()

    def on_resize(self) -> None:
        self._tell_sizes_of_hidden()

    def _tell_sizes_of_hidden(self) -> None:
        """A terminal behind another one has its size, so that nothing moves when it comes to the front."""
        if self.enlarged or not self.size.width:
            return
        found = self.plan_now()
        for front, keys in found.stacks.items():
            for key in keys:
                pane = self.slots.get(key)
                if key != front and isinstance(pane, TerminalPane):
                    pane.take_size(found.places[front])

    def go_to_pane(self, pane: Pane) -> None:
        """Do what a person asked for: focus a pane, and close a modal screen over another one."""
        self.close_overlay()
        self.focus_pane(pane)

    def focus_pane(self, pane: Pane) -> None:
        """Focus a pane and bring it to the front. What a person has opened over the panes keeps the keyboard until it closes."""
        self._note_focus(pane)
        if self.overlay is None:
            self.give_keyboard(pane)

    def _focus_new(self, pane: Pane, before: Pane | None) -> None:
        """Focus a pane that has appeared, unless the person has gone from where the keyboard was before to another one."""
        if self.focused_pane is before:
            self.focus_pane(pane)

    def type_at_terminal(self, keys: Sequence[events.Key]) -> None:
        used = [
            pane for slot in self.recent if isinstance(pane := self.slots[slot], TerminalPane) and pane.has_terminal
        ]
        free = [pane for pane in used if not pane.view.terminal.busy]
        for terminal in (free or used)[:1]:
            for key in keys:
                terminal.type_key(key)
            self.go_to_pane(terminal)

    def bring_to_front(self, pane: Pane) -> None:
        """Show a pane that is behind another one, without giving it the keyboard."""
        if self.holds(pane):
            self.split_tree.bring_to_front(pane.slot)
            self.rearrange()

    def _note_focus(self, pane: Pane) -> None:
        self._last_focus = pane
        if self.holds(pane):
            self.split_tree.bring_to_front(pane.slot)
            self.recent.remove(pane.slot)
            self.recent.insert(0, pane.slot)
        self.rearrange()

    def give_keyboard(self, pane: Pane) -> None:
        """Focus a pane at once: with `Widget.focus`, quick keys meant for `pane` would still go to another one."""
        target = pane.focus_target
        if target.is_attached:
            self.screen.set_focus(target, scroll_visible=False)
        else:
            target.focus(scroll_visible=False)

    def keep_keyboard(self) -> None:
        """Called before a key: if nothing, or something removed, has the focus, focus the pane that should have it.

        Textual leaves it so when the terminal has lost and won the focus while a modal screen was opened or closed.
        """
        if not self.is_attached or self.overlay is not None:
            return
        focused = self.screen.focused
        lost = focused is None or not focused.is_attached or focused.screen is not self.screen
        if lost and (target := self.focused_pane) is not None:
            self.give_keyboard(target)

    @property
    def focused_pane(self) -> Pane | None:
        """The pane that has the focus, or had it before a modal screen was opened; None before there is one."""
        last = self._last_focus
        if last is not None and self.holds(last):
            return last
        return next((self.slots[slot] for slot in self.recent), None)

    def on_descendant_focus(self, event: events.DescendantFocus) -> None:
        pane = _pane_of(event.widget)
        if pane is None or pane is self._last_focus:
            return
        if self.screen.focused not in (event.widget, None):
            return  # quick keys: the news of one pane may come when the next already has the focus
        self._note_focus(pane)

    # -- the mouse on frames -------------------------------------------------------------------------------------------

    def on_mouse_down(self, event: events.MouseDown) -> None:
        self._mouse.press(event)

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if (falling := self._mouse.drag(event)) is not None:
            self.post_message(self.Dragging(*falling))

    def on_mouse_up(self, event: events.MouseUp) -> None:
        self._mouse.release(event)

    @on(TerminalPane.NeedsOthers)
    def _heed_needs(self) -> None:
        self.rearrange()

    @on(Pane.Enlarged)
    def enlarge(self, event: Pane.Enlarged) -> None:
        self.focus_pane(event.pane)
        self.toggle_enlarged()

    def toggle_enlarged(self) -> None:
        """Make the focused pane fill the desktop, or put it back."""
        self.enlarged = not self.enlarged
        self.rearrange()
