# ruff: noqa: E402 - two things have to be settled before Textual is imported
"""The application: wires desk, panes, bars and actions together, and owns nothing else.

`run(options)` is what the command line calls.
"""

from __future__ import annotations

import contextlib
import contextvars
import gc
import logging
import os
import sys
import threading
import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from day6_core.reason import fault, reason

# Read by Textual at import: how often at most it writes to the terminal.
os.environ.setdefault("TEXTUAL_FPS", "30")

from day6_tui import lean

lean.import_asyncio()

import asyncio

from textual import events, on
from textual.app import ComposeResult
from textual.binding import Binding
from textual.message import Message
from textual.widget import Widget

from day6_core.language import language_of
from day6_core.session.harmless import one_line
from day6_core.shell.process.heap import keep_heap_small
from day6_core.virtual import surroundings
from day6_core.virtual.surroundings import in_real_time
from day6_tui import actions
from day6_tui.appearance.changing import Looks
from day6_tui.appearance.colours import colours
from day6_tui.appearance.glyphs import (
    GLYPH_SETS,
    choose,
    detect,
    is_colourless,
    sends_alt,
    speaks_utf8,
    terminal_environ,
)
from day6_tui.appearance.look import Look
from day6_tui.appearance.themes import NAMES
from day6_tui.bars.bars import Bar
from day6_tui.bars.key_line import KeyLine
from day6_tui.bars.notices import HINT_SECONDS, NOTICE_SECONDS, Notices
from day6_tui.bars.top_line import TopLine
from day6_tui.classes.box import BOX_CSS, BREAKPOINTS
from day6_tui.classes.pupil import Classroom
from day6_tui.distribution_choice import SETTING, start_again
from day6_tui.features.detachment import Detachment
from day6_tui.features.distributions import Distributions
from day6_tui.features.explaining import Explaining
from day6_tui.features.guidance import Guidance
from day6_tui.features.leaving import Leaving
from day6_tui.features.lessons import LessonAsked, Lessons
from day6_tui.features.recording import Recording
from day6_tui.features.rewind import Rewind, begin_again
from day6_tui.features.saved_desktop import SavedDesktop
from day6_tui.features.scene_play import ScenePlay
from day6_tui.features.welcome import WelcomePane
from day6_tui.features.world_time import WorldTime
from day6_tui.locale import Texts
from day6_tui.machine import Machine
from day6_tui.options import Options
from day6_tui.panes.arranging import Arranging
from day6_tui.panes.desktop import Desktop
from day6_tui.panes.pane import Piece
from day6_tui.panes.switching import Switching
from day6_tui.parts import Parts
from day6_tui.screen import departure
from day6_tui.screen.frames import Frames
from day6_tui.screen.log_file import keep_log_off_the_screen
from day6_tui.screen.trouble import TerminalTrouble
from day6_tui.settings import Settings
from day6_tui.terminal_app import TerminalApp
from day6_tui.terminals.pane import ARROWS, TerminalPane
from day6_tui.terminals.shown import Terminals
from day6_tui.textual_private import output
from day6_tui.textual_private.access import driver_of, fail, is_leaving
from day6_tui.textual_private.survival import TYPED
from day6_tui.turns import LASTING_SECONDS, Turns
from day6_tui.windows import WindowPane

if TYPE_CHECKING:
    from rich.console import RenderableType
    from textual.notifications import Notification

    from day6_core.session.ending import Ending
    from day6_core.shell.desk import Desk
    from day6_tui.classes.link import ClassLink

_log = logging.getLogger(__name__)

DEFAULT_FPS = 30.0
TITLE_SECONDS = 0.2
"""Between two looks whether titles have changed: that costs as much as a moving turtle."""

BAR_SECONDS = 0.1
"""Between two looks whether the bars have changed."""

YOUNG_OBJECTS = 5_000
"""New objects after which Python looks for circles among them."""

WHILE_ASKED = ("help", "language", "theme", "glyphs", "detach", "copy")
"""What keys may do while a question waits for its answer."""

SAVE_SECONDS = 20.0
"""How much of the session a crash may cost."""

DOOR_SECONDS = 1.0
"""Seconds between checks of the connections to other machines, if there are any."""
LINK_SECONDS = 0.4
"""After the first frame: the prompt comes before the link, whose library costs 50 ms of CPU time and 11 MB."""


def make_look(options: Options, environ: Mapping[str, str] | None = None, settings: Settings | None = None) -> Look:
    """Glyphs, colours and language for the options, what the user chose before, and the terminal.

    Raises KeyError for unknown glyphs or an unknown theme, ValueError for a language.
    """
    environ = terminal_environ() if environ is None else environ
    glyphs = choose(options.glyphs, environ)
    chinese = glyphs.chinese or GLYPH_SETS[detect(environ)].chinese
    letters = speaks_utf8(environ)
    wanted = options.lang or language_of(environ, wide_glyphs=chinese or not letters)
    language = wanted if glyphs.unicode or letters else "en"  # Chinese cannot be written there at all
    sixteen = environ.get("TERM") == "linux" and not environ.get("COLORTERM")
    remembered = settings.text("theme") if settings is not None else ""
    theme = options.theme or (remembered if remembered in NAMES else NAMES[0])
    look = Look(
        glyphs,
        colours(theme, sixteen=sixteen, colourless=is_colourless(environ)),
        Texts(language, plain=not glyphs.unicode),
        letters=letters,
        chinese=chinese,
        alt=sends_alt(environ),
        remark="glyphs.no_chinese" if language != wanted else "",
    )
    look.reduced_motion = options.reduced_motion
    return look


def _class_link(options: Options) -> ClassLink | None:
    if options.part is None:
        return None
    from day6_tui.classes.link import link_of

    return link_of(options.part)


class Day6App(TerminalApp):
    """The desktop. `desk` may be given (tests); otherwise it is made after the first frame."""

    CSS = f"""
    Screen {{ layout: vertical; overflow: hidden; }}
    {BOX_CSS}
    Toast {{ background: $hint; color: $hint-text; border: none; }}
    Toast.-information .toast--title {{ color: $hint-text; }}
    """
    HORIZONTAL_BREAKPOINTS = BREAKPOINTS
    ENABLE_COMMAND_PALETTE = False
    BINDINGS = [
        *(Binding(key, f"do('{name}')", show=False, priority=True) for key, name in actions.bindings()),
        *(Binding(key, call, show=False, priority=True) for key, call in actions.pane_bindings()),
        Binding("ctrl+p", "do('palette')", show=False),  # in a terminal it is the shell's: the line before
    ]
    TITLE = "day6-tui"

    def __init__(self, options: Options | None = None, *, desk: Desk | None = None, look: Look | None = None) -> None:
        self.settings = settings = Settings()
        options = Options() if options is None else options
        look = make_look(options, settings=settings) if look is None else look
        super().__init__(ansi_color=not look.has_shades)
        self.ending: Ending | None = None
        """The end of the process, where this application is all of it."""
        self.leave_soon: Callable[[], object] | None = None
        """Exits the application, from any thread; None until it runs."""
        self.options = options
        self.look = look
        fps = DEFAULT_FPS if options.fps is None else float(options.fps)
        self.frames = Frames(
            self.draw_frame,
            fps,
            work=lambda: self.terminals.read_flood(),
            has_work=lambda: self.terminals.in_flood,
            echo=self.draw_echo,
            congested=self.is_congested,
            blocked=self.is_blocked,
            failed=self.frame_failed,
        )
        look.wake, look.wake_after, look.work_soon = self.frames.wake, self.frames.wake_after, self.frames.work_soon
        self._turns = Turns()
        self._barred = 0.0
        """When the bars were looked at last."""
        self._titled = 0.0
        """When the titles of the panes were looked at last."""
        self.machine = machine = Machine(desk, wake=self.frames.wake)
        self.welcome = WelcomePane(look, last_lesson=lambda: self.lessons.where)
        self.desktop = desktop = Desktop(look, self.welcome)
        self.notices = notices = Notices(look, lambda: self.size.width - 2, self._notify)
        self.terminals = terminals = Terminals(machine, desktop, notices, look)
        self.parts = parts = Parts(look, settings, machine, desktop, notices, terminals)
        self.switching = Switching(parts)
        self.scenes = ScenePlay(parts, options.robot, self._follow_in_world, visibly=fps > 0)
        self.arranging = Arranging(parts)
        self.session = SavedDesktop(parts, self.arranging)
        self.lessons = Lessons(parts, self.arranging, options.lessons)
        self.looks = looks = Looks(self, look)
        self.explaining = Explaining(parts)
        self.detachment = Detachment(self, options.keeper)
        self.class_link = class_link = _class_link(options)
        is_pupil = class_link is not None and not class_link.teaches
        self.classroom = Classroom(self, self._tell, is_possible=self.detachment.is_possible or is_pupil)
        detach = self.detachment.detach if self.detachment.is_possible else None
        self.leaving = Leaving(parts, self, detach, class_link.joined if class_link is not None else lambda: 0)
        self.distributions = Distributions(parts, self.leaving, self.session, self._remember, self.exit, options)
        self.rewind = Rewind(parts, options.past, self._follow_in_world, self.frames.rest, self.exit)
        self.recording = Recording(parts, self, looks, self.leaving.asks)
        self.actions = self._make_actions()
        top = TopLine(
            parts,
            self.actions,
            doors=options.has_doors,
            recording=self.recording.words,
            lesson=lambda: [*self.rewind.pieces(), *self.lessons.pieces()],
            classroom=self._class_pieces,
            offers=self.classroom.offers,
        )
        self.top = Bar(look, top.pieces, name="top")
        self.bottom = Bar(
            look, KeyLine(parts, self.scenes, self.actions, lambda: self.lessons.is_coming()).pieces, name="bottom"
        )

    def _make_actions(self) -> actions.Actions:
        """What can be chosen: offered by whoever does it; what makes no sense here is hidden."""
        registry = actions.Actions()
        for owner in (
            self.terminals,
            self.switching,
            self.scenes,
            self.lessons,
            self.arranging,
            self.recording,
            self.classroom,
            Guidance(self.parts, registry, self.explaining),
            WorldTime(self.parts),
            self.rewind,
        ):
            registry.offer(owner.actions())
        registry.offer(
            {
                "quit": self.leaving.quit,
                "detach": self.detachment.detach,
                "language": self.looks.next_language,
                "theme": self.choose_theme,
                "distro": self.distributions.choose,
                "glyphs": lambda: self.notices.show(self.looks.next_glyphs()),
                "letters": lambda: self.notices.show(self.look.texts("help.action.letters"), NOTICE_SECONDS),
                "motion": self.looks.toggle_motion,
                "class": self.show_class,
            }
        )
        if not self.machine.is_virtual:
            registry.hidden |= {"fastest", "back"}
        if not self.detachment.is_possible:
            registry.hidden.add("detach")
        link = self.class_link
        if link is None or not link.teaches:
            registry.hidden.add("class")
        if not self.classroom.is_possible:
            registry.hidden |= self.classroom.actions().keys() - (set() if link is None else {"stop_showing"})
        if link is None or link.teaches:
            registry.hidden.add("see_shown")
        return registry

    def compose(self) -> ComposeResult:
        yield self.top
        yield self.desktop
        yield self.bottom

    # -- life ----------------------------------------------------------------------------------------------------------

    def on_mount(self) -> None:
        # Threads of programs share the interpreter with the screen; with shorter turns keys stay quick.
        sys.setswitchinterval(0.001)
        self.frames.attach()
        self._attend_the_end()
        self._hear_of_time()
        pane = self.terminals.first_pane()
        self.desktop.focus_pane(self.welcome if self.options.scene is None else pane)
        self.call_after_refresh(self._open_desk)
        self.begin_pictures(self.options.glyphs)

    def _open_desk(self) -> None:
        """Start the simulated machine; after the first frame, so that the user sees a screen as soon as possible."""
        try:
            self.machine.open(self.options)
        except OSError as error:
            path = error.filename or self.options.home or ""
            from rich.text import Text

            message = self.look.texts("error.home", path=path, reason=reason(error))
            self.exit(return_code=1, message=Text(one_line(message)))  # a plain str would be read as Rich's markup
            return
        self.detachment.begin()
        if self.class_link is not None:
            self.class_link.begin(self)
        if self.options.scene is not None or not self.session.restore():
            self.terminals.open()
        elif self.session.in_lesson:
            self.lessons.open()
        self.set_interval(SAVE_SECONDS, self.session.save_meanwhile)
        if surroundings.pace is None:
            self.set_timer(LINK_SECONDS, self.machine.open_link)
        else:
            self.machine.open_link()  # at the same moment of the world each time
        if self.options.has_doors:
            self.set_interval(DOOR_SECONDS, self.frames.wake)
        if (endpoint := self.options.listen) and not self.options.secret:
            part = self.options.part
            key = "notice.open_class" if part is not None and part.is_closed else "notice.open"
            self.notices.show(self.look.texts(key, port=endpoint.rpartition(":")[2]), NOTICE_SECONDS)
        if self.look.remark:
            self.notices.show(self.look.texts(self.look.remark), HINT_SECONDS)
        if self.settings.fault:
            text = self.look.texts("settings.fault", path=self.settings.path, reason=self.settings.fault)
            self.notices.show(one_line(text), NOTICE_SECONDS)
        if self.options.distro is not None:
            self._remember(SETTING, self.options.distro)
        if self.options.record is not None:
            self.recording.begin(self.options.record)
        if self.options.scene is not None:
            self.scenes.start(self.options.scene)
        elif self.options.lessons is not None or self.options.lesson is not None:
            self.lessons.open(self.options.lesson or "", demo=self.options.demo)
        for pane in self.terminals.panes:
            pane.take_early_keys()
        self.lessons.look_back()
        if surroundings.pace is not None:
            surroundings.pace.begin()
            from day6_tui.textual_private.driver import TerminalDriver

            if isinstance(driver := driver_of(self), TerminalDriver):
                self.rewind.play(driver.press_again)
        self.frames.wake()
        if not self.frames.rate:
            self.frames.step()

    def _hear_of_time(self) -> None:
        """Show what virtual time has to say of itself, which would else write over the picture."""
        if surroundings.pace is not None:
            loop, context = asyncio.get_running_loop(), contextvars.copy_context()

            def say(text: str) -> None:
                with contextlib.suppress(RuntimeError):  # the loop was closed
                    loop.call_soon_threadsafe(self.notices.show, one_line(text), NOTICE_SECONDS, context=context)

            surroundings.pace.say = say

    def _tell(self, note: bytes) -> None:
        """Send what this desktop says of itself to all who observe it."""
        self.detachment.tell(note)
        if self.class_link is not None:
            self.class_link.tell(note)

    def _class_pieces(self, short: bool) -> list[Piece]:
        """What pupil or teacher have to see in the top line."""
        pieces = self.classroom.pieces(short)
        return pieces if self.class_link is None else [*pieces, *self.class_link.pieces(short)]

    def show_class(self) -> None:
        """Bring the teacher's view of the class to the front."""
        if self.class_link is not None:
            self.class_link.show(self)

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
            if not is_leaving(self):  # else with the status and the message that are given already
                self.leaving.end_by_signal()

        self.leave_soon = lambda: soon(leave)
        self.ending.wake_main_thread = lambda: soon(lambda: None)
        departure.attend_stops(self, soon)
        if self.ending.begun:  # a signal came before there was an application to leave
            self.exit()

    def exit(self, result: None = None, return_code: int = 0, message: RenderableType | None = None) -> None:
        """Leave the desktop; from here on every step has a deadline."""
        if self.ending is not None:
            output.let_go()
            self.ending.begin()
        if not is_leaving(self) and self.machine.desk is not None and (why := self._last(self.session.save)):
            from rich.console import Group
            from rich.text import Text

            told = Text(one_line(f"day6-tui: {self.look.texts('session.not_kept', reason=why)}"))
            message = told if message is None else Group(message, told)
            return_code = return_code or int(not self.distributions.next)  # which starts the desktop again
        self._last(self.recording.end)
        super().exit(result, return_code, message)

    def _last(self, act: Callable[[], str | None]) -> str:
        """Do something on the way out, which its failure must not bar; return why it failed, or ''."""
        try:
            return act() or ""
        except Exception as error:
            _log.exception("something failed on the way out")
            return fault(error)

    def failed(self, error: Exception) -> None:
        if self.is_headless:
            super().failed(error)
        elif is_leaving(self):
            _log.warning("something failed on the way out", exc_info=error)  # a key for a pane that is gone
        else:
            fail(self, error)

    async def on_event(self, event: events.Event) -> None:
        if isinstance(event, TYPED):
            if is_leaving(self):
                return  # while leaving, there is nothing left to receive keys
            if isinstance(event, events.Key) and event.key == "enter" and self.lessons.keeps_enter():
                self.classroom.keys.forget(event)
                return
            self.desktop.keep_keyboard()
            if event not in self.classroom.keys:
                self.classroom.typed_at = time.monotonic()
        await super().on_event(event)

    async def _hand_over(self, event: events.Event) -> None:
        if self.classroom.keys.may_pass(event):
            await super()._hand_over(event)

    def keyboard(self) -> Widget:
        self.desktop.keep_keyboard()
        return super().keyboard()

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Textual's question before a key is taken: that of the teacher's messages is free as long as none waits."""
        return parameters != ("answer",) or bool(self.classroom.sayings.waiting)

    async def action_do(self, id: str) -> None:  # noqa: A002
        """Textual's entry: a key of the table was pressed."""
        if id == "quit":
            self.leaving.press_quit()
        elif self.desktop.is_asking and id not in WHILE_ASKED:
            return
        elif id == "pause" and self.scenes.player is not None:
            self.scenes.steering.hold()  # of the world, the upper line
        else:
            self.actions[id]()
        self.frames.wake()

    async def action_go_to(self, number: int) -> None:
        """Textual's entry: Alt and a number."""
        self.switching.go_to(number)

    async def action_focus_beside(self, side: str) -> None:
        """Textual's entry: Alt and an arrow."""
        self.switching.focus_beside(side)

    async def action_resize(self, side: str) -> None:
        """Textual's entry: Alt, Shift and an arrow."""
        self.switching.resize(side)

    def _notify(self, text: str, seconds: float) -> None:
        self.notify(one_line(text), timeout=seconds, markup=False)

    def on_resize(self, event: events.Resize) -> None:
        self.call_later(self.classroom.sayings.fit)  # Textual takes the new size after this

    def taken_down(self, box: Notification) -> None:
        self.classroom.sayings.taken_down(box)

    def choose_theme(self) -> None:
        """Offer the themes, and remember the choice."""
        if self.looks.has_choice:
            self.desktop.open_overlay(self.looks.theme_menu(partial(self._remember, "theme")))

    def _remember(self, setting: str, value: str) -> bool:
        """Keep a choice; returns whether that could be done."""
        try:
            self.settings.set(setting, value)
        except OSError as error:
            self.notices.show(self.look.texts("settings.not_kept", reason=reason(error)), NOTICE_SECONDS)
            return False
        return True

    def action_help_quit(self) -> None:
        """Ctrl-C that no pane handles does nothing (Textual would explain how to quit)."""

    def on_terminal_trouble(self, event: TerminalTrouble) -> None:
        self.notices.show(self.look.texts(event.key), HINT_SECONDS)

    def on_cursor_position(self, event: events.CursorPosition) -> None:
        """For Shift+F3, xterm and its relatives send the bytes of a cursor report for 1;2, and Textual takes it for one."""
        if (event.x, event.y) == (1, 0):
            self.actions["previous"]()
            self.frames.wake()

    async def on_unmount(self) -> None:
        self.frames.detach()

    def displays(self) -> bool:
        self.classroom.observed.has_drawn = True
        return not self.detachment.away

    def _write_picture(self, text: str) -> None:
        self.classroom.observed.has_drawn = True
        super()._write_picture(text)

    def lets_in(self, message: Message) -> bool:
        return self.rewind.lets_in(message)

    # -- frames --------------------------------------------------------------------------------------------------------

    def key_read(self) -> None:
        super().key_read()
        self._turns.typed({os.getpid(), threading.get_native_id(), *self.machine.threads})

    def echoes_keys(self) -> bool:
        return isinstance(self.desktop.focused_pane, TerminalPane)

    def draw_echo(self) -> bool:
        """Between frames: draw what was typed into the terminal with the keyboard, and nothing else."""
        pane = self.desktop.focused_pane
        if self.detachment.away or not isinstance(pane, TerminalPane) or not pane.is_mounted:
            return False
        return self.draw_alone(lambda: self._pull_typed(pane))

    @staticmethod
    def _pull_typed(pane: TerminalPane) -> None:
        pane.pull(time.monotonic())
        pane.place_cursor()

    def draw_frame(self) -> bool:
        """Pull what is new into the panes; return True while something is animated."""
        now = time.monotonic()
        if self.frames.untouched_for(now) > LASTING_SECONDS:
            self._turns.rest()
        self._follow()
        again = self.session.advance()
        if surroundings.pace is None:
            again = self.scenes.advance(now) or again
        self.recording.advance()
        if self.detachment.away:
            self.lessons.begin()
            return self.notices.expire(now) or again
        again = self.draw_in_frame(lambda: self._pull_all(now)) or again
        self.send_pictures()
        return again

    def _follow(self) -> None:
        """See what is new on the desk and has to have its place."""
        machine = self.machine
        if machine.desk is not None:
            # Before a scene goes on: what it waits for has its place first.
            if (windows := machine.changed_windows()) is not None:
                key = actions.BY_ID["windows"].label
                for unseen in self.desktop.show_windows(windows):
                    self.notices.show(self.look.texts("window.hidden", title=unseen.label, key=key))
                self.session.place_windows()
            self.terminals.follow_desk()
            self.lessons.follow()
            self.arranging.follow()
            self.distributions.follow()

    def _follow_in_world(self) -> None:
        """The same in virtual time, before a scene goes on: what the world sees of the picture is up to date."""
        self._follow()
        for pane in self.desktop.shown():
            pane.measure()

    def _pull_all(self, now: float) -> bool:
        again = False
        if self.machine.desk is not None:
            again = self._pull(now)
            self.desktop.yield_to_full_terminals()
        again = self.notices.expire(now) or self.lessons.is_coming() or again
        if not self.frames.rate or now - self._barred >= BAR_SECONDS:
            self._barred = now if self.machine.desk is not None else 0.0  # the first look at the desk does not wait
            self.top.pull(now)
            self.bottom.pull(now)
            self.lessons.begin()
        else:
            self.frames.wake_after(self._barred + BAR_SECONDS - now)
        return again

    def _pull(self, now: float) -> bool:
        """Let the visible panes read their models, and now and then their titles."""
        titles = not self.frames.rate or now - self._titled >= TITLE_SECONDS
        if titles:
            self._titled = now
        else:
            self.frames.wake_after(self._titled + TITLE_SECONDS - now)
        again = False
        for pane in self.desktop.shown():
            try:
                pane.measure()
                if titles and isinstance(pane, TerminalPane):
                    pane.key_back = self.switching.key_to(pane)  # before it looks whether its hint has changed
                again = pane.pull(now) or again
                if titles:
                    pane.pull_title()
            except Exception as error:
                if not isinstance(pane, WindowPane):
                    raise
                self.window_failed(pane, error)
            if isinstance(pane, TerminalPane):
                pane.place_cursor()
        return again

    def frame_failed(self, error: Exception) -> None:
        """Report an error of the desktop itself, and keep programs and terminals running."""
        if self.is_headless:
            super().failed(error)
            return
        if is_leaving(self):
            return  # the panes are going away
        _log.error("a frame failed", exc_info=error)
        from day6_tui.overlays.message import ErrorModal

        if not isinstance(self.desktop.overlay, ErrorModal):
            self.desktop.open_overlay(ErrorModal(self.look, fault(error)))

    @on(WindowPane.Failed)
    def drop_broken_window(self, event: WindowPane.Failed) -> None:
        self.window_failed(event.pane, event.error)

    def window_failed(self, pane: WindowPane[object], error: Exception) -> None:
        """Replace a window that cannot be drawn by the reason; everything else goes on."""
        if pane not in self.desktop.panes.values():
            return  # replaced already
        _log.warning("a window failed", exc_info=error)
        self.desktop.break_window(pane, error)

    # -- messages of panes ---------------------------------------------------------------------------------------------

    @on(WelcomePane.Chosen)
    def do_chosen(self, event: WelcomePane.Chosen) -> None:
        """An entry of the welcome pane was chosen."""
        kind, _, rest = event.does.partition(".")
        if kind == "action":
            self.actions[rest]()
        elif event.does.startswith("type:"):
            self.terminals.type(event.does.removeprefix("type:"))
        else:
            self._leave_welcome()
        self.frames.wake()

    @on(LessonAsked)
    def follow_lesson(self, event: LessonAsked) -> None:
        self.lessons.handle(event)

    @on(WindowPane.KeyboardWanted)
    def give_keyboard(self, event: WindowPane.KeyboardWanted) -> None:
        self.desktop.focus_pane(event.pane)

    @on(WindowPane.CommandChosen)
    def type_command(self, event: WindowPane.CommandChosen) -> None:
        """Type a command where it can be seen, without Return."""
        self.terminals.type(event.command)
        self.frames.wake()

    @on(WelcomePane.Closed)
    def close_guide(self) -> None:
        self.desktop.close_guide()

    @on(WelcomePane.Typed)
    def type_in_terminal(self, event: WelcomePane.Typed) -> None:
        """A command is typed where there is no terminal: send it to one that is waiting for a command."""
        if (pane := self._leave_welcome()) is not None:
            pane.on_key(event.key)

    @on(WelcomePane.Pasted)
    def paste_in_terminal(self, event: WelcomePane.Pasted) -> None:
        """Something is pasted where there is no terminal: paste it into one that is waiting for a command."""
        if (pane := self._leave_welcome()) is not None:
            pane.paste(event.text)

    def _leave_welcome(self) -> TerminalPane | None:
        """Give the keyboard to a terminal that waits for a command."""
        self.welcome.show_guide()
        pane = self.desktop.focused_pane
        if not isinstance(pane, TerminalPane):
            pane = self.terminals.use_idle() if self.machine.desk is not None else self.terminals.current
            if pane is not None:
                self.desktop.focus_pane(pane)
        self.frames.wake()
        return pane

    @on(TerminalPane.CloseAsked)
    def close_terminal(self, event: TerminalPane.CloseAsked) -> None:
        self.terminals.close(event.pane)

    @on(TerminalPane.LineClicked)
    def explain_line(self, event: TerminalPane.LineClicked) -> None:
        self.explaining.open_for_line(event.pane, event.line)

    @on(Desktop.ListAsked)
    def list_panes(self) -> None:
        self.switching.list_all()

    @on(Desktop.Dragging)
    def tell_where_it_falls(self, event: Desktop.Dragging) -> None:
        texts = self.look.texts
        where = texts(f"drop.{event.side}", name=event.target.label)
        self.notices.show(texts("drop.told", name=event.pane.label, where=where))

    @on(TerminalPane.ArrowEchoed)
    def explain_arrows(self) -> None:
        self.switching.tell_where_arrows_drive()

    def on_key(self, event: events.Key) -> None:
        """A key that no pane handled."""
        pane = self.desktop.focused_pane
        if event.key in ARROWS and isinstance(pane, WindowPane) and pane.window.kind == "turtlesim":
            self.switching.tell_where_arrows_drive()


def run(options: Options) -> int:
    """Open the desktop and return its exit status when the user has left it and every program has ended."""
    in_real_time()
    keep_heap_small()
    # A frame makes thousands of objects and drops them: looking for circles among them after every 700 costs a tenth of it.
    gc.set_threshold(YOUNG_OBJECTS, *gc.get_threshold()[1:])
    keep_log_off_the_screen()
    environ = dict(os.environ)
    try:
        app = Day6App(options)
    except (KeyError, ValueError) as error:
        print(f"day6-tui: {error}", file=sys.stderr)
        return 2
    # For programs on the desk that explain something: new terminals pass it on.
    os.environ["DAY6_LANG"] = app.look.texts.language
    app.ending = ending = departure.ending_of(app)
    ending.handle_signals(sys.stdin.fileno())
    try:
        app.run()
    finally:
        ending.begin()
        app.machine.close()
        ending.over()
    status = ending.status or app.return_code or 0
    if app.rewind.wanted and not status:
        begin_again(environ)
    if app.distributions.next and not status:
        return start_again(app.distributions.next, environ, options.keeper)
    return status
