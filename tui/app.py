# ruff: noqa: E402 - two things have to be settled before Textual is imported
"""The application: wires desk, panes, bars and actions together, and owns nothing else.

`run(options)` is what the command line calls. `options` has `scene`, `robot`, `lang`, `glyphs`, `fps`, `home`, `listen`,
`connect`, `secret` (all may be None) and `reduced_motion`.
"""

from __future__ import annotations

import contextlib
import contextvars
import logging
import os
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

# Read by Textual at import: how often at most it writes to the terminal.
os.environ.setdefault("TEXTUAL_FPS", "30")

from day6_tui.tui import lean

lean.import_asyncio()

import asyncio

from textual import events
from textual.app import App, ComposeResult
from textual.binding import Binding
from textual.driver import Driver
from textual.screen import Screen

from day6_tui.core.session.harmless import one_line
from day6_tui.core.shell.heap import keep_heap_small
from day6_tui.core.whole_file import append_private
from day6_tui.tui import actions, chops, departure, output
from day6_tui.tui.app_actions import AppActions
from day6_tui.tui.bars import Bar, KeyHint, key_pieces
from day6_tui.tui.colours import colours
from day6_tui.tui.desktop import Desktop
from day6_tui.tui.doors import door_words
from day6_tui.tui.frames import Frames
from day6_tui.tui.glyphs import choose, terminal_environ
from day6_tui.tui.keyboard import BadInput, leave, sturdy
from day6_tui.tui.locale import Texts, detect
from day6_tui.tui.look import Look
from day6_tui.tui.machine import Machine
from day6_tui.tui.overlay import MessageOverlay
from day6_tui.tui.pane import Piece
from day6_tui.tui.scenes import SCENES, Player
from day6_tui.tui.survival import TYPED, survive
from day6_tui.tui.terminal_pane import TerminalPane
from day6_tui.tui.welcome import WelcomePane
from day6_tui.tui.windows import WindowPane

if TYPE_CHECKING:
    from day6_tui.core.session.ending import Ending

chops.install()
output.install()
_log = logging.getLogger(__name__)

DEFAULT_FPS = 30.0
DOOR_SECONDS = 1.0
"""Between looks at the doors to other machines, where there are any."""
NOTICE_SECONDS = 10.0
LINK_SECONDS = 0.4
"""After the first frame: the prompt comes before the link, whose library takes 50 ms of a core and 11 MB."""

BAR_NAMES = {"turtlesim": "turtle", "world": "world", "car": "car"}
"""Kind of a window -> what the top bar calls the desk while there is one."""

HINT_SECONDS = 15.0
"""For what is said only once."""

ARROWS = ("up", "down", "left", "right")

WAITING_OUTPUT = 3
"""Writes the terminal has not taken yet from which the next frame is put off."""


def make_look(options: Any, environ: Any = None) -> Look:
    """Glyphs, colours and language for the options and the terminal.

    Raises KeyError for unknown glyphs, ValueError for a language.
    """
    environ = terminal_environ() if environ is None else environ
    glyphs = choose(getattr(options, "glyphs", None), environ)
    language = getattr(options, "lang", None) or detect(environ, wide_glyphs=glyphs.chinese)
    if not glyphs.unicode:
        language = "en"  # Chinese cannot be written there at all
    sixteen = environ.get("TERM") == "linux" and not environ.get("COLORTERM")
    look = Look(
        glyphs,
        colours(sixteen=sixteen, colourless=bool(environ.get("NO_COLOR"))),
        Texts(language, plain=not glyphs.unicode),
    )
    look.reduced_motion = bool(getattr(options, "reduced_motion", False))
    return look


class DeskScreen(Screen[None]):
    """Textual's screen, whose own background is never seen."""

    BLANK = True


class Day6App(AppActions, App[None]):
    """The desktop. `desk` may be given (tests); otherwise it is made after the first frame."""

    CSS = "Screen { layout: vertical; overflow: hidden; }"
    ENABLE_COMMAND_PALETTE = False
    ALLOW_SELECT = (
        False  # terminals have their own way to mark text; Textual's fails on a widget that is just going away
    )
    BINDINGS = [Binding(key, f"do('{name}')", show=False, priority=True) for key, name in actions.bindings()]
    TITLE = "day6-tui"

    def __init__(self, options: Any = None, *, desk: Any = None, look: Look | None = None) -> None:
        super().__init__()
        self.ending: Ending | None = None
        """The end of the process, where this application is all of it."""
        self.leave_soon: Callable[[], object] | None = None
        """Leaves the application, from any thread; None until there is something to leave."""
        self.options = options
        self.look = make_look(options) if look is None else look
        fps = getattr(options, "fps", None)
        fps = DEFAULT_FPS if fps is None else float(fps)
        self.frames = Frames(
            self.draw_frame, fps, work=self.read_flood, congested=self._congested, failed=self.frame_failed
        )
        self.look.wake = self.frames.wake
        self.machine = Machine(desk, wake=self.frames.wake)
        self.terminals = TerminalPane(self.look)
        self.terminals.other_pieces = lambda: self.desktop.other_tabs(self.terminals)
        self.terminals.on_key_before = self.key_before
        self.terminals.key_back = self.key_to_terminal
        self.welcome = WelcomePane(self.look, self.chosen)
        self.welcome.on_typed = self.typed_at_welcome
        self.welcome.on_pasted = self.pasted_at_welcome
        self.desktop = Desktop(self.look, self.terminals, self.welcome)
        self.top = Bar(self.look, self.top_pieces, name="top")
        self.bottom = Bar(self.look, self.bottom_pieces, name="bottom")
        self.player: Player | None = None
        self.stage: Any = None
        """The terminal a scene types into."""
        self.queued_keys: list[events.Key] = []
        self.notice = ""
        self._notice_until = 0.0

    def get_driver_class(self) -> type[Driver]:
        return sturdy(super().get_driver_class())

    def get_default_screen(self) -> Screen[Any]:
        return DeskScreen(id="_default")

    def compose(self) -> ComposeResult:
        yield self.top
        yield self.desktop
        yield self.bottom

    # -- life ----------------------------------------------------------------------------------------------------------

    def on_mount(self) -> None:
        # Threads of programs share the interpreter with the screen; with shorter turns keys stay quick (tui-tech.md §3.2).
        sys.setswitchinterval(0.001)
        self.frames.attach()
        self._attend_the_end()
        self.desktop.focus_pane(self.welcome if getattr(self.options, "scene", None) is None else self.terminals)
        self.call_after_refresh(self._open_desk)

    def _open_desk(self) -> None:
        """Start the simulated machine; after the first frame, because a screen to look at comes first."""
        try:
            self.machine.open(self.options)
        except OSError as error:
            path = error.filename or getattr(self.options, "home", None) or ""
            from rich.text import Text

            message = self.look.texts("error.home", path=path, reason=error.strerror or error)
            self.exit(return_code=1, message=Text(one_line(message)))  # a plain str would be read as Rich's markup
            return
        self.new_terminal()
        self.set_timer(LINK_SECONDS, self.machine.open_link)
        if self._has_doors():
            self.set_interval(DOOR_SECONDS, self.frames.wake)
        if (endpoint := getattr(self.options, "listen", None)) and not getattr(self.options, "secret", None):
            self.say(self.look.texts("notice.open", port=endpoint.rpartition(":")[2]), NOTICE_SECONDS)
        scene = getattr(self.options, "scene", None)
        if scene is not None:
            self.start_scene(scene)
        elif self.desktop.focused_pane() is not self.terminals:  # else a quick key has gone there already
            self.desktop.focus_pane(self.welcome)
        self.terminals.take_early_keys()
        self.frames.wake()
        if not self.frames.rate:
            self.frames.step()

    def _attend_the_end(self) -> None:
        """A closed terminal window or `kill` ends the desktop in order, with all its programs."""
        if self.ending is None:
            return
        loop = asyncio.get_running_loop()
        context = contextvars.copy_context()

        def soon(function: Callable[[], object]) -> None:
            with contextlib.suppress(RuntimeError):  # the loop was closed: this has been left
                loop.call_soon_threadsafe(function, context=context)

        def leave() -> None:
            if not self._exit:  # else with the status and the message that are given already
                self.end_by_signal()

        self.leave_soon = lambda: soon(leave)
        self.ending.nudge = lambda: soon(lambda: None)
        departure.attend_stops(self, soon)
        if self.ending.begun:  # a signal came before there was an application to leave
            self.exit()

    def exit(self, result: None = None, return_code: int = 0, message: Any = None) -> None:
        """Leave the desktop; from here on everything has its time."""
        if self.ending is not None:
            output.let_go()
            self.ending.begin()
        super().exit(result, return_code, message)

    def _handle_exception(self, error: Exception) -> None:
        if self.is_headless:
            super()._handle_exception(error)
        elif self._exit:
            _log.warning("something failed on the way out", exc_info=error)  # a key for a pane that is gone
        else:
            leave(self, error)

    async def on_event(self, event: events.Event) -> None:
        if isinstance(event, TYPED):
            if self._exit:
                return  # on the way out keys have nobody to go to
            self.desktop.keep_keyboard()
        await survive(self, event, super().on_event(event))

    def on_bad_input(self, event: BadInput) -> None:
        """The terminal has another code than the desktop: what is typed in it cannot be read."""
        self.say(self.look.texts(event.key), HINT_SECONDS)

    def on_cursor_position(self, event: events.CursorPosition) -> None:
        """xterm and its kin send for Shift+F3 what also reports a cursor at 1;2, and Textual takes it for that."""
        if (event.x, event.y) == (1, 0):
            self.do_previous()
            self.frames.wake()

    async def on_unmount(self) -> None:
        self.frames.detach()

    def _congested(self) -> bool:
        writer = getattr(self._driver, "_writer_thread", None)
        queue = getattr(writer, "_queue", None)
        return queue is not None and queue.qsize() > WAITING_OUTPUT

    # -- frames --------------------------------------------------------------------------------------------------------

    def read_flood(self) -> float | None:
        """Between frames: read what programs print without end."""
        return self.terminals.read_flood() if self.machine.desk is not None else None

    def draw_frame(self) -> bool:
        """Pull what is new into the panes. True while something moves by itself."""
        now = time.monotonic()
        again = self._play(now)
        machine = self.machine
        if machine.desk is not None:
            if (windows := machine.changed_windows()) is not None:
                key = actions.BY_ID["windows"].label
                for unseen in self.desktop.show_windows(windows):
                    self.say(self.look.texts("window.hidden", title=unseen.label, key=key))
            self._bury_ended_terminals()
            self._show_opened_terminals()
            shown = self.desktop.shown()
            for pane in (self.terminals, *self.desktop.panes.values()):
                if pane is self.terminals or pane in shown:
                    try:
                        pane.measure()
                        again = pane.pull(now) or again
                    except Exception as error:
                        self.window_failed(pane, error)
            self.terminals.place_cursor()
            self.desktop.yield_to_full_terminals()
        if self._notice_until and now > self._notice_until:
            self.notice, self._notice_until = "", 0.0
        again = again or bool(self._notice_until)
        self.top.pull(now)
        self.bottom.pull(now)
        return again

    def _play(self, now: float) -> bool:
        if self.player is None:
            return False
        if self.machine.desk is None:
            return True  # a quick key: the desk comes right after the first frame
        self.player.advance(now)
        if not self.player.done:
            return True
        self.player = None
        if self.stage in self.terminals.views:
            for event in self.queued_keys:
                self.terminals.type_key(self.stage, event)
        self.queued_keys.clear()
        return False

    def frame_failed(self, error: Exception) -> None:
        """Something in the desktop itself is broken: say so, and keep programs and terminals going."""
        if self.is_headless:
            self._handle_exception(error)
            return
        if self._exit:
            return  # the panes are going away
        _log.error("a frame failed", exc_info=error)
        if not isinstance(self.desktop.overlay, MessageOverlay):
            self.desktop.open_overlay(MessageOverlay(self.look, f"{type(error).__name__}: {error}"))

    def window_failed(self, pane: Any, error: Exception) -> None:
        """A window that cannot be drawn is replaced by the reason; everything else goes on."""
        if pane not in self.desktop.panes.values():
            raise error
        _log.warning("a window failed", exc_info=error)
        self.desktop.break_window(pane, error)

    def _bury_ended_terminals(self) -> None:
        for view in [view for view in self.terminals.views if view.terminal.closed]:
            self.terminals.forget(view)
            # Ending what it still runs may take seconds; the desktop does not wait for that.
            threading.Thread(target=view.terminal.close, name="day6-close-terminal", daemon=True).start()
        if not self.terminals.views and self.is_running and self.machine.desk is not None:
            self.new_terminal()

    def _show_opened_terminals(self) -> None:
        """Show the terminals that programs have opened (`xterm -e …`)."""
        for terminal in list(self.machine.desk.terminals):
            if terminal not in self.terminals.known:
                self.terminals.add(terminal)
                self.desktop.focus_pane(self.terminals)

    # -- bars ----------------------------------------------------------------------------------------------------------

    def say(self, text: str, seconds: float = 3.0) -> None:
        """Show a short notice in the key bar."""
        self.notice = text
        self._notice_until = time.monotonic() + seconds
        self.frames.wake()

    def top_pieces(self) -> tuple[list[Piece], list[Piece]]:
        look, texts, machine = self.look, self.look.texts, self.machine
        colours, glyphs = look.colours, look.glyphs
        kinds = {pane.window.kind for pane in self.desktop.panes.values()}
        name = next((f"bar.{name}" for kind, name in BAR_NAMES.items() if kind in kinds), "bar.desk")
        left = [
            Piece(" day6 ", colours.bar_strong),
            Piece(f"{glyphs.chevron} ", colours.bar_muted),
            Piece(f"{texts(name)}   ", colours.bar_strong),
        ]
        left += self._door_pieces()
        if machine.desk is None:
            left.append(Piece(texts("bar.starting"), colours.bar_muted))
        else:
            nodes, topics = machine.counts()
            left.append(Piece(texts("bar.nodes", count=nodes), colours.bar))
            left.append(Piece(f" {glyphs.dot} {texts('bar.topics', count=topics)}", colours.bar))
        mark = glyphs.paused if machine.paused else glyphs.running
        time_style = colours.hint if machine.paused else colours.bar
        speed = (
            texts("bar.paused")
            if machine.paused
            else f"{machine.speed:g}×"
            if glyphs.unicode
            else f"{machine.speed:g}x"
        )
        right = [
            Piece(f" {texts('bar.language')} " if glyphs.chinese else "", colours.bar_muted, self.do_language),
            Piece(f" {mark} {speed} ", time_style, self.do_pause),
            Piece(f" {texts('bar.help')} ", colours.bar, self.do_help),
        ]
        return left, right

    def _door_pieces(self) -> list[Piece]:
        """How it stands with other machines; a click opens the inspector, which says it at length."""
        machine, colours = self.machine, self.look.colours
        if machine.desk is None or not self._has_doors():
            return []
        pieces = []
        for door in machine.doors():
            key, fine, words = door_words(door, self.look.glyphs.ellipsis)
            style = colours.bar if fine else colours.warning
            pieces.append(Piece(f"{self.look.texts(key, **words)}   ", style, self.do_inspector))
        return pieces

    def _has_doors(self) -> bool:
        return any(getattr(self.options, name, None) for name in ("listen", "connect"))

    def bottom_pieces(self) -> tuple[list[Piece], list[Piece]]:
        look, texts = self.look, self.look.texts
        if self.notice:
            return [Piece(f" {self.notice} ", look.colours.hint)], []
        if self.player is not None:
            return [Piece(f" {texts('bar.playing')} ", look.colours.hint)], []
        keys = [KeyHint(key, name) for key, name in self.desktop.focused_pane().key_hints()]
        for action in actions.bar_actions():
            name = "action.resume" if action.id == "pause" and self.machine.paused else f"action.{action.id}"
            keys.append(KeyHint(action.label, texts(name), getattr(self, action.handler), action.weight))
        return key_pieces(look, keys, self.bottom.extent.width), []

    # -- scenes --------------------------------------------------------------------------------------------------------

    def chosen(self, does: str) -> None:
        """An entry of the welcome pane was chosen."""
        if does.startswith("action."):
            getattr(self, actions.BY_ID[does.removeprefix("action.")].handler)()
        elif does.startswith("type:"):
            self.use_idle_terminal().terminal.send(does.removeprefix("type:"))
            self.desktop.focus_pane(self.terminals)
        else:
            self.welcome.show_guide()
            self.desktop.focus_pane(self.terminals)
        self.frames.wake()

    def typed_at_welcome(self, event: events.Key) -> None:
        """Somebody types a command where there is no terminal: it goes to one that waits for a command."""
        self._leave_welcome()
        self.terminals.on_key(event)

    def pasted_at_welcome(self, text: str) -> None:
        """The same with what comes from the clipboard."""
        self._leave_welcome()
        self.terminals.paste(text)

    def _leave_welcome(self) -> None:
        self.welcome.show_guide()
        if self.desktop.focused_pane() is not self.terminals:
            if self.machine.desk is not None:
                self.use_idle_terminal()
            self.desktop.focus_pane(self.terminals)
        self.frames.wake()

    def start_scene(self, name: str) -> None:
        """Type the commands of a scene."""
        scene = SCENES[name]
        self.welcome.show_guide()
        self.desktop.focus_pane(self.terminals)
        if scene.steps:
            visibly = bool(self.frames.rate) and not self.look.reduced_motion
            values = self.machine.robot_words(self.options) if scene.needs_robot else {}
            self.player = Player(scene, self, values=values, visibly=visibly)
            self.stage = None
            self.queued_keys.clear()
        self.frames.wake()

    def on_key(self, event: events.Key) -> None:
        """A key that no pane wanted."""
        pane = self.desktop.focused_pane()
        if event.key in ARROWS and isinstance(pane, WindowPane) and pane.window.kind == "turtlesim":
            self.tell_where_arrows_drive()

    def key_before(self, event: events.Key) -> bool:
        """Keys where a scene types: Esc stops it, others wait until it has finished, which is then at once."""
        if self.player is None or (self.stage is not None and self.terminals.view is not self.stage):
            view = self.terminals.view
            if event.key in ARROWS and view is not None and view.only_echoes:
                self.tell_where_arrows_drive()
            return False
        if event.key == "escape":
            self.player = None
            self.queued_keys.clear()
        else:
            self.player.hurry()
            self.queued_keys.append(event)
        return True


class _LogFile(logging.FileHandler):
    """A log for this user alone, which goes on without a word when the disk is full: the screen is no place for that."""

    def _open(self) -> TextIO:  # type: ignore[override]
        append_private(Path(self.baseFilename), b"")
        return open(self.baseFilename, "a", encoding=self.encoding)

    def handleError(self, record: logging.LogRecord) -> None:
        """Called instead of raising when a line could not be written."""


def keep_log_off_the_screen(environ: Any = None) -> None:
    """Send the log of our own parts to the file $DAY6_LOG, or nowhere: Python's default, stderr, is the screen."""
    file = (os.environ if environ is None else environ).get("DAY6_LOG")
    handler: logging.Handler = logging.NullHandler()
    if file:
        try:
            handler = _LogFile(file, encoding="utf-8")
        except OSError as error:
            print(f"day6-tui: DAY6_LOG: {file}: {error.strerror or error}", file=sys.stderr)
    handler.setFormatter(logging.Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s"))
    logging.getLogger().addHandler(handler)


def run(options: Any) -> int:
    """Open the desktop and return its exit status when the user has left it and every program has ended."""
    keep_heap_small()
    keep_log_off_the_screen()
    try:
        app = Day6App(options)
    except (KeyError, ValueError) as error:
        print(f"day6-tui: {error}", file=sys.stderr)
        return 2
    # For programs on the desk that explain something: new terminals pass it on.
    os.environ["DAY6_LANG"] = app.look.texts.language
    app.ending = ending = departure.ending_of(app)
    ending.listen(sys.stdin.fileno())
    try:
        app.run()
    finally:
        ending.begin()
        app.machine.close()
        ending.over()
    return ending.status or app.return_code or 0
