"""`ros2 topic pub`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from itertools import repeat
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.cli.completion import message_prototype, topic_names, topic_types
from day6_core.ros.ros2.cli.node import direct_node
from day6_core.ros.ros2.cli.options import (
    add_discovery_options,
    add_qos_options,
    completed,
    nonnegative_int,
    positive_float,
)
from day6_core.ros.ros2.cli.pace import Pace
from day6_core.ros.ros2.cli.yaml_text import file_text, in_turns_with_others, load_all, safe_load

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from rclpy.publisher import Publisher

SUMMARY = "Publish a message to a topic"
POLL_SECONDS = 0.1
POLLS_PER_LINE = 10


def add_arguments(parser: ArgumentParser) -> None:
    completed(
        parser.add_argument("topic_name", help="Name of the ROS topic to publish to (e.g. '/chatter')"), topic_names
    )
    completed(parser.add_argument("message_type", help="Type of the ROS message (e.g. 'std_msgs/String')"), topic_types)
    source = parser.add_mutually_exclusive_group()
    completed(
        source.add_argument(
            "values",
            nargs="?",
            default="{}",
            help="Values to fill the message with in YAML format (e.g. 'data: Hello World'), otherwise the message will be "
            "published with default values",
        ),
        message_prototype,
    )
    source.add_argument("--stdin", action="store_true", help="Read values from standard input")
    source.add_argument(
        "--yaml-file", help="YAML file that has message contents, e.g STDOUT from ros2 topic echo <topic>"
    )
    parser.add_argument(
        "-r", "--rate", metavar="N", type=positive_float, default=1.0, help="Publishing rate in Hz (default: 1)"
    )
    parser.add_argument(
        "-p",
        "--print",
        metavar="N",
        type=int,
        default=1,
        help="Only print every N-th published message (default: 1)",
    )
    number = parser.add_mutually_exclusive_group()
    number.add_argument("-1", "--once", action="store_true", help="Publish one message and exit")
    number.add_argument(
        "-t", "--times", type=nonnegative_int, default=0, help="Publish this number of times and then exit"
    )
    parser.add_argument(
        "-w",
        "--wait-matching-subscriptions",
        type=nonnegative_int,
        help='Wait until finding the specified number of matching subscriptions. Defaults to 1 when using "-1"/"--once"/'
        '"--times", otherwise defaults to 0.',
    )
    parser.add_argument(
        "--max-wait-time-secs",
        type=positive_float,
        help="This sets the maximum wait time in seconds if --wait-until-matching-subscriptions is set. By default, this "
        "flag is not set meaning the subscriber will wait endlessly.",
    )
    parser.add_argument(
        "--keep-alive",
        metavar="N",
        type=positive_float,
        default=0.1,
        help="Keep publishing node alive for N seconds after the last msg (default: 0.1)",
    )
    parser.add_argument("-n", "--node-name", help="Name of the created publishing node")
    add_qos_options(parser, "publish", "default")
    add_discovery_options(parser)


async def main(session: Session, args: Namespace) -> str | None:
    from day6_core.ros.ros2.cli.message_class import message_class
    from day6_core.ros.ros2.cli.qos import profile_from_options

    profile = profile_from_options(args)
    text = (await session.stdin.read_all()).encode() if args.stdin else args.values
    node = await direct_node(session, args, args.node_name)
    kind = message_class(args.message_type, session.env)
    contents: list[Any] = []
    if args.yaml_file is not None:
        contents = await in_turns_with_others(lambda abandoned: load_all(file_text(session, args.yaml_file), abandoned))
    elif not isinstance(values := await safe_load(text), dict):
        return "The passed value needs to be a dictionary in YAML format"
    else:
        contents = [values]
    publisher = node.create_publisher(kind, args.topic_name, profile)
    times = 1 if args.once else args.times
    wanted = args.wait_matching_subscriptions
    if wanted is None:
        wanted = 1 if times else 0
    if wanted == 0 and args.max_wait_time_secs is not None:
        return "--max-wait-time-secs option is only effective with --wait-matching-subscriptions, --once or --times"
    refusal = await _wait_for_subscriptions(session, publisher, wanted, args.max_wait_time_secs)
    if refusal is not None:
        return refusal
    publication = _Publication(session, node, publisher, kind(), args.print)
    if args.yaml_file is None and (problem := publication.fill(contents[0])):
        return problem
    session.print("publisher: beginning loop")
    pace = Pace(session, 1.0 / args.rate)
    session.executor.add_node(node)
    for content in contents if args.yaml_file is not None else repeat(None):
        if content is not None and (problem := publication.fill(content)):
            session.print_error(problem)
            continue
        if publication.count:
            await session.stdout.drain()
            await pace.turn()
            session.spin_some()
        publication.publish()
        if publication.count == times:
            break
    await session.sleep(args.keep_alive)
    return None


class _Publication:
    """One message, published repeatedly; its stamps are set anew every time."""

    def __init__(self, session: Session, node: Any, publisher: Publisher[Any], message: Any, print_nth: int) -> None:
        self.session = session
        self.clock = node.get_clock()
        self.publisher = publisher
        self.message = message
        self.stamps: list[Any] = []
        self.print_nth = print_nth
        self.count = 0

    def fill(self, values: Any) -> str | None:
        """Set fields of the message; return what went wrong."""
        from rosidl_runtime_py.set_message import set_message_fields

        if not isinstance(values, dict):
            return "The contents in YAML file need to be a YAML format"
        try:
            self.stamps = set_message_fields(self.message, values, expand_header_auto=True, expand_time_now=True)
        except Exception as error:
            return f"Failed to populate field: {error}"
        return None

    def publish(self) -> None:
        now = self.clock.now().to_msg() if self.stamps else None
        for stamp in self.stamps:
            stamp(now)
        self.count += 1
        if self.print_nth and self.count % self.print_nth == 0:
            self.session.print(f"publishing #{self.count}: {self.message!r}\n")
        self.publisher.publish(self.message)


async def _wait_for_subscriptions(
    session: Session, publisher: Publisher[Any], wanted: int, longest: float | None
) -> str | None:
    """Wait for `wanted` subscriptions, printing so every second; return the error once `longest` seconds have passed."""
    if wanted == 0:
        return None
    # On a real network a new publisher has not discovered any subscription yet, so the count starts at zero.
    present = 0
    waited = polls = 0.0
    while present < wanted:
        if polls % POLLS_PER_LINE == 0:
            session.print(f"Waiting for at least {wanted} matching subscription(s)...")
        if longest is not None and longest <= waited:
            return f"Timed out waiting for subscribers: Expected {wanted} subcribers but only got {present} subscribers"
        polls += 1
        await session.sleep(POLL_SECONDS)
        waited += POLL_SECONDS
        present = publisher.get_subscription_count()
    return None
