"""What the action browser shows: the actions of the graph with their goals, and the fields of action types.

The types are all that the real plugin shows; the live part is day6-tui's own. An action is watched while its branch is open:
that takes subscriptions to its status and feedback, by which `ros2 action info` counts this node as a client, as it would any.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.graph.names import full_name
from day6_core.interfaces import SerializationError, get_action
from day6_core.ros.programs.rqt_msg.model import TypeBrowser
from day6_core.ros.programs.rqt_py_common.message_form import INTERFACE_ERRORS, FieldRow, MessageForm, field_rows
from day6_core.ros.programs.rqt_py_common.requests import Requests
from day6_core.ros.programs.rqt_service_caller.model import REQUEST_NAMES, convert
from rclpy.action import ActionClient, get_action_names_and_types
from rclpy.qos import qos_profile_action_status_default

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.task import Future

STATUSES = ("UNKNOWN", "ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED")
"""The names of action_msgs/msg/GoalStatus by their numbers."""

ACTIVE = frozenset(("ACCEPTED", "EXECUTING"))
"""Goals that can be cancelled."""

MOST_GOALS = 20
"""Of each action, the newest."""


class Goal(NamedTuple):
    """A goal: its id in hexadecimal digits, its status, whether it was sent from here, and its newest messages."""

    id: str
    status: str
    is_own: bool
    feedback: list[FieldRow]
    result: list[FieldRow]


class ActionEntry(NamedTuple):
    """An action of the graph, with the full names of the nodes at its ends."""

    name: str
    type: str
    servers: tuple[str, ...]
    clients: tuple[str, ...]
    watched: bool
    request: list[FieldRow]
    goals: list[Goal]
    state: str
    """Of the last goal sent from here: sent (and not accepted yet), rejected, no_server or failed (see `message`)."""
    message: str


class ActionBrowser(Requests):
    """The model of one action browser. The window reads `shown` and calls what is below "the window's side"."""

    def __init__(self, node: Node) -> None:
        super().__init__()
        self.browser = TypeBrowser("action")
        """The part that the real plugin has."""
        self._node = node
        self._found: tuple[tuple[str, str, tuple[str, ...], tuple[str, ...]], ...] = ()
        self._watched: dict[str, _Watched] = {}
        self.version = 0

    def shown(self) -> list[ActionEntry]:
        """The actions by name."""
        actions = []
        for name, type_name, servers, clients in self._found:
            watched = self._watched.get(name)
            if watched is None:
                actions.append(ActionEntry(name, type_name, servers, clients, False, [], [], "", ""))
            else:
                goals, request = watched.goals(), watched.request()
                state, message = watched.state, watched.message
                actions.append(ActionEntry(name, type_name, servers, clients, True, request, goals, state, message))
        return actions

    # -- the window's side ---------------------------------------------------------------------------------------------

    def watch(self, action: str, watched: bool) -> None:
        """Follow the goals of an action, or no longer."""
        self.post(partial(self._watch, action, watched=watched))

    def set_expression(self, action: str, path: str, text: str) -> None:
        """Give a field of the goal an expression; an empty one gives it back its default."""
        self.post(partial(self._change, action, lambda watched: watched.set_expression(path, text)))

    def resize(self, action: str, path: str, step: int) -> None:
        """Give a sequence in the goal one element more (1) or less (-1)."""
        self.post(partial(self._change, action, lambda watched: watched.resize(path, step)))

    def send(self, action: str) -> None:
        """Send the goal."""
        self.post(partial(self._change, action, lambda watched: watched.send()))

    def cancel(self, action: str, goal: str) -> None:
        """Ask the server to cancel a goal that was sent from here."""
        self.post(partial(self._change, action, lambda watched: watched.cancel(goal)))

    # -- the program's side --------------------------------------------------------------------------------------------

    def follow(self) -> None:
        """Carry out the window's requests, and look at the graph."""
        self.handle()
        found = tuple(
            (name, types[0], self._ends(name, servers=True), self._ends(name, servers=False))
            for name, types in sorted(get_action_names_and_types(self._node))
        )
        if found != self._found:
            self._found = found
            self.version += 1
            for name in self._watched.keys() - {each[0] for each in found}:
                self._watch(name, watched=False)

    def close(self) -> None:
        """Watch nothing any more."""
        for name in list(self._watched):
            self._watch(name, watched=False)

    def changed(self) -> None:
        """Something that the window shows is different now."""
        self.version += 1

    def _ends(self, action: str, *, servers: bool) -> tuple[str, ...]:
        topic = f"{action}/_action/feedback"
        node = self._node
        infos = node.get_publishers_info_by_topic(topic) if servers else node.get_subscriptions_info_by_topic(topic)
        return tuple(sorted({full_name(info.node_namespace, info.node_name) for info in infos}))

    def _watch(self, action: str, *, watched: bool) -> None:
        if not watched and action in self._watched:
            self._watched.pop(action).close()
        elif watched and action not in self._watched:
            type_name = next((each[1] for each in self._found if each[0] == action), "")
            try:
                self._watched[action] = _Watched(self._node, action, get_action(type_name), self.changed)
            except INTERFACE_ERRORS as error:
                self.browser.message = f"Failed to load class {type_name}: {error}"
        self.version += 1

    def _change(self, action: str, change: Callable[[_Watched], object]) -> None:
        watched = self._watched.get(action)
        if watched is not None:
            change(watched)
            self.version += 1


class _Watched:
    """The goals of one action as its server tells them, and the client that sends goals from here."""

    def __init__(self, node: Node, action: str, action_class: Any, changed: Callable[[], None]) -> None:
        self._node, self._changed = node, changed
        self._form = MessageForm(action_class.Goal, convert)
        self._client: ActionClient[Any, Any, Any] = ActionClient(node, action_class, action)
        parts = action_class.Impl
        self._subscriptions = [
            node.create_subscription(
                parts.GoalStatusMessage, f"{action}/_action/status", self._on_status, qos_profile_action_status_default
            ),
            node.create_subscription(parts.FeedbackMessage, f"{action}/_action/feedback", self._on_feedback, 10),
        ]
        self._statuses: dict[str, str] = {}
        self._feedback: dict[str, Any] = {}
        self._results: dict[str, Any] = {}
        self._handles: dict[str, Any] = {}
        """Of the goals that were sent from here."""
        self._last: Future[Any] | None = None
        self.state = self.message = ""

    def close(self) -> None:
        for subscription in self._subscriptions:
            self._node.destroy_subscription(subscription)
        self._last = None
        self._client.destroy()

    def request(self) -> list[FieldRow]:
        return self._form.rows(2)

    def goals(self) -> list[Goal]:
        """The newest first."""
        return [
            Goal(
                each,
                status,
                each in self._handles,
                field_rows(self._feedback[each], 4) if each in self._feedback else [],
                field_rows(self._results[each], 4) if each in self._results else [],
            )
            for each, status in list(self._statuses.items())[::-1]  # which grows on another thread
        ]

    def set_expression(self, path: str, text: str) -> None:
        self._form.set(path, text)
        self._form.message(REQUEST_NAMES)

    def resize(self, path: str, step: int) -> None:
        self._form.resize(path, step, REQUEST_NAMES)

    def send(self) -> None:
        if not self._client.server_is_ready():
            self.state = "no_server"
            return
        try:
            future = self._client.send_goal_async(self._form.message(REQUEST_NAMES))
        except (SerializationError, AssertionError, OverflowError, TypeError, ValueError) as error:
            self.state, self.message = "failed", str(error)
            return
        self.state, self.message, self._last = "sent", "", future
        future.add_done_callback(self._on_answer)

    def cancel(self, goal: str) -> None:
        if (handle := self._handles.get(goal)) is not None and self._statuses.get(goal) in ACTIVE:
            handle.cancel_goal_async()

    def _on_answer(self, future: Future[Any]) -> None:
        handle: Any = future.result()
        if future is self._last:
            self.state = "" if handle.accepted else "rejected"
        if handle.accepted:
            goal = _hex(handle.goal_id)
            self._handles[goal] = handle
            self._take(goal, self._statuses.get(goal, "ACCEPTED"))
            handle.get_result_async().add_done_callback(partial(self._on_result, goal))
        self._changed()

    def _on_result(self, goal: str, future: Future[Any]) -> None:
        response: Any = future.result()
        self._results[goal] = response.result
        self._take(goal, STATUSES[response.status])
        self._changed()

    def _on_status(self, message: Any) -> None:
        for each in sorted(
            message.status_list, key=lambda each: (each.goal_info.stamp.sec, each.goal_info.stamp.nanosec)
        ):
            self._take(_hex(each.goal_info.goal_id), STATUSES[each.status] if 0 <= each.status < 7 else STATUSES[0])
        self._changed()

    def _on_feedback(self, message: Any) -> None:
        goal = _hex(message.goal_id)
        self._feedback[goal] = message.feedback
        self._take(goal, self._statuses.get(goal, STATUSES[0]))
        self._changed()

    def _take(self, goal: str, status: str) -> None:
        """Note the status of a goal; the oldest goals go."""
        self._statuses[goal] = status
        for old in list(self._statuses)[:-MOST_GOALS]:
            for kept in (self._statuses, self._feedback, self._results, self._handles):
                kept.pop(old, None)


def _hex(goal_id: Any) -> str:
    return bytes(goal_id.uuid).hex()
