"""The Service Caller's window: which service, its request to fill in, its response."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events

from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.pane import Piece
from day6_tui.windows.fields.field_list import FieldLine
from day6_tui.windows.fields.pane import FieldPane
from day6_tui.windows.fields.rows import columns_in, head_line, lines_of
from day6_tui.windows.parts.buttons import Button, shortened

if TYPE_CHECKING:
    from day6_core.ros.programs.rqt_service_caller.model import ServiceCaller

REQUEST, RESPONSE = "?", "="
"""Before the paths of fields, in the keys of lines."""


class ServiceCallerPane(FieldPane["ServiceCaller"]):
    """Shows request and response one below the other."""

    def __init__(self, window: Window[ServiceCaller], look: Look) -> None:
        super().__init__(window, look, columns_in)
        self._called = False
        """Whether the outcome of a call is still to be brought into sight."""

    def pull(self, now: float) -> bool:
        before, animates = self._shown, super().pull(now)
        if self._called and self.model.state and self._shown != before:
            self.call_after_refresh(self.list.show_end)
            self._called = self.model.is_waiting
        return animates

    def _call(self) -> None:
        self._called = True
        self._request("call")

    def state(self) -> tuple[object, ...]:
        return (self.model.version,)

    def subject(self) -> object:
        return self.model.service

    def bar(self) -> Sequence[Segment | Button]:
        texts = self.look.texts
        call = (
            Button("x", texts("service.cancel"), self.ask_action("cancel"))
            if self.model.is_waiting
            else Button("c", texts("service.call"), self._call)
        )
        buttons = [call, Button("r", texts("service.refresh"), self.ask_action("refresh"))]
        mark = " ▾" if self.look.glyphs.chinese else " v"
        choice = Button("s", self.model.service or texts("service.none"), self.choose_service, mark=mark)
        return shortened([choice, *buttons], self.inner_width, self.look.glyphs.ellipsis)

    def lines(self) -> list[FieldLine]:
        texts, model = self.look.texts, self.model
        if not model.service:
            return [self.remark(texts("service.waiting_for_any"))]
        top = FieldLine(REQUEST, (model.service, model.type, ""), is_branch=bool(model.request))
        lines = [head_line(texts, "request"), top, *lines_of(model.request, REQUEST, editable=True)]
        lines.append(head_line(texts, "response"))
        if model.response is not None:
            top = FieldLine(RESPONSE, ("/", f"{model.type}.Response", ""), is_branch=bool(model.response))
            lines += [top, *lines_of(model.response, RESPONSE)]
        elif model.state == "failed":
            lines += [self.remark(line, warns=True) for line in model.message.splitlines()]
        elif model.state:
            late = model.state == "waiting" and model.waited > 0
            key = f"service.{model.state}{'.long' if late else ''}"
            lines.append(self.remark(texts(key, seconds=model.waited), warns=model.state == "gone"))
        return lines

    def take(self, line: FieldLine, text: str) -> None:
        self.model.set_expression(line.key.removeprefix(REQUEST), text)

    def resize(self, line: FieldLine, step: int) -> None:
        self.model.resize(line.key.removeprefix(REQUEST), step)

    # -- keys ----------------------------------------------------------------------------------------------------------

    def usual_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        call = ("x", texts("service.cancel")) if self.model.is_waiting else ("c", texts("service.call"))
        return [*self.line_hints(), call, ("s", texts("service.choose"))]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        arrows = "← →" if self.look.glyphs.unicode else "<- ->"
        return [
            ("Tab", texts("fields.next")),
            ("Del", texts("fields.default")),
            (arrows, texts("topics.open")),
            ("+ -", texts("fields.elements")),
            ("r", texts("service.refresh")),
        ]

    def used(self, event: events.Key) -> bool:
        if event.character == "c":
            self._call()
        elif event.character == "s":
            self.choose_service()
        elif event.character == "r":
            self.model.refresh()
        elif event.character == "x" or (event.key == "escape" and self.model.is_waiting):
            self.model.cancel()
        else:
            return False
        return True

    def choose_service(self) -> None:
        """Open the list of services."""
        from day6_tui.overlays.menu import Menu, MenuEntry

        services = self.model.services
        entries = [
            MenuEntry(name, kind, lambda name=name: self._choose(name))  # type: ignore[misc]
            for name, kind in services
        ]
        chosen = next((at for at, (name, _) in enumerate(services) if name == self.model.service), 0)
        self.lay_over(Menu(self.look, "service.choose_title", entries, chosen=chosen))

    def _choose(self, name: str) -> None:
        self.model.choose(name)
        self.look.wake()

    def status(self) -> list[Piece]:
        count = self.look.texts("service.count", count=len(self.model.services))
        return super().status() or [Piece(f" {count} ", self.look.colours.muted)]
