"""The lesson window keeps up with the course, which goes on in another thread while it draws."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support import waiting
from tests.tui.screens import step
from tests.tui.test_real_desk import _shows, opened, until


@pytest.mark.long
@pytest.mark.process
async def test_the_edge_tells_the_step_that_the_page_shows(tmp_path: Path) -> None:
    async with opened(tmp_path, lesson="day1") as (app, pilot):
        await until(app, pilot, _shows(app, "Step 1 of"))
        for _ in range(5):  # everything has its place, and nothing is drawn for another reason
            await step(app, pilot)
        pane = app.lessons.pane
        pane.touch()
        pane.touch_frame()  # the edges are made, the page is not
        pane.course.request(pane.course.next)
        waiting.until(lambda: pane.course.state.index == 1)  # nothing is drawn meanwhile
        await pilot.pause()  # now the page is
        await until(app, pilot, _shows(app, "Make a folder"))
        await until(app, pilot, _shows(app, "Step 2 of"))
