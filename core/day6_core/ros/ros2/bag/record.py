"""`ros2 bag record`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.ros.differences import value
from day6_core.ros.ros2.bag._options import (
    LOG_LEVELS,
    STORAGES,
    add_qos_overrides,
    console,
    error,
    event_topics,
    qos_overrides,
    regular_expression,
    set_log_level,
    warning,
)
from day6_core.ros.ros2.cli.completion import message_types, service_names, topic_names
from day6_core.ros.ros2.cli.options import completed
from day6_core.session.streams import WriteError

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Record ROS data to a bag"

_WORKS_ON_TOP = "Works on top of --all, --all-topics, --topics or --regex."


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "-o",
        "--output",
        help="Destination of the bagfile to create, defaults to a timestamped folder in the current directory.",
    )
    parser.add_argument(
        "-s",
        "--storage",
        default=value("bag.storage"),
        choices=STORAGES,
        help=f"Storage identifier to be used, defaults to '{value('bag.storage')}'.",
    )
    _add_topics(parser)
    _add_discovery(parser)
    _add_writing(parser)
    _add_compression(parser)


def _add_topics(parser: ArgumentParser) -> None:
    names = parser.add_mutually_exclusive_group()
    if value("bag.positional_topics") == "removed":
        parser.set_defaults(topics_positional=[])
    else:
        completed(
            names.add_argument(
                "topics_positional",
                default=[],
                metavar="[Topic ...]",
                nargs="*",
                help="Space-delimited list of topics to record. (deprecated)",
            ),
            topic_names,
        )
    completed(
        names.add_argument(
            "--topics", default=[], metavar="Topic", nargs="+", help="Space-delimited list of topics to record."
        ),
        topic_names,
    )
    completed(
        parser.add_argument(
            "--services", metavar="ServiceName", nargs="+", help="Space-delimited list of services to record."
        ),
        service_names,
    )
    completed(
        parser.add_argument(
            "--topic-types",
            nargs="+",
            default=[],
            metavar="TopicType",
            help="Space-delimited list of topic types to record.",
        ),
        message_types,
    )
    parser.add_argument(
        "-a", "--all", action="store_true", help="Record all topics and services (Exclude hidden topic)."
    )
    parser.add_argument("--all-topics", action="store_true", help="Record all topics (Exclude hidden topic).")
    parser.add_argument("--all-services", action="store_true", help="Record all services via service event topics.")
    parser.add_argument(
        "-e",
        "--regex",
        type=regular_expression,
        default="",
        help="Record only topics and services containing provided regular expression. Note:  --all, --all-topics or "
        "--all-services will override --regex.",
    )
    parser.add_argument(
        "--exclude-regex",
        type=regular_expression,
        default="",
        help="Exclude topics and services containing provided regular expression. Works on top of --all, --all-topics, "
        "--all-services, --topics, --services or --regex.",
    )
    parser.add_argument(
        "--exclude-topic-types",
        default=[],
        metavar="ExcludeTopicTypes",
        nargs="+",
        help=f"Space-delimited list of topic types not being recorded. {_WORKS_ON_TOP}",
    )
    completed(
        parser.add_argument(
            "--exclude-topics",
            metavar="Topic",
            nargs="+",
            help=f"Space-delimited list of topics not being recorded. {_WORKS_ON_TOP}",
        ),
        topic_names,
    )
    completed(
        parser.add_argument(
            "--exclude-services",
            metavar="ServiceName",
            nargs="+",
            help="Space-delimited list of services not being recorded. Works on top of --all, --all-services, --services or "
            "--regex.",
        ),
        service_names,
    )


def _add_discovery(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--include-unpublished-topics",
        action="store_true",
        help="Discover and record topics which have no publisher. Subscriptions on such topics will be made with default QoS "
        "unless otherwise specified in a QoS overrides file.",
    )
    parser.add_argument(
        "--include-hidden-topics",
        action="store_true",
        help="Discover and record hidden topics as well. These are topics used internally by ROS 2 implementation.",
    )
    parser.add_argument(
        "--no-discovery",
        action="store_true",
        help="Disables topic auto discovery during recording: only topics present at startup will be recorded.",
    )
    parser.add_argument(
        "-p",
        "--polling-interval",
        type=int,
        default=100,
        help="Time in ms to wait between querying available topics for recording. It has no effect if --no-discovery is "
        "enabled.",
    )
    parser.add_argument("--ignore-leaf-topics", action="store_true", help="Ignore topics without a subscription.")
    add_qos_overrides(parser)


def _add_writing(parser: ArgumentParser) -> None:
    parser.add_argument(
        "-f",
        "--serialization-format",
        default="",
        choices=("", "cdr"),
        metavar="{cdr}",
        help="The rmw serialization format in which the messages are saved, defaults to the rmw currently in use.",
    )
    parser.add_argument(
        "-b",
        "--max-bag-size",
        type=int,
        default=0,
        help="Maximum size in bytes before the bagfile will be split. Default: %(default)d, recording written in single "
        "bagfile and splitting is disabled.",
    )
    parser.add_argument(
        "-d",
        "--max-bag-duration",
        type=int,
        default=0,
        help="Maximum duration in seconds before the bagfile will be split. Default: %(default)d, recording written in single "
        "bagfile and splitting is disabled. If both splitting by size and duration are enabled, the bag will split at "
        "whichever threshold is reached first.",
    )
    parser.add_argument(
        "--max-cache-size",
        type=int,
        default=100 * 1024 * 1024,
        help="Maximum size (in bytes) of messages that --snapshot-mode keeps. Default: %(default)d.",
    )
    parser.add_argument(
        "--disable-keyboard-controls", action="store_true", help="disables keyboard controls for recorder"
    )
    parser.add_argument("--start-paused", action="store_true", help="Start the recorder in a paused state.")
    parser.add_argument(
        "--use-sim-time",
        action="store_true",
        help="Use simulation time for message timestamps by subscribing to the /clock topic. Until first /clock message is "
        "received, no messages will be written to bag.",
    )
    parser.add_argument(
        "--node-name",
        default="rosbag2_recorder",
        help="Specify the recorder node name. Default is %(default)s.",
    )
    parser.add_argument(
        "--custom-data",
        metavar="KEY=VALUE",
        nargs="*",
        help="Space-delimited list of key=value pairs. Store the custom data in metadata under the "
        '"rosbag2_bagfile_information/custom_data". The key=value pair can appear more than once. The last value will '
        "override the former ones.",
    )
    parser.add_argument(
        "--snapshot-mode",
        action="store_true",
        help="Enable snapshot mode. Messages will not be written to the bagfile until the "
        '"/rosbag2_recorder/snapshot" service is called. e.g. ros2 service call /rosbag2_recorder/snapshot '
        "rosbag2_interfaces/Snapshot",
    )
    parser.add_argument("--log-level", default="info", choices=LOG_LEVELS, help="Logging level.")
    parser.add_argument(
        "--storage-config-file",
        help="Path to a yaml file defining storage specific configurations. Not used here.",
    )
    parser.add_argument(
        "--storage-preset-profile",
        default="",
        metavar="PROFILE",
        help="Select a preset configuration for the storage. mcap: none, fastwrite, zstd_fast, zstd_small; sqlite3: none, "
        "resilient. Default: none.",
    )


def _add_compression(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--compression-queue-size",
        type=int,
        default=1,
        help="Number of files or messages that may be queued for compression before being dropped.  Default is %(default)d.",
    )
    parser.add_argument(
        "--compression-threads",
        type=int,
        default=0,
        help="Number of files or messages that may be compressed in parallel. Default is %(default)d, which will be "
        "interpreted as the number of CPU cores.",
    )
    parser.add_argument(
        "--compression-threads-priority",
        type=int,
        default=0,
        help="Compression threads scheduling priority. Default is %(default)d.",
    )
    parser.add_argument(
        "--compression-mode",
        default="none",
        choices=("none", "file", "message"),
        help="Choose mode of compression for the storage. Default: %(default)s.",
    )
    parser.add_argument(
        "--compression-format",
        default="",
        choices=("", "zstd"),
        metavar="{zstd}",
        help="Choose the compression format/algorithm. Has no effect if no compression mode is chosen. Default: %(default)s.",
    )


def _refusal(session: Session, args: Namespace, folder: Path) -> str | None:
    """Return ros2bag's error for options that contradict each other; warnings are printed."""
    if args.topics_positional:
        if value("bag.positional_topics") == "deprecated":
            session.print(
                warning('Positional "topics" argument deprecated. Please use optional "--topics" argument instead.')
            )
        args.topics = args.topics_positional
    if not any(
        (args.all, args.all_topics, args.all_services, args.services, args.topics, args.topic_types, args.regex)
    ):
        return error(
            "Need to specify at least one option out of --all, --all-topics, --all-services, --services, --topics, "
            "--topic-types or --regex"
        )
    some = args.all or args.all_topics or args.topic_types or args.regex
    if args.exclude_regex and not (some or args.all_services):
        return error(
            "--exclude-regex argument requires either --all, --all-topics, --topic-types, --all-services or --regex"
        )
    if args.exclude_topics and not some:
        return error("--exclude-topics argument requires either --all, --all-topics, --topic-types or --regex")
    if args.exclude_topic_types and not some:
        return error("--exclude-topic-types argument requires either --all, --all-topics or --regex")
    if args.exclude_services and not (args.all or args.all_services or args.regex):
        return error("--exclude-services argument requires either --all, --all-services or --regex")
    for stronger, weaker in (
        (("all", "all_services"), "services"),
        (("all", "all_topics"), "topics"),
        (("all", "all_topics", "all_services"), "regex"),
    ):
        if any(getattr(args, each) for each in stronger) and getattr(args, weaker):
            *first, last = [f"--{each.replace('_', '-')}" for each in stronger]
            session.print(warning(f"{', '.join(first)} or {last} will override --{weaker}"))
    if folder.is_dir():
        return error(f"Output folder '{args.output}' already exists.")
    if args.use_sim_time and args.no_discovery:
        return error(
            "--use-sim-time and --no-discovery both set, but are incompatible settings. The /clock topic needs to be "
            "discovered to record with sim time."
        )
    if args.compression_format and args.compression_mode == "none":
        return error("Invalid choice: Cannot specify compression format without a compression mode.")
    if args.compression_queue_size < 0:
        return error("Compression queue size must be at least 0.")
    return None


async def main(session: Session, args: Namespace) -> str | None:
    import time

    if not args.output:
        args.output = time.strftime(
            "rosbag2_%Y_%m_%d-%H_%M_%S", time.localtime(session.clock.now_ns() // 1_000_000_000)
        )
    folder = Path(session.cwd, args.output)
    refusal = _refusal(session, args, folder)
    if refusal is not None:
        return refusal
    overrides = qos_overrides(session, args.qos_profile_overrides_path)
    failure = None
    try:
        await _record(session, args, folder, overrides)
    except KeyboardInterrupt:
        pass  # the usual end of a recording
    except (BrokenPipeError, WriteError):
        raise
    except OSError as problem:
        failure = error(f"Recording to '{args.output}' has ended: {problem.strerror or problem}")
    with suppress(OSError):
        folder.rmdir()  # nothing was written into it
    return failure


async def _record(session: Session, args: Namespace, folder: Path, overrides: dict[str, Any]) -> None:
    from rosbag2_py._recording import Recording

    from day6_core.ros.programs.rclcpp import create_node
    from day6_core.ros.ros2.bag._keyboard import keyboard, listen
    from day6_core.ros.ros2.cli.node import settle
    from rclpy.parameter import Parameter

    await settle(session)
    node = create_node(
        session,
        args.node_name,
        cli_args=[],
        parameter_overrides=[Parameter("use_sim_time", value=args.use_sim_time)],
    )
    set_log_level(node, args.log_level)
    with keyboard(session, disabled=args.disable_keyboard_controls):
        with_keys = not args.disable_keyboard_controls
        log = console(session, args.output, least=args.log_level)
        recording = Recording(node, _storage(args, folder), _options(args, overrides), keyboard=with_keys, log=log)
        try:
            recording.start()
            session.spawn(session.spin(node))
            if with_keys and session.stdin.isatty():
                session.spawn(listen(session, recording.press))
            async for _ in session.every(max(args.polling_interval, 1) / 1000):
                recording.poll()
        finally:
            # Messages received so far may still be in the queues.
            session.spin_some()
            recording.stop()


def _storage(args: Namespace, folder: Path) -> Any:
    from rosbag2_py._storage import StorageOptions

    return StorageOptions(
        str(folder),
        storage_id=args.storage,
        max_bagfile_size=args.max_bag_size,
        max_bagfile_duration=args.max_bag_duration,
        max_cache_size=args.max_cache_size,
        storage_preset_profile=args.storage_preset_profile,
        snapshot_mode=args.snapshot_mode,
        custom_data=dict(pair.partition("=")[::2] for pair in args.custom_data or ()),
    )


def _options(args: Namespace, overrides: dict[str, Any]) -> Any:
    from rosbag2_py._options import RecordOptions

    return RecordOptions(
        all_topics=args.all_topics or args.all,
        all_services=args.all_services or args.all,
        is_discovery_disabled=args.no_discovery,
        topics=args.topics,
        topic_types=args.topic_types,
        services=event_topics(args.services),
        rmw_serialization_format="cdr",
        regex=args.regex,
        exclude_regex=args.exclude_regex,
        exclude_topics=args.exclude_topics or [],
        exclude_topic_types=args.exclude_topic_types,
        exclude_service_events=event_topics(args.exclude_services),
        compression_mode=args.compression_mode.upper(),
        compression_format=args.compression_format,
        topic_qos_profile_overrides=overrides,
        include_hidden_topics=args.include_hidden_topics,
        include_unpublished_topics=args.include_unpublished_topics,
        ignore_leaf_topics=args.ignore_leaf_topics,
        start_paused=args.start_paused,
        use_sim_time=args.use_sim_time,
        disable_keyboard_controls=args.disable_keyboard_controls,
    )
