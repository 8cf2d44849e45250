"""What rqt_bag's window asks: which bag, which topics, what name; and its menu."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from day6_core.ros.programs.rqt_bag.model.view import proposed_name
from day6_tui.windows.bag.topics import TopicChoice

if TYPE_CHECKING:
    from day6_tui.windows.bag.rqt_bag import RqtBagPane


class Questions:
    """Asks for one window; each method is what one of its keys does."""

    def __init__(self, pane: RqtBagPane) -> None:
        self._pane = pane

    def bag(self) -> None:
        """Choose one of the bags in the working folder, or type where it is."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        entries = [MenuEntry(name, "", partial(self._pane.model.load, name)) for name in self._pane.model.nearby()]
        other = MenuEntry(self._pane.look.texts("bag.open.other"), "", self._type_bag)
        if entries:
            self._pane.lay_over(Menu(self._pane.look, "bag.open.title", [*entries, other]))
        else:
            self._type_bag()

    def _type_bag(self) -> None:
        def taken(text: str) -> None:
            if text.strip():
                self._pane.model.load(text.strip())

        self._pane.ask(self._pane.look.texts("bag.open.title"), "", taken, note=self._pane.look.texts("bag.open.note"))

    def recording(self) -> None:
        def chosen(topics: Sequence[str] | None) -> None:
            self._ask_name("bag.record.title", lambda name: self._pane.model.record(name, topics))

        title = self._pane.look.texts("bag.record.topics")
        self._pane.choice = TopicChoice(self._pane.look, title, self._pane.model.graph_topics(), chosen, ticked=True)

    def export(self) -> None:
        def chosen(topics: Sequence[str] | None) -> None:
            names = list(self._pane.model.topics) if topics is None else topics
            self._ask_name("bag.save.title", lambda name: self._pane.model.export(name, names))

        if self._pane.model.topics:
            title = self._pane.look.texts("bag.save.topics")
            self._pane.choice = TopicChoice(self._pane.look, title, self._pane.model.topics, chosen, ticked=True)

    def _ask_name(self, title: str, use: Callable[[str], object]) -> None:
        def taken(text: str) -> str | None:
            if not text.strip():
                return self._pane.look.texts("bag.name.none")
            use(text.strip())
            return None

        self._pane.ask(
            self._pane.look.texts(title), proposed_name(), taken, note=self._pane.look.texts("bag.name.note")
        )

    def menu(self) -> None:
        """What rqt_bag offers at a right click (timeline_menu.py)."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        texts, model = self._pane.look.texts, self._pane.model
        publishes = self._pane.chosen in model.player.publishing
        entries = [
            MenuEntry(
                texts("bag.menu.unpublish" if publishes else "bag.menu.publish"),
                self._pane.chosen,
                self._pane.toggle_publishing,
            ),
            MenuEntry(texts("bag.menu.publish_all"), "", lambda: model.publish_all(True)),
            MenuEntry(texts("bag.menu.publish_none"), "", lambda: model.publish_all(False)),
            MenuEntry(texts("bag.menu.view"), self._pane.chosen, self._pane.toggle_view),
            MenuEntry(texts("bag.menu.thumbnails"), "t", self._pane.toggle_thumbnails),
            MenuEntry(texts("bag.menu.reset"), "", self._pane.reset),
            MenuEntry(texts("bag.menu.save"), "s", self.export),
            MenuEntry(texts("bag.menu.open"), "o", self.bag),
            MenuEntry(texts("bag.menu.record"), "r", self.recording),
        ]
        self._pane.lay_over(Menu(self._pane.look, "bag.menu", entries))
