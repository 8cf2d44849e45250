"""rqt's window: the plugins to open, those that are open, and the perspectives."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from rich.segment import Segment
from rich.style import Style
from textual import events, on
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from day6_core.ros.programs.rqt_gui.catalogue import PluginEntry
from day6_core.ros.programs.rqt_gui.model import Open, Rqt
from day6_core.ros.programs.rqt_gui.perspectives import wrong_name
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.overlays.menu import Menu, MenuEntry
from day6_tui.overlays.prompt import before_replacing
from day6_tui.panes.cells import cell_len, clip
from day6_tui.panes.marks import Line
from day6_tui.panes.pane import Piece
from day6_tui.windows.parts.pane_list import ListPane, ListRow, PaneList


class PluginRow(ListRow):
    """One line, cut at the right: the group of the plugin, its title, what it is for; from `least` cells on with the group."""

    def __init__(self, entries: PaneList, index: int, group: str, text: str, style: Style, least: int) -> None:
        super().__init__(entries, index, text, "", style)
        self._group = group
        self._least = least

    def _lines(self, width: int) -> list[Line]:
        text = f" {self._group if width >= self._least else ''}{self._text}"
        return [[Segment(clip(text, width), self._style)]]


class PluginList(PaneList):
    """The plugins of `Rqt.plugins` in their groups; below each those that are open."""

    def __init__(self, model: Rqt, look: Look) -> None:
        super().__init__(look)
        self._model = model
        self._subjects: list[PluginEntry | Open] = []
        """What each line stands for."""

    def show(self) -> None:
        """Write the entries in the present language; the cursor stays on what it is on."""
        chosen, model, texts, colours = self.chosen, self._model, self.look.texts, self.look.colours
        titles = max(cell_len(entry.title) for entry in model.plugins) + 2
        groups = max(cell_len(entry.group) for entry in model.plugins) + 2
        abouts = {entry: texts(f"rqt.about.{entry.package}") for entry in model.plugins}
        least = 1 + groups + titles + max(map(cell_len, abouts.values()))
        rows: list[PluginRow] = []
        self._subjects, before = [], ""

        def add(subject: PluginEntry | Open, group: str, text: str, style: Style) -> None:
            rows.append(PluginRow(self, len(rows), f"{group:<{groups}}", text, style, least))
            self._subjects.append(subject)

        for entry in model.plugins:
            text = f"{entry.title:<{titles}}{abouts[entry]}"
            add(entry, entry.group if entry.group != before else "", text, colours.text)
            before = entry.group
            for opened in model.open:
                if opened.entry == entry:
                    text = f"{self.look.glyphs.news} {texts('rqt.is_open', name=opened.title)}"
                    add(opened, "", text, colours.strong)
        self.set_options([Option(row) for row in rows])
        self.highlighted = self._subjects.index(chosen) if chosen in self._subjects else 0

    @property
    def chosen(self) -> PluginEntry | Open | None:
        """What the cursor is on; None before there is a list."""
        at = self.highlighted
        return self._subjects[at] if at is not None and at < len(self._subjects) else None

    def on_key(self, event: events.Key) -> None:
        """x closes the plugin under the cursor."""
        chosen = self.chosen
        if event.key in ("x", "delete") and isinstance(chosen, Open):
            event.stop()
            self._model.stop(chosen)

    @on(OptionList.OptionSelected)
    def open_chosen(self, event: OptionList.OptionSelected) -> None:
        """Enter or a click: opens a plugin; on one that is open, once more."""
        event.stop()
        subject = self._subjects[event.option_index]
        self._model.start(subject.entry if isinstance(subject, Open) else subject)


class RqtPane(ListPane[Rqt, PluginList]):
    """Keeps which entry the cursor is on."""

    def __init__(self, window: Window[Rqt], look: Look) -> None:
        super().__init__(window, look, PluginList(window.model, look))
        self._shown: tuple[object, ...] = ()

    def pull(self, now: float) -> bool:
        state = (self.look.texts.language, self.model.version, self.extent)
        if self._shown != state and self.list.is_attached:
            self._shown = state
            self.list.show()
            self.touch_status()
        return False

    def restyle(self) -> None:
        self._shown = ()
        super().restyle()

    def status(self) -> list[Piece]:
        colours, texts = self.look.colours, self.look.texts
        if self.model.trouble:
            return [Piece(f" {self.model.trouble} ", colours.warning)]
        chosen = self.list.chosen
        if not isinstance(chosen, PluginEntry):
            return []
        return [Piece(f" {texts(f'rqt.about.{chosen.package}')} ", colours.text)]  # its line may be too short for it

    def status_right(self) -> list[Piece]:
        name = self.look.texts("rqt.perspective", name=self.model.perspective)
        return [Piece(f" {name} ", self.look.colours.muted, self.choose_perspective)]

    @on(OptionList.OptionHighlighted)
    def tell_chosen(self, event: OptionList.OptionHighlighted) -> None:
        """The cursor is on another entry."""
        event.stop()
        self.touch_status()

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        close = [("x", texts("rqt.close"))] if isinstance(self.list.chosen, Open) else []
        return [("Enter", texts("rqt.open")), *close, ("p", texts("rqt.perspectives"))]

    def on_key(self, event: events.Key) -> None:
        """p: perspectives."""
        if event.key == "p":
            event.stop()
            self.choose_perspective()

    # -- perspectives --------------------------------------------------------------------------------------------------

    def choose_perspective(self) -> None:
        """Open the menu of the perspectives and of what can be done with them."""
        texts, model = self.look.texts, self.model
        entries = [
            MenuEntry(
                name,
                "",
                partial(model.switch, name),
                None if name == model.perspective else partial(model.remove, name),
            )
            for name in model.perspectives
        ]
        entries += [
            MenuEntry(texts("rqt.create"), texts("rqt.create.note"), self._ask_name),
            MenuEntry(texts("rqt.import"), ".perspective", partial(self._ask_file, "rqt.import", model.load)),
            MenuEntry(texts("rqt.export"), ".perspective", partial(self._ask_file, "rqt.export", model.export)),
        ]
        at = model.perspectives.index(model.perspective) if model.perspective in model.perspectives else 0
        self.lay_over(Menu(self.look, "rqt.perspectives", entries, chosen=at, keys="menu.keys.remove"))

    def _ask_name(self) -> None:
        def taken(name: str) -> str | None:
            if wrong_name(name):
                return self.look.texts("rqt.wrong_name")
            if name in self.model.perspectives:
                return self.look.texts("rqt.name_taken")
            self.model.keep_as(name)
            return None

        self.ask(self.look.texts("rqt.create"), "", taken)

    def _ask_file(self, title: str, deed: Callable[[str], object]) -> None:
        def taken(name: str) -> str | None:
            if not name:
                return self.look.texts("rqt.wrong_name")
            deed(name)
            return None

        writes = deed == self.model.export
        checked = before_replacing(self.look, self.model.path, taken) if writes else taken
        self.ask(self.look.texts(title), f"{self.model.perspective}.perspective", checked)
