"""The article's sections 2 and 5 played on the screen, small and large, in both languages, by keyboard and by mouse alone.

At every step all that the article tells to watch is on the screen at the same moment: texts are waited for together, never one
after the other.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from typing import TYPE_CHECKING

import pytest

from tests.e2e.hands import PROMPT, Keyboard, Pointer
from tests.e2e.lesson_files import LAUNCH, SETUP, SPINNER_SCRIPT, TALKER, URDF, WHEEL_SPINNER
from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.e2e.hands import Hands
    from tests.e2e.place import Place

pytestmark = pytest.mark.person

SIZES = {(hands, lang): [(80, 24)] for hands, lang in itertools.product(("keyboard", "mouse"), ("zh", "en"))}
"""In which sizes who plays in which language: all where there is little room, and each of them once where there is much."""
SIZES["keyboard", "en"].append((120, 40))
SIZES["mouse", "zh"].append((120, 40))

everybody = pytest.mark.parametrize(
    ("hands", "lang", "size"),
    [
        pytest.param(*who, size, id="-".join((*who, "x".join(map(str, size)))))
        for who, sizes in SIZES.items()
        for size in sizes
    ],
)


@contextmanager
def desk(place: Place, hands: str, lang: str, size: tuple[int, int]) -> Iterator[Hands]:
    """An empty desk, its terminal with the keyboard; what was typed is looked through for what these hands may not use."""
    columns, rows = size
    with place.desktop(columns=columns, rows=rows, lang=lang) as screen:
        who = Keyboard(screen, lang) if hands == "keyboard" else Pointer(screen, lang)
        who.welcome("empty")
        screen.wait(who.texts("guide.heading"))
        who.go_to("1 ~")
        yield who


def pose(x: float, y: float = 5.54) -> str:
    return f"x {x:.2f}  y {y:.2f}"


def pane(person: Hands, title: str, *wanted: str) -> Callable[[str], bool]:
    """Whether each text stands in the pane with this title, wrapped or not."""

    def found(_: str) -> bool:
        lines = person.screen.pane(title)
        text, bare = "\n".join(line.rstrip() for line in lines), "".join("".join(lines).split())
        return all(each in text or "".join(each.split()) in bare for each in wanted)

    return found


def hint(person: Hands) -> Callable[[str], bool]:
    """Whether the teleop's terminal says, in full, how to get the keyboard back."""
    values = {"keys": person.texts("teleop.arrows"), "key": "Alt+3"}
    said = [person.texts(f"terminal.hint{which}", **values) for which in ("", ".short")]
    return lambda seen: any(text in seen or text.replace("Alt+3", "F3") in seen for text in said)


def twist(person: Hands, linear: float, angular: float) -> Callable[[str], bool]:
    """Whether `ros2 topic echo` shows this command as its newest one, down to the line that ends it."""
    lines = [f"  x: {linear}", "  y: 0.0", "  z: 0.0", "angular:", "  x: 0.0", "  y: 0.0", f"  z: {angular}", "---"]
    return pane(person, "echo", "\n".join(lines))


def drive_the_turtle(person: Hands) -> None:
    """Section 2.2: the turtle in terminal 1, its remote control in terminal 3, and one step forwards."""
    screen = person.screen
    person.run("ros2 run turtlesim turtlesim_node")
    screen.wait("2 TurtleSim", pose(5.54))
    person.new_terminal(3)
    person.run("ros2 run turtlesim turtle_teleop_key")
    screen.wait("'q' to quit.")
    screen.press("Up")
    screen.wait(pose(7.56), "Use arrow keys to move the turtle.")


def wait_for_echo(place: Place) -> None:
    """Wait until `ros2 topic echo` hears the turtle's commands: its title is there before, and a key is told once only."""
    until(lambda: "Subscription count: 2" in place.run("ros2", "topic", "info", "/turtle1/cmd_vel").stdout)


@everybody
def test_section_2_messages_are_seen_while_the_turtle_moves(
    place: Place, hands: str, lang: str, size: tuple[int, int]
) -> None:
    with desk(place, hands, lang, size) as person:
        screen = person.screen
        drive_the_turtle(person)
        person.new_terminal(4)
        person.run("ros2 node list")
        screen.wait_lines("/teleop_turtle", "/turtlesim")
        screen.wait(pose(7.56), hint(person))
        person.run("clear; ros2 topic list")
        screen.wait_lines("/turtle1/cmd_vel", "/turtle1/pose")
        person.run("clear; ros2 topic echo /turtle1/cmd_vel")
        screen.wait("4 echo")
        wait_for_echo(place)
        person.go_to("3 turtle_te")
        screen.press("Left")
        screen.wait(lambda seen: "θ 0.00" not in seen, "'q' to quit.", twist(person, 0.0, 2.0))
        screen.press("Up")
        screen.wait(lambda seen: pose(7.56) not in seen, "'q' to quit.", twist(person, 2.0, 0.0))

        person.new_terminal(5)
        person.run("rqt_graph")
        whole = pane(person, "6 rqt_graph", " /teleop_turtle ", " /turtlesim ", "/turtle1/cmd_vel")
        screen.wait(whole, "2 TurtleSim", hint(person))

        # The graph follows: without the teleop, and with it again.
        person.go_to("3 turtle_te")
        screen.send("q")
        alone = pane(person, "6 rqt_graph", " /turtlesim ")
        screen.wait(alone, lambda seen: not whole(seen), pane(person, "3 ~", PROMPT))
        screen.press("Up", "Enter")
        screen.wait(whole, "'q' to quit.")
        person.go_to("6 rqt_graph")
        column, row = screen.find("/teleop_turtle", "6 rqt_graph") or (0, 0)
        person.move_graph()
        screen.wait(lambda seen: screen.find("/teleop_turtle", "6 rqt_graph") == (column + 8, row))
        person.close_window("6 rqt_graph")
        screen.wait(lambda seen: not screen.pane("6 rqt_graph"))


# -- section 5 ---------------------------------------------------------------------------------------------------------

LARGE = 25
"""Cells of the chassis, at least, in a car that is looked at closely: at 80x24 it has 100."""

CLOSE = 60
"""And in one that shares 80x24 with two terminals and RViz's own panel: there it has about 75."""

PACKAGE = "ros2_ws/src/day6_publisher"


def write_package(person: Hands, place: Place) -> None:
    """Sections 3 and 4 are over: the package is there, with the robot, the launch file and the student's program."""
    create = "ros2 pkg create --build-type ament_python day6_publisher --dependencies rclpy std_msgs > /dev/null"
    person.run(f"mkdir -p ~/ros2_ws/src; cd ~/ros2_ws/src; {create}; cd ~/ros2_ws; clear; echo cre''ated")
    person.screen.wait_lines("created")
    for name, text in {
        "urdf/day6_bot.urdf": URDF,
        "launch/day6_display.launch.py": LAUNCH.replace("@HOME@", str(place.home)),
        "day6_publisher/wheel_spinner.py": WHEEL_SPINNER,
        "setup.py": SETUP.replace("@SCRIPTS@", SPINNER_SCRIPT),
    }.items():
        path = place.home / PACKAGE / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")


def blue(person: Hands) -> int:
    """How many cells of RViz's picture show the chassis, whatever the light does to its colour."""
    return sum(is_blue(fore) or is_blue(ground) for _, fore, ground in person.screen.cells(person.rviz))


@cache
def is_blue(colour: str) -> bool:
    """Whether this is a shade of the URDF's 0.2 0.3 0.9."""
    if not re.fullmatch("[0-9a-f]{6}", colour):
        return False
    red, green, blue = (int(colour[at : at + 2], 16) for at in (0, 2, 4))
    return blue > 2.5 * red and blue > 2 * green


def turning(person: Hands) -> Callable[[str], bool]:
    """Whether the car is there and its picture goes on changing while nobody touches it."""
    pictures = set()

    def seen(_: str) -> bool:
        pictures.add(
            tuple(person.screen.cells(person.rviz)[: -2 * person.screen.columns])
        )  # without the words below it
        return len(pictures) > 3 and blue(person) > LARGE

    return seen


@everybody
def test_section_5_the_wheels_turn_on_the_screen(place: Place, hands: str, lang: str, size: tuple[int, int]) -> None:
    with desk(place, hands, lang, size) as person:
        screen = person.screen
        write_package(person, place)
        person.run("clear; colcon build --packages-select day6_publisher")
        screen.wait("1 package finished")
        person.run("clear; source install/setup.bash; ros2 launch day6_publisher day6_display.launch.py")
        screen.wait(
            pane(person, "1 day6_display", "process started with pid", "Robot initialized"),
            pane(person, "2 RViz", "Global Options", "Fixed Frame map", "Global Status: Error", "Add"),
        )
        assert not blue(person)

        person.fixed_frame("map", "base_link")
        screen.wait(pane(person, "2 RViz", "Global Status: Ok", "Fixed Frame base_link"))
        person.add_display("RobotModel")
        screen.wait(pane(person, "2 RViz", "[x]", "RobotModel", "/robot_description"))
        person.description_topic("/robot_description")
        screen.wait(lambda seen: blue(person) > LARGE)  # without a key
        person.enlarge("2 RViz")
        screen.wait(lambda seen: not screen.pane("1 day6_display"))  # without it, RViz may be as high before
        screen.wait(lambda seen: len(screen.pane("2 RViz")) == size[1] - 4 and blue(person) > LARGE)
        person.enlarge("2 RViz")
        screen.wait(pane(person, "1 day6_display", "Robot initialized"), lambda seen: blue(person) > LARGE)
        person.new_terminal(3)
        person.run("source ~/ros2_ws/install/setup.bash; ros2 run day6_publisher wheel_spinner")
        screen.wait("3 wheel_spinner", turning(person))

        # Two publishers of /joint_states: both are named while the car is seen, and what happens when one of them stops.
        person.new_terminal(4)
        person.run("ros2 run joint_state_publisher_gui joint_state_publisher_gui")
        screen.wait(pane(person, "5 Joint", "left_wheel_joint", "0.000 rad", "wheel_spinner"), turning(person))
        person.inspect()
        fight = person.texts("inspector.fight", topic="/joint_states", count=2, nodes="")
        screen.wait(pane(person, person.texts("inspector.title"), fight), turning(person))
        person.go_to("3 wheel")
        screen.press("Ctrl-C")
        screen.wait(pane(person, "3 ~", "KeyboardInterrupt"), lambda seen: blue(person) > LARGE)
        person.go_to("5 Joint")
        before = screen.cells("2 RViz")
        person.slide("left_wheel_joint")
        screen.wait(
            lambda seen: screen.cells("2 RViz") != before and blue(person) > LARGE,
            lambda seen: "\n".join(screen.pane("5 Joint")).count("0.000 rad") == 1,
        )


# -- the whole day in one desktop --------------------------------------------------------------------------------------


def test_from_the_kitchen_to_the_two_publishers_in_one_desktop(place: Place) -> None:
    """Sections 2 to 5.4 as a class does them: 80x24, Chinese, keyboard only, and nothing is closed in between."""
    with desk(place, "keyboard", "zh", (80, 24)) as person:
        _section_2(person, place)
        _sections_3_and_4(person, place)
        _section_5(person)


def _section_2(person: Hands, place: Place) -> None:
    screen = person.screen
    drive_the_turtle(person)
    person.new_terminal(4)
    person.run("ros2 node list")
    screen.wait_lines("/teleop_turtle", "/turtlesim")
    person.run("clear; ros2 topic list")
    screen.wait_lines("/turtle1/cmd_vel", "/turtle1/pose")
    person.run("clear; ros2 topic echo /turtle1/cmd_vel")
    screen.wait("4 echo")
    wait_for_echo(place)
    person.go_to("3 ")
    screen.press("Up")
    screen.wait(lambda seen: pose(7.56) not in seen and "2 TurtleSim" in seen, twist(person, 2.0, 0.0))
    person.new_terminal(5)
    person.run("rqt_graph")
    screen.wait(pane(person, "6 rqt_graph", "/teleop_turtle", "/turtlesim", "/turtle1/cmd_vel"))


def _sections_3_and_4(person: Hands, place: Place) -> None:
    screen = person.screen
    person.new_terminal(7)
    write_package(person, place)
    (place.home / PACKAGE / "day6_publisher/talker.py").write_text(TALKER, encoding="utf-8")
    script = "'talker = day6_publisher.talker:main',\n" + SPINNER_SCRIPT
    (place.home / PACKAGE / "setup.py").write_text(SETUP.replace("@SCRIPTS@", script), encoding="utf-8")
    person.run("clear; colcon build --packages-select day6_publisher")
    screen.wait("1 package finished")
    person.run("clear; source install/setup.bash; ros2 run day6_publisher talker")
    screen.wait(lambda seen: re.search(r"Publishing: Hello from Day 6: \d", "".join(screen.pane("7 "))))
    person.new_terminal(8)
    person.run("source ~/ros2_ws/install/setup.bash; ros2 topic echo /chatter")
    # Both ends of the belt at once: what is sent and what arrives.
    screen.wait(
        pane(person, "7 ", "Publishing: Hello from Day 6"),
        lambda seen: re.search(r"data: ['\"]?Hello from Day 6: \d+", "".join(screen.pane("8 "))),
    )
    screen.press("Ctrl-C")
    person.run("clear; ros2 topic info /chatter")
    screen.wait(pane(person, "8 ", "Type: std_msgs/msg/String", "Publisher count: 1", "Subscription count: 0"))
    person.run("clear; check_urdf ~/ros2_ws/src/day6_publisher/urdf/day6_bot.urdf")
    screen.wait(pane(person, "8 ", "robot name is: day6_bot", "root Link: base_link has 3 child(ren)"))


def _section_5(person: Hands) -> None:
    screen = person.screen
    person.run("clear; ros2 launch day6_publisher day6_display.launch.py")
    person.rviz = "9 RViz"
    # RViz pops up, and nothing but a grid is in it.
    screen.wait(pane(person, person.rviz, "Global Status: Error"))
    assert not blue(person)
    person.fixed_frame("map", "base_link")
    screen.wait(pane(person, person.rviz, "Fixed Frame base_link"))
    person.add_display("RobotModel")
    screen.wait(pane(person, person.rviz, "RobotModel"))
    person.description_topic("/robot_description")
    screen.wait(lambda seen: blue(person) > LARGE)  # framed by itself
    person.new_terminal(10)
    person.run("source ~/ros2_ws/install/setup.bash; ros2 run day6_publisher wheel_spinner")
    screen.wait("10 ", turning(person), lambda seen: blue(person) > CLOSE)
    person.new_terminal(11)
    person.run("ros2 run joint_state_publisher_gui joint_state_publisher_gui")
    # Two publishers: the sliders say so, and the wheels that twitch are seen beside them.
    screen.wait(pane(person, "12 Joint", "left_wheel_joint", "wheel_spinner"), turning(person))
