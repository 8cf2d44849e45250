"""The container of the windows' panes: the desktop, or the screen of a single program."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence

from textual import events
from textual.containers import Container
from textual.screen import Screen

from day6_tui.overlays.modal import Modal
from day6_tui.panes.pane import Pane, PaneStacks


class PaneHost(Container, PaneStacks):
    """Its panes lose the keyboard while a modal screen is open, at most one, and get it back."""

    def on_mount(self) -> None:
        self.app.screen_change_signal.subscribe(self, self._screen_changed)

    @property
    @abstractmethod
    def focused_pane(self) -> Pane | None:
        """The pane that has the focus, or had it before a modal screen was opened."""

    @abstractmethod
    def give_keyboard(self, pane: Pane) -> None:
        """Focus a pane."""

    @property
    def overlay(self) -> Modal | None:
        """The modal screen that is open."""
        screen = self.app.screen
        return screen if isinstance(screen, Modal) else None

    @property
    def is_asking(self) -> bool:
        """Whether something is open that has to be answered before anything else is done."""
        return self.overlay is not None and self.overlay.waits

    def type_at_terminal(self, keys: Sequence[events.Key]) -> None:
        """Type where a command is expected what was typed at a pane that takes none, and give it the keyboard."""

    def open_overlay(self, modal: Modal, about: Pane | None = None) -> None:
        """Open a modal screen in place of any other; one that is about a pane closes with it."""
        self.close_overlay()
        modal.about = about
        self.app.push_screen(modal)

    def close_overlay(self) -> None:
        """Close the modal screen; the pane that had the focus gets it back."""
        if (modal := self.overlay) is not None:
            modal.close()

    def close_overlay_about(self, pane: Pane) -> None:
        """The pane goes: close the modal screen that is about it."""
        if (modal := self.overlay) is not None and modal.about is pane:
            modal.close()

    def _screen_changed(self, screen: Screen[object]) -> None:
        if screen is not self.screen:
            self.screen.set_focus(None)
        elif (pane := self.focused_pane) is not None:
            self.give_keyboard(pane)
