"""The window of rqt_logger_level: the nodes, the loggers of the chosen one, and the level of the chosen logger, side by side."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rich.segment import Segment
from rich.style import Style
from textual import events

from day6_core.elide import elide
from day6_core.ros.programs.rqt_logger_level.model import LEVELS
from day6_core.session.display import Window
from day6_core.session.harmless import one_line
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import fit, wrap
from day6_tui.panes.pane import Piece
from day6_tui.windows.parts.lines_pane import Line, LinesPane
from day6_tui.windows.parts.list_keys import first_seen, list_steps

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_logger_level.model import LoggerLevels

NODES, LOGGERS, LEVEL = range(3)
COLUMNS = ("loggers.nodes", "loggers.loggers", "loggers.levels")
LEVELS_WIDTH = 14

Entry = tuple[str, Style]


class LoggerLevelPane(LinesPane["LoggerLevels"]):
    """Draws three lists; keeps which of them the keys mean, and the chosen line of each."""

    key_weight = 3  # one more of its keys where there is no room for F8, too

    def __init__(self, window: Window[LoggerLevels], look: Look) -> None:
        super().__init__(window, look)
        self._column = NODES
        self._at = [0, 0, 0]
        self._first = [0, 0, 0]

    # -- the lists -----------------------------------------------------------------------------------------------------

    def _entries(self) -> list[list[Entry]]:
        model, colours = self.model, self.look.colours
        nodes = [
            (name, colours.accent if name == model.node else colours.node if served else colours.muted)
            for name, served in model.nodes.items()
        ]
        loggers = [(logger.name, colours.topic) for logger in model.loggers] if model.node else []
        level = self._level()
        levels = [(name, colours.accent if number == level else colours.text) for number, name in LEVELS.items()]
        return [nodes, loggers, levels if loggers and model.nodes.get(model.node) else []]

    def _level(self) -> int | None:
        """The level of the chosen logger."""
        loggers, at = self.model.loggers, self._at[LOGGERS]
        return loggers[at].level if at < len(loggers) else None

    def _widths(self, width: int) -> list[int]:
        levels = min(LEVELS_WIDTH, width // 4)
        rest = width - levels - 2
        return [rest // 2, rest - rest // 2, levels]

    def _build(self, width: int, height: int) -> list[Line]:
        colours, entries, remarks = self.look.colours, self._entries(), self._remarks(width)
        room = max(1, height - 1 - len(remarks))
        widths = self._widths(width)
        for column, found in enumerate(entries):
            self._at[column] = max(0, min(self._at[column], len(found) - 1))
            at = self._at[column]
            self._first[column] = first_seen(self._first[column], at, room, len(found))
        heads = [
            Segment(fit(f" {self.look.texts(key)}", size), colours.muted)
            for key, size in zip(COLUMNS, widths, strict=True)
        ]
        between = Segment(self.look.glyphs.border.vertical, colours.frame)
        lines: list[Line] = [[heads[0], between, heads[1], between, heads[2]]]
        for y in range(room):
            cells = [
                self._cell(column, self._first[column] + y, entries[column], widths[column]) for column in range(3)
            ]
            lines.append([*cells[0], between, *cells[1], between, *cells[2]])
        lines += [[Segment(f" {text}", style)] for text, style in remarks]
        return lines[:height]

    def _cell(self, column: int, index: int, entries: list[Entry], width: int) -> Line:
        colours = self.look.colours
        if index >= len(entries):
            return [Segment(" " * width, colours.text)]
        text, style = entries[index]
        chosen = index == self._at[column]
        current = style is colours.accent
        if chosen and column == self._column:
            style = colours.choice if self.has_focus else colours.strong
        mark = self.look.glyphs.news if current else self.look.glyphs.marker if chosen and column == LOGGERS else " "
        return [Segment(f"{mark} ", colours.accent), Segment(self._fitted(text, width - 2), style)]

    def _fitted(self, text: str, width: int) -> str:
        """A name in so many cells; of long ones the end tells them apart."""
        return fit(elide(one_line(text), max(1, width), self.look.glyphs.ellipsis), width)

    def _remarks(self, width: int) -> list[tuple[str, Style]]:
        """What there is to say of the chosen node, below the lists."""
        model, texts, colours = self.model, self.look.texts, self.look.colours
        if not model.node:
            text, style = texts("loggers.choose"), colours.muted
        elif model.node not in model.nodes:
            text, style = texts("loggers.gone", node=model.node), colours.warning
        elif not model.nodes[model.node]:
            text, style = texts("loggers.not_served", node=model.node), colours.warning
        elif model.waited:
            text, style = texts("loggers.waiting", seconds=model.waited), colours.warning
        elif model.message:
            text, style = model.message[:1000], colours.warning
        elif self._level() == 0:
            text, style = texts("loggers.not_set"), colours.muted
        else:
            return []
        return [(line, style) for line in wrap(text, width - 2)[:3]]

    def status(self) -> list[Piece]:
        return [
            Piece(f" {self.look.texts('reconfigure.nodes', count=len(self.model.nodes))} ", self.look.colours.muted)
        ]

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        doing = ("loggers.show", "loggers.to_levels", "loggers.set")[self._column]
        return [
            ("Enter", texts(doing)),
            ("← →" if self.look.glyphs.unicode else "<- ->", texts("loggers.column")),
            ("a", texts("loggers.add")),
            ("r", texts("reconfigure.read")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        return [("Esc", self.look.texts("loggers.cancel"))]

    def _press(self, key: str, character: str) -> bool:
        if (steps := list_steps(key, self.inner_height - 2)) is not None:
            self._at[self._column] = max(0, self._at[self._column] + steps)
        elif key in ("left", "right", "tab", "shift+tab"):
            self._column = (self._column + (1 if key in ("right", "tab") else -1)) % 3
        elif key in ("enter", "space"):
            self._use()
            if self._column == NODES and self.model.nodes.get(self._node_here()):
                self._column = LOGGERS
        elif character == "a" and self.model.node:
            self.ask(self.look.texts("loggers.name"), "", lambda text: self.model.add(text.strip()))
        elif character == "r":
            self.model.read()
        elif key == "escape" and self.model.waited is not None:
            self.model.cancel()
        else:
            return False
        return True

    def _node_here(self) -> str:
        nodes, at = list(self.model.nodes), self._at[NODES]
        return nodes[at] if at < len(nodes) else ""

    def _use(self) -> None:
        """Choose the node, go on to the levels, or set the level."""
        model, at = self.model, self._at[self._column]
        if not self._entries()[self._column]:
            return
        if self._column == NODES:
            model.choose(self._node_here())
            self._at[LOGGERS] = 0
        elif self._column == LOGGERS:
            self._column = LEVEL
        else:
            model.set(model.loggers[self._at[LOGGERS]].name, list(LEVELS)[at])

    def on_mouse_down(self, event: events.MouseDown) -> None:
        x, y = event.x - self.inner_offset, event.y - self.inner_offset - 1
        if event.button != 1 or not self.is_inside(event) or y < 0:
            return
        widths = self._widths(self.inner_width)
        self._column = NODES if x <= widths[0] else LOGGERS if x <= widths[0] + 1 + widths[1] else LEVEL
        index = self._first[self._column] + y
        if index < len(self._entries()[self._column]):
            self._at[self._column] = index
            if self._column != LOGGERS:
                self._use()
        self._redraw()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._press("down" if notches > 0 else "up", "")
        self._show()
