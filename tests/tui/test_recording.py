"""Recording on a stepped desktop: the upper line tells, a recording that breaks is told, pixels pause meanwhile."""

from __future__ import annotations

from pathlib import Path

from tests.tui.fakes import FakeDesk
from tests.tui.screens import opened, screen_lines, screen_text, step


async def test_a_running_recording_is_seen_and_a_click_ends_it(desk: FakeDesk, tmp_path: Path) -> None:
    async with opened(desk, 250, 24, lang="en", scene="empty") as (app, pilot):
        app._driver.recorder = None  # a driver that can be recorded
        app.recording.begin(tmp_path / "a.cast")
        await step(app, pilot)
        assert "recording 0:00" in screen_lines(app)[0] and app._driver.recorder is not None
        await pilot.click(offset=(screen_lines(app)[0].index("recording"), 0))
        await step(app, pilot)
        assert "recording 0:" not in screen_lines(app)[0] and app._driver.recorder is None
        assert "recorded:" in screen_text(app) and (tmp_path / "a.cast").read_text().startswith('{"version": 2')


async def test_a_recording_that_breaks_is_told_and_over(desk: FakeDesk, tmp_path: Path) -> None:
    async with opened(desk, 120, 24, lang="zh", scene="empty") as (app, pilot):
        app._driver.recorder = None
        app.recording.begin(tmp_path / "a.cast")
        await step(app, pilot)
        app._driver.recorder.fault = "No space left on device"
        await step(app, pilot)
        assert "录制 a.cast 停下了：No space left on device" in screen_text(app)
        assert not app.recording.running and app._driver.recorder is None


async def test_what_cannot_be_recorded_is_told(desk: FakeDesk, short_folder: Path) -> None:
    (short_folder / "mine").write_text("mine")
    async with opened(desk, 250, 24, lang="en", scene="empty") as (app, pilot):
        app.recording.begin(short_folder / "a.cast")
        await step(app, pilot)
        assert "cannot be recorded on this system" in screen_text(app)
    async with opened(desk, 250, 24, lang="en", scene="empty") as (app, pilot):
        app._driver.recorder = None
        app.recording.begin(short_folder / "mine")
        await step(app, pilot)
        assert "File exists" in screen_text(app) and not app.recording.running
        assert (short_folder / "mine").read_text() == "mine"
