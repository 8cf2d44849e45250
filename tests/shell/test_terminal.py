"""A terminal: typing, echo, editing, history, completion, jobs, the picture."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.session.task import let_others_run
from day6_core.shell.terminal import CROWDED
from tests.shell.conftest import show_all

PROMPT = "student@day6:~$"


def test_a_new_terminal_shows_the_prompt_in_the_home_folder(seat: Any) -> None:
    assert seat.look() == PROMPT
    assert seat.terminal.idle
    assert not seat.terminal.busy


def test_the_prompt_has_ubuntus_colours(seat: Any) -> None:
    row = seat.terminal.screen.row(0)
    assert [(text, style.fg, style.bold) for text, style in row[:3]] == [
        ("student@day6", "green", True),
        (":", "default", False),
        ("~", "blue", True),
    ]


def test_a_command_is_echoed_and_answered(seat: Any) -> None:
    assert seat.line("echo 你好 | grep 好").splitlines() == [f"{PROMPT} echo 你好 | grep 好", "你好", PROMPT]


def test_the_prompt_follows_the_directory(seat: Any) -> None:
    assert seat.line("cd ros2_ws/src").splitlines()[-1] == "student@day6:~/ros2_ws/src$"
    assert seat.terminal.title == "~/ros2_ws/src"
    assert seat.line("cd /").splitlines()[-1] == "student@day6:/$"


def test_output_without_a_newline_does_not_swallow_the_prompt(seat: Any) -> None:
    assert seat.line("echo -n abc").splitlines()[-2:] == ["abc", PROMPT]


def test_ctrl_c_ends_the_running_command_and_the_rest_of_its_line(seat: Any) -> None:
    seat.line("sleep 100; echo never")
    assert seat.terminal.busy
    assert seat.terminal.title == "sleep 100"
    screen = seat.type("\x03")
    assert screen.splitlines() == [f"{PROMPT} sleep 100; echo never", "^C", PROMPT]
    assert seat.line("echo $?").splitlines()[-2] == "130"


def test_ctrl_c_between_two_commands_ends_the_line(seat: Any) -> None:
    terminal = seat.terminal

    async def press_in_between() -> None:
        while terminal.runs.running is None or terminal.busy:
            await let_others_run()
        terminal.discipline.type("\x03")

    seat.desk.scheduler.spawn(press_in_between())
    screen = seat.line("for x in {1..99999}; do :; done; echo never")
    assert screen.splitlines()[-2:] == ["^C", PROMPT]
    assert seat.line("echo $?").splitlines()[-2] == "130"


def test_ctrl_backslash_ends_a_command_but_not_the_prompt(seat: Any) -> None:
    seat.type("echo a\x1c")
    assert seat.type("b\r").splitlines()[-2] == "ab"
    seat.line("sleep 100; echo status $?")
    assert seat.type("\x1c").splitlines()[-3:] == ["^\\Quit", "status 131", PROMPT]


def test_ctrl_c_at_the_prompt_drops_the_line(seat: Any) -> None:
    screen = seat.type("echo no\x03")
    assert screen.splitlines() == [f"{PROMPT} echo no^C", PROMPT]


def test_ctrl_d_on_an_empty_line_ends_the_shell(seat: Any) -> None:
    seat.type("x\x04")
    assert not seat.terminal.closed
    seat.type("\x15\x04")
    assert seat.terminal.closed


def test_exit_ends_the_shell_with_its_status(seat: Any) -> None:
    seat.line("exit 4")
    assert seat.terminal.closed
    assert seat.terminal.program.status == 4


def test_a_program_reads_the_lines_that_are_typed_until_ctrl_d(seat: Any) -> None:
    seat.line("cat > f")
    seat.line("one")
    seat.line("twx\x7fo")
    seat.type("\x04")
    assert seat.line("cat f").splitlines()[-3:] == ["one", "two", PROMPT]


def test_what_is_typed_ahead_runs_when_the_command_is_done(seat: Any) -> None:
    seat.line("sleep 5")
    seat.line("echo later")
    assert "later\nlater" not in seat.look()
    seat.settle(6)
    assert seat.look().splitlines()[-3:] == [f"{PROMPT} echo later", "later", PROMPT]


def test_keys_in_cooked_mode_are_echoed_as_a_kernel_does(seat: Any) -> None:
    seat.line("sleep 5")
    assert seat.type("\x1b[Aab\x7f\x01").splitlines()[-1] == "^[[Aa^A"


@pytest.mark.parametrize(
    ("keys", "line"),
    [
        ("echo abc\x01X", "Xecho abc"),
        ("echo abc\x1b[H\x1b[Fd", "echo abcd"),
        ("echo abc\x1b[D\x1b[DX", "echo aXbc"),
        ("echo abc\x1b[D\x1b[C\x1b[CX", "echo abcX"),
        ("echo abc\x7f\x7fX", "echo aX"),
        ("echo abc\x01\x1b[3~", "cho abc"),
        ("echo abc def\x17X", "echo abc X"),
        ("echo abc def\x15X", "X"),
        ("echo abc\x01\x0bX", "X"),
        ("echo abc\x15\x19\x19", "echo abcecho abc"),
        ("one two\x1bbX", "one Xtwo"),
        ("one two\x01\x1bfX", "oneX two"),
        ("one two\x01\x1b[1;5C\x1b[1;5CX", "one twoX"),
        ("ab\x14", "ba"),
        ("你好世界\x1b[D\x1b[D\x7f", "你世界"),
        ("a\x1b[15~b", "ab"),
    ],
)
def test_editing_keys(seat: Any, keys: str, line: str) -> None:
    assert seat.type(keys).splitlines()[-1] == f"{PROMPT} {line}".rstrip()


def test_the_cursor_stands_where_the_next_character_goes(seat: Any) -> None:
    seat.type("你好\x1b[D")
    assert (seat.terminal.screen.cursor.x, seat.terminal.screen.cursor.y) == (len(PROMPT) + 1 + 2, 0)


def test_a_long_line_wraps_and_can_be_edited_in_its_first_row(seat: Any) -> None:
    seat.type("echo " + "x" * 100)
    assert seat.terminal.screen.cursor.y == 1
    screen = seat.type("\x01# ")
    assert screen == f"{PROMPT} # echo {'x' * (80 - len(PROMPT) - 8)}\n{'x' * (100 - (80 - len(PROMPT) - 8))}"
    assert seat.type("\r").splitlines()[-1] == PROMPT


def test_a_line_as_long_as_the_window_leaves_the_cursor_in_the_next_row(seat: Any) -> None:
    seat.type("x" * (80 - len(PROMPT) - 1))
    assert (seat.terminal.screen.cursor.x, seat.terminal.screen.cursor.y) == (0, 1)
    seat.type("y")
    assert seat.look().splitlines()[1] == "y"
    seat.type("\x7f\x7f")
    assert seat.look().splitlines() == [f"{PROMPT} {'x' * (80 - len(PROMPT) - 2)}"]


def test_up_and_down_walk_through_the_history_and_back_to_what_was_typed(seat: Any) -> None:
    seat.line("echo one")
    seat.line("echo two")
    assert seat.type("draft\x1b[A\x1b[A").splitlines()[-1] == f"{PROMPT} echo one"
    assert seat.type("\x1b[A").splitlines()[-1] == f"{PROMPT} echo one"
    assert seat.type("\x1b[B\x1b[B").splitlines()[-1] == f"{PROMPT} draft"


def test_ctrl_r_finds_the_last_line_with_a_text(seat: Any) -> None:
    seat.line("echo alpha")
    seat.line("echo beta")
    seat.line("echo alpha beta")
    assert seat.type("\x12alp").splitlines()[-1] == "(reverse-i-search)`alp': echo alpha beta"
    assert seat.type("\x12").splitlines()[-1] == "(reverse-i-search)`alp': echo alpha"
    assert seat.type("\r").splitlines()[-3:] == [f"{PROMPT} echo alpha", "alpha", PROMPT]


def test_a_search_that_finds_nothing_says_so_and_ctrl_c_gives_the_line_back(seat: Any) -> None:
    seat.line("echo alpha")
    assert seat.type("draft\x12zzz").splitlines()[-1].startswith("(failed reverse-i-search)`zzz':")
    assert seat.type("\x07").splitlines()[-1] == f"{PROMPT} draft"


def test_the_next_terminal_knows_the_history(machine: Any, seat: Any) -> None:
    seat.line("echo remembered")
    other = type(seat)(machine.desk)
    assert other.type("\x1b[A").splitlines()[-1] == f"{PROMPT} echo remembered"


def test_an_open_quote_asks_for_more(seat: Any) -> None:
    assert seat.line("echo 'a").splitlines()[-1] == ">"
    assert seat.line("b'").splitlines()[-3:] == ["a", "b", PROMPT]


def test_pasted_lines_run_only_after_enter(seat: Any) -> None:
    seat.terminal.paste("echo one\necho two\n")
    seat.settle()
    assert "\none" not in seat.look()
    assert seat.type("\r").splitlines()[-3:] == ["one", "two", PROMPT]


def test_tab_completes_commands_files_and_variables(seat: Any) -> None:
    assert seat.type("whoa\t").splitlines()[-1] == f"{PROMPT} whoami"
    seat.type("\x15")
    seat.line("mkdir -p 'one dir' other; touch one.py")
    assert seat.type("cat one.\t").splitlines()[-1] == f"{PROMPT} cat one.py"
    assert seat.type("\x15cd one\t").splitlines()[-1] == f"{PROMPT} cd one\\ dir/"
    assert seat.type("\x15cat 'one d\t").splitlines()[-1] == f"{PROMPT} cat 'one dir/"
    assert seat.type("\x15echo a | cat ~/ros2_\t").splitlines()[-1] == f"{PROMPT} echo a | cat ~/ros2_ws/"
    assert seat.type("\x15echo $ROS_DI\t").splitlines()[-1] == f"{PROMPT} echo $ROS_DISTRO"


def test_the_second_tab_lists_what_is_possible(seat: Any) -> None:
    seat.line("touch apple.py apricot.py")
    seat.line("clear")
    assert seat.type("cat a\t").splitlines() == [f"{PROMPT} cat ap"]
    assert seat.type("\t").splitlines() == [f"{PROMPT} cat ap", "apple.py    apricot.py", f"{PROMPT} cat ap"]


def test_clear_empties_the_screen_and_the_scrollback(seat: Any) -> None:
    seat.line("seq 100")
    assert len(seat.terminal.history) > 70
    assert seat.line("clear") == PROMPT
    assert len(seat.terminal.history) == 0


def test_the_scrollback_keeps_the_lines_that_left_the_screen(seat: Any) -> None:
    seat.line("seq 100")
    history = seat.terminal.history
    lines = ["".join(row[x].data for x in range(80)).rstrip() for row in history[:]]
    assert lines[:3] == [f"{PROMPT} seq 100", "1", "2"]
    assert len(history) == 102 - 24


def test_jobs_in_the_background_are_numbered_listed_and_reported(seat: Any) -> None:
    first = seat.line("sleep 3 &").splitlines()[1]
    assert first.startswith("[1] ")
    seat.line("sleep 50 &")
    assert seat.line("jobs").splitlines()[-3:] == [
        "[1]-  Running                 sleep 3 &",
        "[2]+  Running                 sleep 50 &",
        PROMPT,
    ]
    seat.settle(4)
    assert seat.line("").splitlines()[-2:] == ["[1]-  Done                    sleep 3", PROMPT]
    assert seat.line("kill %2").splitlines()[-2:] == ["[2]+  Terminated              sleep 50", PROMPT]


def test_ctrl_z_stops_a_program_and_fg_brings_it_back(seat: Any) -> None:
    seat.line("sleep 10")
    assert seat.type("\x1a").splitlines()[-3:] == ["^Z", "[1]+  Stopped                 sleep 10", PROMPT]
    seat.settle(100)
    assert seat.line("jobs").splitlines()[-2] == "[1]+  Stopped                 sleep 10"
    assert seat.line("bg").splitlines()[-3:-1] == ["[1]+ sleep 10 &", "[1]+  Done                    sleep 10"]


def test_fg_gives_the_terminal_to_a_background_job(seat: Any) -> None:
    seat.line("cat > f &")
    seat.line("fg")
    assert seat.terminal.busy
    seat.line("typed")
    seat.type("\x04")
    assert seat.line("cat f").splitlines()[-2] == "typed"


def test_raw_keys_go_to_the_program_and_the_mode_ends_with_it(
    machine: Any, seat: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    keys: list[str] = []

    async def teleop(session: Any) -> int:
        with session.stdin.raw():
            while (key := await session.stdin.read_key()) != "q":
                keys.append(key)
        return 0

    from day6_core.shell.builtins import programs

    monkeypatch.setattr(programs, "ros_program", teleop)
    seat.line("rqt_graph")
    assert seat.terminal.reading_keys
    seat.type("\x1b[A你x")
    assert keys == ["\x1b[A", "你", "x"]
    seat.type("\x03")
    assert not seat.terminal.reading_keys
    assert seat.line("echo back").splitlines()[-2] == "back"


def test_two_terminals_have_their_own_environment_and_directory(machine: Any, seat: Any) -> None:
    other = type(seat)(machine.desk)
    seat.line("export COLOUR=red; cd ros2_ws")
    assert other.line('echo "[$COLOUR]"').splitlines()[-2:] == ["[]", PROMPT]


def test_bashrc_is_read_by_every_new_terminal(machine: Any, seat: Any) -> None:
    seat.line("echo 'export GREETING=hello' >> ~/.bashrc")
    other = type(seat)(machine.desk)
    assert other.line("echo $GREETING").splitlines()[-2] == "hello"


def test_a_broken_bashrc_is_told_and_the_prompt_comes_all_the_same(machine: Any) -> None:
    from tests.shell.conftest import Seat

    (machine.desk.home / ".bashrc").write_text("source nowhere\nif\n")
    assert Seat(machine.desk).look().splitlines()[-1] == PROMPT


def test_a_hung_up_terminal_ends_its_shell_and_what_ran_in_it(machine: Any, seat: Any) -> None:
    seat.line("sleep 1000 &")
    seat.line("sleep 2000")
    seat.terminal.close()
    assert seat.terminal.closed
    assert machine.desk.programs == {}
    assert machine.desk.terminals == []


def test_a_flood_that_nobody_looks_at_stays_bounded_and_leaves_a_mark(machine: Any, seat: Any) -> None:
    seat.terminal.send("seq 200000\r")
    machine.go()
    assert seat.terminal._size <= 600 * 1024
    screen = seat.look()
    assert screen.splitlines()[-2:] == ["200000", PROMPT]
    rows = seat.terminal.history
    first = ["".join(row[x].data for x in range(80)).rstrip() for row in rows[:]]
    assert len(rows) == 5000
    assert first[0].isdigit()


def test_a_view_that_has_read_everything_is_called_when_programs_begin_to_pause(seat: Any) -> None:
    terminal, called = seat.terminal, []
    terminal.on_crowded = lambda: called.append(terminal._size)
    line = "x" * 10_000
    while not called:
        assert terminal._size <= CROWDED
        terminal.write(line)
    assert called == [terminal._size] and terminal.is_crowded
    terminal.write(line)
    assert len(called) == 1
    show_all(terminal)
    terminal.write(line)
    assert len(called) == 1  # it pauses for nobody
    for _ in range(20):
        terminal.write(line)
    assert len(called) == 2


def test_the_mark_says_how_many_lines_are_missing(machine: Any, seat: Any) -> None:
    terminal = seat.terminal
    for number in range(10000):
        terminal.write(f"{number} {'x' * 70}\r\n")
    show_all(terminal)
    texts = ["".join(row[x].data for x in range(80)).rstrip() for row in terminal.history[:]]
    marks = [text for text in texts if "lines dropped" in text]
    assert marks and marks[0].startswith("… ")
    missing = int(marks[0].split()[1])
    first_left = next(text for text in texts[texts.index(marks[0]) + 1 :] if text[:1].isdigit())
    assert missing in (int(first_left.split()[0]), int(first_left.split()[0]) - 1)


def test_resizing_keeps_what_was_printed(seat: Any) -> None:
    seat.line("seq 30")
    seat.terminal.resize(40, 10)
    seat.settle()
    assert seat.look().splitlines()[-2:] == ["30", PROMPT]
    assert len(seat.look().splitlines()) == 10
    seat.terminal.resize(100, 30)
    seat.settle()
    lines = seat.look().splitlines()
    assert lines[-2:] == ["30", PROMPT]
    assert lines[0] == "2"
    assert seat.line("echo wide").splitlines()[-2] == "wide"


@pytest.mark.parametrize(("columns", "rows"), [(40, 10), (300, 100), (2, 1)])
def test_terminals_of_any_size_work(machine: Any, columns: int, rows: int) -> None:
    from tests.shell.conftest import Seat

    seat = Seat(machine.desk, columns, rows)
    seat.line("echo ok")
    assert seat.terminal.idle


def test_a_line_being_typed_survives_what_a_background_job_prints(seat: Any) -> None:
    seat.line("(sleep 1; echo from behind) &")
    seat.type("echo a")
    seat.settle(2)
    assert seat.look().splitlines()[-1] == f"{PROMPT} echo afrom behind"
    assert seat.type("b").splitlines()[-1] == f"{PROMPT} echo ab"
    assert seat.type("\r").splitlines()[-3:] == [
        "ab",
        "[1]+  Done                    (sleep 1; echo from behind)",
        PROMPT,
    ]


def test_less_behind_a_pipe_takes_its_keys_from_the_terminal(seat: Any) -> None:
    screen = seat.line("seq 1 100 | less")
    assert screen.splitlines()[:2] == ["1", "2"] and seat.terminal.busy
    assert seat.type("G").splitlines()[-2:] == ["100", "(END)"]
    seat.type("q")
    assert "(END)" not in seat.look() and not seat.terminal.busy
    assert seat.line("echo on").splitlines()[-2:] == ["on", PROMPT]


def test_what_is_typed_after_nano_is_nanos_even_before_its_window_is_there(seat: Any) -> None:
    seat.type("nano talker.py\rimport rclpy\r")
    (window,) = seat.desk.display.windows
    seat.type("\x03x")
    assert window.model.take_typed() == "import rclpy\r\x03x"
    assert window.model.take_typed() == ""
    window.close_by_user()
    assert seat.line("echo back").splitlines()[-2:] == ["back", PROMPT]


def test_gedit_has_a_window_of_its_own_and_leaves_the_terminal_alone(seat: Any) -> None:
    seat.line("gedit talker.py")
    (window,) = seat.desk.display.windows
    assert seat.type("abc").endswith("abc")
    assert window.model.take_typed() == ""
    seat.type("\x03")
    assert seat.desk.display.windows == []


def test_a_prompt_drawn_anew_for_another_size_is_no_news(seat: Any) -> None:
    seat.line("echo told")
    seat.terminal.mark_seen()
    seat.terminal.resize(60, 20)
    seat.settle()
    assert not seat.terminal.has_news
    seat.line("sleep 5; echo told")
    seat.terminal.mark_seen()
    seat.terminal.resize(80, 24)
    seat.settle(6)
    assert seat.terminal.has_news


def test_an_open_condition_asks_for_more(seat: Any) -> None:
    assert seat.line("[[ a = a").splitlines()[-1] == ">"
    assert seat.line("&& 1 -lt 2").splitlines()[-1] == ">"
    assert seat.line("]]; echo $?").splitlines()[-2:] == ["0", PROMPT]


@pytest.mark.parametrize("line", ["export", "export -p", "history", "alias", "jobs", "set", "shopt"])
def test_a_list_of_what_there_is_succeeds(machine: Any, line: str) -> None:
    assert machine.run(f"false; {line} > f; echo $?").out == "0\n"
