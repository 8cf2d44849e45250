"""The console's window on a desktop whose frames the test draws."""

from __future__ import annotations

import asyncio
import re
from types import SimpleNamespace

import pytest
from textual import events

from day6_core.ros.programs.rqt_console import model
from day6_core.ros.programs.rqt_console.model import Console
from day6_tui.windows.console import table as console_table
from tests.tui.fakes import FakeDesk
from tests.tui.screens import look_at, opened, screen_lines, screen_text, step, step_until


def log(text, level, node):
    stamp = SimpleNamespace(sec=5, nanosec=0)
    return SimpleNamespace(stamp=stamp, level=level, name=node, msg=text, file="talker.py", function="tick", line=7)


WALL = "Oh no! I hit the wall! (Clamping from [x=11.120889, y=5.544445])"


def look(console, keys=(), **options):
    return look_at(("rqt_console", "Console", console), "RqtConsolePane", keys, **options)


@pytest.fixture
def console():
    made = Console()
    made.receive(log("Starting turtlesim", 20, "turtlesim"))
    made.receive(log(WALL, 30, "turtlesim"))
    made.receive(log("details", 10, "talker"))
    return made


def test_the_table_has_the_columns_of_the_real_window_and_the_message_in_full(console):
    text = look(console, ["up"])
    for word in ("#", "Message", "Severity", "Node", "Stamp", "Warn", "turtlesim", "Exclude", "3 messages"):
        assert word in text
    assert WALL in text


def test_a_larger_window_shows_the_location_too(console):
    assert "talker.py:tick:7" in look(console, width=120, height=40)


def test_letters_leave_severities_out(console):
    text = look(console, ["W", "D"])
    assert "hit the wall" not in text and "details" not in text and "Starting turtlesim" in text
    assert "[x] Warn" in text and "1 of 3 messages" in text
    console.show_everything()
    assert "hit the wall" in look(console)


def test_text_is_typed_into_a_prompt(console):
    text = look(console, ["slash", *"wa", "enter"])
    assert console.choice.first("excludes", "message").text == "wa" and WALL not in text
    look(console, ["h", *"st", "enter"])
    assert console.choice.first("highlights", "message").text == "st"


def test_pause_and_clear(console):
    assert "paused" in look(console, ["p"])
    assert "No log messages yet" in look(console, ["c"])


@pytest.mark.parametrize(("size", "seen"), [((40, 10), 20), ((60, 12), 28), ((120, 40), 35)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_at_every_size_the_message_has_room_and_every_severity_its_box(console, size, seen, lang):
    lines = look(console, ["f8"], width=size[0], height=size[1], lang=lang).splitlines()
    assert any(f" {WALL[:seen]}" in line for line in lines)
    boxes = next(line for line in lines if "[ ]" in line)
    assert [word[0] for word in boxes.replace("[ ] ", "[ ]").split("[ ]")[1:]] == list("DIWEF")


@pytest.mark.parametrize("size", [(40, 10), (80, 24)])
def test_a_click_on_a_severitys_box_leaves_it_out_and_one_on_a_message_chooses_it(console, size):
    async def click() -> None:
        desk = FakeDesk()
        desk.display.open("rqt_console", "Console", console)
        async with opened(desk, *size, scene="empty", lang="en") as (app, pilot):
            await step(app, pilot)
            pane = next(iter(app.query("RqtConsolePane")))
            pane.focus()
            await pilot.press("f8")
            await step(app, pilot)
            lines = screen_lines(app)
            row = next(y for y, line in enumerate(lines) if "Exclude" in line)
            await pilot.click(offset=(lines[row].index("W"), row))
            await step(app, pilot)
            assert console.choice.first("excludes", "severity").levels == {30} and WALL not in screen_text(app)
            await pilot.click(offset=(3, row - 1))
            await step(app, pilot)
            assert pane.table.chosen is None
            await pilot.click(offset=(12, next(y for y, line in enumerate(lines) if "#1" in line)))
            await step(app, pilot)
            assert pane.table.chosen.number == 1

    asyncio.run(click())


@pytest.mark.parametrize(
    ("size", "language", "glyphs"),
    (((40, 12), "en", "half"), ((80, 24), "zh", "ascii"), ((120, 40), "zh", "half"), ((10, 4), "en", "ascii")),
)
def test_every_size_language_and_glyph_set_is_drawn(console, language, size, glyphs):
    console.receive(log("海龟撞墙了 " * 40, 50, "a_node_with_a_very_long_name_indeed"))
    text = look(console, ["up", "end"], width=size[0], height=size[1], lang=language, glyphs=glyphs)
    assert "Error" not in text.replace("Error(", "").replace("] Error", "")


def test_an_empty_console_says_where_messages_come_from():
    assert "/rosout" in look(Console())


def numbers(text):
    """The numbers of the messages in the table, from the top."""
    return [int(found[1]) for line in text.splitlines() if (found := re.match(r"┃[ ▸] +#(\d+) ", line))]


def in_the_window(console, drive, size=(80, 24), **options):
    """Open the window, enlarged, and let `drive(app, pilot, pane)` use it."""

    async def run() -> None:
        desk = FakeDesk()
        desk.display.open("rqt_console", "Console", console)
        async with opened(desk, *size, scene="empty", lang="en", **options) as (app, pilot):
            await step(app, pilot)
            pane = next(iter(app.query("RqtConsolePane")))
            pane.focus()
            await pilot.press("f8")
            await step(app, pilot)
            await drive(app, pilot, pane)

    asyncio.run(run())


@pytest.fixture
def full():
    made = Console()
    for number in range(1, 61):
        made.receive(log(f"hello {number * 37 % 61:02d}", (20, 10, 40)[number % 3], ("talker", "listener")[number % 2]))
    return made


def test_a_click_on_a_columns_name_sorts_by_it_and_a_second_one_the_other_way_round(full):
    async def drive(app, pilot, pane) -> None:
        assert numbers(screen_text(app))[-1] == 60
        for word, shown in (
            ("Message", sorted(range(1, 61), key=lambda number: number * 37 % 61)),
            ("Message", sorted(range(1, 61), key=lambda number: -(number * 37 % 61))),
            ("Severity", [number for number in range(60, 0, -1) if number % 3 == 2]),  # the worst and newest first
            ("Node", [number for number in range(1, 61) if number % 2]),
            ("#", list(range(60 - 12, 61))),
        ):
            lines = screen_lines(app)
            row = next(y for y, line in enumerate(lines) if "Message" in line and "Severity" in line)
            await pilot.click(offset=(lines[row].index(word), row))
            await step(app, pilot)
            assert numbers(screen_text(app))[:12] == shown[:12]

    in_the_window(full, drive)


def test_keys_sort_by_the_next_column_and_the_other_way_round(full):
    text = look(full, ["f8", "S"])
    assert numbers(text)[:3] == [60, 59, 58] and "▼#" in text
    text = look(full, ["f8", "s"])
    assert numbers(text)[0] == 33 and "Message ▲" in text  # 33 * 37 % 61 == 1


def test_the_newest_is_followed_until_another_message_is_chosen_or_scrolled_to(full):
    async def drive(app, pilot, pane) -> None:
        full.receive(log("sixty-one", 20, "talker"))
        await step(app, pilot)
        assert numbers(screen_text(app))[-1] == 61
        for leave in (pilot.press("up"), pilot._post_mouse_events([events.MouseScrollUp], pane.table, (5, 5))):
            await leave
            await step(app, pilot)
            before = numbers(screen_text(app))
            full.receive(log("one more", 20, "talker"))
            await step(app, pilot)
            assert numbers(screen_text(app)) == before
            await pilot.press("escape")
            await step(app, pilot)
            assert numbers(screen_text(app))[-1] == full.total

    in_the_window(full, drive)


def test_what_is_in_sight_stays_there_while_the_oldest_go(full, monkeypatch):
    monkeypatch.setattr(model, "MOST", 60)

    async def drive(app, pilot, pane) -> None:
        await pilot.press("home", *["down"] * 30)
        await step(app, pilot)
        before = numbers(screen_text(app))
        for _ in range(10):
            full.receive(log("one more", 20, "talker"))
        await step(app, pilot)
        assert numbers(screen_text(app)) == before and pane.table.chosen.number == 31
        await pilot.press("home")
        await step(app, pilot)
        assert numbers(screen_text(app))[0] == 11

    in_the_window(full, drive)


def test_a_text_is_in_force_while_it_is_typed_and_escape_takes_it_back(full):
    async def drive(app, pilot, pane) -> None:
        for keys, text in ((["slash", "0"], "0"), (["1"], "01"), (["escape"], ""), (["slash", "7", "enter"], "7")):
            await pilot.press(*keys)
            await step(app, pilot)
            assert full.choice.first("excludes", "message").text == text
        await pilot.press("D")
        assert full.choice.first("excludes", "severity").levels == {10} and 'also: "7"' in screen_text(app)

    in_the_window(full, drive, size=(120, 40))


def test_keys_that_are_quicker_than_the_line_are_typed_into_it(full):
    async def drive(app, pilot, pane) -> None:
        for key in ("slash", "d", "e", "w", "enter", "n"):
            app.post_message(events.Key(key, "/" if key == "slash" else key if len(key) == 1 else None))
        await step(app, pilot)
        choice = full.choice
        assert choice.first("excludes", "message").text == "dew" and not choice.first("excludes", "severity").levels
        assert choice.first("excludes", "node").nodes == {"talker"}

    in_the_window(full, drive)


def test_enter_and_a_double_click_show_a_message_in_full(console):
    console.receive(log("Traceback:\n" + "\n".join(f"  frame {n}" for n in range(12)) + "\nValueError", 40, "talker"))
    text = look(console, ["enter"])
    assert "frame 11" in text and "ValueError" in text and "Location: talker.py:tick:7" in text

    async def drive(app, pilot, pane) -> None:
        row = next(y for y, line in enumerate(screen_lines(app)) if "#4" in line)
        await pilot.click(offset=(20, row), times=2)
        await step(app, pilot)
        assert "ValueError" in screen_text(app)
        await pilot.press("escape", "up")
        await step(app, pilot)
        assert pane.table.chosen.number == 3

    in_the_window(console, drive)


def test_what_programs_write_is_text_and_nothing_else(console):
    console.receive(log("[bold red]\x1b[2J\x07 \u202eabc[/]", 30, "[node]\x1b]0;x\x07"))
    for keys in ([], ["enter"], ["n"], ["f"], ["n", "f", *"exclude messages from", "enter"]):
        text = look(console, keys)
        assert "[bold red]^[[2J^G" in text or ("[node]^[]0;x^G" in text and "\x1b" not in text and "\u202e" not in text)


def test_a_click_beside_the_table_leaves_it_the_keyboard(full):
    async def drive(app, pilot, pane) -> None:
        row = next(y for y, line in enumerate(screen_lines(app)) if "Exclude" in line)
        await pilot.click(offset=(5, row - 2))
        await pilot.press("up")
        await step(app, pilot)
        assert pane.table.chosen.number == 59

    in_the_window(full, drive)


def test_behind_an_open_message_the_whole_frame_is_one_without_the_keyboard(full):
    async def drive(app, pilot, pane) -> None:
        assert {line[0] for line in screen_lines(app)[2:-2]} == {"┃"}
        await pilot.press("up", "enter")
        await step(app, pilot)
        assert {line[0] for line in screen_lines(app)[2:-2]} == {"│"}
        await pilot.press("escape")
        await step(app, pilot)
        assert {line[0] for line in screen_lines(app)[2:-2]} == {"┃"}

    in_the_window(full, drive, size=(120, 40))


def test_the_scroll_bar_can_be_dragged_and_a_click_beside_its_thumb_turns_the_page(full):
    async def drive(app, pilot, pane) -> None:
        lines = screen_lines(app)
        top = next(y for y, line in enumerate(lines) if "Severity" in line)
        x = len(lines[top]) - 2
        await pilot.click(offset=(x, top))
        await step(app, pilot)
        assert numbers(screen_text(app))[0] > 1 and numbers(screen_text(app))[-1] < 60
        # The thumb has moved with the page; its last cell can be drawn to the top from wherever it is.
        cells = range(top, top + pane.table.size.height - 1)
        thumb = [y for y in cells if app.screen.get_style_at(x, y).meta.get("@mouse.down") == "grab"]
        await pilot.mouse_down(offset=(x, thumb[-1]))
        await pilot._post_mouse_events([events.MouseMove], pane.table.vertical_scrollbar, (0, 0), button=1)
        await step(app, pilot)
        assert numbers(screen_text(app))[0] == 1
        await pilot.mouse_up(offset=(x, top))
        full.receive(log("one more", 20, "talker"))
        await step(app, pilot)
        assert numbers(screen_text(app))[0] == 1

    in_the_window(full, drive)


def test_in_a_window_of_another_size_the_newest_is_still_followed_or_what_was_chosen_is_in_sight(full):
    async def drive(app, pilot, pane) -> None:
        for size in ((80, 14), (80, 30), (80, 24)):
            await pilot.resize_terminal(*size)
            await step(app, pilot)
            assert numbers(screen_text(app))[-1] == 60
        await pilot.press(*["up"] * 12)
        for size in ((80, 14), (80, 30), (80, 24)):
            await pilot.resize_terminal(*size)
            await step(app, pilot)
            assert 48 in numbers(screen_text(app)) and pane.table.chosen.number == 48
        await pilot.press("end", *["pageup"] * 2, "escape")
        await pilot._post_mouse_events([events.MouseScrollUp], pane.table, (5, 5))
        await step(app, pilot)
        before = numbers(screen_text(app))[0]
        await pilot.resize_terminal(80, 14)
        await step(app, pilot)
        assert numbers(screen_text(app))[0] == before

    in_the_window(full, drive)


@pytest.mark.parametrize("keys", [[], ["enter"], ["s", "s"]])
def test_a_megabyte_and_a_stamp_that_no_calendar_has_are_shown(console, keys, monkeypatch):
    console.receive(log("x " * 500_000, 40, "talker"))

    def localtime(seconds):
        raise OSError(seconds)

    monkeypatch.setattr(console_table.time, "localtime", localtime)
    text = look(console, keys)
    assert "x x x x x" in text and "5.000" in text


def test_tab_makes_a_regular_expression_of_what_is_typed_and_escape_takes_both_back(full):
    async def drive(app, pilot, pane) -> None:
        await pilot.press("slash", *"^hello.[01]", "tab")
        await step(app, pilot)
        assert full.choice.first(
            "excludes", "message"
        ).is_regex and "Exclude messages containing (Regex):" in screen_text(app)
        assert {record.text[6] for record in full.shown()} == set("23456")
        await pilot.press("escape", "slash", *"(", "tab")
        await step(app, pilot)
        assert len(full.shown()) == 60 and "missing ), unterminated subpattern" in screen_text(app)

    in_the_window(full, drive, size=(120, 40))


def test_the_list_of_filters_adds_changes_and_removes_them(full):
    async def drive(app, pilot, pane) -> None:
        await pilot.press("f")
        await step(app, pilot)
        assert "[x] Exclude messages with severities" in screen_text(app)
        await pilot.press(*"exclude messages …", "enter", *"node", "enter")
        await step(app, pilot)
        await pilot.press(*"listener", "enter", "escape")  # the menu comes back after each change
        assert full.choice.first("excludes", "node").nodes == {"listener"} and len(full.shown()) == 30
        await pilot.press("f", *"exclude messages from nodes", "delete", "escape")
        await step(app, pilot)
        assert len(full.shown()) == 60
        await pilot.press("f", *"highlight messages …", "enter", *"location", "enter", *"talker.py", "enter")
        await step(app, pilot)
        assert [each.kind for each in full.choice.highlights] == ["message", "location"]

    in_the_window(full, drive)


def test_a_time_range_begins_at_the_chosen_message_and_takes_times_of_day(console):
    async def drive(app, pilot, pane) -> None:
        await pilot.press("f", *"highlight messages …", "enter", *"time", "enter")
        await step(app, pilot)
        await pilot.press(*"until", "enter")
        await step(app, pilot)
        for text, good in (("noon", False), ("25:00", False), ("1970-01-01 23:00", True)):
            await pilot.press(*["backspace"] * 8, *text, "enter")
            await step(app, pilot)
            assert ("Not a time" in screen_text(app)) is not good
        (each,) = (each for each in console.choice.highlights if each.kind == "time")
        assert each.start_ns == 5_000_000_000 and each.stop_ns is not None

    in_the_window(console, drive)


def test_what_is_shown_is_saved_and_comes_back(console, tmp_path):
    console._path_of = tmp_path.joinpath
    assert "saved:" in look(console, ["W", "w", "enter"], width=120)
    lines = (tmp_path / "rqt_console.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "message;severity;node;stamp;location" and len(lines) == 3
    assert "exists" in look(console, ["w", "enter"])  # nothing is overwritten without being asked


def test_what_takes_long_to_filter_comes_into_sight_piece_by_piece(full, monkeypatch):
    monkeypatch.setattr(model, "SLICE_SECONDS", -1.0)
    monkeypatch.setattr(model, "SLICE", 20)

    async def drive(app, pilot, pane) -> None:
        await step_until(app, pilot, lambda: numbers(screen_text(app))[-1] == 60)
        await pilot.press("I")
        await step_until(app, pilot, lambda: "40 of 60 messages" in screen_text(app))

    in_the_window(full, drive)
