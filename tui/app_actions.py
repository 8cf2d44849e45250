"""What every action of `actions` does: the `do_…` methods of the application."""

from __future__ import annotations

import os
from functools import partial
from typing import TYPE_CHECKING, Any

from day6_tui.tui import actions
from day6_tui.tui.colours import THEMES, colours
from day6_tui.tui.glyphs import CANVASES, GLYPH_SETS
from day6_tui.tui.locale import LANGUAGES, catalogue
from day6_tui.tui.pane import Pane
from day6_tui.tui.terminal_pane import TerminalPane
from day6_tui.tui.terminal_view import TerminalView, tab_name
from day6_tui.tui.windows import WindowPane

if TYPE_CHECKING:
    from day6_tui.tui.desktop import Desktop
    from day6_tui.tui.frames import Frames
    from day6_tui.tui.look import Look
    from day6_tui.tui.machine import Machine
    from day6_tui.tui.welcome import WelcomePane

TURTLE_TICK = 0.016


class AppActions:
    """Mixed into the application, which has the attributes named here."""

    desktop: Desktop
    frames: Frames
    look: Look
    machine: Machine
    terminals: TerminalPane
    welcome: WelcomePane
    player: Any
    stage: Any
    options: Any
    _front: int | None = None
    """The window that was in front when the keyboard was in a terminal last: a round of F3 through the windows begins there."""

    if TYPE_CHECKING:

        def say(self, text: str, seconds: float = 3.0) -> None: ...
        def start_scene(self, name: str) -> None: ...
        def exit(self, result: Any = None, return_code: int = 0, message: Any = None) -> None: ...

    async def action_do(self, id: str) -> None:  # noqa: A002
        """Textual's entry: a key of the table was pressed."""
        getattr(self, actions.BY_ID[id].handler)()
        self.frames.wake()

    def action_help_quit(self) -> None:
        """Ctrl-C where nobody wants it does nothing (Textual would explain how to quit)."""

    # -- terminals and windows -----------------------------------------------------------------------------------------

    def new_terminal(self) -> None:
        """Open a terminal and show it; says so when too many programs run for one more."""
        if self.machine.desk is not None:
            columns, rows = self.terminals.terminal_size()
            try:
                self.terminals.add(self.machine.desk.open_terminal(columns, rows))
            except BlockingIOError:
                self.say(self.look.texts("terminal.no_room"), 10.0)

    def do_terminal(self) -> None:
        self.new_terminal()
        self.desktop.focus_pane(self.terminals)

    def do_next(self) -> None:
        self._cycle(1)

    def do_previous(self) -> None:
        self._cycle(-1)

    def _cycle(self, step: int) -> None:
        """Through all terminals and then all windows, beginning with the one that is in front."""
        if self.desktop.focused_pane() is self.terminals:
            self._front = self.desktop.active
        target, index = self._stop(step)
        if target is self.terminals and self.terminals.views:
            self.terminals.activate(index)
        self.desktop.focus_pane(target)

    def _stop(self, step: int) -> tuple[Pane, int]:
        """Where that leads: a pane, and which of the terminals if it is theirs."""
        stops: list[tuple[Pane, int]] = [(self.terminals, index) for index in range(len(self.terminals.views))]
        pane = self.desktop.focused_pane()
        numbers = self.desktop.numbers
        front = self.desktop.active if pane is self.terminals else self._front
        first = numbers.index(front) if front in numbers else 0
        windows = [self.desktop.pane(number) for number in numbers[first:] + numbers[:first]]
        stops += [(window, 0) for window in windows if window is not None]
        here = (pane, self.terminals.active if pane is self.terminals else 0)
        if here in stops:
            return stops[(stops.index(here) + step) % len(stops)]
        return stops[0] if stops else here

    def key_to_terminal(self, index: int | None = None) -> str:
        """The key that leads from here to a terminal, without an index to the one that is shown."""
        wanted = (self.terminals, self.terminals.active if index is None else index)
        keys = {1: actions.BY_ID["next"].label, -1: actions.BY_ID["previous"].label}
        return next((key for step, key in keys.items() if self._stop(step) == wanted), actions.BY_ID["windows"].label)

    def tell_where_arrows_drive(self) -> None:
        """An arrow key was pressed where it drives nothing: name the terminal in which it would, if there is one."""
        for index, view in enumerate(self.terminals.views):
            if view.reading_keys and "teleop" in view.terminal.title:
                key = self.key_to_terminal(index)
                self.say(self.look.texts("terminal.arrows", number=index + 1, key=key))
                return

    def do_windows(self) -> None:
        from day6_tui.tui.menu import Entry, Menu

        texts, entries = self.look.texts, []
        for index, view in enumerate(self.terminals.views):
            name = f"{index + 1} {tab_name(view.terminal.title)}"
            entries.append(Entry(name, texts("menu.terminal"), partial(self.go_terminal, index), view.terminal.hang_up))
        for pane in self.desktop.panes.values():
            entries.append(
                Entry(
                    pane.label,
                    texts("menu.window"),
                    partial(self.desktop.focus_pane, pane),
                    pane.close,
                )
            )
        self.desktop.open_overlay(Menu(self.look, "menu.windows", entries))

    def go_terminal(self, index: int) -> None:
        """Show this terminal and give it the keyboard."""
        if index < len(self.terminals.views):
            self.terminals.activate(index)
            self.desktop.focus_pane(self.terminals)

    def do_inspector(self) -> None:
        """Open the inspector, or close the one that is open."""
        for pane in self.desktop.panes.values():
            if pane.window.kind == "inspector":
                pane.window.close_by_user()
                return
        self.machine.run_tool("day6_inspector", "inspector")

    def do_enlarge(self) -> None:
        self.desktop.toggle_enlarged()

    def do_grow(self) -> None:
        self._change_share(0.05)

    def do_shrink(self) -> None:
        self._change_share(-0.05)

    def _change_share(self, step: float) -> None:
        self.desktop.share = max(0.2, min(0.8, self.desktop.share + step))
        self.desktop.rearrange()

    def do_close(self) -> None:
        pane = self.desktop.focused_pane()
        if pane is self.terminals:
            if self.terminals.view is not None:
                self.terminals.view.terminal.hang_up()
        elif isinstance(pane, WindowPane):
            pane.close()

    def do_copy(self) -> None:
        if self.terminals.copy_selection():
            self.say(self.look.texts("terminal.copied"))

    def do_paste(self) -> None:
        self.terminals.paste(self.terminals.app.clipboard)

    def do_clear(self) -> None:
        if self.terminals.view is not None:
            self.terminals.view.forget_history()
            self.terminals.touch()

    # -- help, palette, scenes -----------------------------------------------------------------------------------------

    def do_help(self) -> None:
        from day6_tui.tui.help import HelpOverlay

        if isinstance(self.desktop.overlay, HelpOverlay):
            self.desktop.close_overlay()
        else:
            self.desktop.open_overlay(HelpOverlay(self.look, self.desktop.focused_pane()))

    def do_palette(self) -> None:
        from day6_tui.tui.menu import Entry, Menu

        texts, entries = self.look.texts, []
        for action in actions.ACTIONS:
            if action.palette:
                key = f"action.{action.id}"
                words = " ".join([catalogue(language)[key] for language in LANGUAGES] + [texts("help." + key)])
                entries.append(Entry(texts(key), action.label, getattr(self, action.handler), words=words))
        self.desktop.open_overlay(Menu(self.look, "menu.palette", entries))

    def do_scene_turtle(self) -> None:
        self.start_scene("turtle")

    def do_scene_car(self) -> None:
        self.start_scene("car")

    def do_scene_world(self) -> None:
        self.start_scene("world")

    def do_quit(self) -> None:
        """End the desktop; asks when a text would be lost with it, because there is no room for a copy of it."""
        lost = self.lost_at_the_end()
        if not lost:
            self.exit()
            return
        from day6_tui.tui.prompt import Question

        texts = self.look.texts
        title = texts("quit.lost", what="; ".join(lost))
        self.desktop.open_overlay(Question(self.look, texts("quit.title"), title, {"y": self.exit}))

    def lost_at_the_end(self) -> list[str]:
        """What the windows cannot keep if the desktop ends now, each with the reason."""
        return [lost for pane in self.desktop.panes.values() if (lost := pane.loses_at_the_end())]

    def end_by_signal(self) -> None:
        """A closed terminal or `kill`: nobody can be asked, but what is lost is told."""
        lost = self.lost_at_the_end()
        if lost:
            self.exit(return_code=1, message=self.look.texts("quit.was_lost", what="; ".join(lost)))
        else:
            self.exit()

    # -- looks ---------------------------------------------------------------------------------------------------------

    def do_language(self) -> None:
        if self.look.glyphs.chinese:
            self.look.texts.switch()
            if "DAY6_LANG" in os.environ:
                os.environ["DAY6_LANG"] = self.look.texts.language
            self._redraw()

    def do_theme(self) -> None:
        present = self.look.colours
        if present.name in THEMES:
            self.look.colours = colours(THEMES[(THEMES.index(present.name) + 1) % len(THEMES)])
            self._redraw()

    def do_glyphs(self) -> None:
        names = CANVASES
        name = names[(names.index(self.look.glyphs.name) + 1) % len(names)]
        self.look.glyphs = GLYPH_SETS[name]
        self.look.texts.plain = not self.look.glyphs.unicode
        self._redraw()
        self.say(name)

    def do_motion(self) -> None:
        self.look.reduced_motion = not self.look.reduced_motion
        self._redraw()

    def _redraw(self) -> None:
        for pane in self.desktop.screen.query(Pane):
            pane.restyle()
        self.frames.wake()

    # -- time ----------------------------------------------------------------------------------------------------------

    def do_pause(self) -> None:
        self.machine.toggle_pause()
        self.frames.wake()

    def do_step(self) -> None:
        if self.machine.paused:
            self.machine.desk.step(TURTLE_TICK)

    def do_faster(self) -> None:
        self._speed(1)

    def do_slower(self) -> None:
        self._speed(-1)

    def do_normal(self) -> None:
        self._speed(0)

    def _speed(self, step: int) -> None:
        speed = self.machine.change_speed(step)
        note = "" if speed == 1.0 else f" {self.look.glyphs.dot} {self.look.texts('bar.external')}"
        self.say(f"{speed:g}x{note}")

    # -- what a scene acts on (scenes.Stage) ---------------------------------------------------------------------------

    def use_terminal(self, which: str) -> None:
        terminals = self.terminals
        left = terminals.active if self.stage is not None and terminals.view is not self.stage else None
        if which == "idle":
            self.stage = self.use_idle_terminal()
        else:
            self.new_terminal()
            self.stage = terminals.view
        if left is not None:
            terminals.activate(left)  # the user went to another one: the scene goes on beside it

    def use_idle_terminal(self) -> TerminalView:
        """Show a terminal that waits for a command, a new one if there is none."""
        for index, view in enumerate(self.terminals.views):
            if not view.terminal.busy:  # its shell may still be starting: `ready` waits for the prompt
                self.terminals.activate(index)
                return view
        self.new_terminal()
        return self.terminals.views[-1]

    def send(self, text: str) -> None:
        if self.stage in self.terminals.views:
            self.stage.terminal.send(text)

    def ready(self) -> bool:
        return self.stage in self.terminals.views and self.stage.at_prompt

    def has_window(self, kind: str) -> bool:
        return any(window.kind == kind for window in self.machine.desk.display.windows)

    def has_topic(self, name: str) -> bool:
        from day6_tui.core.graph.endpoints import EndpointKind

        names = self.machine.desk.graph.names_and_types(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)
        return any(topic == name for topic, _ in names)

    def reading_keys(self) -> bool:
        return self.stage in self.terminals.views and self.stage.reading_keys
