"""The yardstick for start-up: a Textual app with header, tabs, table, input, tree and footer, and nothing behind them."""

from __future__ import annotations

from textual.app import App, ComposeResult
from textual.containers import Horizontal
from textual.widgets import DataTable, Footer, Header, Input, TabbedContent, TabPane, Tree


class BareApp(App[None]):
    """Nothing but widgets."""

    BINDINGS = [("q", "quit", "Quit")]

    def compose(self) -> ComposeResult:
        yield Header()
        with TabbedContent():
            with TabPane("one"):
                yield DataTable()
            with TabPane("two"), Horizontal():
                yield Tree("tree")
        yield Input()
        yield Footer()

    def on_mount(self) -> None:
        table = self.query_one(DataTable)
        table.add_columns("a", "b", "c")
        table.add_rows([("1", "2", "3")] * 10)


if __name__ == "__main__":
    BareApp().run()
