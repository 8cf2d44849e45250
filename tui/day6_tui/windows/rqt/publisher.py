"""The Message Publisher's window: publishers with rates, and the expressions of their messages' fields."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events

from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import clip
from day6_tui.panes.pane import Piece
from day6_tui.windows.fields.field_list import FieldLine, FieldNeeds
from day6_tui.windows.fields.pane import BOOLEAN, FieldPane
from day6_tui.windows.fields.rows import NARROW, is_long, narrow_columns, problem_of
from day6_tui.windows.parts.buttons import Button

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_publisher.model import MessagePublisher, ShownPublisher

RATE, EXPRESSION = 2, 3
"""Columns."""


def columns_in(width: int, needs: FieldNeeds) -> tuple[int, int, int, int]:
    """Widths of topic, type, rate and expression; 0 for the rate in a narrow window, where it is in the column of expressions."""
    if width < NARROW:
        name, kind = narrow_columns(width, needs)
        return name, kind, 0, max(1, width - name - kind - (2 if kind else 1))
    name, kind = max(16, width * 3 // 10), max(9, width // 5, min(needs.type, width // 4))
    return name, kind, 7, max(1, width - name - kind - 10)


class PublisherPane(FieldPane["MessagePublisher"]):
    """Shows a publisher on each top line, and the fields of its message below."""

    def __init__(self, window: Window[MessagePublisher], look: Look) -> None:
        super().__init__(window, look, columns_in)
        self._publishers: list[ShownPublisher] = []
        self._count = -1

    def state(self) -> tuple[object, ...]:
        return (self.model.version,)

    def pull(self, now: float) -> bool:
        before = self._publishers
        again = super().pull(now)
        if len(self._publishers) > len(before):
            self.list.choose(f"{self._publishers[-1].number}:")
        publisher = self._chosen()
        count = self.model.count_of(publisher.number) if publisher is not None else -1
        if count != self._count:
            self._count = count
            self.touch_status()
        return again

    def bar(self) -> Sequence[Segment | Button]:
        texts = self.look.texts
        buttons: list[Segment | Button] = [Button("a", texts("publisher.add"), self.choose_topic)]
        if self._publishers:
            buttons += [
                Button("o", texts("publisher.once"), self._publish_once),
                Button("d", texts("publisher.remove"), self._remove),
                Button("C", texts("publisher.clear"), self.ask_action("clear")),
            ]
        return buttons

    def lines(self) -> list[FieldLine]:
        texts, model = self.look.texts, self.model
        self._publishers = model.shown()
        is_narrow = not self.list.widths[RATE]
        rate_column = EXPRESSION if is_narrow else RATE
        columns = ("topic", "type", "rate", "both" if is_narrow else "expression")
        lines = [FieldLine("", tuple(texts(f"publisher.columns.{each}") for each in columns), is_head=True)]
        for each in self._publishers:
            key = f"{each.number}:"
            rate = f"{each.rate:.2f}"
            cells = (each.topic, each.type, "", f"{rate} Hz") if is_narrow else (each.topic, each.type, rate, "")
            problem = each.problem
            lines.append(
                FieldLine(
                    key,
                    cells,
                    0,
                    rate_column,
                    f"{each.rate:g}",
                    each.enabled,
                    is_branch=bool(each.rows),
                    problem=problem,
                )
            )
            lines += [
                FieldLine(
                    key + row.path,
                    (row.name, row.type, "", row.text),
                    row.depth,
                    EXPRESSION if row.path else None,
                    row.text,
                    is_branch=row.is_branch,
                    problem=problem_of(row, texts),
                    begins_closed=is_long(row),
                )
                for row in each.rows
            ]
        if not self._publishers:
            lines.append(self.remark(texts("publisher.none")))
        lines += [self.remark(line, warns=True) for line in model.message.splitlines()]
        return lines

    def take(self, line: FieldLine, text: str) -> None:
        number, _, path = line.key.partition(":")
        if not path:
            if text:
                self.model.set_rate(int(number), text)
        else:
            self.model.set_expression(int(number), path, text)

    def resize(self, line: FieldLine, step: int) -> None:
        number, _, path = line.key.partition(":")
        self.model.resize(int(number), path, step)

    def tick(self, line: FieldLine) -> None:
        publisher = self._of(line)
        if publisher is not None:
            self.model.set_enabled(publisher.number, not publisher.enabled)

    def status(self) -> list[Piece]:
        publisher, colours = self._chosen(), self.look.colours
        pieces = super().status()
        if publisher is None:
            return pieces
        topic = clip(publisher.topic, max(8, self.inner_width // 2), self.look.glyphs.ellipsis)
        head = f"{topic}  " if not pieces else ""
        return [*pieces, Piece(f" {head}i = {self.model.count_of(publisher.number)} ", colours.muted)]

    # -- keys ----------------------------------------------------------------------------------------------------------

    def usual_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        if not self._publishers:
            return [("a", texts("publisher.add"))]
        line = self.list.chosen
        if line is not None and line.ticked is not None:
            return [("Space", texts("publisher.tick")), ("Enter", texts("publisher.columns.rate"))]
        return [*self.line_hints(), ("o", texts("publisher.once")), ("a", texts("publisher.add"))]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        arrows = "← →" if self.look.glyphs.unicode else "<- ->"
        return [
            ("o", texts("publisher.once")),
            ("Tab", texts("fields.next")),
            ("Del", texts("fields.default")),
            (arrows, texts("topics.open")),
            ("+ -", texts("fields.elements")),
            ("n", texts("publisher.new")),
            ("d", texts("publisher.remove")),
            ("C", texts("publisher.clear")),
        ]

    def used(self, event: events.Key) -> bool:
        line = self.list.chosen
        if event.character == "a":
            self.choose_topic()
        elif event.character == "n":
            self._type_topic()
        elif event.character == "C":
            self.model.clear()
        elif line is None:
            return False
        elif event.character == "o":
            self._publish_once()
        elif event.character == "d" or (event.key == "delete" and line.ticked is not None):
            self._remove()
        elif event.key == "space" and line.cells[1] != BOOLEAN:
            self.tick(line)
        else:
            return False
        return True

    def _of(self, line: FieldLine) -> ShownPublisher | None:
        number = line.key.partition(":")[0]
        return next((each for each in self._publishers if str(each.number) == number), None)

    def _chosen(self) -> ShownPublisher | None:
        return self._of(self.list.chosen) if self.list.chosen is not None else None

    def _publish_once(self) -> None:
        if (publisher := self._chosen()) is not None:
            self.model.publish_once(publisher.number)
            self.look.wake()

    def _remove(self) -> None:
        if (publisher := self._chosen()) is not None:
            self.model.remove(publisher.number)
            self.look.wake()

    # -- adding --------------------------------------------------------------------------------------------------------

    def choose_topic(self) -> None:
        """Open the list of topics; its first entry is a topic of another name."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        entries = [MenuEntry(self.look.texts("publisher.new_topic"), "", self._type_topic)]
        entries += [
            MenuEntry(name, kind, lambda name=name, kind=kind: self._add(name, kind))  # type: ignore[misc]
            for name, kind in self.model.topics()
        ]
        self.lay_over(Menu(self.look, "publisher.choose_topic", entries, chosen=min(1, len(entries) - 1)))

    def _type_topic(self) -> None:
        def taken(text: str) -> str | None:
            topic = text.strip()
            if not topic:
                return None
            kinds = dict(self.model.topics())
            kind = kinds.get(topic if topic.startswith("/") else f"/{topic}")
            if kind is not None:
                self._add(topic, kind)
            else:
                self.call_after_refresh(self._choose_type, topic)
            return None

        texts = self.look.texts
        self.ask(texts("publisher.new_topic"), "", taken, note=texts("publisher.new_topic.note"))

    def _choose_type(self, topic: str) -> None:
        from day6_core.interfaces import interface_names, packages
        from day6_tui.overlays.menu import Menu, MenuEntry

        kinds = [f"{package}/{name}" for package in packages() for name in interface_names(package, "msg")]
        entries = [MenuEntry(kind, "", lambda kind=kind: self._add(topic, kind)) for kind in sorted(kinds)]  # type: ignore[misc]
        self.lay_over(Menu(self.look, "publisher.choose_type", entries))

    def _add(self, topic: str, kind: str) -> None:
        self.model.add(topic, kind)
        self.look.wake()
