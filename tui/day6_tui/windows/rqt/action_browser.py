"""rqt_action's window: the actions of the graph, their goals, one to fill in and send; below them the types, as in rqt."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rich.segment import Segment
from textual import events

from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows.fields.field_list import FieldLine
from day6_tui.windows.fields.rows import lines_of
from day6_tui.windows.parts.buttons import Button
from day6_tui.windows.rqt.type_browser import BrowsingPane

if TYPE_CHECKING:
    from collections.abc import Sequence

    from day6_core.ros.programs.rqt_action.model import ActionBrowser, ActionEntry, Goal
    from day6_core.ros.programs.rqt_msg.model import TypeBrowser

ACTION, GOAL, REQUEST = "@", "!", "?"
"""Before the name of an action in the keys of its lines; behind it, before a goal's id and before a field of the request."""

SHORT = 8
"""Digits of a goal's id that are shown."""


class ActionBrowserPane(BrowsingPane["ActionBrowser"]):
    """An open action is watched."""

    needs = PaneNeeds(Extent(36, 9), Extent(60, 18), Extent(100, 30))

    def __init__(self, window: Window[ActionBrowser], look: Look) -> None:
        super().__init__(window, look)
        self._actions: list[ActionEntry] = []
        self.list.wants_open = self._wants_open

    @property
    def browser(self) -> TypeBrowser:
        return self.model.browser

    def state(self) -> tuple[object, ...]:
        return (self.model.version, *super().state())

    def bar(self) -> Sequence[Segment | Button]:
        texts = self.look.texts
        if not any(action.watched for action in self._actions):
            return super().bar()
        send = Button("g", texts("actions.send"), self._send)
        return [send, Button("x", texts("actions.cancel"), self._cancel), *super().bar()]

    def lines(self) -> list[FieldLine]:
        texts = self.look.texts
        self._actions = self.model.shown()
        names = ("actions.live", "fields.type", "fields.value")
        lines = [FieldLine("", tuple(map(texts, names)), is_head=True)]
        for action in self._actions:
            lines += self._lines_of(action)
        if not self._actions:
            lines.append(self.remark(texts("actions.none")))
        return lines + super().lines()

    def _lines_of(self, action: ActionEntry) -> list[FieldLine]:
        texts, key = self.look.texts, ACTION + action.name
        ends = texts("actions.ends", servers=len(action.servers), clients=len(action.clients))
        lines = [FieldLine(key, (action.name, action.type, ends), is_branch=True)]
        if not action.watched:
            return lines
        goal_type = f"{action.type}.Goal"
        lines.append(
            FieldLine(f"{key}{REQUEST}", (texts("actions.goal"), goal_type, ""), 1, is_branch=bool(action.request))
        )
        lines += lines_of(action.request, f"{key}{REQUEST}", editable=True)
        if action.state:
            text = action.message or texts(f"actions.state.{action.state}")
            warns = action.state != "sent"
            lines.append(FieldLine("", (text,), 1, problem=text if warns else ""))
        for goal in action.goals:
            lines += self._goal(action, goal, f"{key}{GOAL}{goal.id}")
        for part, nodes in (("server", action.servers), ("client", action.clients)):
            lines += [FieldLine(f"{key} {part}{node}", (texts(f"actions.{part}"), "", node), 1) for node in nodes]
        return lines

    def _goal(self, action: ActionEntry, goal: Goal, key: str) -> list[FieldLine]:
        texts = self.look.texts
        whose = texts("actions.own") if goal.is_own else ""
        name = texts("actions.id", id=goal.id[:SHORT])
        lines = [FieldLine(key, (name, whose, goal.status), 1, is_branch=bool(goal.feedback or goal.result))]
        for part, rows in (("Feedback", goal.feedback), ("Result", goal.result)):
            if rows:
                head = (texts(f"actions.{part.lower()}"), f"{action.type}.{part}", "")
                lines.append(FieldLine(f"{key}{part}", head, 2, is_branch=True))
                lines += lines_of((row._replace(depth=row.depth - 1) for row in rows), f"{key}{part}")
        return lines

    def take(self, line: FieldLine, text: str) -> None:
        name, _, path = line.key.removeprefix(ACTION).partition(REQUEST)
        self.model.set_expression(name, path, text)

    def resize(self, line: FieldLine, step: int) -> None:
        name, _, path = line.key.removeprefix(ACTION).partition(REQUEST)
        self.model.resize(name, path, step)

    # -- opening -------------------------------------------------------------------------------------------------------

    def _wants_open(self, line: FieldLine) -> bool:
        action = self._action_of(line)
        return action is None or line.key != ACTION + action.name or action.watched

    def toggle(self, line: FieldLine) -> None:
        action = self._action_of(line)
        if action is not None and line.key == ACTION + action.name:
            self.model.watch(action.name, not action.watched)
        else:
            super().toggle(line)

    def enter(self, line: FieldLine) -> None:
        if line.is_branch and not line.key.startswith("#"):
            self.toggle(line)
        else:
            super().enter(line)

    # -- keys ----------------------------------------------------------------------------------------------------------

    def usual_hints(self) -> list[tuple[str, str]]:
        texts, action = self.look.texts, self._chosen()
        if action is None:
            return super().usual_hints()
        if not action.watched:
            return [("Enter", texts("actions.watch")), *super().usual_hints()]
        return [*self.line_hints(), ("g", texts("actions.send")), ("x", texts("actions.cancel"))]

    def used(self, event: events.Key) -> bool:
        if event.character == "g":
            self._send()
        elif event.character == "x":
            self._cancel()
        else:
            return super().used(event)
        return True

    def _action_of(self, line: FieldLine) -> ActionEntry | None:
        name = line.key.removeprefix(ACTION) if line.key.startswith(ACTION) else ""
        ends = ("", " ", REQUEST, GOAL)
        return next(
            (each for each in self._actions if name[len(each.name) :][:1] in ends and name.startswith(each.name)), None
        )

    def _chosen(self) -> ActionEntry | None:
        """The action that the cursor is on; the only one that is watched, if it is on none."""
        line = self.list.chosen
        watched = [action for action in self._actions if action.watched]
        return (self._action_of(line) if line is not None else None) or (watched[0] if len(watched) == 1 else None)

    def _send(self) -> None:
        if (action := self._chosen()) is not None:
            self.model.send(action.name)
            self.look.wake()

    def _cancel(self) -> None:
        """Cancel the goal that the cursor is on, or else the newest one that was sent from here."""
        action, line = self._chosen(), self.list.chosen
        if action is None or line is None:
            return
        own = [goal for goal in action.goals if goal.is_own and goal.status in ("ACCEPTED", "EXECUTING")]
        here = [goal for goal in own if f"{GOAL}{goal.id}" in line.key]
        for goal in (here or own)[:1]:
            self.model.cancel(action.name, goal.id)
        self.look.wake()
