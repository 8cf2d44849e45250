"""Parameter Reconfigure's window: the nodes at the left, the parameters of those that are opened at the right.

The values and what becomes of a change are the program's (`Reconfigure`); this draws them and keeps what is chosen.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rich.segment import Segment
from textual import events

from day6_core.reason import reason
from day6_core.ros.programs.rqt_reconfigure.values import LONGEST, Unfitting, name_of, shown, text_of, value_from
from day6_core.session.display import Window
from day6_core.session.harmless import one_line
from day6_tui.appearance.look import Look
from day6_tui.overlays.prompt import before_replacing
from day6_tui.panes.cells import cell_len, fit, wrap
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows.parts.lines_pane import Line, LinesPane
from day6_tui.windows.parts.list_keys import BEGINS_NUMBER, SLIDER_FINEST, SLIDER_STEPS, first_seen, list_steps
from day6_tui.windows.parts.node_tree import NodeLine, node_lines
from day6_tui.windows.rqt.rqt_reconfigure_rows import Editors, Key, ParameterRow, rows_of

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_reconfigure.model import Reconfigure
    from day6_core.ros.programs.rqt_reconfigure.opened import Parameter

NARROW = 56
"""Columns below which only one half is seen, the one with the keyboard."""

DETAILS = 3
"""Lines below the parameters that describe the chosen one, at least."""


class ReconfigurePane(LinesPane["Reconfigure"]):
    """Draws the model; keeps the chosen lines, what is folded, the filter of parameters and what the mouse drags."""

    needs = PaneNeeds(Extent(40, 8), Extent(64, 16), Extent(100, 30), 2.0)

    key_weight = 3  # one more of its keys where there is no room for F8, too

    def __init__(self, window: Window[Reconfigure], look: Look) -> None:
        super().__init__(window, look)
        self._editors = Editors(look)
        self._on_nodes = True
        """Whether the keys mean the nodes; otherwise the parameters."""
        self._node = ""
        self._folded: set[str] = set()
        self._key: Key = ("", "")
        self._text = ""
        """Part of the names of the parameters that are shown."""
        self._dragged: dict[Key, Any] = {}
        """The slider that the mouse holds, with the value that it will send."""
        self._first_node = self._first_row = 0
        self._tree: list[NodeLine] = []
        self._rows: list[ParameterRow] = []

    # -- places --------------------------------------------------------------------------------------------------------

    @property
    def _left(self) -> int:
        """Columns of the nodes, 0 while only the parameters are seen."""
        if self.inner_width < NARROW:
            return self.inner_width if self._on_nodes else 0
        longest = max((line.depth * 2 + cell_len(line.text) + 6 for line in self._tree), default=0)
        return min(max(longest, 18), self.inner_width // 3)

    @property
    def _right(self) -> int:
        """The first column of the parameters, behind a line; the whole width while only the nodes are seen."""
        left = self._left
        return left + 1 if 0 < left < self.inner_width else left

    def _list_height(self, height: int) -> int:
        return height - max(DETAILS, height // 4) - 1 if height >= 4 * DETAILS else height

    # -- building ------------------------------------------------------------------------------------------------------

    def _build(self, width: int, height: int) -> list[Line]:
        wanted = self.model.filter.casefold()
        self._tree = node_lines((node for node in self.model.nodes if wanted in node.casefold()), self._folded)
        self._rows = rows_of(self.model.opened, self._text, self.look)
        left, right = self._left, self._right
        nodes = self._node_lines(left, height) if left else [[]] * height
        parameters = self._parameter_lines(width - right, height) if right < width else [[]] * height
        border = Segment(self.look.glyphs.border.vertical, self.look.colours.frame)
        between = [border] if 0 < left < width else []
        return [[*one, *between, *other] for one, other in zip(nodes, parameters, strict=True)]

    def _node_lines(self, width: int, height: int) -> list[Line]:
        colours, glyphs = self.look.colours, self.look.glyphs
        if not self._tree:
            text = self.look.texts("reconfigure.no_match" if self.model.filter else "reconfigure.none")
            lines = [[Segment(fit(f" {line}", width), colours.muted)] for line in wrap(text, width - 2)]
            return (lines + [[Segment(" " * width, self.background)]] * height)[:height]
        opened = {node.name for node in self.model.opened}
        at = self._node_at()
        self._first_node = first_seen(self._first_node, at, height, len(self._tree))
        lines = []
        for index in range(self._first_node, self._first_node + height):
            if index >= len(self._tree):
                lines.append([Segment(" " * width, self.background)])
                continue
            line = self._tree[index]
            fold = ("+" if line.path in self._folded else "-") if line.has_children else " "
            if line.has_children and glyphs.chinese:
                fold = "▸" if line.path in self._folded else "▾"
            style = colours.muted if not line.is_node else colours.node
            if line.path in opened:
                style = colours.accent
            if index == at:
                style = colours.choice if self.has_focus and self._on_nodes else colours.strong
            mark = glyphs.news if line.path in opened else " "
            text = f"{'  ' * line.depth}{fold} {line.text}"
            lines.append([Segment(f"{mark} ", colours.accent), Segment(fit(text, width - 2, glyphs.ellipsis), style)])
        return lines

    def _parameter_lines(self, width: int, height: int) -> list[Line]:
        colours = self.look.colours
        if not self._rows:
            text = self.look.texts("reconfigure.choose")
            lines = [[Segment(f" {line}", colours.muted)] for line in wrap(text, width - 2)]
            return (lines + [[]] * height)[:height]
        room, at = self._list_height(height), self._row_at()
        self._first_row = first_seen(self._first_row, at, room, len(self._rows))
        rows = self._rows[self._first_row : self._first_row + room]
        self._editors.begin(rows, width)
        focused = self.has_focus and not self._on_nodes
        lines = [
            self._editors.line(row, self._first_row + index == at, focused, self._dragged, width)
            for index, row in enumerate(rows)
        ]
        lines += [[]] * (room - len(lines))
        if room == height:
            return lines
        rule = Segment(self.look.glyphs.border.horizontal * width, colours.frame)
        return [*lines, [rule], *self._details(self._rows[at], width, height - room - 1)]

    def _details(self, row: ParameterRow, width: int, height: int) -> list[Line]:
        """What is known of the chosen parameter."""
        colours, texts, parameter = self.look.colours, self.look.texts, row.parameter
        if parameter is None:
            return [[]] * height
        facts = [name_of(parameter.kind), parameter.limits]
        facts += [texts("reconfigure.read_only")] if parameter.read_only else []
        facts += [texts("reconfigure.sent")] if parameter.sent else []
        lines = [[Segment(" " + fit("   ".join(filter(None, facts)), width - 2), colours.muted)]]
        said = parameter.refusal or " ".join(filter(None, (parameter.description, parameter.constraints)))
        style = colours.warning if parameter.refusal else colours.text
        lines += [[Segment(f" {line}", style)] for line in wrap(said[:LONGEST], width - 2)] if said else []
        if self._editors.cuts_value(parameter):
            lines += [[Segment(f" {line}", colours.strong)] for line in wrap(shown(parameter.value), width - 2)]
        return (lines + [[]] * height)[:height]

    def status(self) -> list[Piece]:
        texts, colours = self.look.texts, self.look.colours
        pieces = [Piece(f" {text} ", colours.muted) for text in self._told_below()]
        pieces = pieces or [Piece(f" {texts('reconfigure.nodes', count=len(self.model.nodes))} ", colours.muted)]
        for text in filter(None, (self.model.filter, self._text)):
            pieces.append(Piece(f" {texts('reconfigure.filtered', text=text)} ", colours.muted))
        if self.model.message:
            pieces.append(Piece(f" {self.model.message} ", colours.hint))
        return pieces

    def _told_below(self) -> list[str]:
        """What the list has no room for: the chosen parameter's whole name, and its range where no details are seen."""
        row = self._row
        if self._on_nodes or row is None or row.parameter is None:
            return []
        told = [one_line(row.parameter.name)] if self._editors.cuts(row.parameter) else []
        if self._list_height(self.inner_height) == self.inner_height and row.parameter.limits:
            told.append(row.parameter.limits)
        return told

    # -- what is chosen ------------------------------------------------------------------------------------------------

    def _node_at(self) -> int:
        return next((index for index, line in enumerate(self._tree) if line.path == self._node), 0)

    def _row_at(self) -> int:
        return next((index for index, row in enumerate(self._rows) if row.key == self._key), 0)

    @property
    def _row(self) -> ParameterRow | None:
        return self._rows[self._row_at()] if self._rows else None

    def _choose(self, step: int) -> None:
        if self._on_nodes:
            if self._tree:
                self._node = self._tree[min(max(self._node_at() + step, 0), len(self._tree) - 1)].path
            return
        keys = [row.key for row in self._rows if row.key is not None]
        if keys:
            at = keys.index(self._key) if self._key in keys else 0
            self._key = keys[min(max(at + step, 0), len(keys) - 1)]

    # -- keys ----------------------------------------------------------------------------------------------------------

    def key_hints(self) -> list[tuple[str, str]]:
        texts, row = self.look.texts, self._row
        arrows = "← →" if self.look.glyphs.unicode else "<- ->"
        if self._on_nodes or row is None:
            opened = any(node.name == self._node for node in self.model.opened)
            hints = [("Enter", texts("reconfigure.close" if opened else "reconfigure.open"))]
        elif row.parameter is None or not row.is_changeable:
            hints = [("x", texts("reconfigure.close"))]
            hints += [("r", texts("reconfigure.read"))] if row.node.there else []
        elif isinstance(row.parameter.value, bool):
            hints = [("Enter", texts("reconfigure.switch"))]
        else:
            hints = [(arrows, texts("reconfigure.move"))] if row.parameter.range is not None else []
            hints.append(("Enter", texts("reconfigure.value")))
        return [*hints, ("Tab", texts("reconfigure.side")), ("/", texts("reconfigure.filter"))]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        arrows = "← →" if self.look.glyphs.unicode else "<- ->"
        return [
            (f"Shift {arrows}", texts("reconfigure.far")),
            ("Home End", texts("reconfigure.ends")),
            ("Esc", texts("reconfigure.cancel")),
            ("r", texts("reconfigure.read")),
            ("x", texts("reconfigure.close")),
            ("w o", texts("reconfigure.files")),
        ]

    def _press(self, key: str, character: str) -> bool:
        row = None if self._on_nodes else self._row
        slides = row is not None and row.parameter is not None and row.parameter.range is not None
        steps = list_steps(key, self._list_height(self.inner_height), ends=not slides)
        if steps is not None:
            self._choose(steps)
        elif key in ("tab", "shift+tab"):
            self._on_nodes = not self._on_nodes or not self._rows
        elif character == "/":
            self._ask_filter()
        elif key == "escape":
            return self._escape()
        elif self._on_nodes:
            return self._press_on_nodes(key)
        else:
            return self._press_on_parameters(key, character)
        return True

    def _escape(self) -> bool:
        """Wait no more, else show all that a filter hides."""
        waiting = [node.name for node in self.model.opened if node.waited is not None]
        for name in waiting:
            self.model.cancel(name)
        if not waiting and not self._text and not self.model.filter:
            return False
        if not waiting:
            self._filter_by("")
        return True

    def _press_on_nodes(self, key: str) -> bool:
        line = self._tree[self._node_at()] if self._tree else None
        if line is None:
            return False
        if key in ("enter", "space") and line.is_node:
            self._toggle(line.path)
        elif key in ("enter", "space"):
            self._fold(line, fold=line.path not in self._folded)
        elif key in ("left", "right"):
            self._fold(line, fold=key == "left")
        else:
            return False
        return True

    def _toggle(self, node: str) -> None:
        self._node, self._key = node, (node, "")
        if self.inner_width < NARROW:  # where only one half is seen
            self._on_nodes = any(each.name == node for each in self.model.opened)
        self.model.toggle(node)

    def _fold(self, line: NodeLine, *, fold: bool) -> None:
        if fold and line.has_children and line.path not in self._folded:
            self._folded.add(line.path)
        elif fold and line.depth:
            self._node = line.path.rpartition("/")[0]
        elif not fold:
            self._folded.discard(line.path)
        self._node = self._node or line.path

    def _press_on_parameters(self, key: str, character: str) -> bool:
        row = self._row
        if row is None:
            return False
        node, parameter = row.node.name, row.parameter
        if character == "x":
            self._toggle(node)
        elif character == "r":
            self.model.read(node)
        elif key in ("ctrl+s", "w", "ctrl+o", "o"):
            self._ask_file(node, saving=key in ("ctrl+s", "w"))
        elif parameter is None or not row.is_changeable:
            return False
        elif key in SLIDER_STEPS or key in SLIDER_FINEST:
            self.model.move(node, parameter.name, SLIDER_STEPS.get(key) or SLIDER_FINEST[key])
        elif key in ("home", "end") and parameter.range is not None:
            limits = parameter.range
            self.model.set(node, parameter.name, limits.minimum if key == "home" else limits.maximum)
        elif key in ("enter", "space") and isinstance(parameter.value, bool):
            self.model.set(node, parameter.name, not parameter.value)
        elif key == "enter":
            self._ask_value(node, parameter, text_of(parameter.value))
        elif character and character in BEGINS_NUMBER and isinstance(parameter.value, (int, float)):
            self._ask_value(node, parameter, character)
        else:
            return False
        return True

    # -- asking --------------------------------------------------------------------------------------------------------

    def _ask_value(self, node: str, parameter: Parameter, begun: str) -> None:
        texts, kind = self.look.texts, name_of(parameter.kind)

        def taken(text: str) -> str | None:
            try:
                self.model.set(node, parameter.name, value_from(text, parameter.kind))
            except Unfitting:
                return texts("reconfigure.unfitting", type=kind)
            return None

        note = "   ".join(filter(None, (kind, parameter.limits, parameter.description)))
        self.ask(parameter.name, begun, taken, note=note)

    def _ask_filter(self) -> None:
        def taken(text: str) -> None:
            self._filter_by(text.strip())

        key = "reconfigure.filter_nodes" if self._on_nodes else "reconfigure.filter_parameters"
        self.ask(self.look.texts(key), self.model.filter if self._on_nodes else self._text, taken)

    def _filter_by(self, text: str) -> None:
        if self._on_nodes:
            self.model.filter = text
        else:
            self._text = text
        self._show()

    def _ask_file(self, node: str, *, saving: bool) -> None:
        texts, model = self.look.texts, self.model

        def save(text: str) -> str | None:
            try:
                model.tell(texts("reconfigure.saved", file=str(model.save(node, text.strip()))))
            except OSError as error:
                return reason(error)
            return None

        def load(text: str) -> None:
            model.load(node, text.strip())

        taken = before_replacing(self.look, lambda text: model.path(text.strip()), save) if saving else load
        self.ask(
            texts("reconfigure.save" if saving else "reconfigure.load"),
            f"{node.rpartition('/')[2]}.yaml",
            taken,
            note=node,
        )

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def on_mouse_down(self, event: events.MouseDown) -> None:
        if event.button != 1 or not self.is_inside(event):
            return
        x, y = event.x - self.inner_offset, event.y - self.inner_offset
        if x < self._left:
            self._press_node(x, self._first_node + y)
        elif x >= self._right and y < self._list_height(self.inner_height):
            self._press_row(x - self._right, self._first_row + y)
        self._redraw()

    def _press_node(self, x: int, index: int) -> None:
        self._on_nodes = True
        if index >= len(self._tree):
            return
        line = self._tree[index]
        self._node = line.path
        if line.has_children and (not line.is_node or x <= line.depth * 2 + 3):
            self._fold(line, fold=line.path not in self._folded)
        elif line.is_node:
            self._toggle(line.path)

    def _press_row(self, x: int, index: int) -> None:
        self._on_nodes = False
        row = self._rows[index] if index < len(self._rows) else None
        if row is None or row.key is None:
            return
        self._key = row.key
        parameter = row.parameter
        if parameter is None:
            if x >= self.inner_width - self._right - 4:
                self._toggle(row.node.name)
        elif not row.is_changeable:
            return
        elif row.key in self._editors.tracks and self._drag_to(x):
            self.capture_mouse()
        elif x >= self._editors.value_column:
            self._press_on_parameters("enter", "")

    def _drag_to(self, x: int) -> bool:
        """Move the slider of the chosen line to a column; False if it is not on its track."""
        row = self._row
        column, width = self._editors.tracks.get(self._key, (0, 0))
        on_track = column <= x < column + width
        if row is None or row.parameter is None or row.parameter.range is None or not (on_track or self._dragged):
            return False
        self._dragged = {self._key: row.parameter.range.at((x - column) / max(width - 1, 1))}
        return True

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if self._dragged and self._drag_to(event.x - self.inner_offset - self._right):
            self._show()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        # As in the real plugin a slider sends its value when it is let go.
        self.release_mouse()
        for (node, parameter), value in self._dragged.items():
            self.model.set(node, parameter, value)
        self._dragged = {}
        self._show()

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        event.stop()
        self._on_nodes = event.x - self.inner_offset < self._left
        self._choose(notches)
        self._redraw()
