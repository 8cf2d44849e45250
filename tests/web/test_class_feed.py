"""What the teacher's page is told of a running class, and what its orders do."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any

import aiohttp
import pytest

from tests.support.waiting import Deadline
from tests.web.in_time import in_time
from tests.web.serving import Serving, browser, run

pytestmark = pytest.mark.process

Rows = dict[str, dict[str, Any]]


async def told(ws: aiohttp.ClientWebSocketResponse, wanted: Callable[[Rows], object]) -> Rows:
    """The first rows of which this is true."""
    deadline = Deadline()
    rows: Rows = {}
    while not deadline.is_over():
        message = await in_time(ws.receive_json())
        if message["t"] == "rows":
            rows = {row["name"]: row for row in message["rows"]}
            if wanted(rows):
                return rows
    raise AssertionError(rows)


def test_the_teacher_sees_who_is_there_and_what_they_run_and_says_something_to_all(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door, browser(class_server.base) as teacher:
            await teacher.get(class_server.link("the teacher"))
            ws = await teacher.session.ws_connect(teacher.base + "class/ws", headers=teacher.origin)
            hello = await ws.receive_json()
            assert hello["t"] == "hello" and "day1" in {each["name"] for each in hello["lessons"]}
            assert {"name": "turtle", "title": {"zh": "海龟", "en": "Turtle"}} in hello["scenes"]
            await door.get(class_server.link("anna"))
            tab = await door.tab()
            await tab.see("anna@day6:~$")
            reading = asyncio.create_task(tab.see("listen-to-me"))
            await told(
                ws, lambda rows: rows.get("anna", {}).get("state") == "here" and rows["anna"].get("lesson", 0) is None
            )
            await ws.send_json({"t": "order", "names": ["anna"], "order": {"do": "watch", "seconds": 10}})
            rows = await told(ws, lambda rows: rows["anna"].get("screen"))
            await ws.send_json({"t": "order", "names": ["anna"], "order": {"do": "type", "text": "x"}})
            refused = await told(ws, lambda rows: rows["anna"].get("refused"))
            assert refused["anna"]["refused"] == "the pupil has not agreed"
            assert "anna@day6" in rows["anna"]["screen"]["ansi"] and rows["anna"]["watched"] is True
            await ws.send_json({"t": "order", "names": "*", "order": {"do": "say", "text": "listen-to-me"}})
            await reading
            await tab.type("\x1b")
            await tab.ws.close()
            await told(ws, lambda rows: rows["anna"]["state"] == "away")
            await ws.send_json({"t": "order", "names": ["anna"], "order": {"do": "end"}})
            await told(ws, lambda rows: rows["anna"]["state"] == "gone")

    run(deed())


def test_a_pupil_sees_live_what_the_teacher_types_on_the_own_desktop_until_it_ends(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door, browser(class_server.base) as teacher:
            await teacher.get(class_server.link("the teacher"))
            ws = await teacher.session.ws_connect(teacher.base + "class/ws", headers=teacher.origin)
            await door.get(class_server.link("bert"))
            await ws.send_json({"t": "show", "do": "start", "name": "", "names": "*", "full": False})
            mine = await teacher.tab("mine=1&cols=80&rows=24")
            await mine.see("class sees this")
            shown = await door.session.ws_connect(f"{door.base}shown", headers=door.origin)
            lines: dict[str, str] = {}

            async def sees(text: str) -> None:
                while not any(text in line for line in lines.values()):
                    message = await in_time(shown.receive_json())
                    lines.update(message.get("lines", {}))
                    await shown.send_json({"t": "ack"})

            await sees("class sees this")
            await mine.type("echo $((6 * 7))-live\r")
            reading = asyncio.create_task(mine.see("42-live"))
            await sees("42-live")
            await reading
            await ws.send_json({"t": "order", "names": ["@teacher"], "order": {"do": "end"}})
            while (await in_time(shown.receive_json()))["t"] != "bye":
                await shown.send_json({"t": "ack"})

    run(deed())


@pytest.mark.parametrize(
    "sent", ["[]", '{"t": "order", "names": "*", "order": {"do": "rm"}}', "{}", "nothing", '{"t": 1}']
)
def test_orders_that_are_none_close_the_teachers_line(class_server: Serving, sent: str) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as teacher:
            await teacher.get(class_server.link("the teacher"))
            ws = await teacher.session.ws_connect(teacher.base + "class/ws", headers=teacher.origin)
            await ws.send_str(sent)
            if sent == '{"t": 1}':
                await ws.send_str("{}")
            while (await in_time(ws.receive())).type == aiohttp.WSMsgType.TEXT:
                pass
            assert ws.close_code == 1008

    run(deed())


def test_a_pupil_does_not_reach_the_teachers_line(class_server: Serving) -> None:
    async def deed() -> None:
        async with browser(class_server.base) as door:
            await door.get(class_server.link("anna"))
            with pytest.raises(aiohttp.WSServerHandshakeError):
                await door.session.ws_connect(door.base + "class/ws", headers=door.origin)
            assert (await door.get("class"))[0] == 403

    run(deed())
