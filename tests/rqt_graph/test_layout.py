"""The picture: nothing overlaps, every arrow ends at its box, and thirty nodes stay readable."""

from __future__ import annotations

import random
from itertools import pairwise
from typing import Any

import pytest

from day6_core.elide import elide
from day6_core.ros.programs.rqt_graph.model import fit
from day6_core.ros.programs.rqt_graph.model.drawing import (
    ASCII,
    CONSOLE,
    UNICODE,
    Glyphs,
    draw,
    draw_pulse,
    measure,
)
from day6_core.ros.programs.rqt_graph.model.fit import fitted, overview
from day6_core.ros.programs.rqt_graph.model.layout import layout
from day6_core.ros.programs.rqt_graph.model.shapes import Box, Edge, LaidOutGraph, Rect

FEEDBACK = "/turtle1/rotate_absolute/_action/feedback"
LESSON = (
    [Box("/teleop_turtle", ("/teleop_turtle",), "node"), Box("/turtlesim", ("/turtlesim",), "node")],
    [Edge("/teleop_turtle", "/turtlesim", "/turtle1/cmd_vel", "/turtle1/cmd_vel")],
)
BACK = Edge("/turtlesim", "/teleop_turtle", FEEDBACK, FEEDBACK, 0.1)


def text(picture: LaidOutGraph, glyphs: object = UNICODE) -> list[str]:
    assert glyphs in (UNICODE, ASCII)
    canvas = draw(picture, UNICODE if glyphs is UNICODE else ASCII)
    return ["".join(run for run, _ in row).rstrip() for row in canvas.rows()]


def test_the_picture_of_the_lesson() -> None:
    assert text(layout(*LESSON, measure)) == [
        "╭────────────────╮                        ╭────────────╮",
        "│ /teleop_turtle │────/turtle1/cmd_vel───▶│ /turtlesim │",
        "╰────────────────╯                        ╰────────────╯",
    ]


def test_the_same_picture_where_only_ascii_can_be_shown() -> None:
    lines = text(layout(*LESSON, measure), ASCII)
    assert lines[1] == "( /teleop_turtle )----/turtle1/cmd_vel--->( /turtlesim )"
    assert all(line.isascii() for line in lines)


@pytest.mark.parametrize("glyphs", [ASCII, CONSOLE], ids=["ascii", "console"])
def test_without_round_corners_an_ellipse_is_made_of_slashes_that_meet_its_sides(glyphs: Glyphs) -> None:
    across = glyphs.across
    for height, sides in ((3, "()"), (4, "/\\ \\/"), (6, "/\\ || || \\/")):
        box = Box("/n", ("/n",), "node")
        picture = LaidOutGraph(6, height, {"/n": (box, Rect(0, 0, 6, height))}, ())
        rows = ["".join(run for run, _ in row) for row in draw(picture, glyphs).rows()]
        assert rows[0] == f" /{across * 2}\\ " and rows[-1] == f" \\{across * 2}/ "
        assert [row[0] + row[-1] for row in rows[1:-1]] == sides.split()


def test_feedback_flows_back_without_turning_the_picture_round() -> None:
    boxes, edges = LESSON
    picture = layout(boxes, [*edges, BACK], measure)
    lines = text(picture)
    teleop, turtlesim = (picture.boxes[name][1] for name in ("/teleop_turtle", "/turtlesim"))
    assert teleop.x < turtlesim.x
    back = next(route for route in picture.routes if route.edge is BACK)
    assert back.cells[0][0] > back.cells[-1][0]
    assert "◀" in "".join(lines)


def touches(rect: Rect, x: int, y: int) -> bool:
    return rect.y <= y < rect.y + rect.height and x in (rect.x - 1, rect.x + rect.width)


def inside(rect: Rect, x: int, y: int) -> bool:
    return rect.x <= x < rect.x + rect.width and rect.y <= y < rect.y + rect.height


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("roomy", [True, False])
def test_in_any_graph_boxes_stay_apart_and_edges_join_their_boxes(seed: int, roomy: bool) -> None:
    pick = random.Random(seed)
    boxes = [Box(f"n{i}", (f"/node_{i}",), "node") for i in range(15)]
    boxes += [Box(f"t{i}", (f"/小车/topic_{i}",), "topic") for i in range(15)]
    edges = []
    for i in range(15):
        edges.append(Edge(f"n{pick.randrange(15)}", f"t{i}", "", f"t{i}"))
        edges += [Edge(f"t{i}", f"n{pick.randrange(15)}", "", f"t{i}") for _ in range(pick.randrange(1, 3))]
    edges = list(dict.fromkeys(edges))
    picture = layout(boxes, edges, measure, roomy=roomy)
    rects = [rect for _, rect in picture.boxes.values()]
    cells = [(x, y) for r in rects for x in range(r.x, r.x + r.width) for y in range(r.y, r.y + r.height)]
    assert len(cells) == len(set(cells)), "boxes overlap"
    for route in picture.routes:
        start, end = picture.boxes[route.edge.start][1], picture.boxes[route.edge.end][1]
        assert touches(start, *route.cells[0]), route.edge
        assert touches(end, *route.cells[-1]), route.edge
        steps = zip(route.cells, route.cells[1:], strict=False)
        assert all(abs(a[0] - b[0]) + abs(a[1] - b[1]) <= 1 for a, b in steps), "a gap in the line"
        for x, y in route.cells:
            assert 0 <= x < picture.width and 0 <= y < picture.height
            assert not any(inside(rect, x, y) for rect in rects), "a line runs through a box"


def test_a_window_too_narrow_gets_shorter_labels() -> None:
    boxes, edges = LESSON
    wide = fitted(boxes, [*edges, BACK], 100, 20)
    narrow = fitted(boxes, [*edges, BACK], 70, 20)
    assert wide.width > 70 >= narrow.width
    assert any(route.edge.label == "/turtle1/…/feedback" for route in narrow.routes)


def test_where_a_picture_has_no_room_every_edge_is_a_line_with_its_topic_from_start_to_end() -> None:
    boxes, edges = LESSON
    assert text(fitted(boxes, edges, 52, 3)) == ["/teleop_turtle ───/turtle1/cmd_vel──▶ /turtlesim"]
    more = [*edges, BACK, Edge("/turtlesim", "/follower", "/turtle1/pose", "/turtle1/pose")]
    boxes = [*boxes, Box("/follower", ("/follower",), "node"), Box("/alone", ("/alone",), "node")]
    assert text(fitted(boxes, more, 70, 4)) == [
        "/teleop_turtle ───/turtle1/cmd_vel─────▶ /turtlesim",
        "/turtlesim ─────┬─/turtle1/…/feedback──▶ /teleop_turtle",
        "                └─/turtle1/pose────────▶ /follower",
        "/alone",
    ]
    assert text(fitted(boxes, more, 42, 9)) == [
        "/teleop_turtle",
        " └─/turtle1/cmd_vel─────▶ /turtlesim",
        "/turtlesim",
        " ├─/turtle1/…/feedback──▶ /teleop_turtle",
        " └─/turtle1/pose────────▶ /follower",
        "/alone",
    ]
    assert "".join(text(fitted(boxes, more, 42, 9, ellipsis="~"), ASCII)).isascii()


def test_lines_that_are_too_many_for_the_window_go_on_below_it_and_keep_their_names() -> None:
    boxes = [Box(f"/n{number}", (f"/node_{number}",), "node") for number in range(20)]
    edges = [
        Edge(f"/n{a}", f"/n{b}", f"/from_{a}_to_{b}", f"t{a}{b}") for a in range(20) for b in (a + 1, a + 7) if b < 20
    ]
    picture = fitted(boxes, edges, 42, 12)
    assert picture.width <= 42 and picture.height > 12
    assert all(route.edge.label in "\n".join(text(picture)) for route in picture.routes)


def test_of_very_many_edges_only_pictures_are_laid_out_that_may_fit(monkeypatch: pytest.MonkeyPatch) -> None:
    laid_out: list[bool] = []

    def counted(*given: Any, roomy: bool = True) -> LaidOutGraph:
        laid_out.append(roomy)
        return layout(*given, roomy=roomy)

    monkeypatch.setattr(fit, "layout", counted)
    boxes = [Box(name, (name,), "node") for name in ("/talker", "/listener")]
    edges = [Edge("/talker", "/listener", f"/topic_{number}", f"{number}") for number in range(1000)]
    assert len(fitted(boxes, edges, 120, 40).routes) == 1000
    assert laid_out == [False], "the smallest one, in which names of topics have no room"


def test_an_overview_takes_its_room_from_the_edges_and_keeps_boxes_names_and_arrows() -> None:
    names = [f"/r1/part_{number}" for number in range(4)]
    boxes = [Box(name, (name,), "node", "/r1") for name in names]
    edges = [Edge(*ends, "/a_topic", "t") for ends in pairwise(names)]
    picture = layout(boxes, edges, measure)
    small = overview(picture, 76, 9)
    assert picture.width > 76 >= small.width
    assert text(small)[2].count("│ /r1/part_") == 4 and text(small)[2].count("─▶│") == 3
    least = overview(layout(boxes, edges, measure, roomy=False), 40, 3)
    assert text(least)[0].startswith("┌ /r1 ─") and text(least)[1].count("▶") == 3
    assert all(f"part_{number}" in text(least)[1] for number in range(4))


def test_long_names_of_topics_drawn_as_boxes_are_shortened_before_the_boxes_become_lines() -> None:
    boxes = [Box("/teleop_turtle", ("/teleop_turtle",), "node"), Box(" t", (FEEDBACK,), "topic")]
    picture = fitted(boxes, [Edge(" t", "/teleop_turtle", "", "t")], 60, 20)
    assert picture.boxes[" t"][0].lines == ("/turtle1/…/feedback",) and picture.boxes[" t"][1].height == 3


@pytest.mark.parametrize(
    ("longest", "short"),
    [
        (50, FEEDBACK),
        (28, "/turtle1/…/_action/feedback"),
        (20, "/turtle1/…/feedback"),
        (18, "/turtle1…/feedback"),
        (16, "/turtl…/feedback"),
        (10, "…/feedback"),
        (6, "/tu…ck"),
        (1, "…"),
    ],
)
def test_a_label_keeps_its_first_and_last_parts(longest: int, short: str) -> None:
    assert elide(FEEDBACK, longest, "…") == short


def test_names_that_differ_at_one_end_differ_when_they_are_short() -> None:
    names = ["/joint_state_publisher", "/robot_state_publisher", "/robot_state_listener", "/机器人的关节状态发布节点"]
    short = [elide(name, 16, "…") for name in names]
    assert len(set(short)) == 4 and all(measure(each) <= 16 for each in short)


def test_a_pulse_runs_from_start_to_end() -> None:
    picture = layout(*LESSON, measure)
    (route,) = picture.routes
    places = []
    for progress in (0.0, 0.5, 0.999):
        canvas = draw(picture, UNICODE)
        draw_pulse(canvas, route, progress, UNICODE)
        row = canvas.text[1]
        places.append(row.index("●"))
    assert places == sorted(set(places))


def test_a_pulse_never_stands_on_a_letter() -> None:
    boxes, edges = LESSON
    for picture in (fitted(boxes, [*edges, BACK], 100, 20), fitted(boxes, [*edges, BACK], 42, 9)):
        plain = text(picture)
        for route in picture.routes:
            for step in range(100):
                canvas = draw(picture, UNICODE)
                draw_pulse(canvas, route, step / 100, UNICODE)
                shown = ["".join(run for run, _ in row).rstrip() for row in canvas.rows()]
                for before, after in zip(plain, shown, strict=True):
                    changed = [old for old, new in zip(before, after, strict=True) if old != new]
                    assert all(old in UNICODE.drawn for old in changed), (before, after)


def test_an_empty_graph_is_an_empty_picture() -> None:
    picture = layout([], [], measure)
    assert (picture.width, picture.height) == (0, 0)
    assert fitted([], [], 10, 10).width == 0


def clustered(names: list[tuple[str, str]], edges: list[tuple[int, int]]) -> LaidOutGraph:
    boxes = [Box(name, (name,), "node", cluster) for name, cluster in names]
    return layout(boxes, [Edge(boxes[a].key, boxes[b].key, "", f"/t{a}{b}") for a, b in edges], measure)


def holds(rect: Rect, frame: Rect) -> bool:
    return (
        frame.x < rect.x
        and rect.x + rect.width < frame.x + frame.width
        and frame.y < rect.y
        and rect.y + rect.height < frame.y + frame.height
    )


def apart(rect: Rect, frame: Rect) -> bool:
    return (
        rect.x + rect.width <= frame.x
        or frame.x + frame.width <= rect.x
        or rect.y + rect.height <= frame.y
        or frame.y + frame.height <= rect.y
    )


def test_namespace_boxes_hold_their_members_and_nobody_else() -> None:
    names = [(f"/{space}/n{number}", f"/{space}".rstrip("/")) for space in ("a", "a/b", "c") for number in range(4)] + [
        (f"/n{number}", "") for number in range(4)
    ]
    random.seed(6)
    for _ in range(20):
        edges = [tuple(random.sample(range(len(names)), 2)) for _ in range(18)]
        picture = clustered(names, edges)  # type: ignore[arg-type]
        for frame_name, frame in picture.clusters:
            for box, rect in picture.boxes.values():
                if box.cluster == frame_name or box.cluster.startswith(frame_name + "/"):
                    assert holds(rect, frame), (frame_name, box.key)
                else:
                    assert apart(rect, frame), (frame_name, box.key)


def test_two_robots_get_a_frame_each() -> None:
    names = [(f"/{robot}/{node}", f"/{robot}") for robot in ("r1", "r2") for node in ("lidar", "slam", "nav")]
    picture = clustered([*names, ("/fleet", "")], [(0, 1), (1, 2), (3, 4), (4, 5), (2, 6), (5, 6)])
    assert [name for name, _ in picture.clusters] == ["/r1", "/r2"]
    text = "\n".join("".join(part for part, _ in row) for row in draw(picture, ASCII).rows())
    assert "+ /r1 -" in text and "+ /r2 -" in text
