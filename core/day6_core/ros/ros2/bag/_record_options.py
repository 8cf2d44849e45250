"""The options of `ros2 bag record`, and which of them contradict each other."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable

from day6_core.ros.differences import value
from day6_core.ros.ros2.bag._options import (
    LOG_LEVELS,
    STORAGES,
    add_qos_overrides,
    error,
    readable_file,
    regular_expression,
    repeated_topics,
    warning,
)
from day6_core.ros.ros2.cli.completion import action_names, message_types, service_names, topic_names
from day6_core.ros.ros2.cli.options import completed

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
            "--actions", metavar="ActionName", nargs="+", help="Space-delimited list of actions to record."
        ),
        action_names,
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
    kinds = "topics, services and actions" if value("bag.records_actions") else "topics and services"
    parser.add_argument("-a", "--all", action="store_true", help=f"Record all {kinds} (Exclude hidden topic).")
    parser.add_argument("--all-topics", action="store_true", help="Record all topics (Exclude hidden topic).")
    parser.add_argument("--all-services", action="store_true", help="Record all services via service event topics.")
    parser.add_argument(
        "--all-actions", action="store_true", help="Record all actions via internal topics and service event topics."
    )
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
    completed(
        parser.add_argument(
            "--exclude-actions",
            metavar="ActionName",
            nargs="+",
            help="Space-delimited list of actions not being recorded. Works on top of --all, --all-actions, --actions or "
            "--regex.",
        ),
        action_names,
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
    parser.add_argument(
        "--static-topics-path",
        type=readable_file(parser),
        help="Path to a YAML file with statically defined topic names and types, which are recorded whether they are "
        "published or not: static_topics_and_types_list: [[/topic_name, topic_type], ...]",
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
        "--max-bag-files",
        type=int,
        default=0,
        help="Maximum number of bag files to retain before deleting the oldest bagfile (circular logging). Default: "
        "%(default)d, unlimited. Requires --max-bag-size or --max-bag-duration to be set.",
    )
    parser.add_argument(
        "--max-cache-duration",
        type=int,
        default=0,
        help="Maximum duration in seconds of the messages that --snapshot-mode keeps. Default: %(default)d, limited by "
        "--max-cache-size only. With --max-cache-size 0 the duration alone is the limit.",
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
    completed(
        parser.add_argument(
            "--repeat-transient-local",
            default=[],
            metavar="Topic[=Depth]",
            nargs="+",
            help="Space-delimited list of transient-local topics whose last messages should be prepended on bag split and "
            "snapshot writes. Format: <topic> or <topic>=<depth>. Default depth is 1 when omitted.",
        ),
        topic_names,
    )
    parser.add_argument(
        "--repeat-all-transient-local",
        type=int,
        default=0,
        const=1,
        nargs="?",
        metavar="Depth",
        help="The same for all topics that a publisher offers with transient-local durability; --repeat-transient-local "
        "has precedence.",
    )
    parser.add_argument(
        "--stats_max_publishing_rate",
        type=float,
        default=1.0,
        help="Maximum rate in times per second (Hz) at which the statistics about lost messages will be published. Default: "
        "%(default)s. If set to 0, no statistics will be published. At most 1000.",
    )
    parser.add_argument("--log-level", default="info", choices=LOG_LEVELS, help="Logging level.")
    parser.add_argument(
        "--storage-config-file",
        type=readable_file(parser),
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


def refusal(args: Namespace, exists: bool, say: Callable[[str], object]) -> str | None:
    """Return ros2bag's error for options that contradict each other; `say` gets warnings. `exists`: the folder is there."""
    if args.topics_positional:
        if value("bag.positional_topics") == "deprecated":
            say(warning('Positional "topics" argument deprecated. Please use optional "--topics" argument instead.'))
        args.topics = args.topics_positional
    if not any(
        (
            *(args.all, args.all_topics, args.all_services, args.services, args.topics, args.topic_types, args.regex),
            *(args.all_actions, args.actions, args.static_topics_path),
        )
    ):
        static = ", --static-topics-path" if value("bag.newer_options") else ""
        return error(
            "Need to specify at least one option out of --all, --all-topics, --all-services, --services, --topics, "
            f"--topic-types{static} or --regex"
        )
    some = args.all or args.all_topics or args.topic_types or args.regex
    actions = value("bag.records_actions")
    if args.exclude_regex and not (some or args.all_services or args.all_actions):
        every = "--all, --all-topics, --topic-types, --all-services"
        return error(f"--exclude-regex argument requires either {every}{', --all-actions' * actions} or --regex")
    if args.exclude_topics and not some:
        return error("--exclude-topics argument requires either --all, --all-topics, --topic-types or --regex")
    if args.exclude_topic_types and not some:
        return error("--exclude-topic-types argument requires either --all, --all-topics or --regex")
    if args.exclude_services and not (args.all or args.all_services or args.regex):
        return error("--exclude-services argument requires either --all, --all-services or --regex")
    if args.exclude_actions and not (args.all or args.all_actions or args.regex):
        return error("--exclude-actions argument requires either --all, --all-actions or --regex")
    all_of_them = (
        ("--all, --all-topics --all-services", "--all-actions")
        if actions
        else ("--all, --all-topics", "--all-services")
    )
    for first, last, weaker in (
        ("--all", "--all-services", "services"),
        ("--all", "--all-topics", "topics"),
        ("--all", "--all-actions", "actions"),
        (*all_of_them, "regex"),
    ):
        named = [word[2:].replace("-", "_") for word in (*first.replace(",", "").split(), last)]
        if any(getattr(args, each) for each in named) and getattr(args, weaker):
            say(warning(f"{first} or {last} will override --{weaker}"))
    if exists:
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
    return _newer_refusal(args) if value("bag.newer_options") else None


def _newer_refusal(args: Namespace) -> str | None:
    if not 0 <= args.stats_max_publishing_rate <= 1000:
        return error("stats_max_publishing_rate must be between 0 and 1000.")
    for name, what in (("max_cache_size", "bytes (~4 GiB"), ("max_cache_duration", "seconds (~136 years")):
        if getattr(args, name) < 0:
            return error(f"{name} must be a non-negative integer.")
        if getattr(args, name) >= 2**32:
            return error(f"{name} must not exceed {2**32 - 1} {what}, uint32_t max).")
    if args.snapshot_mode and args.max_cache_duration == 0 and args.max_cache_size == 0:
        return error("In snapshot mode, either the max_cache_duration or max_cache_size shall not be set to zero.")
    try:
        repeated_topics(args.repeat_transient_local)
    except ValueError as problem:
        return error(str(problem))
    return None
