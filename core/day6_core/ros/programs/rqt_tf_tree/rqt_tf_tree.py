"""`ros2 run rqt_tf_tree rqt_tf_tree`: collects the transforms on /tf and /tf_static and shows the tree of their frames.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from functools import partial
from typing import Any

from tf2_msgs.srv import FrameGraph
from tf2_ros import Buffer, TransformListener

from day6_core.ros.programs._without_screen import stays
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.ros.programs.rqt_tf_tree.model import FrameLine, Snapshot, TfTree, snapshot
from day6_core.ros.programs.tf2_tools.frame_tree import read_frames
from day6_core.session.harmless import one_line
from day6_core.session.session import Session
from day6_core.session.task import Signal
from day6_core.session.threads import in_thread

SERVICE = "tf2_frames"

AUTO_SECONDS = 1.0
"""Between two looks, while it looks by itself: ages that change faster cannot be read."""

LISTEN_SECONDS = 1.0
"""How long to listen before the first tree is printed (rqt_tf_tree/dotcode_tf.py: initial_listen_duration)."""

ANSWER_SECONDS = 5.0
"""How long to wait for the service, which may be another node's."""


class TfTreePlugin(Plugin[TfTree]):
    """rqt_tf_tree/RosTfTree."""

    kind, title = "rqt_tf_tree", "TF Tree"

    def __init__(self, place: PluginPlace) -> None:
        super().__init__(
            place, TfTree(place.session.path, auto_refresh=place.settings.get("auto_refresh", True) is not False)
        )
        self._wanted = Signal()
        self.model.on_request = self._wanted.set
        self._buffer = Buffer(node=place.node)
        self._listener = TransformListener(self._buffer, place.node)
        # The tree comes by its own service, as in the original.
        self._client = place.node.create_client(FrameGraph, SERVICE)

    async def run(self) -> None:
        while True:
            if self.model.clear_wanted:
                self.model.clear_wanted = False
                self._buffer.clear()
            if name := self.model.save_wanted:
                self.model.save_wanted = ""
                await in_thread(partial(self.model.save, name))
            await self._refresh()
            await self.place.session.wait(self._wanted, AUTO_SECONDS if self.model.auto_refresh else None)
            self._wanted.clear()

    async def _refresh(self) -> None:
        answer, answered = self._client.call_async(FrameGraph.Request()), Signal()
        answer.add_done_callback(lambda _: answered.set())
        if not await self.place.session.wait(answered, ANSWER_SECONDS):
            self._client.remove_pending_request(answer)
            self.model.fail(f"Service {SERVICE} does not answer")
            return
        now = self.place.node.get_clock().now().nanoseconds * 1e-9
        try:
            self.model.show(await in_thread(lambda: _read(answer.result(), now)))
        except ValueError as error:
            self.model.fail(f"Service call failed {error}")

    def close(self) -> None:
        node = self.place.node
        self._listener.unregister()
        node.destroy_service(self._buffer.srv)
        node.destroy_client(self._client)
        self._buffer.jump_handle.unregister()

    def settings(self) -> Settings:
        return {"auto_refresh": self.model.auto_refresh}

    async def without_screen(self) -> int | None:
        session, node = self.place.session, self.place.node
        if stays(session, node):
            await session.spin(node)
            return 0
        session.spawn(session.spin(node))
        await session.sleep(LISTEN_SECONDS)
        await self._refresh()
        if self.model.problem:
            session.print_error(self.model.problem)
            return 1
        for line in self.model.snapshot.lines:
            session.print(_printed(line, self.model.snapshot))
        if not self.model.snapshot.lines:
            session.print("No tf data received")
        return 0


async def main(session: Session) -> int | None:
    """Open the window and follow the frames until interrupted; without a display print the tree once, or stay."""
    return await run_alone(session, TfTreePlugin)


def _read(answer: Any, recorded: float) -> Snapshot:
    return snapshot(read_frames(answer.frame_yaml), recorded)


def _printed(line: FrameLine, shot: Snapshot) -> str:
    text = "  " * len(line.ends) + one_line(line.name)
    if line.frame is None or line.again:
        return text
    age = shot.age(line.frame)
    said = "static" if age is None else f"{age:.3f} s old, {line.frame.rate} Hz"
    return f"{text}: {said}, {one_line(line.frame.broadcaster)}"
