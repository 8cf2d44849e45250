"""Performs the actions of hidden scenarios: those of lessons, and what the grader does itself, out of the pupil's reach.

Programs of ours are started in this process, messages are sent and services called by a node of ours: no alias, no file and no
`ros2` of the pupil's comes in between.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from day6_core.lessons.checks import condition_of
from day6_core.lessons.checks.terminals import plain_output
from day6_core.lessons.grading.limits import ANSWER_SECONDS, BUILD_SECONDS, IDLE_SECONDS
from day6_core.lessons.grading.marks import Mark
from day6_core.lessons.player import LOOK, StageError
from day6_core.lessons.stage import Stage
from day6_core.lessons.texts import Say
from day6_core.reason import named_reason

if TYPE_CHECKING:
    from day6_core.lessons.live import Live
    from day6_core.session.session import Session

TAIL_LINES = 3
LONGEST_LINE = 80
_STAMP = re.compile(r"\[\d+\.\d+\] ")


class NotPlayed(Exception):
    """A scenario that cannot go on: what was wanted, what was seen instead, and what that is marked with.

    `timed`: whether it might have gone otherwise on a machine that is less busy.
    """

    def __init__(self, wanted: Say, saw: Say | None, mark: Mark = Mark.WRONG, *, timed: bool = True) -> None:
        super().__init__(wanted.text("en"))
        self.wanted, self.saw, self.mark, self.timed = wanted, saw, mark, timed


class GraderStage(Stage):
    """A stage with the actions that only scenarios have. `built` remembers, for one submission, how each build ended."""

    def __init__(self, live: Live, session: Session, built: dict[str, NotPlayed | None]) -> None:
        super().__init__(live, session)
        self._built = built
        self._publishers: dict[tuple[str, str], Any] = {}

    async def perform(self, actions: Iterable[Mapping[str, Any]]) -> None:
        """Perform them. Raises NotPlayed."""
        try:
            await super().perform(actions)
        except (StageError, OSError, ValueError, KeyError) as error:
            raise NotPlayed(Say("grade.action"), Say("grade.action_saw", reason=named_reason(error)[:200])) from None

    async def _do_wait(self, given: object) -> None:
        """Wait for a check, not longer than there is something of the pupil's that could make it hold."""
        condition = condition_of(given)
        assert not isinstance(condition, str)
        waited = idle = 0.0
        while not (verdict := condition.judge(self._live)).ok:
            if waited > ANSWER_SECONDS or idle > IDLE_SECONDS:
                raise NotPlayed(verdict.wanted, verdict.saw)
            idle = idle + LOOK if self._terminals and not self._live.running() else 0.0
            await self._session.sleep(LOOK)
            waited += LOOK

    async def _do_start(self, given: str | Mapping[str, Any]) -> None:
        from day6_core.ros.programs import load
        from day6_core.session.streams import Captured, InputStream
        from day6_core.shell.language.redirection import Streams

        words = given if isinstance(given, str) else str(given["program"])
        arguments = [] if isinstance(given, str) else [str(each) for each in given.get("arguments", ())]
        package, executable = words.split()
        desk, output = self._live.desk, Captured()
        desk.start_program(
            [executable, *arguments], load(package, executable), Streams(InputStream(), output, output),
            env=desk.environment(), cwd=self._live.home,
        )  # fmt: skip

    async def _do_build(self, name: str) -> None:
        if name not in self._built:
            self._built[name] = None
            try:
                await self._build(name)
            except NotPlayed as problem:
                self._built[name] = problem
        if (before := self._built[name]) is not None:
            raise before

    async def _build(self, name: str) -> None:
        wanted = Say("grade.build", name=name)
        sources = (self._live.home / "ros2_ws" / "src").rglob("package.xml")
        if not any(f"<name>{name}</name>" in path.read_text(encoding="utf-8", errors="replace") for path in sources):
            raise NotPlayed(wanted, Say("grade.build_none"), timed=False)
        terminal = self._live.desk.open_terminal()
        terminal.run_line(f"cd ~/ros2_ws && colcon build --packages-select {name}")
        runs = terminal.runs
        if not await self._session.until(lambda: runs.all and runs.all[-1].status is not None, BUILD_SECONDS, LOOK):
            raise NotPlayed(wanted, Say("grade.build_late", seconds=f"{BUILD_SECONDS:g}"), Mark.LATE)
        last = runs.all[-1]
        installed = self._live.home / "ros2_ws" / "install" / name / "share" / name / "package.xml"
        if last.status or not installed.is_file():
            raise NotPlayed(wanted, Say("grade.build_failed", text=tail(plain_output(last))), timed=False)

    async def _do_publish(self, given: Mapping[str, Any]) -> None:
        """Send messages once somebody listens."""
        from rosidl_runtime_py.set_message import set_message_fields
        from rosidl_runtime_py.utilities import get_message

        topic, kind, node = str(given["topic"]), str(given["type"]), self._live.node
        if (topic, kind) not in self._publishers:
            self._publishers[topic, kind] = node.create_publisher(get_message(kind), topic, 10)
        publisher = self._publishers[topic, kind]
        if not await self._session.until(publisher.get_subscription_count, ANSWER_SECONDS, LOOK):
            raise NotPlayed(Say("grade.listener", topic=topic, type=kind), Say("grade.listener_saw"))
        for number in range(int(given.get("count", 1))):
            if number:
                await self._session.sleep(float(given.get("every", 0.2)))
            message = get_message(kind)()
            set_message_fields(message, dict(given["fields"]))
            if hasattr(message, "header") and hasattr(message.header, "stamp"):
                message.header.stamp = node.get_clock().now().to_msg()
            publisher.publish(message)

    async def _do_call(self, given: Mapping[str, Any]) -> None:
        from rosidl_runtime_py.set_message import set_message_fields
        from rosidl_runtime_py.utilities import get_service

        name, kind, node = str(given["service"]), get_service(str(given["type"])), self._live.node
        client = node.create_client(kind, name)
        problem = NotPlayed(Say("grade.service", name=name), Say("grade.service_saw"))
        try:
            if not await self._session.until(client.service_is_ready, ANSWER_SECONDS, LOOK):
                raise problem
            request = kind.Request()
            set_message_fields(request, dict(given.get("fields", {})))
            if not await self._session.spin_until(client.call_async(request), ANSWER_SECONDS):
                raise problem
        finally:
            node.destroy_client(client)


def tail(text: str) -> str:
    """The last lines of what was printed, in one line, without stamps and Python's lines about files and places."""
    found = [_STAMP.sub("", line).strip() for line in text.splitlines()]
    told = [line for line in found if line and not line.startswith(("File ", "Traceback ", "^", "Summary:"))]
    last = list(dict.fromkeys(told[-12:]))[-TAIL_LINES:]
    return " / ".join(line if len(line) <= LONGEST_LINE else line[: LONGEST_LINE - 1] + "…" for line in last)
