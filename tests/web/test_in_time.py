"""Waiting with a limit: a cancellation is never lost, also not when what is waited for ends at the same moment."""

from __future__ import annotations

import asyncio

import pytest

from day6_tui.web.in_time import in_time
from tests.support.waiting import PATIENCE


async def _passed(turns: int) -> None:
    for _ in range(turns):
        await asyncio.sleep(0)


@pytest.mark.parametrize("turns", range(6))
def test_a_task_that_is_cancelled_while_its_event_comes_ends(turns: int) -> None:
    async def whole() -> None:
        event = asyncio.Event()

        async def listen() -> None:
            while True:
                event.clear()
                await in_time(event.wait(), PATIENCE)

        task = asyncio.create_task(listen())
        await _passed(5)
        event.set()
        await _passed(turns)
        task.cancel()
        await _passed(10)
        assert task.cancelled()

    asyncio.run(whole())


def test_what_is_not_done_in_time_is_ended() -> None:
    async def whole() -> None:
        ended = False

        async def deed() -> None:
            nonlocal ended
            try:
                await asyncio.Event().wait()
            finally:
                await asyncio.sleep(0)
                ended = True

        with pytest.raises(asyncio.TimeoutError):
            await in_time(deed(), 0.0)
        assert ended

    asyncio.run(whole())


def test_what_comes_of_it_is_handed_on() -> None:
    async def fails() -> None:
        raise KeyError("x")

    async def whole() -> None:
        assert await in_time(asyncio.sleep(0, 7), PATIENCE) == 7
        with pytest.raises(KeyError):
            await in_time(fails(), PATIENCE)

    asyncio.run(whole())
