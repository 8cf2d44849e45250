"""Programs in their sessions: how they end, what they leave."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Main, Session
from day6_core.session.streams import Captured
from day6_core.session.task import Signal


class Machine:
    def __init__(self) -> None:
        self.scheduler = Scheduler(WorldClock(wall=None, epoch_ns=0))
        self.display = Display()
        self.out, self.err = Captured(), Captured()

    def start(self, main: Main, *argv: str) -> Program:
        session = Session(
            self.scheduler, None, list(argv) or ["program"], stdout=self.out, stderr=self.err, display=self.display
        )
        program = Program(session, main)
        self.scheduler.advance()
        return program

    def go(self, seconds: float = 0.0) -> None:
        self.scheduler.advance(seconds)


@pytest.fixture
def machine() -> Iterator[Machine]:
    yield Machine()


async def forever(session: Session) -> None:
    await session.wait(Signal())


def test_the_return_value_is_the_exit_status(machine: Machine) -> None:
    async def three(session: Session) -> int:
        return 3

    async def none(session: Session) -> None:
        session.print("done")

    assert machine.start(three).status == 3
    assert machine.start(none).status == 0
    assert machine.out.text == "done\n"


def test_an_exception_ends_a_program_with_status_1_and_its_message(machine: Machine) -> None:
    async def broken(session: Session) -> None:
        raise ValueError("no such turtle")

    program = machine.start(broken, "/opt/ros/jazzy/lib/turtlesim/turtlesim_node")
    assert program.status == 1
    assert machine.err.text == "turtlesim_node: no such turtle\n"


def test_an_exception_without_a_text_is_told_by_its_name(machine: Machine) -> None:
    async def broken(session: Session) -> None:
        raise AssertionError

    machine.start(broken)
    assert machine.err.text == "program: AssertionError\n"


@pytest.mark.parametrize(("code", "status", "text"), [(None, 0, ""), (4, 4, ""), ("usage: x", 1, "usage: x\n")])
def test_sys_exit_means_what_it_means_in_python(machine: Machine, code: object, status: int, text: str) -> None:
    async def leave(session: Session) -> None:
        raise SystemExit(code)

    assert machine.start(leave).status == status
    assert machine.err.text == text


@pytest.mark.parametrize(
    ("number", "status", "killed_by"),
    [(2, 130, 2), (15, 143, 15), (9, 137, 9), (1, 129, 1), (10, 138, 10), (28, None, 0)],
)
def test_a_signal_ends_a_program_as_a_shell_counts_it(
    machine: Machine, number: int, status: int | None, killed_by: int
) -> None:
    program = machine.start(forever)
    program.send(number)
    machine.go()
    assert (program.status, program.killed_by) == (status, killed_by)


def test_a_program_may_handle_ctrl_c_and_end_well(machine: Machine) -> None:
    async def careful(session: Session) -> int:
        try:
            await session.wait(Signal())
        except KeyboardInterrupt:
            session.print("bye")
        return 0

    program = machine.start(careful)
    program.interrupt()
    machine.go()
    assert (program.status, machine.out.text) == (0, "bye\n")


def test_what_was_deferred_runs_last_first_however_the_program_ends(machine: Machine) -> None:
    async def main(session: Session) -> None:
        session.defer(lambda: session.print("first"))
        session.defer(lambda: session.print("second"))
        await session.wait(Signal())

    program = machine.start(main)
    program.kill()
    machine.go()
    assert machine.out.text == "second\nfirst\n"


def test_child_tasks_end_with_their_program(machine: Machine) -> None:
    async def child(session: Session) -> None:
        async for number in session.every(0.1):
            session.print(number)

    async def main(session: Session) -> None:
        session.spawn(child(session))
        await session.sleep(0.25)

    machine.start(main)
    machine.go(5)
    assert machine.out.text == "1\n2\n"
    assert not machine.scheduler._tasks


def test_an_exception_in_a_child_task_ends_the_program(machine: Machine) -> None:
    async def child() -> None:
        raise RuntimeError("callback failed")

    async def main(session: Session) -> None:
        session.spawn(child())
        await session.wait(Signal())

    program = machine.start(main)
    assert program.status == 1
    assert machine.err.text == "program: callback failed\n"


def test_every_yields_each_whole_period_once(machine: Machine) -> None:
    times: list[int] = []

    async def main(session: Session) -> None:
        async for count in session.every(0.016):
            times.append(session.clock.steady_ns())
            if count == 63:
                return

    machine.start(main)
    machine.go(2)
    assert times == [16_000_000 * number for number in range(1, 64)]


def test_a_stopped_program_takes_no_step_until_it_goes_on(machine: Machine) -> None:
    async def main(session: Session) -> None:
        async for count in session.every(1):
            session.print(count)

    program = machine.start(main)
    machine.go(2)
    program.stop()
    machine.go(3)
    assert machine.out.text == "1\n2\n"
    program.resume()
    machine.go()
    assert machine.out.text.startswith("1\n2\n3\n")


def test_windows_vanish_with_their_program(machine: Machine) -> None:
    async def main(session: Session) -> None:
        assert session.display is not None
        session.display.open("turtlesim", "TurtleSim", object())
        await session.wait(Signal())

    program = machine.start(main)
    assert [window.title for window in machine.display.windows] == ["TurtleSim"]
    version = machine.display.version
    program.terminate()
    machine.go()
    assert machine.display.windows == []
    assert machine.display.version > version


def test_closing_a_window_interrupts_its_program(machine: Machine) -> None:
    async def main(session: Session) -> None:
        assert session.display is not None
        session.display.open("turtlesim", "TurtleSim", object())
        await session.wait(Signal())

    program = machine.start(main)
    (window,) = machine.display.windows
    window.close_by_user()
    assert window.closed
    assert machine.display.windows == []
    machine.go()
    assert program.status == 130


def test_going_on_as_another_program_keeps_the_process_number(machine: Machine) -> None:
    async def other(session: Session) -> int:
        session.print(session.pid, *session.argv)
        return 7

    async def main(session: Session) -> int:
        session.pid = 1234
        return await session.execute(other, ["other", "argument"])

    assert machine.start(main).status == 7
    assert machine.out.text == "1234 other argument\n"
