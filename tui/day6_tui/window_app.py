# ruff: noqa: E402 - two things have to be settled before Textual is imported
"""One program's window on a real terminal: `day6-tui ros2 run turtlesim turtlesim_node` takes the terminal it was started in.

There is no simulated machine: the program runs in this process (`day6_core.session.local`). What it writes while its
window is shown appears on the line below, in the log (F5), and on the terminal afterwards.
"""

from __future__ import annotations

import logging
import os
import re
import sys
import time
from collections.abc import Callable
from functools import partial
from typing import Any

from day6_core.reason import fault

# Read by Textual at import: how often at most it writes to the terminal.
os.environ.setdefault("TEXTUAL_FPS", "30")

from day6_tui import lean

lean.import_asyncio()

from textual import events, on
from textual.app import App, ComposeResult
from textual.binding import Binding
from textual.geometry import NULL_OFFSET, NULL_SPACING, Region, Size
from textual.layout import ArrangeResult, Layout, WidgetPlacement
from textual.widget import Widget

from day6_core.session.display import Window
from day6_core.session.local import Foreground
from day6_tui.app import DEFAULT_FPS, make_look
from day6_tui.appearance.changing import Looks
from day6_tui.appearance.look import Look
from day6_tui.bars.bars import Bar, KeyHint, key_pieces
from day6_tui.bars.notices import HINT_SECONDS
from day6_tui.options import Options
from day6_tui.panes.cells import cell_len, clip
from day6_tui.panes.host import PaneHost
from day6_tui.panes.pane import Pane, Piece
from day6_tui.panes.tabs import Tab, tab_pieces
from day6_tui.screen.departure import give_back
from day6_tui.screen.frames import Frames
from day6_tui.screen.log_file import keep_log_off_the_screen
from day6_tui.screen.trouble import TerminalTrouble
from day6_tui.settings import Settings
from day6_tui.terminal_app import TerminalApp
from day6_tui.textual_private.access import fail
from day6_tui.windows import BrokenPane, WindowPane, make_window

_log = logging.getLogger(__name__)

_STAMP = re.compile(r"(?<=^\[[A-Z]{4}\] )\[[0-9.]+\] |(?<=^\[[A-Z]{5}\] )\[[0-9.]+\] ")
"""The time in a line of the log: the log has it, the lower bar has no room."""

GRACE = 2.0
"""Seconds a program has to end on its own when its terminal is gone."""

KEYS = (("q ^C", "end"), ("F1", "help"), ("F5", "log"))
"""The lower bar's keys, each with the `<part>` of the text `single.<part>` that names its action."""
MORE_KEYS = (("F3", "next"), ("F6", "glyphs"), ("F7", "language"), ("^Z", "suspend"))
"""Keys that only the help lists."""


def keys_beside(pane: Pane | None) -> tuple[tuple[str, str], ...]:
    """The keys of `KEYS` while a pane has the keyboard: in one that takes text q is a letter."""
    return (("^C", "end"), *KEYS[1:]) if pane is not None and pane.takes_text else KEYS


class _Stage(Layout):
    """Gives all the space to the last used window."""

    name = "stage"

    def arrange(self, parent: Widget, children: list[Widget], size: Size, greedy: bool = True) -> ArrangeResult:
        assert isinstance(parent, WindowStage)
        placements = []
        for child in children:
            if child is parent.shown:
                region = Region(0, 0, size.width, size.height)
                placements.append(WidgetPlacement(region, NULL_OFFSET, NULL_SPACING, child))
        return placements


class WindowStage(PaneHost):
    """Holds the panes of the program's windows (nearly always one)."""

    DEFAULT_CSS = "WindowStage { width: 1fr; height: 1fr; overflow: hidden; }"
    BLANK = True

    def __init__(self, look: Look) -> None:
        super().__init__(id="stage")
        self._stage = _Stage()
        self.look = look
        self.panes: dict[int, WindowPane[object]] = {}
        """By window number, oldest first."""
        self.shown: WindowPane[object] | None = None

    @property
    def layout(self) -> Layout:
        return self._stage

    def show_windows(self, windows: list[Window[object]]) -> None:
        """Make the panes agree with what the program has opened."""
        numbers = {window.number for window in windows}
        for number in [number for number in self.panes if number not in numbers]:
            self.panes.pop(number).remove()
        for window in windows:
            if window.number not in self.panes:
                self._put(window.number, make_window(window, self.look))
        if self.shown not in self.panes.values():
            self.show(next(reversed(self.panes.values()), None))

    def break_window(self, pane: WindowPane[object], error: Exception) -> None:
        """Show the reason in place of a window that failed while being drawn."""
        if pane in self.panes.values():
            pane.remove()
            self._put(pane.window.number, BrokenPane(pane.window, self.look, error))

    def _put(self, number: int, pane: WindowPane[object]) -> None:
        self.panes[number] = pane
        self.mount(pane)
        self.show(pane)

    def show(self, pane: WindowPane[object] | None) -> None:
        """Bring a window to the front."""
        self.shown = pane
        if pane is not None:
            pane.refresh(layout=True)
            pane.touch()
            if self.overlay is None:
                self.give_keyboard(pane)

    def tabs(self, pane: Pane, room: int) -> list[Piece]:
        panes = list(self.panes.values())
        tabs = [Tab("", each.label, each.has_news, partial(self.show, each)) for each in panes]
        return (
            tab_pieces(self.look, tabs, panes.index(pane), focused=True, room=room, list_all=self.show_next)
            if pane in panes
            else []
        )

    def show_next(self) -> None:
        """Bring the next window to the front."""
        panes = list(self.panes.values())
        if self.shown in panes:
            self.show(panes[(panes.index(self.shown) + 1) % len(panes)])

    @property
    def focused_pane(self) -> Pane | None:
        return self.shown

    def give_keyboard(self, pane: Pane) -> None:
        pane.focus(scroll_visible=False)


class WindowApp(TerminalApp):
    """Shows the windows of one program until it has ended."""

    CSS = "Screen { layout: vertical; overflow: hidden; }"
    ENABLE_COMMAND_PALETTE = False
    BINDINGS = [
        Binding(key, f"do('{name}')", show=False, priority=True)
        for key, name in (
            ("ctrl+c", "interrupt"),
            ("ctrl+q", "end"),
            ("f1", "help"),
            ("f3", "next"),
            ("f5", "log"),
            ("f6", "glyphs"),
            ("f7", "language"),
            ("ctrl+z", "suspend"),
        )
    ]

    def __init__(self, foreground: Foreground, look: Look, fps: float = DEFAULT_FPS) -> None:
        super().__init__(ansi_color=not look.has_shades)
        self.foreground = foreground
        self.look = look
        self.frames = Frames(self.draw_frame, fps, congested=self.is_congested, failed=self.frame_failed)
        self.look.wake, self.look.wake_after = self.frames.wake, self.frames.wake_after
        self.stage = WindowStage(look)
        looks = Looks(self, look)
        self.deeds: dict[str, Callable[[], object]] = {
            "end": self.do_end,
            "interrupt": self.do_interrupt,
            "help": self.do_help,
            "log": self.do_log,
            "next": self.do_next,
            "suspend": self.do_suspend,
            "glyphs": looks.next_glyphs,
            "language": looks.next_language,
        }
        """The handlers of the keys, by the names in BINDINGS."""
        self.bottom = Bar(look, self.bottom_pieces, name="bottom")
        self._version = -1
        self._presses = 0
        self._hint, self._hint_until = "", 0.0

    def compose(self) -> ComposeResult:
        yield self.stage
        yield self.bottom

    def on_mount(self) -> None:
        # As on the desktop: the program's thread shares the interpreter with the screen.
        sys.setswitchinterval(0.001)
        self.frames.attach()
        self.foreground.scheduler.on_activity = self.frames.wake
        self.foreground.backlog.on_change = self.frames.wake
        self.app_resume_signal.subscribe(self, self._resumed)
        self.set_interval(0.25, self._look)
        self.begin_pictures(os.environ.get("DAY6_GLYPHS"))
        self._look()

    async def on_unmount(self) -> None:
        self.frames.detach()
        self.foreground.scheduler.on_activity = None

    def _look(self) -> None:
        """Exit when the program has ended, even if nothing wakes the frames any more."""
        if self.foreground.over:
            self.exit()
        else:
            self.frames.wake()

    def failed(self, error: Exception) -> None:
        fail(self, error)

    def on_terminal_trouble(self, event: TerminalTrouble) -> None:
        self._hint, self._hint_until = self.look.texts(event.key), time.monotonic() + HINT_SECONDS
        self.frames.wake()

    def _resumed(self, app: App[Any]) -> None:
        """`fg`: the shell has written over everything."""
        for pane in self.stage.query(Pane):
            pane.touch()
        self.screen.refresh()

    def draw_frame(self) -> bool:
        """Pull what is new into the panes; return True while something is animated."""
        now = time.monotonic()
        display = self.foreground.display
        if self.foreground.over:
            self.exit()
            return False
        if display.version != self._version:
            self._version = display.version
            self.stage.show_windows(display.windows)
        again = self.draw_in_frame(lambda: self._pull_all(now))
        self.send_pictures()
        return again

    def _pull_all(self, now: float) -> bool:
        again = False
        pane = self.stage.shown
        if pane is not None:
            try:
                pane.measure()
                again = pane.pull(now)
            except Exception as error:
                self.window_failed(pane, error)
        self.bottom.pull(now)
        return again

    def frame_failed(self, error: Exception) -> None:
        """Report an error of the screen itself, and let the program go on."""
        _log.error("a frame failed", exc_info=error)
        from day6_tui.overlays.message import ErrorModal

        if not isinstance(self.stage.overlay, ErrorModal):
            self.stage.open_overlay(ErrorModal(self.look, fault(error)))

    @on(WindowPane.Failed)
    def drop_broken_window(self, event: WindowPane.Failed) -> None:
        self.window_failed(event.pane, event.error)

    def window_failed(self, pane: WindowPane[object], error: Exception) -> None:
        """Replace a window that cannot be drawn by the reason; its program goes on."""
        _log.warning("a window failed", exc_info=error)
        self.stage.break_window(pane, error)

    def bottom_pieces(self, width: int) -> tuple[list[Piece], list[Piece]]:
        """The newest line of the log, and the keys; these alone have the whole line, as on the desktop."""
        look = self.look
        pane = self.stage.shown
        keys = [KeyHint(key, look.texts(f"single.{part}"), self.deeds[part]) for key, part in keys_beside(pane)]
        if len(self.stage.panes) > 1:
            keys.insert(1, KeyHint("F3", look.texts("single.next"), self.deeds["next"]))
        if pane is not None:
            keys = [*keys[:1], *(KeyHint(key, name, weight=5) for key, name in pane.key_hints()), *keys[1:]]
        notice = time.monotonic() < self._hint_until
        said = self._hint if notice else _STAMP.sub("", self.foreground.backlog.last)
        said = "".join(char if char.isprintable() else " " for char in said)
        if not said:
            return key_pieces(look, keys, width), []
        right = key_pieces(look, keys, width // 2)
        room = max(0, width - 1 - sum(cell_len(piece.text) for piece in right))
        said = clip(said, room - 1, look.glyphs.ellipsis)
        return [Piece(f" {said} ", look.colours.hint) if notice else Piece(f" {said}", look.colours.bar)], right

    # -- keys ----------------------------------------------------------------------------------------------------------

    async def action_do(self, name: str) -> None:
        """Textual's entry: a key of BINDINGS was pressed."""
        self.deeds[name]()
        self.frames.wake()

    def action_help_quit(self) -> None:
        """Ctrl-C has a meaning here."""

    def on_key(self, event: events.Key) -> None:
        """What no window wanted."""
        if event.key == "q" and self.stage.overlay is None:
            self.do_end()

    def do_end(self) -> None:
        """Close the windows as a click on their crosses does; a program that ignores that is ended."""
        if self._presses == 0:
            for pane in list(self.stage.panes.values()):
                pane.close()
            if self.stage.overlay is not None:
                return  # a window asks first
        self._insist()

    def do_interrupt(self) -> None:
        """Ctrl-C goes to the program, not to what is open over its window."""
        if self.stage.overlay is not None:
            self.stage.close_overlay()
            return
        if self._presses == 0:
            self.foreground.program.interrupt()
        self._insist()

    def _insist(self) -> None:
        self._presses += 1
        if self._presses > 1:
            self.foreground.program.terminate()
        if self._presses > 2:
            self.foreground.program.kill()

    def do_help(self) -> None:
        """Explain the window."""
        from day6_tui.overlays.manual import Manual

        if isinstance(self.stage.overlay, Manual):
            self.stage.close_overlay()
        elif self.stage.shown is not None:
            named = keys_beside(self.stage.shown) + MORE_KEYS
            keys = [(key, self.look.texts("help.single." + part)) for key, part in named]
            self.stage.open_overlay(Manual(self.look, self.stage.shown, keys))

    def do_log(self) -> None:
        """Show what the program has written."""
        from day6_tui.overlays.message import LogModal

        if isinstance(self.stage.overlay, LogModal):
            self.stage.close_overlay()
        else:
            lines = self.foreground.backlog.lines() or [self.look.texts("single.no_log")]
            self.stage.open_overlay(LogModal(self.look, self.look.texts("single.log"), lines))

    def do_next(self) -> None:
        """Bring the program's next window to the front."""
        self.stage.show_next()

    def do_suspend(self) -> None:
        """Ctrl-Z: the shell gets its terminal back, and the program stands still, until `fg`."""
        self.action_suspend_process()


def show(foreground: Foreground) -> None:
    """Draw the program's windows on this terminal until they are gone (`day6_core.session.local.Show`)."""
    keep_log_off_the_screen()
    look = make_look(Options(glyphs=os.environ.get("DAY6_GLYPHS")), settings=Settings())
    app = WindowApp(foreground, look)
    foreground.ending.restore_terminal = lambda: give_back(app)
    app.run()
    if app.return_code and not foreground.over:
        _end_without_screen(foreground)


def _end_without_screen(foreground: Foreground) -> None:
    """The terminal is gone or cannot be drawn on: end the program in an orderly way, then by force."""
    for end in (foreground.program.terminate, foreground.program.kill):
        foreground.scheduler.call_soon_threadsafe(end)
        given_up = time.monotonic() + GRACE
        while not foreground.over and time.monotonic() < given_up:
            time.sleep(0.02)
