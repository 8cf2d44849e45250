"""Futures and tasks: outcomes, callbacks, coroutines that wait."""

from __future__ import annotations

import asyncio
import gc
import weakref
from typing import Any

import pytest

from rclpy.task import Future, Task


def test_a_future_gets_a_result() -> None:
    future: Future[int] = Future()
    assert (future.done(), future.cancelled(), future.result(), future.exception()) == (False, False, None, None)
    future.set_result(5)
    assert (future.done(), future.cancelled(), future.result(), future.exception()) == (True, False, 5, None)


def test_a_future_gets_an_exception() -> None:
    future: Future[int] = Future()
    future.set_exception(KeyError("x"))
    assert future.done()
    assert isinstance(future.exception(), KeyError)
    with pytest.raises(KeyError):
        future.result()


def test_a_cancelled_future_is_not_done() -> None:
    future: Future[int] = Future()
    future.cancel()
    assert future.cancelled()
    assert not future.done()
    done: Future[int] = Future()
    done.set_result(1)
    done.cancel()
    assert not done.cancelled()


def test_an_exception_that_nobody_looked_at_is_told(capsys: Any) -> None:
    future: Future[int] = Future()
    future.set_exception(ValueError("unseen"))
    del future
    assert capsys.readouterr().err == "The following exception was never retrieved: unseen\n"
    seen: Future[int] = Future()
    seen.set_exception(ValueError("seen"))
    seen.exception()
    del seen
    assert capsys.readouterr().err == ""


def test_callbacks_run_when_there_is_an_outcome_and_at_once_after_it() -> None:
    for end in (lambda future: future.set_result(1), lambda future: future.cancel()):
        future: Future[int] = Future()
        called: list[tuple[str, Any]] = []
        future.add_done_callback(lambda each, called=called: called.append(("a", each)))  # type: ignore[misc]
        future.add_done_callback(lambda each, called=called: called.append(("b", each)))  # type: ignore[misc]
        assert called == []
        end(future)
        assert called == [("a", future), ("b", future)]
        future.add_done_callback(lambda each, called=called: called.append(("c", each)))  # type: ignore[misc]
        assert called[2:] == [("c", future)]


def test_a_removed_callback_is_not_called() -> None:
    future: Future[int] = Future()
    called: list[Any] = []
    future.add_done_callback(called.append)
    assert future.remove_done_callback(called.append)
    assert not future.remove_done_callback(called.append)
    future.set_result(1)
    assert called == []


def test_an_exception_of_a_callback_is_a_warning() -> None:
    future: Future[int] = Future()
    called: list[Any] = []

    def fail(_: Any) -> None:
        raise ValueError("oh")

    future.add_done_callback(fail)
    future.add_done_callback(called.append)
    with pytest.warns(UserWarning, match="Unhandled exception in done callback: oh"):
        future.set_result(1)
    assert called == [future]


def test_the_callbacks_of_an_executors_future_run_when_it_spins(world: Any) -> None:
    called: list[Any] = []
    before, after = world.executor.create_future(), world.executor.create_future()
    before.add_done_callback(called.append)
    before.set_result(1)
    after.set_result(2)
    after.add_done_callback(called.append)
    assert called == []
    world.settle()
    assert called == [before, after]


def test_a_task_runs_a_function_once() -> None:
    ran: list[Any] = []
    task: Task[int] = Task(lambda *args, **kwargs: ran.append((args, kwargs)) or 7, (1, 2), {"x": 3})
    assert not task.done()
    assert not task.executing()
    task()
    task()
    assert ran == [((1, 2), {"x": 3})]
    assert (task.done(), task.executing(), task.result()) == (True, False, 7)


def test_a_task_keeps_the_exception_of_its_function() -> None:
    def fail() -> None:
        raise KeyError("x")

    async def fail_too() -> None:
        raise KeyError("x")

    for function in (fail, fail_too):
        task: Task[None] = Task(function)
        task()
        assert task.done()
        with pytest.raises(KeyError):
            task.result()


def test_a_task_tells_that_it_runs() -> None:
    seen: list[bool] = []
    task: Task[None] = Task(lambda: seen.append(task.executing()))
    task()
    assert seen == [True]


def test_a_coroutine_goes_on_when_what_it_waits_for_is_there() -> None:
    gate: Future[str] = Future()
    steps: list[Any] = []

    async def wait(first: str) -> int:
        steps.append(first)
        steps.append(await gate)
        return 3

    task: Task[int] = Task(wait, ("start",))
    task()
    task()
    assert steps == ["start"]
    assert not task.done()
    gate.set_result("go")
    task()
    assert steps == ["start", "go"]
    assert (task.done(), task.result()) == (True, 3)


def test_a_coroutine_gets_the_exception_it_waited_for() -> None:
    gate: Future[str] = Future()

    async def wait() -> str:
        try:
            return str(await gate)
        except ValueError as error:
            return f"caught {error}"

    task: Task[str] = Task(wait)
    task()
    gate.set_exception(ValueError("no"))
    task()
    assert task.result() == "caught no"


def test_one_coroutine_waits_for_another(world: Any) -> None:
    gate: Future[int] = Future()

    async def inner() -> int:
        return (await gate or 0) + 1

    async def outer() -> int:
        return (await world.executor.create_task(inner) or 0) * 10

    task = world.executor.create_task(outer)
    world.settle()
    assert not task.done()
    gate.set_result(4)
    world.settle()
    assert task.result() == 50


def test_a_cancelled_task_runs_no_more() -> None:
    gate: Future[None] = Future()
    steps: list[str] = []

    async def wait() -> None:
        steps.append("in")
        await gate
        steps.append("out")

    task: Task[None] = Task(wait)
    task()
    task.cancel()
    gate.set_result(None)
    task()
    assert steps == ["in"]
    assert task.cancelled()
    never: Task[Any] = Task(lambda: steps.append("never"))
    never.cancel()
    never()
    assert steps == ["in"]


def test_asyncio_can_await_a_future() -> None:
    future: Future[int] = Future()

    async def main() -> int | None:
        asyncio.get_running_loop().call_later(0.01, future.set_result, 5)
        return await future

    assert asyncio.run(main()) == 5


def test_an_executor_calls_what_it_was_given_as_a_task(world: Any) -> None:
    async def double(number: int, *, plus: int = 0) -> int:
        return number * 2 + plus

    tasks = [
        world.executor.create_task(double, 4, plus=1),
        world.executor.create_task(lambda number: number + 1, 4),
        world.executor.create_task(lambda: "nothing"),
    ]
    assert not any(task.done() for task in tasks)
    world.settle()
    assert [task.result() for task in tasks] == [9, 5, "nothing"]


class Held:
    """Something a task is given; whether it lives on can be told."""


@pytest.mark.long
@pytest.mark.parametrize("fails", [True, False])
@pytest.mark.parametrize("is_coroutine", [True, False])
def test_a_task_lets_go_of_what_it_was_given_when_it_is_over(fails: bool, is_coroutine: bool) -> None:
    def work(_held: Held, *, _also: Held) -> int:
        return 1 // (not fails)

    async def work_later(_held: Held, *, _also: Held) -> int:
        return 1 // (not fails)

    one, other = Held(), Held()
    living = [weakref.ref(one), weakref.ref(other)]
    task: Task[int] = Task(work_later if is_coroutine else work, (one,), {"_also": other})
    del one, other
    assert None not in [each() for each in living]
    task()
    assert isinstance(task.exception(), ZeroDivisionError) is fails
    if task.exception() is not None:
        task.exception().__traceback__ = None  # type: ignore[union-attr]
    gc.collect()
    assert [each() for each in living] == [None, None]
    task()
    assert task.done()


def test_a_task_that_calls_itself_does_not_run_twice() -> None:
    ran: list[bool] = []

    def work() -> None:
        ran.append(task.executing())
        task()

    task: Task[None] = Task(work)
    assert not task.executing()
    task()
    assert ran == [True]
    assert not task.executing()


def test_a_callback_is_called_once_however_often_there_is_an_outcome() -> None:
    called: list[Any] = []
    future: Future[int] = Future()
    future.add_done_callback(lambda done: called.append(done.result()))
    future.set_result(1)
    future.set_result(2)
    future.cancel()
    assert (called, future.result(), future.done(), future.cancelled()) == ([1], 2, True, False)
    assert not future.remove_done_callback(print)
    stopped: Future[int] = Future()
    stopped.add_done_callback(called.append)
    stopped.cancel()
    stopped.cancel()
    assert (called[1:], stopped.done(), stopped.result()) == ([stopped], False, None)


def test_executors_of_others_see_who_runs_a_future_and_what_a_task_runs() -> None:
    """Public packages with an executor of their own look at these names of real rclpy."""

    async def nothing() -> None: ...

    assert Future()._executor() is None
    function, coroutine = Task(len, ("ab",)), Task(nothing)
    assert function._executor() is None and function._pending()
    assert function._handler is len and asyncio.iscoroutine(coroutine._handler)
    function()
    coroutine()
    assert not function._pending() and coroutine.done()
