"""`ros2 bag record`."""

from __future__ import annotations

from argparse import Namespace
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.reason import reason
from day6_core.ros.ros2.bag._options import (
    console,
    error,
    event_topics,
    path_in,
    qos_overrides,
    repeated_topics,
    set_log_level,
)
from day6_core.ros.ros2.bag._record_options import add_arguments as add_arguments
from day6_core.ros.ros2.bag._record_options import refusal
from day6_core.session.streams import WriteError

if TYPE_CHECKING:
    from day6_core.session.session import Session

SUMMARY = "Record ROS data to a bag"


def _validated(args: Namespace, uri: str) -> str | None:
    return refusal(args, Path(uri).is_dir(), print)


EXPORTS = {"add_recorder_arguments": add_arguments, "validate_parsed_arguments": _validated}
"""What programs import of ros2bag.verb.record."""


async def main(session: Session, args: Namespace) -> str | None:
    import time

    if not args.output:
        args.output = time.strftime(
            "rosbag2_%Y_%m_%d-%H_%M_%S", time.localtime(session.clock.now_ns() // 1_000_000_000)
        )
    folder = Path(session.cwd, args.output)
    refused = refusal(args, folder.is_dir(), session.print)
    if refused is not None:
        return refused
    overrides = qos_overrides(session, args.qos_profile_overrides_path)
    failure = None
    try:
        await _record(session, args, folder, overrides)
    except KeyboardInterrupt:
        pass  # the usual end of a recording
    except (BrokenPipeError, WriteError):
        raise
    except OSError as problem:
        failure = error(f"Recording to '{args.output}' has ended: {reason(problem)}")
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
        recording = Recording(
            node, _storage(args, folder), _options(session, args, overrides), keyboard=with_keys, log=log
        )
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
        max_bag_files=args.max_bag_files,
        max_cache_duration=args.max_cache_duration,
        custom_data=dict(pair.partition("=")[::2] for pair in args.custom_data or ()),
    )


def _options(session: Session, args: Namespace, overrides: dict[str, Any]) -> Any:
    from rosbag2_py._options import RecordOptions

    return RecordOptions(
        all_topics=args.all_topics or args.all,
        all_services=args.all_services or args.all,
        all_actions=args.all_actions or args.all,
        is_discovery_disabled=args.no_discovery,
        topics=args.topics,
        topic_types=args.topic_types,
        services=event_topics(args.services),
        actions=args.actions or [],
        rmw_serialization_format="cdr",
        regex=args.regex,
        exclude_regex=args.exclude_regex,
        exclude_topics=args.exclude_topics or [],
        exclude_topic_types=args.exclude_topic_types,
        exclude_service_events=event_topics(args.exclude_services),
        exclude_actions=args.exclude_actions or [],
        compression_mode=args.compression_mode.upper(),
        compression_format=args.compression_format,
        topic_qos_profile_overrides=overrides,
        include_hidden_topics=args.include_hidden_topics,
        include_unpublished_topics=args.include_unpublished_topics,
        ignore_leaf_topics=args.ignore_leaf_topics,
        start_paused=args.start_paused,
        use_sim_time=args.use_sim_time,
        disable_keyboard_controls=args.disable_keyboard_controls,
        static_topics_uri=path_in(session, args.static_topics_path),
        statistics_max_publishing_rate=args.stats_max_publishing_rate,
        repeat_transient_local_messages=repeated_topics(args.repeat_transient_local),
        repeat_all_transient_local_depth=args.repeat_all_transient_local,
    )
