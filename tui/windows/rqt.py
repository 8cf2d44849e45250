"""rqt's window: the list of windows to choose from."""

from __future__ import annotations

from textual import events, on
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from day6_tui.core.ros.programs.rqt_gui.model import Menu, Plugin
from day6_tui.core.session.display import Window
from day6_tui.tui.look import Look
from day6_tui.tui.windows.pane_list import ListPane, PaneList, Row


class PluginList(PaneList):
    """The windows of `Menu.plugins`, each with its number, which is its key too."""

    def __init__(self, menu: Menu, look: Look) -> None:
        super().__init__(look)
        self._menu = menu

    def show(self) -> None:
        """Write the entries in the present language."""
        at, texts, colours = self.highlighted or 0, self.look.texts, self.look.colours
        rows = [Row(self, -1, texts("rqt.plugins"), "", colours.muted)]
        for number, plugin in enumerate(self._menu.plugins, 1):
            note = f"{plugin.package:<12} {texts(f'rqt.about.{plugin.package}')}"
            rows.append(Row(self, number, f"{plugin.title:<16}{note}", str(number), colours.text))
        self.set_options([Option(row, disabled=not number) for number, row in enumerate(rows)])
        self.highlighted = max(1, at)

    def on_key(self, event: events.Key) -> None:
        """A number opens its window."""
        plugins = self._menu.plugins
        if event.key.isdigit() and 1 <= int(event.key) <= len(plugins):
            event.stop()
            self._open(plugins[int(event.key) - 1])

    @on(OptionList.OptionSelected)
    def open_chosen(self, event: OptionList.OptionSelected) -> None:
        """Enter or a click."""
        event.stop()
        self._open(self._menu.plugins[event.option_index - 1])

    def _open(self, plugin: Plugin) -> None:
        self._menu.choose(plugin)


class RqtPane(ListPane[Menu, PluginList]):
    """Keeps which entry the cursor is on."""

    def __init__(self, window: Window[Menu], look: Look) -> None:
        super().__init__(window, look, PluginList(window.model, look))
        self._shown = ""

    def pull(self, now: float) -> bool:
        if self._shown != self.look.texts.language and self.list.is_attached:
            self._shown = self.look.texts.language
            self.list.show()
        return False

    def restyle(self) -> None:
        self._shown = ""
        super().restyle()

    def key_hints(self) -> list[tuple[str, str]]:
        return [("Enter", self.look.texts("rqt.open"))]
