"""Terminals: keys go in as a real terminal sends them, what changed comes out and nothing else."""

from __future__ import annotations

from typing import Any

import pytest
from rich.cells import cell_len
from textual import events

from day6_tui.appearance.colours import colours
from day6_tui.terminals.keys import _PLAIN, decode, encode
from day6_tui.terminals.view import TerminalView, tab_name
from tests.support.folded import folded
from tests.tui.fakes import FakeDesk, FakeTerminal
from tests.tui.screens import opened, screen_lines, screen_text, step, step_until


@folded(
    "key, character, sent",
    [
        ("a", "a", "a"),
        ("upper_a", "A", "A"),
        ("海", "海", "海"),
        ("space", " ", " "),
        ("enter", "\r", "\r"),
        ("tab", "\t", "\t"),
        ("shift+tab", None, "\x1b[Z"),
        ("backspace", "\x7f", "\x7f"),
        ("escape", "\x1b", "\x1b"),
        ("up", None, "\x1b[A"),
        ("shift+left", None, "\x1b[1;2D"),
        ("ctrl+right", None, "\x1b[1;5C"),
        ("home", None, "\x1b[H"),
        ("delete", None, "\x1b[3~"),
        ("ctrl+c", "\x03", "\x03"),
        ("ctrl+d", "\x04", "\x04"),
        ("ctrl+z", "\x1a", "\x1a"),
        ("ctrl+r", "\x12", "\x12"),
        ("ctrl+backslash", "\x1c", "\x1c"),
        ("alt+b", None, "\x1bb"),
        ("f5", None, "\x1b[15~"),
        ("f24", None, ""),
        ("plus", "+", "+"),
        ("+", "+", "+"),
    ],
)
def test_a_key_sends_what_xterm_sends(key, character, sent) -> None:
    assert encode(key, character) == sent


def test_programs_that_ask_for_it_get_application_cursor_keys() -> None:
    assert encode("up", None, application_cursor=True) == "\x1bOA"
    assert encode("ctrl+up", None, application_cursor=True) == "\x1b[1;5A"


@pytest.mark.parametrize(
    ("command", "name"),
    [
        ("ros2 run turtlesim turtle_teleop_key", "turtle_teleop_key"),
        ("ros2 topic echo /turtle1/pose", "echo /turtle1/pose"),
        ("ros2 launch day6_publisher day6_display.launch.py", "day6_display.launch.py"),
        ("ros2 launch src/day6/go.launch.py speed:=2", "go.launch.py"),
        ("/opt/ros/kilted/lib/turtlesim/turtle_teleop_key --ros-args -r __ns:=/a", "turtle_teleop_key"),
        ("python3 src/day6/talker.py --loud", "talker.py"),
        ("ros2 launch 'a folder/go.launch.py'", "go.launch.py"),
        ("'/a folder/lib/turtlesim/turtle_teleop_key' --ros-args", "turtle_teleop_key"),
        ("python3 'it is", "'it"),
        ("~/ros2_ws", "~/ros2_ws"),
        ("", ""),
    ],
)
def test_a_tab_has_a_short_name(command, name) -> None:
    assert tab_name(command) == name


def _text(view: TerminalView, line: int) -> str:
    return "".join(segment.text for segment in view.segments(line, colours(), focused=False)).rstrip()


def test_only_the_lines_that_changed_are_drawn_again() -> None:
    terminal = FakeTerminal(40, 5)
    view = TerminalView(terminal)
    assert view.changes() == {0, 1, 2, 3, 4}
    assert view.changes() == set()
    for text in ("hello", "\rhellO", "\r"):
        terminal.write(text)
        assert view.changes() == {0}
    terminal.write("\rhellO\r")
    assert view.changes() == set()
    terminal.write("\x1b[3;1H")
    assert view.changes() == {0, 2}  # where the cursor was and where it is


async def test_the_end_of_a_flood_is_shown_with_the_next_frame() -> None:
    async with opened(FakeDesk(), 60, 12, scene="empty") as (app, pilot):
        await step(app, pilot)
        (pane,) = app.terminals.panes
        terminal = pane.view.terminal
        terminal.busy = True
        pane.pull(1000.0)
        terminal.write("flood\n" * 100)
        pane.pull(1000.03)
        terminal.write("more\n")
        pane.pull(1000.06)
        assert "more" not in shown(pane), "nobody could read that"
        terminal.busy = False
        terminal.write("prompt$ ")
        pane.pull(1000.09)
        assert "prompt$" in shown(pane)


def shown(pane: Any) -> str:
    return "\n".join(_text(pane.view, line) for line in range(pane.view.lines))


def test_a_wide_character_is_never_cut_in_half() -> None:
    terminal = FakeTerminal(10, 2)
    terminal.write("ab海龟")
    view = TerminalView(terminal)
    view.changes()
    terminal.write("\x1b[1;6H!")
    assert view.changes() == {0}
    assert _text(view, 0) == "ab海 !"


def test_looking_back_stays_at_its_lines_while_more_is_printed() -> None:
    terminal = FakeTerminal(20, 4)
    terminal.write("\n".join(f"line {n}" for n in range(20)))
    view = TerminalView(terminal)
    view.changes()
    assert view.scroll_by(10)
    view.changes()
    before = [_text(view, line) for line in range(4)]
    assert before == ["line 6", "line 7", "line 8", "line 9"]
    terminal.write("\nmore\nand more")
    view.changes()
    assert [_text(view, line) for line in range(4)] == before
    assert not view.scroll_by(-5) or view.scroll == 7
    view.scroll_by(-99)
    view.changes()
    assert _text(view, 3) == "and more"


def test_looking_back_stays_at_its_lines_when_the_width_changes() -> None:
    terminal = FakeTerminal(20, 4)
    terminal.write("\n".join(f"line {n} that is longer than the window" for n in range(20)))
    view = TerminalView(terminal)
    view.changes()
    view.scroll_by(22)
    view.changes()
    first = _text(view, 0)
    assert first == "line 7 that is longe"
    for columns in (10, 50, 7, 33, 20):
        terminal.resize(columns, 4)
        view.changes()
        shown = _text(view, 0)
        assert shown.startswith(first[:columns].rstrip()) and view.passed == 0
    assert [_text(view, line) for line in range(2)] == ["line 7 that is longe", "r than the window"]
    terminal.resize(60, 30)
    view.changes()
    assert not view.scroll
    terminal.write("\nmore" * 40)
    view.changes()
    assert _text(view, 29) == "more" and not view.scroll


def test_a_frame_between_another_width_and_the_next_look_shows_what_was_there() -> None:
    terminal = FakeTerminal(10, 4)
    terminal.write("0123456789abcdefghij-more")
    view = TerminalView(terminal)
    view.changes()
    before = [_text(view, line) for line in range(4)]
    terminal.resize(40, 4)
    assert [_text(view, line) for line in range(4)] == before
    view.changes()
    assert _text(view, 0) == "0123456789abcdefghij-more"


@pytest.mark.parametrize("columns", [7, 12, 60])
def test_a_selection_stays_with_its_text_when_the_width_changes(columns: int) -> None:
    terminal = FakeTerminal(20, 3)
    terminal.write("first line is long enough to be wrapped\n海龟 and second\nthird\nfourth")
    view = TerminalView(terminal)
    view.changes()
    view.selection = ((1, 3), (2, 4))
    text = view.selected_text()
    assert text == "gh to be wrapped\n海龟"
    terminal.resize(columns, 3)
    view.changes()
    assert view.selected_text() == text
    terminal.resize(20, 3)
    assert view.selection == ((1, 3), (2, 4))


def test_a_selection_stays_with_its_text_when_the_oldest_lines_are_forgotten() -> None:
    terminal = FakeTerminal(20, 3)
    terminal.write("\n".join(f"line {n}" for n in range(5002)))
    view = TerminalView(terminal)
    view.changes()
    view.selection = ((9, 0), (9, 6))
    text = view.selected_text()
    terminal.write("\nmore" * 8)
    assert view.selected_text() == text
    terminal.write("\nmore" * 8)
    assert view.selection is None and view.selected_text() == ""


def test_copying_a_line_that_was_wrapped_joins_it() -> None:
    terminal = FakeTerminal(10, 3)
    terminal.write("ros2 topic pub -r 10 /cmd_vel\n一二三四五六七\n\nend")
    view = TerminalView(terminal)
    view.changes()
    view.selection = ((0, 0), (6, 3))
    assert view.selected_text() == "ros2 topic pub -r 10 /cmd_vel\n一二三四五六七\n\nend"
    view.selection = ((0, 5), (1, 7))
    assert view.selected_text() == "topic pub -r"


def test_the_selected_text_spans_scrollback_and_screen() -> None:
    terminal = FakeTerminal(20, 3)
    terminal.write("one\ntwo   \n海龟\nfour\nfive")
    view = TerminalView(terminal)
    view.changes()
    view.selection = ((0, 1), (3, 2))
    assert view.selected_text() == "ne\ntwo\n海龟\nfo"


def test_the_colours_of_programs_are_kept() -> None:
    terminal = FakeTerminal(20, 2)
    terminal.write("\x1b[01;32mstudent\x1b[0m \x1b[7mback\x1b[0m \x1b[38;2;1;2;3mx")
    view = TerminalView(terminal)
    view.changes()
    styles = {segment.text: segment.style for segment in view.segments(0, colours(), focused=False)}
    assert styles["student"].bold and styles["student"].color.get_truecolor().green > 150
    assert styles["back"].bgcolor == colours().terminal.color
    assert tuple(styles["x"].color.get_truecolor()) == (1, 2, 3)
    plain = view.segments(0, colours(colourless=True), focused=False)
    assert all(segment.style.color is None for segment in plain)


def _contrast(style) -> float:
    """How well letters can be read, 1 to 21 (WCAG 2)."""

    def luminance(colour) -> float:
        parts = [part / 255 for part in colour.get_truecolor()]
        linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    darker, lighter = sorted(map(luminance, (style.color, style.bgcolor)))
    return (lighter + 0.05) / (darker + 0.05)


@pytest.mark.parametrize("theme", ["dark", "light"])
@pytest.mark.parametrize(
    "pair", ["1;37;40", "1;37;41", "1;37;44", "33;44", "1;33;44", "1;37;45", "30;42", "30;46", "30;47"]
)
def test_the_usual_pairs_of_full_screen_programs_can_be_read(theme, pair) -> None:
    terminal = FakeTerminal(20, 2)
    terminal.write(f"\x1b[{pair}mtext")
    view = TerminalView(terminal)
    view.changes()
    style = next(segment.style for segment in view.segments(0, colours(theme), focused=False) if segment.text == "text")
    assert _contrast(style) >= 2.5


async def test_keys_go_to_the_terminal_and_only_the_desks_own_do_not(desk) -> None:
    async with opened(desk, lang="en") as (app, pilot):
        app.desktop.focus_pane(app.terminals.current)
        await pilot.press("l", "s", "space", "tab", "up", "ctrl+c", "escape", "f10", "enter")
        assert desk.terminals[0].sent == "ls \t\x1b[A\x03\x1b\x1b[21~\r"
        await pilot.press("f2")
        assert len(desk.terminals) == 2
        await pilot.press("x")
        assert desk.terminals[1].sent == "x"


async def test_pasted_text_goes_in_as_a_paste(desk) -> None:
    async with opened(desk, lang="en") as (app, pilot):
        app.desktop.focus_pane(app.terminals.current)
        await pilot.pause()
        app.post_message(events.Paste("ros2 node list\nls"))
        await pilot.pause()
        await pilot.pause()
        assert desk.terminals[0].sent == "<ros2 node list\nls>"


async def test_a_tab_tells_what_runs_and_that_there_is_news(desk) -> None:
    async with opened(desk, 60, 12, lang="en") as (app, pilot):
        await pilot.press("f2")
        app.actions["stack"]()
        desk.terminals[0].title = "ros2 topic echo /turtle1/pose"
        desk.terminals[0].write("x: 1.0\n")
        await step(app, pilot)
        title = screen_lines(app)[1]
        assert " 1 echo /turtle1/pose ● " in title
        assert " 2 ~ " in title
        for key in ("alt+1", "alt+2"):
            await pilot.press(key)
            await step(app, pilot)
        assert "●" not in screen_lines(app)[1]


async def test_a_teleop_terminal_says_that_it_lacks_the_keyboard(desk) -> None:
    async with opened(desk, 100, 30, lang="zh") as (app, pilot):
        desk.terminals[0].busy, desk.terminals[0].title = True, "ros2 run turtlesim turtle_teleop_key"
        app.desktop.focus_pane(app.welcome)
        await step(app, pilot)
        assert "方向键只在这个终端里有用" in screen_text(app)
        app.desktop.focus_pane(app.terminals.current)
        await step(app, pilot)
        assert "方向键只在这个终端里有用" not in screen_text(app)


async def test_a_program_that_ignores_ctrl_c_makes_the_terminal_say_what_helps(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        app.desktop.focus_pane(app.terminals.current)
        desk.terminals[0].is_stubborn = True
        await step(app, pilot)
        assert "It ignores Ctrl-C. Ctrl-\\ ends it; or Ctrl-Z, then: kill -9 %%" in screen_text(app)
        desk.terminals[0].is_stubborn = False
        await step(app, pilot)
        assert "ignores" not in screen_text(app)


async def test_the_wheel_looks_back_and_a_key_returns(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        app.desktop.focus_pane(app.terminals.current)
        desk.terminals[0].write("\n".join(f"line {n}" for n in range(50)))
        await step_until(app, pilot, lambda: "line 49" in screen_text(app))
        assert "line 49" in screen_text(app)
        await pilot.press("shift+pageup")
        await step_until(app, pilot, lambda: "line 49" not in screen_text(app))
        assert "more lines below" in screen_text(app)
        await pilot.press("a")
        await step(app, pilot)
        assert "line 49" in screen_text(app) and "more lines below" not in screen_text(app)


async def test_dragging_with_the_mouse_copies(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        app.desktop.focus_pane(app.terminals.current)
        await step(app, pilot)
        await pilot.mouse_down(app.terminals.current, offset=(1, 1))
        await pilot.hover(app.terminals.current, offset=(8, 1))
        await pilot.mouse_up(app.terminals.current, offset=(8, 1))
        assert app.clipboard == "student"


async def test_dragging_goes_on_from_its_text_when_the_width_changes_meanwhile(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        pane = app.terminals.current
        app.desktop.focus_pane(pane)
        desk.terminals[0].write("\r" + "".join(chr(97 + n % 26) for n in range(100)))
        await step(app, pilot)
        width = pane.view.columns
        await pilot.mouse_down(pane, offset=(3, 2))
        await pilot.hover(pane, offset=(5, 2))
        assert pane.view.selection == ((1, 2), (1, 4))
        desk.terminals[0].resize(200, pane.view.lines)
        await pilot.hover(pane, offset=(6, 1))
        assert pane.view.selection == ((0, width + 2), (0, 5))
        await pilot.mouse_up(pane, offset=(6, 1))


async def test_a_shell_that_ended_leaves_and_the_last_one_is_replaced(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        await pilot.press("f2")
        desk.terminals[0].closed = True
        await step(app, pilot)
        assert [pane.view.terminal for pane in app.terminals.panes] == [desk.terminals[1]]
        desk.terminals[1].closed = True
        await step(app, pilot)
        assert [pane.view.terminal for pane in app.terminals.panes] == [desk.terminals[2]]


async def test_terminals_are_as_large_as_their_pane(desk) -> None:
    async with opened(desk, 120, 40, lang="en") as (app, pilot):
        await pilot.press("f2", "f2")
        for size in ((120, 40), (80, 24), (40, 10), (100, 30)):
            await pilot.resize_terminal(*size)
            await step(app, pilot)
            for pane in app.terminals.panes:
                front = next(top for top, keys in app.desktop.plan_now().stacks.items() if pane.slot in keys)
                place = app.desktop.plan_now().places[front]
                screen = pane.view.terminal.screen
                assert (screen.columns, screen.lines) == (place.width - 2, place.height - 2)


async def test_page_up_alone_looks_back_at_a_prompt_and_goes_to_a_program_that_reads_keys(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        app.desktop.focus_pane(app.terminals.current)
        desk.terminals[0].write("\n".join(f"line {n}" for n in range(50)))
        await step_until(app, pilot, lambda: "line 49" in screen_text(app))
        await pilot.press("pageup")
        await step_until(app, pilot, lambda: "line 49" not in screen_text(app))
        assert desk.terminals[0].sent == ""
        desk.terminals[0].busy = True
        await pilot.press("pageup")
        assert desk.terminals[0].sent == "\x1b[5~"


@folded("text", [*_PLAIN.values(), *"aZ好~^", "\x01", "\x18", "\x1b[A", "\x1b[H", "\x1bOF"])
def test_what_a_terminal_sends_is_read_as_the_key_that_sends_it(text) -> None:
    assert encode(*decode(text)) == text.replace("\x1bO", "\x1b[") or decode(text)[0] in ("f1", "f2", "f3", "f4")


@pytest.mark.parametrize("width", [40, 60, 80, 120])
async def test_with_many_terminals_the_tab_of_the_one_in_front_is_always_there(desk, width) -> None:
    async with opened(desk, width, 24, lang="en", scene="empty") as (app, pilot):
        for _ in range(15):
            await pilot.press("f2")
        for terminal in desk.terminals[:4]:
            terminal.has_news = True
        for slot in range(1, 17):
            app.switching.go_to(slot)
            await step(app, pilot)
            pane = app.desktop.focused_pane
            title = "".join(piece.text for piece in pane.title())
            assert pane.slot == slot and f" {slot} " in title
            assert cell_len(title) <= pane.inner_width - 3
