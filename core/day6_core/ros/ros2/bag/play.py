"""`ros2 bag play`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import value
from day6_core.ros.ros2.bag._options import (
    LOG_LEVELS,
    add_bag_path,
    add_qos_overrides,
    error,
    event_topics,
    not_negative_float,
    not_negative_int,
    positive_float,
    readable_file,
    regular_expression,
)
from day6_core.ros.ros2.cli.completion import topic_names
from day6_core.ros.ros2.cli.options import completed

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Play back ROS data from a bag"

_LIMITS = (
    "When positive, the maximum effective time between {other} and this argument will determine when playback stops."
)


def add_arguments(parser: ArgumentParser) -> None:
    add_bag_path(parser, required=False, storage=value("bag.play_takes_storage"))
    parser.add_argument(
        "-i",
        "--input",
        action="append",
        nargs="+",
        metavar=("uri", "storage_id"),
        help="URI (and optional storage ID) of an input bag. May be provided more than once for multiple input bags.",
    )
    add_reading(parser)
    parser.add_argument(
        "-r",
        "--rate",
        type=positive_float,
        default=1.0,
        help="rate at which to play back messages. Valid range > 0.0.",
    )
    _add_choice(parser)
    add_qos_overrides(parser)
    parser.add_argument(
        "-l",
        "--loop",
        action="store_true",
        help="enables loop playback when playing a bagfile: it starts back at the beginning on reaching the end and plays "
        "indefinitely.",
    )
    add_remapping(parser)
    _add_clock(parser)
    _add_span(parser)
    parser.add_argument(
        "--disable-keyboard-controls", action="store_true", help="disables keyboard controls for playback"
    )
    parser.add_argument(
        "-p", "--start-paused", action="store_true", help="Start the playback player in a paused state."
    )
    parser.add_argument(
        "--wait-for-all-acked",
        type=not_negative_int,
        default=-1,
        metavar="TIMEOUT",
        help="Wait until all published messages are acknowledged by all subscribers or until the timeout elapses in "
        "millisecond before play is terminated. Negative timeout is invalid. 0 means wait forever. Note that this option is "
        "valid only if the publisher's QOS profile is RELIABLE.",
    )
    parser.add_argument(
        "--disable-loan-message",
        action="store_true",
        help="Disable to publish as loaned message. Nothing is loaned here.",
    )
    parser.add_argument(
        "--publish-service-requests",
        action="store_true",
        help="Publish recorded service requests instead of recorded service events",
    )
    parser.add_argument(
        "--send-actions-as-client",
        action="store_true",
        help="Send the send_goal request, cancel_goal request, and get_result request respectively based on the recorded "
        'send_goal, cancel_goal, and get_result event messages. Note that the messages from action\'s "status topic" '
        '[NameSpace/]ActionName/_action/status and "feedback topic" [NameSpace/]ActionName/_action/feedback will not be '
        "sent because they are expected to be sent from the action server side.",
    )
    others = ' or "--send-actions-as-client"' if value("bag.records_actions") else ""
    parser.add_argument(
        "--service-requests-source",
        default="service_introspection",
        choices=("service_introspection", "client_introspection"),
        help="Determine the source of the service requests to be replayed. This option only makes sense if the "
        f'"--publish-service-requests"{others} option is set. By default, the service requests replaying from recorded service '
        "introspection message.",
    )
    parser.add_argument("--log-level", default="info", choices=LOG_LEVELS, help="Logging level.")
    parser.add_argument(
        "--progress-bar-update-rate",
        type=int,
        default=value("bag.progress_rate"),
        metavar="PROGRESS_BAR_UPDATE_RATE",
        help="How often in a second the progress bar is printed in a terminal; 0 turns it off. Default is %(default)d.",
    )
    parser.add_argument(
        "--message-order",
        default="received",
        choices=("received", "sent"),
        help="The reference to use for bag message chronological ordering. Default: %(default)s.",
    )


def add_reading(parser: ArgumentParser) -> None:
    """Add the options that `play` and `burst` share."""
    parser.add_argument(
        "--read-ahead-queue-size",
        type=int,
        default=1000,
        help="size of message queue rosbag tries to hold in memory to help deterministic playback. Not needed here: bags "
        "are read as they are played.",
    )
    parser.add_argument(
        "--storage-config-file",
        type=readable_file(parser),
        help="Path to a yaml file defining storage specific configurations. Not used here.",
    )
    parser.add_argument(
        "--start-offset",
        type=not_negative_float,
        default=0.0,
        help="Start the playback player this many seconds into the bag file.",
    )


def add_remapping(parser: ArgumentParser) -> None:
    """Add the list of topic remappings."""
    parser.add_argument(
        "--remap",
        "-m",
        default="",
        nargs="+",
        help='list of topics to be remapped: in the form "old_topic1:=new_topic1 old_topic2:=new_topic2 etc." ',
    )


def _add_choice(parser: ArgumentParser) -> None:
    for things in ("topic", "service", "action"):
        completed(
            parser.add_argument(
                f"--{things}s",
                default=[],
                metavar=things,
                nargs="+",
                help=f"Space-delimited list of {things}s to play.",
            ),
            topic_names,
        )
    kinds = "topics, services and actions" if value("bag.records_actions") else "topics and services"
    parser.add_argument(
        "-e",
        "--regex",
        type=regular_expression,
        default="",
        help=f"Play only {kinds} matches with regular expression.",
    )
    parser.add_argument(
        "-x",
        "--exclude-regex",
        type=regular_expression,
        default="",
        help=f"regular expressions to exclude {kinds} from replay.",
    )
    for things in ("topic", "service", "action"):
        text = f"Space-delimited list of {things}s not to play."
        parser.add_argument(f"--exclude-{things}s", default=[], metavar=things, nargs="+", help=text)


def _add_clock(parser: ArgumentParser) -> None:
    clock = parser.add_mutually_exclusive_group()
    clock.add_argument(
        "--clock",
        type=_positive,
        nargs="?",
        const=40,
        default=0,
        help="Publish to /clock at a specific frequency in Hz, to act as a ROS Time Source. Value must be positive. Defaults "
        "to not publishing.If specified, /clock topic in the bag file is excluded to publish.",
    )
    clock.add_argument(
        "--clock-topics",
        default=[],
        nargs="+",
        help="List of topics separated by spaces that will trigger a /clock update when a message is published on them",
    )
    clock.add_argument(
        "--clock-topics-all",
        action="store_true",
        help="Publishes an update on /clock immediately before each replayed message",
    )
    parser.add_argument(
        "-d",
        "--delay",
        type=_positive,
        default=0.0,
        help="Sleep duration before play (each loop), in seconds. Negative durations invalid.",
    )


def _add_span(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--playback-duration",
        type=float,
        default=-1.0,
        help="Playback duration, in seconds. Negative durations mark an infinite playback. Default is %(default)d. "
        + _LIMITS.format(other="`playback-until-*`"),
    )
    until = parser.add_mutually_exclusive_group()
    until.add_argument(
        "--playback-until-sec",
        type=float,
        default=-1.0,
        help="Playback until timestamp, expressed in seconds since epoch. Mutually exclusive argument with "
        "`--playback-until-nsec`. A negative value disables this feature. Default is %(default)f. "
        + _LIMITS.format(other="`--playback-duration`"),
    )
    until.add_argument(
        "--playback-until-nsec",
        type=int,
        default=-1,
        help="Playback until timestamp, expressed in nanoseconds since epoch.  Mutually exclusive argument with "
        "`--playback-until-sec`. A negative value disables this feature. Default is %(default)s. "
        + _LIMITS.format(other="`--playback-duration`"),
    )


def _positive(text: str) -> float:
    value = float(text)
    if value <= 0:
        raise ValueError(f"Value {value} is less than or equal to zero.")
    return value


_positive.__name__ = "positive_float"  # argparse names the type when a value is wrong


async def main(session: Session, args: Namespace) -> str | None:
    from day6_core.ros.ros2.bag._player import play

    if (args.bag_path is None) == (not args.input):
        return error("Must specify exactly one of a bag path and --input")
    inputs = args.input or [[args.bag_path, *([args.storage] if args.storage else [])]]
    return await play(session, inputs, _options(args), args)


def _options(args: Namespace) -> Any:
    from rosbag2_py._options import PlayOptions, ServiceRequestsSource

    until = round(args.playback_until_sec * 1_000_000_000) if args.playback_until_sec >= 0 else args.playback_until_nsec
    return PlayOptions(
        rate=args.rate,
        topics_to_filter=args.topics,
        services_to_filter=event_topics(args.services),
        actions_to_filter=args.actions,
        regex_to_filter=args.regex,
        exclude_regex_to_filter=args.exclude_regex,
        exclude_topics_to_filter=[*args.exclude_topics, *(["/clock"] if args.clock else [])],
        exclude_service_events_to_filter=event_topics(args.exclude_services),
        exclude_actions_to_filter=args.exclude_actions,
        loop=args.loop,
        clock_publish_frequency=args.clock,
        clock_publish_on_topic_publish=args.clock_topics_all or bool(args.clock_topics),
        clock_topics=args.clock_topics,
        delay=args.delay,
        playback_duration=args.playback_duration,
        playback_until_timestamp=max(until, -1),
        start_paused=args.start_paused,
        start_offset=args.start_offset,
        disable_keyboard_controls=args.disable_keyboard_controls,
        wait_acked_timeout=args.wait_for_all_acked,
        publish_service_requests=args.publish_service_requests,
        send_actions_as_client=args.send_actions_as_client,
        service_requests_source=ServiceRequestsSource[args.service_requests_source.upper()],
        progress_bar_update_rate=args.progress_bar_update_rate,
        message_order=args.message_order,
    )
