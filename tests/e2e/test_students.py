"""Students' own programs: by `python3 FILE` in a terminal of the desktop, by `day6-tui python FILE` in a real one."""

from __future__ import annotations

import re
import shutil
import signal
from typing import TYPE_CHECKING

import pytest

from day6_urdf.shipped import shipped_model
from tests.e2e.students import ASKS, STUBBORN, TALKER, WHEEL_SPINNER, WRONG_NAMES
from tests.support.waiting import Deadline, until

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person

GONE_SECONDS = 2.0
"""So long at most a killed program's node is still listed."""

SPINS = re.compile(r"left_wheel +(-?\d+)° .*?([+-]\d\.\d\d) rad/s")
"""What stands beside the left wheel: its angle and speed."""

CAR = (
    "ros2 run robot_state_publisher robot_state_publisher day6_bot.urdf & ros2 run day6_bot car_view & sleep 0.1; clear"
)


def assert_gone(place: Place, name: str) -> None:
    """The node of a program that was killed just now is off every list in time."""
    deadline = Deadline(GONE_SECONDS)
    while True:
        late = deadline.is_over()
        if name not in place.nodes():
            return
        assert not late, f"{name} is still listed after {GONE_SECONDS} s"


def turned(screen: Terminal) -> int:
    """Degrees of the left wheel, once the car's window tells them."""
    found = SPINS.search(screen.wait(lambda seen: SPINS.search(seen)))
    assert found is not None
    return int(found[1])


def picture(screen: Terminal) -> list[str]:
    """The lines of the car's window in the wide desktop."""
    return [line[60:] for line in screen.look().split("\n")[1:38]]


def lines_below(seen: str) -> int:
    """How many lines are below those that a terminal shows which looks back."""
    found = re.search(r"(\d+) more lines below", seen)
    return int(found[1]) if found else 0


def car_desktop(place: Place, *commands: str) -> Terminal:
    """A wide desktop with the car's window; commands may be run in its terminal."""
    place.home.mkdir(exist_ok=True)
    shutil.copy(shipped_model(), place.home)
    screen = place.desktop("--scene", "empty", columns=120, rows=40)
    screen.wait("student@day6:~$")
    screen.line(CAR)
    screen.wait("╭ 2 car_view", "nobody publishes /joint_states: the wheels don't turn")
    return screen


def test_the_talker_talks_in_the_desktop_and_everybody_hears_it(place: Place) -> None:
    place.home_file("talker.py", TALKER)
    with place.desktop("--scene", "empty", rows=40) as screen:
        screen.wait("student@day6:~$")
        screen.line("python3 talker.py")
        screen.wait(lambda seen: re.search(r"\[INFO] \[\d+\.\d+] \[day6_talker]: I said: line \d+ of the t", seen))
        screen.press("F2")
        screen.wait("2 ~", "nodes 1")  # a program may be there before the desktop has joined the others
        screen.line("ros2 node list; ros2 topic echo --once /chatter")
        screen.wait_lines("/day6_talker", "---")
        assert any(re.fullmatch(r"data: line \d+ of the talker", piece) for piece in screen.pieces())

        heard = place.run("ros2", "topic", "echo", "--once", "/chatter")
        assert re.fullmatch(r"data: line \d+ of the talker\n---\n", heard.stdout), heard.stderr

        screen.press("Shift-F3")
        screen.wait("I said")
        screen.press("Ctrl-C")
        screen.wait_lines("KeyboardInterrupt", "student@day6:~$")
        screen.line("echo status $?")
        screen.wait_lines("status 130")
        screen.press("F8")
        screen.wait_gone("2 ~")
        for text in ("rclpy.spin(node)", "^CTraceback (most recent call last):"):
            while text not in (seen := screen.look()):
                before = lines_below(seen)
                screen.press("Shift-PageUp")  # one page after the other: a second one could go past the text
                # Or the text is there by now, and nothing above it: what was looked at was half drawn.
                screen.wait(lambda seen, text=text, before=before: text in seen or lines_below(seen) not in (0, before))
        place.wait_nodes()


def test_the_talker_of_another_real_terminal_is_seen_in_the_desktop(place: Place) -> None:
    file = place.file("talker.py", TALKER)
    with place.desktop("--scene", "empty") as screen, place.terminal("python", str(file), rows=40) as other:
        other.wait("[day6_talker]: I said: line 0 of the talker")
        screen.wait("student@day6:~$")
        until(lambda: "nodes 1" in screen.look(0.05))
        screen.line("ros2 node list; ros2 topic echo --once /chatter")
        screen.wait_lines("/day6_talker", "---")
        screen.line("clear; ros2 topic info /chatter")
        screen.wait_lines("Type: std_msgs/msg/String", "Publisher count: 1", "Subscription count: 0")
        other.press("Ctrl-C")
        assert other.wait_end() == -signal.SIGINT  # which a shell calls 130
        seen = other.look()
        assert b"Traceback (most recent call last):" in other.output and seen.rstrip().endswith("KeyboardInterrupt")
        until(lambda: "nodes 0" in screen.look(0.05))


def test_a_script_without_a_screen_hears_the_talker(place: Place) -> None:
    file = place.file("talker.py", TALKER)
    done = place.play(
        f"python3 '{file}' 2> log & ros2 topic echo /chatter std_msgs/msg/String > heard & "
        "until ros2 topic info /chatter | grep -q 'Subscription count: 1'; do sleep 0.05; done; "
        # What others of this machine hear after it, it hears too; the file has it in the end.
        "for n in 1 2 3; do ros2 topic echo --once /chatter std_msgs/msg/String > other; done; "
        "kill %1 %2; wait; cat heard; cat log"
    )
    numbers = [int(text) for text in re.findall(r"^data: line (\d+) of the talker$", done.stdout, re.MULTILINE)]
    assert len(numbers) >= 2 and numbers == list(range(numbers[0], numbers[0] + len(numbers))), (
        done.stdout + done.stderr
    )
    logged = [int(text) for text in re.findall(r"I said: line (\d+)", done.stdout)]
    assert logged[: len(numbers)] == list(range(len(numbers))) or numbers[-1] in logged


def test_a_killed_program_is_off_the_list_within_two_seconds(place: Place) -> None:
    file = place.file("talker.py", TALKER)
    process = place.start("python", str(file))
    place.wait_nodes("/day6_talker")
    process.kill()
    assert_gone(place, "/day6_talker")
    assert process.wait() == -signal.SIGKILL


@pytest.mark.timing
def test_the_wheels_turn_as_the_students_program_says(place: Place) -> None:
    place.home_file("wheel_spinner.py", WHEEL_SPINNER)
    place.home_file("wrong_names.py", WRONG_NAMES)
    with car_desktop(place) as screen:
        screen.line("python3 wheel_spinner.py")
        first, before = turned(screen), picture(screen)
        screen.wait("+1.00 rad/s", lambda seen: SPINS.search(seen)[1] != str(first))  # type: ignore[index]
        screen.wait(lambda seen: re.search(r"/joint_states (4\d|5[0-5]) Hz", seen))
        assert picture(screen) != before
        screen.press("Ctrl-C")
        seen = screen.wait("KeyboardInterrupt", "nobody publishes /joint_states: the wheels don't turn", "+0.00 rad/s")
        still = SPINS.search(seen)

        screen.line("clear; python3 wrong_names.py")
        seen = screen.wait("joint wheel_left_joint is not in the URDF;", "left_wheel_joint?")
        assert SPINS.search(seen)[1] == still[1]  # type: ignore[index]

        def stands_still(_: str) -> bool:
            """Turning wheels never do; the new lines below the car may still make it smaller."""
            before = picture(screen)
            screen.look(0.3)
            return picture(screen) == before

        screen.wait(stands_still)


def test_two_programs_that_fight_over_the_wheels_are_both_named(place: Place) -> None:
    file = place.file("wheel_spinner.py", WHEEL_SPINNER)
    with car_desktop(place) as screen, place.terminal("python", str(file)):
        screen.wait(lambda seen: SPINS.search(seen))
        screen.line("ros2 run day6_bot wheel_spinner &")
        screen.wait("2 publishers on /joint_states: wheel_spinner")

        def gids() -> list[str]:
            info = place.run("ros2", "topic", "info", "-v", "/joint_states").stdout
            is_whole = "Publisher count: 2\n" in info and info.count("Node name: wheel_spinner\n") == 2
            return re.findall(r"GID: (\S+)", info) if is_whole else []

        until(lambda: len(gids()) == 4)  # robot_state_publisher and the car's window listen
        assert len(set(gids())) == 4


@pytest.mark.timing
def test_the_wheels_are_told_fifty_times_a_second(place: Place) -> None:
    file = place.file("wheel_spinner.py", WHEEL_SPINNER)
    process = place.start("python", str(file))
    place.wait_nodes("/wheel_spinner")
    done = place.execute("timeout -s INT 2.4 ros2 topic hz /joint_states")
    rates = [float(text) for text in re.findall(r"average rate: ([\d.]+)", done.stdout)]
    # Never faster; slower by as much as others have the processor, as calls that are due together are one.
    assert rates and 20 < max(rates) < 55, done.stdout + done.stderr
    process.kill()


def test_what_is_typed_reaches_the_program_that_asks(place: Place) -> None:
    place.home_file("asks.py", ASKS)
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$")
        # Typed before the program runs: the terminal keeps it for the one who reads next.
        screen.line("python3 asks.py")
        screen.line("小明")
        screen.wait_lines("Your name? Hello 小明!")
        screen.line("clear; echo '小红' | python3 asks.py")
        screen.wait_lines("Your name? Hello 小红!")


def test_quitting_ends_a_program_that_ignores_ctrl_c(place: Place) -> None:
    place.home_file("stubborn.py", STUBBORN)
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$")
        screen.line("python3 stubborn.py")
        screen.wait_lines("you cannot stop me")
        screen.press("Ctrl-C")
        screen.quit()
        assert screen.wait_end() == 0
        until(lambda: place.processes() == {})  # the guard looks once more when the desktop is gone


def test_a_desktop_that_is_killed_takes_its_students_programs_with_it(place: Place) -> None:
    place.home_file("stubborn.py", STUBBORN)
    place.home_file("talker.py", TALKER)
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$")
        screen.line("python3 talker.py > out 2>&1 &")
        screen.line("clear; python3 stubborn.py")
        screen.wait_lines("you cannot stop me")
        place.wait_nodes("/day6_talker")
        screen.kill()
        assert screen.wait_end() == -signal.SIGKILL
        until(lambda: place.processes() == {}, limit=10)
        assert place.nodes() == []
