"""Wrong words, broken files, poor terminals: a clear message in the real tool's words, and the desktop stays alive."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from tests.support.broken_lines import without_blanks
from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = pytest.mark.person

BROKEN_XML = '<robot name="r"><link name="a"></robot>\n'
TWO_ROOTS = '<robot name="r"><link name="a"/><link name="b"/></robot>\n'
MISMATCH = "Error=XML_ERROR_MISMATCHED_ELEMENT ErrorID=14 (0xe) Line number=1: XMLElement name=link"
PUBLISHER = "ros2 run robot_state_publisher robot_state_publisher"

WRONG_COMMANDS = {
    "unknown command": ("nope", 127, "bash: nope: command not found\n"),
    "unknown package": ("ros2 run nope talker", 1, "Package 'nope' not found\n"),
    "unknown executable": ("ros2 run turtlesim nope", 1, "No executable found\n"),
    "unknown topic to echo": (
        "ros2 topic echo /nope",
        1,
        "Could not determine the type for the passed topic\nWARNING: topic [/nope] does not appear to be published yet\n",
    ),
    "unknown topic to ask about": ("ros2 topic info /nope", 1, "Unknown topic '/nope'\n"),
    "unknown node": ("ros2 node info /nope", 1, "Unable to find node '/nope'\n"),
    "unknown type": ("ros2 topic pub --once /x std_msgs/msg/Strin '{}'", 1, "The passed message type is invalid\n"),
    "unknown type's package": (
        "ros2 topic pub --once /x no_msgs/msg/String '{}'",
        1,
        "The passed message type is invalid\n",
    ),
    "malformed YAML": (
        "ros2 topic pub --once /x std_msgs/msg/String '{data: '",
        1,
        (
            "yaml.parser.ParserError: while parsing a flow node\n"
            "expected the node content, but found '<stream end>'\n"
            '  in "<unicode string>", line 1, column 8:\n    {data: \n           ^\n'
        ),
    ),
    "YAML that is no dictionary": (
        "ros2 topic pub --once -w 0 /x std_msgs/msg/String hello",
        1,
        "The passed value needs to be a dictionary in YAML format\n",
    ),
    "a field the type has not": (
        "ros2 topic pub --once -w 0 /x std_msgs/msg/String '{dat: x}'",
        1,
        "Failed to populate field: 'String' object has no attribute 'dat'\n",
    ),
    "no robot description": (PUBLISHER, 250, "robot_description parameter must not be empty\n"),
    "a missing URDF": (f"{PUBLISHER} no.urdf", 250, "Failed to open URDF file: no.urdf: No such file or directory\n"),
    "a URDF with a tag left open": (f"{PUBLISHER} broken.urdf", 250, f"Error:   {MISMATCH}\n"),
    "a URDF with two roots": (
        f"{PUBLISHER} two.urdf",
        250,
        "Error:   Failed to find root link: Two root links found: [a] and [b]\n",
    ),
    "a missing Python file": ("python3 nope.py", 2, "nope.py': [Errno 2] No such file or directory\n"),
    "a Python file with a slip": ("python3 slip.py", 1, "NameError: name 'prnt' is not defined"),
    "an unfinished line": ("echo 'never closed", 2, "unexpected EOF while looking for matching `''\n"),
}


@pytest.mark.parametrize(("command", "status", "words"), WRONG_COMMANDS.values(), ids=WRONG_COMMANDS)
def test_a_wrong_command_is_answered_in_the_real_words(place: Place, command: str, status: int, words: str) -> None:
    place.file("broken.urdf", BROKEN_XML)
    place.file("empty.urdf", "")
    place.file("two.urdf", TWO_ROOTS)
    place.file("slip.py", "prnt('hello')\n")
    done = place.execute(command)
    assert done.returncode == status
    assert words in done.stderr + done.stdout
    assert "day6_tui" not in done.stderr


def test_the_desktop_stays_alive_whatever_is_typed(place: Place) -> None:
    place.home_file("broken.urdf", BROKEN_XML)
    place.home_file("two.urdf", TWO_ROOTS)
    place.home_file("slip.py", "prnt('hello')\n")
    with place.desktop("--scene", "empty", columns=200, rows=50) as screen:
        screen.wait("student@day6:~$")
        for command, status, words in WRONG_COMMANDS.values():
            if "closed" in command:
                continue  # a terminal asks for the rest of the line
            last = [line for line in words.split("\n") if line][-1].strip()
            screen.line(f"clear; {command}; echo status $?")
            # The words may stand behind a path, and break anywhere.
            screen.wait(
                lambda seen, last=last: without_blanks(last) in without_blanks("".join(re.findall("┃(.*?)┃", seen))),
                lambda seen, status=status: f"status {status}" in screen.pieces(),
            )
        screen.line("clear; echo 'never")
        screen.wait_lines(">")
        screen.line("closed'")
        screen.wait_lines("never", "closed")


@pytest.mark.parametrize(
    ("robot", "words"),
    [
        ("empty.urdf", ("process has died", "was required")),
        ("broken.urdf", ("process has died", "was required")),
    ],
)
def test_a_robot_that_cannot_be_read_ends_the_scene_with_the_reason(
    place: Place, robot: str, words: tuple[str, ...]
) -> None:
    place.file("broken.urdf", BROKEN_XML)
    place.file("empty.urdf", "")
    with place.desktop("--scene", "car", "--robot", robot, "--reduced-motion") as screen:
        seen = screen.wait(*words, "student@day6:~$", "^Q")
        assert "2 ~" not in seen
        screen.line("clear; echo alive")
        screen.wait_lines("alive")


def test_a_robot_of_ones_own_is_shown(place: Place) -> None:
    wheel = (
        '<link name="{0}"><visual><origin rpy="1.5707963 0 0"/><geometry><cylinder radius="0.1" length="0.05"/></geometry>'
        '</visual></link><joint name="{0}_joint" type="continuous"><parent link="body"/><child link="{0}"/>'
        '<origin xyz="0 {1} 0"/><axis xyz="0 1 0"/></joint>'
    )
    body = '<link name="body"><visual><geometry><box size="0.5 0.3 0.1"/></geometry></visual></link>'
    wheels = wheel.format("port", 0.2) + wheel.format("starboard", -0.2)
    place.file("my robot.urdf", f'<robot name="rover">{body}{wheels}</robot>')
    with place.desktop(
        "--scene", "car", "--robot", "my robot.urdf", "--reduced-motion", columns=120, rows=40
    ) as screen:
        screen.wait("car_view  rover ", "joint left_wheel_joint is not in the URDF")


@pytest.mark.parametrize(
    ("words", "problem"),
    [
        (("--nope",), "day6-tui: error: unrecognized arguments: --nope\n"),
        (("--scene", "nope"), "day6-tui: error: argument --scene: invalid choice: 'nope' (choose from"),
        (("--lang", "fr"), "day6-tui: error: argument --lang: invalid choice: 'fr' (choose from"),
        (("--glyphs", "teletext"), "day6-tui: error: argument --glyphs: invalid choice: 'teletext' (choose from"),
        (("--fps", "nan"), "day6-tui: error: argument --fps: 'nan' isn't a number from 1 to 120\n"),
        (("--robot", "nofile"), "day6-tui: error: argument --robot: there is no file 'nofile'\n"),
        (("--lesson", "day99"), "day6-tui: error: argument --lesson: there is no lesson 'day99'"),
        (("--home", __file__), "isn't a folder, and can't become one\n"),
        (("demo", "9"), "day6-tui demo: error: argument DAY: there is no lesson 'day9'; the lessons are day1, day2,"),
        (("serv",), "day6-tui: there is no command 'serv'; did you mean serve?\n"),
        (("--listen", "nonsense"), "day6-tui: error: argument --listen: 'nonsense' is not an endpoint like tcp/"),
        (("nope",), "day6-tui: there is no command 'nope'; day6-tui --help lists them\n"),
        ((), "day6-tui: the desktop needs a terminal; day6-tui exec runs commands without one\n"),
        (("exec", "--nope"), "day6-tui exec: error: unrecognized arguments: --nope\n"),
    ],
)
def test_a_wrong_option_is_told_before_anything_is_drawn(place: Place, words: tuple[str, ...], problem: str) -> None:
    done = place.run(*words)
    assert (done.returncode, done.stdout) == (2, "")
    assert problem in done.stderr
    assert "Traceback" not in done.stderr and "\x1b" not in done.stderr


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_home_that_cannot_be_used_is_told_on_the_way_out(place: Place, lang: str) -> None:
    path = place.work / "odd"
    path.mkdir()
    place.file("odd/ros2_ws", "")
    before, after = {"en": ("The home folder", "cannot be used: Not a dir"), "zh": ("主目录", "不能用：Not a dir")}[
        lang
    ]
    with place.desktop("--home", str(path), lang=lang, columns=200) as screen:
        assert screen.wait_end() == 1
        left = screen.output.decode().rsplit("\x1b[?1049l")[-1]
        told = re.escape(without_blanks(f"{before} {path}"))
        assert re.search(rf"{told}\S*{without_blanks(after)}", without_blanks(left)), left
    done = place.run("exec", "--home", str(path), "-c", "true")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("day6-tui exec: the home folder cannot be used: ")


@pytest.mark.parametrize(("columns", "rows"), [(40, 10), (300, 100)])
def test_the_turtle_is_driven_in_small_and_in_huge_terminals(place: Place, columns: int, rows: int) -> None:
    with place.desktop("--scene", "turtle", "--reduced-motion", columns=columns, rows=rows) as screen:
        screen.wait("'q' to quit.", "F1 Help", "^Q Quit" if columns < 80 else "^Q  Quit")
        screen.press("Up", "F4", "Enter")
        seen = screen.wait("2 Tur", "7.56")  # in the small one the title is short
        lines = seen.split("\n")
        assert len(lines) == rows and max(map(len, lines)) == columns
        screen.quit()
        assert screen.wait_end() == 0


def test_the_window_is_resized_while_everything_moves(place: Place) -> None:
    with place.desktop("--scene", "empty", columns=120, rows=40) as screen:
        screen.wait("student@day6:~$")
        screen.line("ros2 run turtlesim turtlesim_node 2> log & sleep 0.2; clear")
        screen.line("ros2 topic pub -r 20 /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 2}, angular: {z: 1}}'")
        screen.wait("TurtleSim", "v 2.0")
        for columns, rows in ((80, 24), (41, 11), (7, 3), (300, 100), (1, 1), (60, 40), (200, 10), (80, 24)):
            screen.resize(columns, rows)
            screen.look(0.1)
        screen.resize(100, 30)

        def is_framed(seen: str) -> bool:
            lines = seen.split("\n")[1:-1]
            return all(len(line) == 100 and line[0] in "┏┃┗╭│╰" and line[-1] in "┓┃┛╮│╯" for line in lines)

        bar = re.compile(" ?F2 +Terminal")
        seen = screen.wait("TurtleSim", "v 2.0", lambda seen: bar.match(seen.split("\n")[-1]), is_framed)
        assert "Traceback" not in screen.output.decode(errors="replace")
        moved = re.search(r"x (\d+\.\d+)", seen)
        assert moved is not None
        screen.wait(lambda seen: (now := re.search(r"x (\d+\.\d+)", seen)) and now[1] != moved[1])
        screen.press("Ctrl-C")
        screen.wait("^C", "student@day6:~$", "v 0.0")


def test_without_colour_nothing_is_coloured_and_the_focus_is_still_seen(place: Place) -> None:
    with place.desktop("--scene", "turtle", "--reduced-motion", NO_COLOR="1") as screen:
        screen.wait("'q' to quit.", "┏ ")
        screen.press("Up")
        screen.wait("7.56")
        codes = re.findall(rb"\x1b\[([\d;]*)m", bytes(screen.output))
        coloured = {code for code in codes for part in code.split(b";") if re.fullmatch(rb"(3|4|9|10)[0-8]", part)}
        assert coloured == set()


def test_without_utf_8_every_character_is_ascii(place: Place) -> None:
    with place.desktop("--scene", "turtle", "--reduced-motion", lang="zh", LANG="C", LC_ALL="C") as screen:
        seen = screen.wait("'q' to quit.", "turtle_tele", "F1 Help")
        screen.press("Up")
        seen = screen.wait("7.56")
        assert seen.isascii() and bytes(screen.output).isascii()
        screen.press("F2")
        screen.wait("5 ~")
        screen.line("rqt_graph")
        screen.press("Alt-5", "F3")
        seen = screen.wait("/teleop_turtle", "/turtle1/cmd_vel", "/turtlesim")
        assert seen.isascii()


def test_the_linux_console_gets_what_its_font_has_and_its_keys_are_understood(place: Place) -> None:
    with place.desktop("--scene", "turtle", "--reduced-motion", TERM="linux", COLORTERM=None) as screen:
        screen.wait("'q' to quit.", "╔ ")
        screen.press("Up")
        screen.wait("7.56")
        screen.send("\x1b[[B")  # F2
        seen = screen.wait("5 ~", "student@day6:~$")
        assert not set(seen) & set("▀▄╭╮╰╯▌▐▸⏵")
        assert re.search(rb"\x1b\[[\d;]*[34]8;", bytes(screen.output)) is None, "more than sixteen colours"


def test_nothing_typed_while_the_desktop_starts_is_lost(place: Place) -> None:
    with place.desktop("--scene", "empty") as screen:
        screen.wait(lambda seen: b"\x1b[?1049h" in screen.output)
        screen.line("echo early''bird")
        screen.wait_lines("earlybird")
    with place.desktop("--scene", "turtle", "--reduced-motion") as screen:
        screen.wait(lambda seen: b"\x1b[?1049h" in screen.output)
        screen.press("Up")
        screen.wait("x 7.56")


def test_nothing_of_a_long_paste_is_lost(place: Place) -> None:
    text = "".join(f"line {number} of what was copied: 你好\n" for number in range(400))
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$")
        screen.line("clear; cat > pasted")
        screen.wait("1 cat")
        screen.send("\x1b[200~")
        for line in text.splitlines(keepends=True):
            screen.send(line.replace("\n", "\r"))
        screen.send("\x1b[201~")
        screen.wait("line 399")
        screen.press("Ctrl-D")
        screen.wait_lines("student@day6:~$")
        until(lambda: (place.home / "pasted").read_text(encoding="utf-8") == text)


def test_a_program_that_floods_the_terminal_is_stopped_by_ctrl_c(place: Place) -> None:
    place.home_file("flood.py", "while True: print('again and again and again')\n")
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$")
        screen.line("python3 flood.py")
        screen.wait_lines("again and again and again")
        screen.press("Ctrl-C")
        screen.wait_lines("KeyboardInterrupt", "student@day6:~$")
        screen.line("clear; echo alive")
        screen.wait_lines("alive")
