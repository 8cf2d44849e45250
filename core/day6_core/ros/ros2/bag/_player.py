"""Runs a player in a session: its node, keys, services and the progress bar."""

from __future__ import annotations

from argparse import Namespace
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.ros.ros2.bag._keyboard import keyboard, listen
from day6_core.ros.ros2.bag._options import console, error, qos_overrides, set_log_level
from day6_core.session.task import Signal, wait_for

if TYPE_CHECKING:
    from rosbag2_py._options import PlayOptions
    from rosbag2_py._playing import Playing
    from rosbag2_py._reader import SequentialReader

    from day6_core.session.session import Session

SECOND = 1_000_000_000
_BELOW = "\x1b[J"
_UP = "\x1b[3A\r"


async def play(
    session: Session, inputs: list[list[str]], options: PlayOptions, args: Namespace, burst: int | None = None
) -> str | None:
    """Play bags, each given as `[path]` or `[path, storage_id]`, to the end or until Ctrl-C."""
    readers: list[SequentialReader] = []

    def close() -> None:
        for reader in readers:
            reader.close()

    session.defer(close)
    for bag in inputs:
        if len(bag) > 2:
            return error(f"--input expects 1 or 2 arguments, {len(bag)} provided")
        if not Path(session.cwd, bag[0]).exists():
            return error(f"Bag path '{bag[0]}' does not exist!")
        readers.append(_open(session, getattr(args, "log_level", "info"), *bag))
    options.topic_qos_profile_overrides = qos_overrides(session, args.qos_profile_overrides_path)
    with suppress(KeyboardInterrupt):
        await _play(session, readers, options, args, burst)
    return None


def _open(session: Session, log_level: str, path: str, storage: str = "") -> SequentialReader:
    from rosbag2_py._reader import SequentialReader
    from rosbag2_py._storage import StorageOptions

    reader = SequentialReader(console(session, path, least=log_level))
    reader.open(StorageOptions(str(Path(session.cwd, path)), storage_id=storage))
    return reader


async def _play(
    session: Session, readers: list[SequentialReader], options: PlayOptions, args: Namespace, burst: int | None
) -> None:
    from rosbag2_py._play_services import offer_services
    from rosbag2_py._playing import NODE_NAME, Playing

    from day6_core.ros.programs.rclcpp import create_node
    from day6_core.ros.ros2.cli.node import settle

    await settle(session)
    rules = [word for rule in args.remap for word in ("--remap", rule)]
    node = create_node(session, NODE_NAME, cli_args=["--ros-args", *rules])
    set_log_level(node, getattr(args, "log_level", "info"))
    changed = Signal()
    with_keys = not options.disable_keyboard_controls
    with keyboard(session, disabled=not with_keys):
        playing = Playing(
            node,
            readers,
            options,
            keyboard=with_keys,
            steady_ns=session.clock.steady_ns,
            on_wake=changed.set,
        )
        offer_services(node, playing)
        session.spawn(session.spin(node))
        if with_keys and session.stdin.isatty():
            session.spawn(listen(session, playing.press))
        bar = _ProgressBar(session, node, playing, options.progress_bar_update_rate)
        try:
            playing.begin()
            if burst is not None:
                playing.burst(burst)
            while not playing.finished:
                changed.clear()
                due = playing.advance()
                if playing.finished:
                    break
                await wait_for(changed, due)
                # A bag that is late must not hold up other programs.
                if due is not None and due <= session.clock.steady_ns():
                    await session.sleep(0)
        except KeyboardInterrupt:
            playing.stop()
            raise
        finally:
            bar.end()


class _ProgressBar:
    """Two lines below the player's log, redrawn a few times a second; only on a terminal."""

    def __init__(self, session: Session, node: Any, playing: Playing, rate: int) -> None:
        self._session = session
        self._playing = playing
        self._on = rate > 0 and session.stdout.isatty()
        if not self._on:
            return
        log = node.get_logger()
        log.info(f"Progress bar enabled at {rate} Hz.")
        log.info("Progress bar [?]: [R]unning, [P]aused, [B]urst, [D]elayed, [S]topped")
        self._write = session.context._log_write or session.stderr.write
        session.context._log_write = self._log
        session.spawn(self._run(1 / rate))

    async def _run(self, seconds: float) -> None:
        self._draw()
        async for _ in self._session.every(seconds):
            self._draw()

    def _log(self, text: str) -> None:
        """Write a line of the log where the bar begins, and draw the bar below it."""
        self._session.stdout.control(_BELOW)
        self._session.stdout.flush()
        self._write(text)
        self._draw()

    def _draw(self) -> None:
        if self._on:
            self._show()
            self._session.stdout.control(_UP)
            self._session.stdout.flush()

    def _show(self) -> None:
        self._session.stdout.control(_BELOW)
        self._session.stdout.write(f"\n{self._playing.progress()}\n")

    def end(self) -> None:
        """Leave the last state on the screen."""
        if self._on:
            self._on = False
            self._session.context._log_write = self._write
            self._show()
            self._session.stdout.flush()
