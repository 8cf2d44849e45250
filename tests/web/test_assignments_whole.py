"""An assignment from the first order to the returned mark, with a real desktop, and a server that is killed in the middle."""

from __future__ import annotations

import asyncio
import signal
from pathlib import Path
from typing import Any

import aiohttp
import pytest

from tests.support.short_folder import make_short_folder
from tests.support.waiting import Deadline
from tests.web.in_time import in_time
from tests.web.serving import Serving, Tab, browser, run

pytestmark = pytest.mark.process


async def shown(ws: aiohttp.ClientWebSocketResponse, wanted: Any) -> dict[str, Any]:
    """How anna stands, as soon as this is true."""
    deadline, rows = Deadline(), {}
    while not deadline.is_over():
        await ws.send_json({"t": "assign", "do": "show", "id": "day1"})
        while (message := await in_time(ws.receive_json())).get("do") != "show":
            pass
        rows = {row["name"]: row for row in message["rows"]}
        if not message["working"] and wanted(rows["anna"]):
            return dict(rows["anna"])
        await asyncio.sleep(0.1)
    raise AssertionError(rows)


async def told(ws: aiohttp.ClientWebSocketResponse, do: str, **more: Any) -> None:
    await ws.send_json({"t": "assign", "do": do, "id": "day1", "names": "*", **more})


def test_an_assignment_survives_a_killed_server_and_comes_back_marked() -> None:
    folder = make_short_folder("d6c-")
    table = folder / "pupils.csv"
    table.write_text("name\nanna\n", encoding="utf-8")
    with Serving(folder, "--class", str(table), "--isolation", "none") as serving:

        async def first() -> None:
            async with browser(serving.base) as door, browser(serving.base) as teacher:
                ws = await desk(teacher, serving)
                await door.get(serving.link("anna"))
                tab = await door.tab()
                await tab.see("anna@day6:~$")
                await told(ws, "new", kind="lesson", names=["day1"], to="*", due=0, title="")
                await tab.see("Day 1")  # the lesson is open beside the terminal
                await shown(ws, lambda anna: anna["at"] == 1)
                await tab.type("ls\r")
                await shown(ws, lambda anna: solved(folder) == 1)
                await told(ws, "collect")
                await shown(ws, lambda anna: anna["collected"] and anna["solved"] == 1)
                serving.end(signal.SIGKILL)

        async def second() -> None:
            async with browser(serving.base) as door, browser(serving.base) as teacher:
                ws = await desk(teacher, serving)
                assert (await shown(ws, lambda anna: anna["here"]))["solved"] == 1  # nothing collected is lost
                await told(ws, "grade")
                await shown(ws, lambda anna: anna["points"] == 0.0)  # the question of the lesson has no answer
                await told(ws, "word", name="anna", mark="B-", line="Go on: the question is open.")
                await told(ws, "return")
                await shown(ws, lambda anna: anna["returned"] and not anna["news"])
                await door.get(links["anna"])
                tab: Tab = await door.tab()
                await tab.see("F10")
                await tab.type("\x1b[21~")
                await tab.see("marks/Day_1")

        links: dict[str, str] = {}
        links["anna"] = serving.link("anna")
        run(first())
        serving.start()
        links["anna"] = links["anna"].replace(links["anna"].split("/p/")[0], serving.base.rstrip("/"))
        run(second())
        assert b"B-" in next((folder / "class/homes/anna/marks").glob("*.md")).read_bytes()
    assert serving.cells() == []
    assert not list((folder / "class/grading").iterdir())  # nothing is left of the cell


async def desk(teacher: Any, serving: Serving) -> aiohttp.ClientWebSocketResponse:
    await teacher.get(serving.link("the teacher"))
    ws: aiohttp.ClientWebSocketResponse = await teacher.session.ws_connect(
        teacher.base + "class/ws", headers=teacher.origin
    )
    return ws


def solved(folder: Path) -> int:
    """Steps of the first day, as the desktop has noted."""
    from day6_core.lessons.progress import pupils

    return sum(each.solved("day1") for each in pupils(folder / "class/homes/anna"))
