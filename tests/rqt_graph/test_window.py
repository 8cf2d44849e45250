"""rqt_graph's window as a person uses it: panning, zooming, Fit, namespace boxes, what lies outside."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest
from textual import events

from day6_core.graph import Graph
from day6_core.ros.programs.rqt_graph.model.content import GraphContent, GraphOptions
from day6_core.ros.programs.rqt_graph.model.rqt_graph import RqtGraph
from tests.tui.screens import ToolWindow, screen_lines, step, use_window

LESSON = GraphContent({"/turtle1/cmd_vel": ("/teleop_turtle",)}, {"/turtle1/cmd_vel": ("/turtlesim",)})

ROBOTS = GraphContent(
    {f"/r{robot}/topic_{part}": (f"/r{robot}/part_{part}",) for robot in range(4) for part in range(7)},
    {f"/r{robot}/topic_{part}": (f"/r{robot}/part_{part + 1}",) for robot in range(4) for part in range(7)},
)
"""Four robots with chains of eight nodes: wider than any window with everything in full."""


class _Window(ToolWindow):
    """rqt_graph on a stepped desktop."""

    def place(self, text: str) -> tuple[int, int]:
        """Column and row of the pane at which a text stands on the screen."""
        region = self.pane.region
        for y, line in enumerate(screen_lines(self.app)):
            if text in line[region.x : region.right]:
                return line.index(text, region.x) - region.x, y - region.y
        raise AssertionError(f"{text!r} is not in\n{self.text}")

    async def to_the_start(self) -> None:
        """Pan to the upper left corner of a picture larger than the window."""
        view = self.pane._view
        await self.press(*["up"] * ((view.y + 1) // 2), *["left"] * (view.x // 8))
        await self.drag((10, 5), (10 + view.x, 5 + view.y))

    async def wheel(self, direction: str, *, at: tuple[int, int] = (10, 5)) -> None:
        kind = events.MouseScrollDown if direction == "down" else events.MouseScrollUp
        x, y = self.pane.region.x + at[0], self.pane.region.y + at[1]
        self.app.screen._forward_event(kind(None, x, y, 0, 0, 0, False, False, False, x, y))
        await self.pilot.pause()
        await step(self.app, self.pilot)

    async def drag(self, start: tuple[int, int], end: tuple[int, int]) -> None:
        await self.pilot.mouse_down("RqtGraphPane", offset=start)
        await self.pilot.hover("RqtGraphPane", offset=end)
        await self.pilot.mouse_up("RqtGraphPane", offset=end)
        await step(self.app, self.pilot)


def use(
    facts: GraphContent, act: Callable[[_Window], Awaitable[None]], size: tuple[int, int] = (80, 24), **options: Any
) -> None:
    """Open the graph and do something with it."""
    model = RqtGraph(None, Graph(0), Path("/nowhere"))  # type: ignore[arg-type]
    model._show(facts, GraphOptions())
    use_window(("rqt_graph", "rqt_graph", model), act, size, _Window, **options)


@pytest.mark.parametrize(("key", "moved"), [("right", (-8, 0)), ("left", (8, 0)), ("up", (0, 2)), ("down", (0, -2))])
def test_an_arrow_key_pans_and_ends_fit(key: str, moved: tuple[int, int]) -> None:
    async def act(window: _Window) -> None:
        x, y = window.place("/turtlesim")
        await window.press(key)
        assert window.place("/turtlesim") == (x + moved[0], y + moved[1])
        assert not window.model.options.fit
        await window.press("v")
        assert window.place("/turtlesim") == (x, y) and window.model.options.fit

    use(LESSON, act, (120, 40))


def test_dragging_moves_the_picture_with_the_mouse_and_chooses_nothing() -> None:
    async def act(window: _Window) -> None:
        x, y = window.place("/turtlesim")
        await window.drag((x, y), (x - 7, y + 3))
        assert window.place("/turtlesim") == (x - 7, y + 3)
        assert "arrows in" not in window.text
        await window.pilot.click("RqtGraphPane", offset=(x - 7, y + 3))
        await step(window.app, window.pilot)
        assert "/turtlesim: 1 arrows in, 0 out" in window.text

    use(LESSON, act)


def test_the_picture_cannot_be_lost_by_panning() -> None:
    async def act(window: _Window) -> None:
        for key in ("right", "down", "left", "up"):
            await window.press(*[key] * 40)
            assert "─" in "".join(line[1:-1] for line in screen_lines(window.app)[2:-6]), key

    use(LESSON, act)


@pytest.mark.parametrize("size", [(40, 10), (60, 12), (80, 24), (120, 40)])
@pytest.mark.parametrize("facts", [LESSON, ROBOTS], ids=["lesson", "robots"])
def test_fit_brings_the_whole_graph_into_view(facts: GraphContent, size: tuple[int, int]) -> None:
    async def act(window: _Window) -> None:
        picture, view = window.pane._picture, window.pane._view
        assert len(picture.boxes) == len(window.model.content.boxes)
        for _, rect in picture.boxes.values():
            assert view.x <= rect.x and rect.x + rect.width <= view.x + view.columns
            assert view.y <= rect.y and rect.y + rect.height <= view.y + view.rows
        assert not any(view.beyond(rect for _, rect in picture.boxes.values()))

    use(facts, act, size)


@pytest.mark.parametrize("size", [(80, 24), (120, 40), (200, 60)])
def test_namespaces_have_their_boxes_at_every_size(size: tuple[int, int]) -> None:
    async def act(window: _Window) -> None:
        for name in ("/r0", "/r1", "/r2", "/r3"):
            assert f" {name} " in window.text
        await window.press("plus")
        assert {name for name, _ in window.pane._picture.clusters} == {"/r0", "/r1", "/r2", "/r3"}

    use(ROBOTS, act, size)


def test_zooming_in_shows_names_in_full_and_zooming_out_comes_back() -> None:
    async def act(window: _Window) -> None:
        fitted = window.text
        assert "/r0/topic_0" not in fitted
        await window.press(*["plus"] * 12)
        await window.to_the_start()
        assert "/r0/topic_0" in window.text and not window.model.options.fit
        await window.press(*["minus"] * 12)
        assert window.pane._picture.width <= 118
        await window.press("v")
        assert window.text == fitted

    use(ROBOTS, act, (120, 40))


def test_the_wheel_zooms_and_what_is_under_the_pointer_stays_there() -> None:
    async def act(window: _Window) -> None:
        await window.press(*["plus"] * 12)
        await window.press(*["right"] * 6)
        sizes, shares = [], []
        for direction in ("down", "down", "up", "up"):
            picture = window.pane._picture
            sizes.append(picture.width * picture.height)
            shares.append((window.pane._view.x + 60) / picture.width)
            await window.wheel(direction, at=(61, 10))
        assert sizes[0] > sizes[1] > sizes[2] and sizes[3] == sizes[1]
        assert shares == pytest.approx([shares[0]] * 4, abs=0.02)

    use(ROBOTS, act, (120, 40))


def test_hints_say_how_many_boxes_lie_beyond_each_edge() -> None:
    async def act(window: _Window) -> None:
        await window.press(*["plus"] * 12)
        await window.to_the_start()
        view = window.pane._view
        rects = [rect for _, rect in window.pane._picture.boxes.values()]
        beyond = view.beyond(rects)
        assert beyond.left is None and beyond.up is None
        assert f" ▶ {beyond.right} " in window.text and f" ▼ {beyond.down} " in window.text
        assert beyond.right == sum(rect.x + rect.width > view.columns for rect in rects) > 0
        await window.press("right", "down")
        beyond = view.beyond(rects)
        assert f" ◀ {beyond.left} " in window.text and f" ▲ {beyond.up} " in window.text

    use(ROBOTS, act)


def test_in_an_overview_every_box_can_still_be_chosen() -> None:
    async def act(window: _Window) -> None:
        await window.press("j")
        first = window.pane._chosen
        assert f"{first}: " in window.text
        seen = {first}
        for _ in range(len(window.model.content.boxes) - 1):
            await window.press("j")
            seen.add(window.pane._chosen)
        assert seen == {box.key for box in window.model.content.boxes}

    use(ROBOTS, act, (60, 12))


def test_a_pan_stays_when_the_graph_changes() -> None:
    async def act(window: _Window) -> None:
        await window.press(*["plus"] * 12)
        await window.press("right", "right")
        before = window.pane._view.part
        more = GraphContent({**ROBOTS.publishers, "/late": ("/r9",)}, {**ROBOTS.subscribers, "/late": ("/r3/part_0",)})
        window.model._show(more, window.model.options)
        await step(window.app, window.pilot)
        assert window.pane._view.part == before

    use(ROBOTS, act)


@pytest.mark.parametrize(
    ("key", "title"),
    [("w", "Save the graph"), ("ctrl+s", "Save the graph"), ("o", "Open a DOT"), ("ctrl+o", "Open a DOT")],
)
def test_the_keys_that_save_and_open_are_those_of_the_other_windows(key: str, title: str) -> None:
    async def act(window: _Window) -> None:
        await window.press(key)
        assert title in window.text

    use(LESSON, act)


def test_boxes_keep_their_frames_and_names_where_there_is_room_though_none_for_the_names_of_topics() -> None:
    names = ["/talker_of_the_robot", "/listener", "/simulator", "/broadcaster1", "/broadcaster2"]
    talker, listener, simulator, *broadcasters = names
    facts = GraphContent(
        {
            "/chatter": (talker,),
            "/tf": tuple(broadcasters),
            "/turtle2/cmd_vel": (listener,),
            **{f"/turtle{n}/pose": (simulator,) for n in (1, 2)},
        },
        {
            "/chatter": (listener,),
            "/tf": (listener,),
            "/turtle2/cmd_vel": (simulator,),
            **{f"/turtle{n + 1}/pose": (each,) for n, each in enumerate(broadcasters)},
        },
    )

    async def act(window: _Window) -> None:
        assert all(f"│ {name} │" in window.text for name in names)

    async def with_topics(window: _Window) -> None:
        assert "/chatter" in window.text and "/tf" in window.text

    use(facts, act, (100, 30))
    use(facts, with_topics, (120, 40))


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_what_is_hidden_is_named_where_that_fits_and_else_counted(size: tuple[int, int], lang: str) -> None:
    few = {"/a": ("/one",)}
    many = {f"/topic_with_a_long_name_{number}": ("/one",) for number in range(9)}

    async def all_named(window: _Window) -> None:
        assert "Dead sinks" in screen_lines(window.app)[-2] and "/a " in screen_lines(window.app)[-2]

    async def counted(window: _Window) -> None:
        told = screen_lines(window.app)[-2]
        assert "Dead sinks 9" in told and "…" not in told

    use(GraphContent(few, {}), all_named, size, lang=lang)
    use(GraphContent(many, {}), counted, size, lang=lang)
