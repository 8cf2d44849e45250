"""`ros2 action send_goal`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.completion import action_names, action_types_of_action, goal_prototype
from day6_core.ros.ros2.cli.node import PREFIX, appears, plain_node
from day6_core.ros.ros2.cli.options import add_response_timeout, completed
from day6_core.ros.ros2.cli.yaml_text import safe_load

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.action.client import ActionClient, ClientGoalHandle

SUMMARY = "Send an action goal"


def add_arguments(parser: ArgumentParser) -> None:
    completed(parser.add_argument("action_name", help="Name of the ROS action (e.g. '/fibonacci')"), action_names)
    completed(
        parser.add_argument("action_type", help="Type of the ROS action (e.g. 'example_interfaces/action/Fibonacci')"),
        action_types_of_action,
    )
    source = parser.add_mutually_exclusive_group()
    completed(
        source.add_argument(
            "goal", nargs="?", default="{}", help="Goal request values in YAML format (e.g. '{order: 10}')"
        ),
        goal_prototype,
    )
    source.add_argument("--stdin", action="store_true", help="Read goal from standard input")
    parser.add_argument("-f", "--feedback", action="store_true", help="Echo feedback messages for the goal")
    add_response_timeout(parser)


async def main(session: Session, args: Namespace) -> str | None:
    from rosidl_runtime_py.convert import message_to_yaml
    from rosidl_runtime_py.set_message import set_message_fields
    from rosidl_runtime_py.utilities import get_action

    from rclpy.action import ActionClient

    text = (await session.stdin.read_all()).encode() if args.stdin else args.goal
    try:
        kind = get_action(args.action_type)
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError("The passed action type is invalid") from None
    values = await safe_load(text)
    node = await plain_node(session, f"{PREFIX}_send_goal_{args.action_type.replace('/', '_')}")
    client: ActionClient[Any, Any, Any] = ActionClient(node, kind, args.action_name)
    session.defer(client.destroy)
    goal = kind.Goal()
    try:
        set_message_fields(goal, values)
    except Exception as error:
        return f"Failed to populate message fields: {error!r}"
    session.print("Waiting for an action server to become available...")
    if not await appears(session, client.server_is_ready, args.timeout):
        return f"Action server is not available after waiting {args.timeout} seconds."
    session.print(f"Sending goal:\n     {message_to_yaml(goal)}")
    session.executor.add_node(node)

    early: list[Any] | None = []

    def feedback(message: Any) -> None:
        if early is not None:
            early.append(message)  # it arrived together with the acceptance, which is printed first
        else:
            session.print(f"Feedback:\n    {message_to_yaml(message.feedback)}")

    handle = await _send(session, client, goal, feedback if args.feedback else None, args.timeout)
    if handle is None:
        session.print("Goal was rejected.")
        return None
    session.print(f"Goal accepted with ID: {bytes(handle.goal_id.uuid).hex()}\n")
    waiting, early = early, None
    for message in waiting or ():
        feedback(message)
    result = await _result(session, handle, args.timeout)
    session.print(f"Result:\n    {message_to_yaml(result.result)}")
    session.print(f"Goal finished with status: {_status_name(result.status)}")
    return None


async def _send(
    session: Session, client: ActionClient[Any, Any, Any], goal: Any, feedback: Any, seconds: float | None
) -> ClientGoalHandle[Any, Any, Any] | None:
    """Send the goal; returns None if the server rejects it."""
    future = client.send_goal_async(goal, feedback)
    if not await session.spin_until(future, seconds):
        raise RuntimeError(f"Timed out waiting for the goal's acceptance (timeout: {seconds}s)")
    handle = future.result()
    if handle is None:
        raise RuntimeError(f"Exception while sending goal: {future.exception()!r}")
    return handle if handle.accepted else None


async def _result(session: Session, handle: ClientGoalHandle[Any, Any, Any], seconds: float | None) -> Any:
    """Wait for the result; Ctrl-C cancels the goal."""
    future = handle.get_result_async()
    try:
        if not await session.spin_until(future, seconds):
            raise RuntimeError(f"Timed out waiting for the result (timeout: {seconds}s)")
    except KeyboardInterrupt:
        session.print("Canceling goal...")
        handle.cancel_goal_async()
        # In the real tool Ctrl-C has shut the context down by now: the request goes out, the response never arrives.
        raise RuntimeError("Exception while canceling goal: None") from None
    result = future.result()
    if result is None:
        raise RuntimeError(f"Exception while getting result: {future.exception()!r}")
    return result


def _status_name(status: int) -> str:
    from action_msgs.msg import GoalStatus

    names = ("ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED")
    return next((name for name in names if getattr(GoalStatus, f"STATUS_{name}") == status), "UNKNOWN")
