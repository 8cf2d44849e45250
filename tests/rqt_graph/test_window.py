"""rqt_graph's window as a person uses it: panning, zooming, Fit, namespace boxes, what lies outside."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest
from rich.cells import cell_len
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
    model = RqtGraph(None, Graph(0), Path("/nowhere").joinpath)  # type: ignore[arg-type]
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


ROBOT = GraphContent(
    {
        "/joint_states": ("/joint_state_publisher",),
        "/tf": ("/robot_state_publisher", "/odometry"),
        "/scan": ("/lidar",),
        "/cmd_vel": ("/navigator",),
        "/odom": ("/odometry",),
        "/map": ("/mapper",),
    },
    {
        "/joint_states": ("/robot_state_publisher",),
        "/tf": ("/mapper", "/navigator"),
        "/scan": ("/mapper", "/navigator"),
        "/cmd_vel": ("/base_driver",),
        "/odom": ("/navigator",),
        "/map": ("/navigator",),
    },
)
"""Seven nodes, and topics that several of them share."""

TURTLES = GraphContent(
    {"/turtle1/cmd_vel": ("/teleop_turtle",), "/turtle1/pose": ("/turtlesim",)},
    {"/turtle1/cmd_vel": ("/turtlesim",), "/turtle1/pose": ("/follower",)},
)


@pytest.mark.parametrize(
    ("facts", "size"),
    [(TURTLES, (40, 24)), (TURTLES, (40, 15)), (TURTLES, (80, 10)), (ROBOT, (80, 24)), (ROBOT, (120, 40))],
)
@pytest.mark.parametrize("glyphs", ["half", "cell", "ascii"])
def test_in_a_small_window_every_topic_has_its_name_and_its_direction(
    facts: GraphContent, size: tuple[int, int], glyphs: str
) -> None:
    async def act(window: _Window) -> None:
        assert all(node in window.text for node in facts.nodes), window.text
        arrows = window.pane._glyphs.right + window.pane._glyphs.left
        for route in window.pane._picture.routes:
            y = route.label_at[1]
            row = "".join(text for text, _ in window.pane._rows[y - window.pane._view.y])
            assert route.edge.key in row and any(arrow in row for arrow in arrows), row

    use(facts, act, size, glyphs=glyphs)


def test_an_end_of_a_line_is_the_node_wherever_its_name_stands() -> None:
    async def act(window: _Window) -> None:
        lines = screen_lines(window.app)
        y = next(y for y, line in enumerate(lines) if "/scan" in line and "/navigator" in line)
        await window.pilot.click(offset=(lines[y].index("/navigator") + 1, y))
        await step(window.app, window.pilot)
        assert "/navigator: 5 arrows in, 1 out" in window.text
        seen = set()
        for _ in range(7):
            await window.press("j")
            seen.add(window.pane._chosen)
        assert seen == set(ROBOT.nodes)

    use(ROBOT, act)


def test_where_the_controls_have_no_room_the_key_that_shows_what_is_hidden_is_told() -> None:
    facts = GraphContent({**TURTLES.publishers, "/turtle1/color_sensor": ("/turtlesim",)}, TURTLES.subscribers)

    async def small(window: _Window) -> None:
        assert "[x]" not in window.text and "s shows what is hidden (1)" in window.text
        await window.press("s")
        assert "l shows what is hidden (1)" in window.text
        await window.press("l")
        assert "nothing is hidden" in window.text

    async def in_chinese(window: _Window) -> None:
        assert "按 s 显示" in window.text

    async def tall(window: _Window) -> None:
        assert "[x] Dead sinks" in window.text and "shows what" not in window.text

    use(facts, small, (80, 14))
    use(facts, small, (40, 24))
    use(facts, in_chinese, (80, 14), lang="zh")
    use(facts, tall, (80, 24))


@pytest.mark.long
@pytest.mark.parametrize("size", [(20, 9), (40, 12), (80, 24), (120, 40)])
@pytest.mark.parametrize("glyphs", ["half", "ascii"])
def test_fifty_nodes_with_names_of_any_length_are_drawn(size: tuple[int, int], glyphs: str) -> None:
    names = [(f"/n{n}_{'x' * 200}", f"/节点_{n}_很长的名字", f"/n{n}")[n % 3] for n in range(50)]
    facts = GraphContent(
        {f"/话题/{n}/{'t' * (n % 3) * 90}": (names[n % 50],) for n in range(100)},
        {f"/话题/{n}/{'t' * (n % 3) * 90}": (names[(n * 7 + 3) % 50],) for n in range(100)},
    )

    async def act(window: _Window) -> None:
        for key in ("down", "plus", "minus", "v", "t", "t", "t", "j", "k", "s", "n"):
            await window.press(key)
            assert all(cell_len(line) <= size[0] for line in screen_lines(window.app)), window.text
        assert type(window.pane).__name__ == "RqtGraphPane" and not window.pane._failed

    use(facts, act, size, glyphs=glyphs)


def test_messages_run_along_the_lines_and_leave_every_letter() -> None:
    async def act(window: _Window) -> None:
        counts = {"/turtle1/cmd_vel": 0, "/turtle1/pose": 0}
        window.model.activity = lambda: dict(counts)
        seen, now = set(), 1e9  # later than any frame that was drawn so far
        for beat in range(40):
            counts.update(dict.fromkeys(counts, beat))
            now += 0.1
            window.pane.pull(now)
            await window.pilot.pause()
            rows = screen_lines(window.app)
            seen |= {(y, x) for y, row in enumerate(rows) for x, char in enumerate(row) if char == "●"}
            assert all(name in window.text for name in (*counts, *TURTLES.nodes)), window.text
        assert len({y for y, _ in seen}) >= 2 and len(seen) > 6

    use(TURTLES, act, (40, 24))


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
