"""`ros2 topic echo`."""

from __future__ import annotations

import re
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import value
from day6_core.ros.ros2.cli.choice import choose_topic, may_be_left_out
from day6_core.ros.ros2.cli.completion import topic_fields, topic_names, topic_types
from day6_core.ros.ros2.cli.node import direct_node, graph_node
from day6_core.ros.ros2.cli.options import (
    add_length_options,
    add_qos_options,
    add_strategy_options,
    completed,
    positive_float,
)

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.task import Future

SUMMARY = "Output messages from a topic"
_ENTRY = re.compile(r"\[(\d+)\]")
CLEAR = "\x1b[H\x1b[2J"
START_SECONDS = 1.0
"""Time in which a topic may appear: the real command itself needs that long to start, and launch files rely on it."""


def add_arguments(parser: ArgumentParser) -> None:
    add_strategy_options(parser)
    completed(
        parser.add_argument(
            "topic_name", nargs=may_be_left_out(), help="Name of the ROS topic to listen to (e.g. '/chatter')"
        ),
        topic_names,
    )
    completed(
        parser.add_argument("message_type", nargs="?", help="Type of the ROS message (e.g. 'std_msgs/msg/String')"),
        topic_types,
    )
    add_qos_options(parser, "subscribe", "sensor_data")
    parser.add_argument(
        "--csv",
        action="store_true",
        help="Output all recursive fields separated by commas (e.g. for plotting). If --include-message-info is also "
        "passed, the following fields are prepended: source_timestamp, received_timestamp, publication_sequence_number, "
        "reception_sequence_number.",
    )
    words = (
        "Echo a selected field of a message. Use '.' to select sub-fields. For example, to echo the position field of a "
        "nav_msgs/msg/Odometry message: 'ros2 topic echo /odom --field pose.pose.position'"
    )
    field = (
        parser.add_argument("--field", action="append", help=f"{words}. May be given more than once")
        if value("topic.echo_of_several")
        else parser.add_argument("--field", help=words)
    )
    completed(field, topic_fields)
    add_length_options(parser)
    parser.add_argument("--no-lost-messages", action="store_true", help="Don't report when a message is lost")
    parser.add_argument("--raw", action="store_true", help="Echo the raw binary representation")
    parser.add_argument(
        "--filter",
        dest="filter_expr",
        help="Python expression to filter messages that are printed. Expression can use Python builtins as well as m (the "
        "message).",
    )
    parser.add_argument("--once", action="store_true", help="Print the first message received and then exit.")
    parser.add_argument("--timeout", metavar="N", type=positive_float, help="Set a timeout in seconds for waiting")
    parser.add_argument("--include-message-info", "-i", action="store_true", help="Shows the associated message info.")
    parser.add_argument("--clear", "-c", action="store_true", help="Clear screen before printing next message")
    parser.add_argument(
        "-n", "--node-name", help="The name of the echoing node; by default, will be a hidden node name"
    )


async def main(session: Session, args: Namespace) -> None:
    from day6_core.ros.ros2.cli.message_class import POLL_SECONDS, class_of_topic, message_class, unpublished
    from day6_core.ros.ros2.cli.qos import profile_for_echo

    echo = _Echo(session, args)
    async with graph_node(session, args) as query_node:
        if args.topic_name is None:
            args.topic_name = await choose_topic(session, args, query_node, "Select topic to echo:")
        env = session.env
        kind = message_class(args.message_type, env) if args.message_type is not None else None
        waited = 0.0
        while (
            kind is None
            and (kind := class_of_topic(query_node, args.topic_name, env)) is None
            and waited < START_SECONDS
        ):
            await session.sleep(POLL_SECONDS)
            waited += POLL_SECONDS
        profile = profile_for_echo(session, query_node, args, args.topic_name)
        if kind is None:
            session.print(unpublished(args.topic_name))
            raise RuntimeError("Could not determine the type for the passed topic")
    node = await direct_node(session, args, args.node_name)
    if args.timeout is not None:
        node.create_timer(args.timeout, echo.time_out)
    node.create_subscription(
        kind, args.topic_name, echo.receive, profile, event_callbacks=_lost_callbacks(session, args), raw=args.raw
    )
    if echo.future is None:
        await session.spin(node)
    else:
        session.executor.add_node(node)
        await session.spin_until(echo.future)


def _lost_callbacks(session: Session, args: Namespace) -> Any:
    if args.no_lost_messages:
        return None
    from rclpy.event_handler import SubscriptionEventCallbacks

    def lost(status: Any) -> None:
        session.print(
            f"A message was lost!!!\n\ttotal count change:{status.total_count_change}"
            f"\n\ttotal count: {status.total_count}",
            end="---\n",
        )

    return SubscriptionEventCallbacks(message_lost=lost)


class _Echo:
    """Prints received messages as the options say. `future` is done when the command should end; None if never."""

    def __init__(self, session: Session, args: Namespace) -> None:
        self.session = session
        self.args = args
        given = [args.field] if isinstance(args.field, str) else args.field or []
        self.fields = [[part for part in field.split(".") if part] for field in given]
        """The fields to print, each a path; without any, the whole message."""
        for field, path in zip(given, self.fields, strict=True):
            if not path:
                raise RuntimeError(f"Invalid field value '{field}'")
        self.limits: dict[str, Any] = {
            "truncate_length": None if args.full_length else args.truncate_length,
            "no_arr": args.no_arr,
            "no_str": args.no_str,
        }
        self.future: Future[bool] | None = None
        if args.timeout or args.once:
            from rclpy.task import Future

            self.future = Future()

    def time_out(self) -> None:
        if self.future is not None:
            self.future.set_result(True)

    def receive(self, message: Any, info: Any) -> None:
        if self.future is not None and self.future.done():
            return  # a second message, before the command has ended
        chosen = [self._select(message, path) for path in self.fields or [[]]]
        if self.args.filter_expr and not self._passes(chosen[-1]):
            return
        if self.future is not None and self.args.once:
            self.future.set_result(True)
        if self.args.clear:
            self.session.stdout.control(CLEAR + "\n")
        for selected in chosen:
            if not hasattr(selected, "__slots__"):
                self._print_bare(selected, info)
            elif self.args.csv:
                self._print_csv(selected, info)
            else:
                self._print_yaml(selected, info)

    def _select(self, message: Any, path: list[str]) -> Any:
        """Return a field of a message, where the distribution knows them also entries of arrays: `name[1][2]`."""
        for field in path:
            name, *numbers = _ENTRY.split(field) if value("topic.echo_of_several") else [field]
            try:
                message = getattr(message, name)
                for number in filter(None, numbers):
                    message = message[int(number)]
            except (AttributeError, IndexError, TypeError) as error:
                raise RuntimeError(f"Invalid field '{'.'.join(path)}': {error}") from None
        return message

    def _passes(self, message: Any) -> bool:
        from day6_core.ros.ros2.topic._filter import evaluate

        return bool(evaluate(self.args.filter_expr, message))

    def _print_bare(self, value: Any, info: Any) -> None:
        if self.args.include_message_info:
            self.session.print("---Got new message, message info:---")
            self.session.print(info)
            self.session.print("---Message data:---")
        self.session.print(value, end="\n---\n")

    def _print_csv(self, message: Any, info: Any) -> None:
        from rosidl_runtime_py.convert import message_to_csv

        line = message_to_csv(message, **self.limits)
        if self.args.include_message_info:
            line = f"{','.join(map(str, info.values()))},{line}"
        self.session.print(line)

    def _print_yaml(self, message: Any, info: Any) -> None:
        from rosidl_runtime_py.convert import message_to_yaml

        if self.args.include_message_info:
            import yaml

            self.session.print(yaml.safe_dump(info), end="---\n")
        text = message_to_yaml(message, flow_style=self.args.flow_style, **self.limits)
        self.session.print(text, end="---\n")
