"""The area between the bars: one pane for the terminals, one for each window, laid out by `arrangement`."""

from __future__ import annotations

from functools import partial

from textual import events
from textual.geometry import NULL_OFFSET, NULL_SPACING, Region, Size
from textual.layout import ArrangeResult, Layout, WidgetPlacement
from textual.widget import Widget

from day6_tui.core.session.display import Window
from day6_tui.tui.arrangement import WIDE, Arrangement, Place, arrange
from day6_tui.tui.look import Look
from day6_tui.tui.overlay import Overlay, PaneHost
from day6_tui.tui.pane import Pane, Piece
from day6_tui.tui.terminal_pane import TerminalPane
from day6_tui.tui.welcome import WelcomePane
from day6_tui.tui.windows import BrokenPane, WindowPane, make_window


class _DesktopLayout(Layout):
    """Places every pane as the desktop's arrangement says; a pane that is behind another gets no place."""

    name = "desktop"

    def arrange(self, parent: Widget, children: list[Widget], size: Size, greedy: bool = True) -> ArrangeResult:
        assert isinstance(parent, Desktop)
        found = parent.plan(size.width, size.height)
        placements = []
        for child in children:
            if isinstance(child, Overlay):
                over = child.place(_column_for_overlays(found, size))
                placements.append(WidgetPlacement(Region(*over), NULL_OFFSET, NULL_SPACING, child))
                continue
            place = found.terminal if child is parent.terminals else found.windows.get(_number_of(child))
            if place is not None:
                placements.append(WidgetPlacement(Region(*place), NULL_OFFSET, NULL_SPACING, child))
        return placements


def _number_of(widget: Widget) -> int:
    """The window number of a window's pane, or of the pane that replaces it; -1 for others."""
    return widget.number if isinstance(widget, (WindowPane, WelcomePane)) else -1


def _pane_of(widget: Widget) -> Pane | None:
    """The pane that a focused widget is or belongs to (such as the text of an editor)."""
    return next((found for found in widget.ancestors_with_self if isinstance(found, Pane)), None)


def _column_for_overlays(found: Arrangement, size: Size) -> Place:
    """The part of the desktop that an overlay may cover: one column of panes.

    Textual cuts every line at the edges of all widgets on it, also of those below, and a Chinese character that is cut is lost.
    """
    places = list(found.windows.values())
    if found.terminal is None or not places or found.terminal.x == places[0].x:
        return Place(0, 0, size.width, size.height)
    return Place(places[0].x, 0, places[0].width, size.height)


class Desktop(PaneHost):
    """Owns the panes, the last used window and what is enlarged; the windows themselves belong to the display."""

    DEFAULT_CSS = "Desktop { width: 1fr; height: 1fr; overflow: hidden; layers: below above; }"

    BLANK = True  # the panes cover it

    def __init__(self, look: Look, terminals: TerminalPane, welcome: WelcomePane) -> None:
        super().__init__(terminals, welcome, id="desktop")
        self._layout_of_panes = _DesktopLayout()
        self.look = look
        self.terminals = terminals
        self.welcome = welcome
        self.panes: dict[int, WindowPane[object]] = {}
        """The panes of the open windows, by window number, oldest first."""
        self.active: int | None = None
        """The window used last."""
        self.enlarged: str | None = None
        self.share = 0.5
        self.guided = True
        """Whether the welcome pane is shown while there are no windows."""
        self.guide_yields = False
        """On a small screen the guide makes room for terminals whose text no longer fits, while they have the focus."""

    @property
    def layout(self) -> Layout:
        return self._layout_of_panes

    # -- what is shown -------------------------------------------------------------------------------------------------

    @property
    def numbers(self) -> list[int]:
        """The numbers of the windows, the welcome pane's if there is none."""
        return list(self.panes) or ([WelcomePane.number] if self.guided else [])

    def plan(self, width: int, height: int) -> Arrangement:
        terminal_focused = self.terminals.has_focus or self._lately_terminal
        yields = self.guide_yields and not self.panes and terminal_focused and width < WIDE
        return arrange(
            width,
            height,
            [] if yields else self.numbers,
            self.active,
            enlarged=self.enlarged,
            terminal_focused=terminal_focused,
            share=self.share,
        )

    @property
    def _lately_terminal(self) -> bool:
        # While an overlay has the focus the pane below it stays where it is.
        return self._last_focus is self.terminals

    _last_focus: Pane | None = None

    def shown(self) -> list[Pane]:
        """The visible panes."""
        found = self.plan(*self.size)
        panes: list[Pane] = [self.terminals] if found.terminal is not None else []
        for number in found.windows:
            pane = self.pane(number)
            if pane is not None:
                panes.append(pane)
        return panes

    def pane(self, number: int) -> Pane | None:
        """The pane of a window, or the welcome pane for its number."""
        return self.welcome if number == WelcomePane.number and not self.panes else self.panes.get(number)

    def hidden_windows(self) -> list[WindowPane[object]]:
        """The hidden windows: their names are shown on the frames of other panes."""
        places = self.plan(*self.size).windows
        return [pane for number, pane in self.panes.items() if number not in places]

    # -- windows come and go -------------------------------------------------------------------------------------------

    def show_windows(self, windows: list[Window[object]]) -> list[WindowPane[object]]:
        """Make the panes agree with the display's list; return the new ones that do not fit beside the terminal."""
        unseen: list[WindowPane[object]] = []
        open_numbers = {window.number for window in windows}
        focused_gone = False
        for number in [number for number in self.panes if number not in open_numbers]:
            pane = self.panes.pop(number)
            focused_gone = focused_gone or self.focused_pane is pane
            pane.remove()
        for window in windows:
            if window.number not in self.panes:
                pane = make_window(window, self.look)
                self.panes[window.number] = pane
                self.active = window.number
                self.mount(pane)
                if pane.takes_focus or self._covers_the_focus():
                    self.call_after_refresh(self.focus_pane, pane)
                elif pane.number not in self.plan(*self.size).windows:
                    unseen.append(pane)
        if self.active not in self.panes:
            self.active = next(reversed(self.panes), WelcomePane.number)
            if self.enlarged == "window":
                self.enlarged = None
        self.welcome.display = not self.panes and self.guided
        if focused_gone:
            self.focus_pane(self.terminals)
        self.rearrange()
        return unseen

    def yield_to_full_terminals(self) -> None:
        """Let the guide (not the choices of the start) make room once something has scrolled out of a terminal."""
        if not self.guide_yields and self.welcome.help_key == "guide" and any(v.history for v in self.terminals.views):
            self.guide_yields = True
            self.rearrange()

    def _covers_the_focus(self) -> bool:
        """Whether the window opened last covers the focused one, which would then be invisible."""
        focused = self.focused_pane
        return isinstance(focused, WindowPane) and focused.number not in self.plan(*self.size).windows

    def break_window(self, pane: WindowPane[object], error: Exception) -> None:
        """Show the reason in place of a window that failed while being drawn."""
        broken = BrokenPane(pane.window, self.look, error)
        self.panes[pane.number] = broken
        pane.remove()
        self.mount(broken)
        self.rearrange()

    # -- focus and size ------------------------------------------------------------------------------------------------

    def rearrange(self) -> None:
        """Lay out the panes again."""
        # Asked of a child: a widget's own arrangement is only forgotten when a child's layout changes.
        self.terminals.refresh(layout=True)
        for pane in (self.terminals, self.welcome, *self.panes.values()):
            pane.touch()

    def focus_pane(self, pane: Pane) -> None:
        """Focus a pane and bring it to the front; an overlay over another pane is closed."""
        self.drop_overlay()
        self._last_focus = pane
        if isinstance(pane, (WindowPane, WelcomePane)):
            self.active = pane.number
        if self.enlarged is not None:
            self.enlarged = "terminal" if pane is self.terminals else "window"
        self.rearrange()
        self.give_keyboard(pane)

    def give_keyboard(self, pane: Pane) -> None:
        """Focus a pane at once: with `Widget.focus`, quick keys meant for `pane` would still go to another one."""
        target = pane.focus_target
        if target.is_attached:
            self.screen.set_focus(target, scroll_visible=False)
        else:
            target.focus(scroll_visible=False)

    def keep_keyboard(self) -> None:
        """Called before a key: if nothing, or something removed, has the focus, focus the pane that should have it.

        Textual gives it back to an overlay that was closed in the meantime when the terminal has lost and won the focus.
        """
        if not self.is_attached:
            return
        focused = self.screen.focused
        if focused is None or not focused.is_attached or (isinstance(focused, Overlay) and focused is not self.overlay):
            self.give_keyboard(self.focused_pane if self.overlay is None else self.overlay)

    @property
    def focused_pane(self) -> Pane:
        """The pane that has the focus, or had it before an overlay."""
        last = self._last_focus
        return last if last is not None and last.is_attached else self.terminals

    def on_descendant_focus(self, event: events.DescendantFocus) -> None:
        pane = _pane_of(event.widget)
        if pane is None or isinstance(pane, Overlay) or pane is self._last_focus:
            return
        if event.widget is not self.screen.focused:
            return  # quick keys: the news of one pane may come when the next already has the focus
        self._last_focus = pane
        if isinstance(pane, (WindowPane, WelcomePane)):
            self.active = pane.number
        self.rearrange()

    def toggle_enlarged(self) -> None:
        """Make the focused pane fill the desktop, or put it back."""
        if self.enlarged is not None:
            self.enlarged = None
        else:
            self.enlarged = "terminal" if self.focused_pane is self.terminals else "window"
        self.rearrange()

    def tabs_beside(self, pane: Pane) -> list[Piece]:
        """The names of the hidden windows: shown on the upper edge of the terminals and of the last used window."""
        if isinstance(pane, WindowPane) and pane.number != self.active:
            return []
        colours = self.look.colours
        return [
            Piece(f" {hidden.label} ", colours.title, partial(self.focus_pane, hidden))
            for hidden in self.hidden_windows()
        ]
