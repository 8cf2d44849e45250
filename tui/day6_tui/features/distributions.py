"""Another distribution of ROS 2 for the desktop: chosen with F7, or because a line that was typed in a terminal sources it.

It is remembered. A process has one distribution, so the desktop has to start again: after a line that sources another one it does
so at once if nothing runs, and asks if something does.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from day6_core.ros import distribution
from day6_core.shell.desk import Wanted
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.distribution_choice import SETTING, sourced_by
from day6_tui.features.leaving import Leaving
from day6_tui.features.saved_desktop import SavedDesktop
from day6_tui.options import Options
from day6_tui.parts import Feature, Parts


class Distributions(Feature):
    """Takes the choice, and leaves the application by `leave` if it is to start again."""

    def __init__(
        self,
        parts: Parts,
        leaving: Leaving,
        session: SavedDesktop,
        remember: Callable[[str, str], bool],
        leave: Callable[[], object],
        options: Options,
    ) -> None:
        super().__init__(parts)
        self._leaving, self._session, self._remember, self._leave = leaving, session, remember, leave
        self._may_start_again = not (options.scene or options.demo or options.record or options.part)
        self._home = ["--home", str(options.home)] if options.home is not None else []
        self.next = ""
        """The distribution as which the desktop is to start again once it has been left."""

    def choose(self) -> None:
        """Offer the distributions of ROS 2, and remember the choice for the next start."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        entries = [
            MenuEntry(name.capitalize(), f"/opt/ros/{name}", partial(self._take, name)) for name in distribution.NAMES
        ]
        present = distribution.NAMES.index(distribution.current())
        self._desktop.open_overlay(Menu(self._look, "distro.title", entries, chosen=present))

    def _take(self, name: str) -> None:
        if not self._remember(SETTING, name):
            return
        if (sourced := sourced_by(self._home)) not in (None, name):
            self._tell("distro.bashrc", name=name, sourced=sourced)
        elif name != distribution.current():
            self._tell("distro.next_start", name=name)

    def _tell(self, key: str, **words: object) -> None:
        self._notices.show(self._look.texts(key, **words), NOTICE_SECONDS)

    def follow(self) -> None:
        """At every frame: look whether a line has sourced another distribution, and its terminal has nothing more to do."""
        desk = self._machine.desk
        if desk is None:
            return
        desk.may_change_distribution = True
        wanted = desk.wanted_distribution
        if wanted is None or self._desktop.overlay is not None:
            return
        terminal = wanted.terminal
        if not (terminal.closed or terminal.busy or terminal.waiting_at_prompt):
            return
        desk.wanted_distribution = None
        self._remember(SETTING, wanted.name)
        if not self._may_start_again or desk.searching():
            self._tell("distro.next_start", name=wanted.name)
        elif running := self._leaving.running():
            self._ask(wanted, running)
        elif self._leaving.lost():
            self._tell("distro.next_start", name=wanted.name)
        else:
            self._start_again(wanted)

    def _ask(self, wanted: Wanted, running: list[str]) -> None:
        from day6_tui.overlays.question import Answer, Question

        texts = self._look.texts
        what = texts("list.comma").join(running)
        yes = Answer("y", texts("distro.again.yes"), partial(self._start_again, wanted))
        text = texts("distro.again.ask", name=wanted.name, what=what)
        self._desktop.open_overlay(
            Question(self._look, texts("distro.title"), text, [yes], back=texts("distro.again.back"))
        )

    def _start_again(self, wanted: Wanted) -> None:
        while wanted.terminal.has_more:
            wanted.terminal.update()  # what it was told last is saved, too
        self.next = wanted.name
        self._session.type_again(wanted.terminal, wanted.source)
        self._leave()
