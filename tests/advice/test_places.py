"""Where an error came from decides which card it has, and no card names a line of a file that isn't the pupil's."""

from __future__ import annotations

import re
import sysconfig
from collections.abc import Callable
from pathlib import Path

import pytest

from day6_core.advice.below import first_line_below
from day6_core.advice.card_files import CardError, all_cards, read_topic
from day6_core.advice.explain import as_text, explain, scene_of
from day6_core.advice.fault import fault_in, faults_in, module_of
from day6_core.advice.matching import Match, cards_in
from day6_core.advice.rules import Surroundings, hint_below
from day6_core.advice.wording import at_home
from day6_core.language import LANGUAGES
from day6_core.ros.environment import PYTHON_PATH, program_environment
from tests.advice.failing import failed
from tests.advice.test_cards import CARD

OWN, THEIRS = 7, 2047
STDLIB = sysconfig.get_path("stdlib")


def report(*places: tuple[str, int, str], error: str) -> str:
    """A traceback through these files, each with its line and what stands there."""
    lines = "".join(f'  File "{file}", line {line}, in work\n    {code}\n' for file, line, code in places)
    return f"Traceback (most recent call last):\n{lines}{error}\n"


LIBRARIES = {
    f"{STDLIB}/inspect.py": "inspect",
    f"{STDLIB}/importlib/metadata/__init__.py": "importlib",
    f"{PYTHON_PATH}/rclpy/executors.py": "rclpy",
    "/opt/ros/jazzy/lib/python3.12/site-packages/rclpy/node.py": "rclpy",
    "/usr/lib/python3.12/inspect.py": "inspect",
    "/usr/lib/python3/dist-packages/numpy/core/numeric.py": "numpy",
    "/home/me/.venv/lib/python3.12/site-packages/rosbag2_py/__init__.py": "rosbag2_py",
    "<frozen importlib._bootstrap>": "importlib",
    "<string>": "string",
    "/home/me/ros2_ws/install/car/lib/car/go": "setuptools",
}
PUPILS = (
    "talker.py",
    "/home/me/ros2_ws/src/car/car/talker.py",
    "/home/me/ros2_ws/install/car/lib/python3.12/site-packages/car/talker.py",
    "/home/me/ros2_ws/install/lib/python3.12/site-packages/car/talker.py",
    "/home/me/inspect.py",
    "/home/me/rclpy/lesson.py",
)


def test_a_file_is_the_pupils_unless_it_lies_among_the_libraries() -> None:
    assert {file: module_of(file) for file in LIBRARIES} == LIBRARIES
    assert {file: module_of(file) for file in PUPILS} == dict.fromkeys(PUPILS, "")


@pytest.mark.parametrize("library", LIBRARIES)
def test_the_place_of_a_fault_is_in_the_pupils_file(library: str) -> None:
    fault = fault_in(
        report(("a.py", 3, "b()"), ("a.py", OWN, "c()"), (library, THEIRS, "raise"), error="KeyError: 'a'")
    )
    assert fault is not None and (fault.file, fault.line, fault.through) == ("a.py", OWN, (LIBRARIES[library],))
    assert not fault.own
    nowhere = fault_in(report((library, THEIRS, "raise"), error="KeyError: 'a'"))
    assert nowhere is not None and (nowhere.file, nowhere.line) == ("", 0)
    own = fault_in(report((library, THEIRS, "f()"), ("a.py", OWN, "{}['a']"), error="KeyError: 'a'"))
    assert own is not None and own.own and own.line == OWN
    spins = fault_in(report(("a.py", OWN, "rclpy.spin(node)"), (library, THEIRS, "f()"), error="KeyError: 'a'"))
    assert spins is not None and (spins.file, spins.line) == ("a.py", 0)  # the mistake is elsewhere


def test_the_text_that_setuptools_runs_is_setup_py() -> None:
    core = "/x/site-packages/setuptools/_distutils/core.py"
    syntax = '  File "<string>", line 7\n    def f(:\n          ^\nSyntaxError: invalid syntax\n'
    whole = f'Traceback (most recent call last):\n  File "{core}", line 250, in run_setup\n    exec(code, g)\n{syntax}'
    fault = fault_in(whole)
    assert fault is not None and (fault.file, fault.line) == ("setup.py", 7)
    alone = fault_in(syntax)  # python3 -c
    assert alone is not None and (alone.file, alone.line) == ("", 0)


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_card_names_a_line_of_a_file_that_is_not_the_pupils(language: str, tmp_path: Path) -> None:
    around = Surroundings({"HOME": str(tmp_path), "DAY6_LANG": language}, tmp_path)
    names = ("name", "package", "share", "type", "path", "variable", "fixed", "kind")
    through = (f"{STDLIB}/inspect.py", THEIRS, "raise ValueError")
    for card in all_cards():
        values = dict.fromkeys((*names, *map(str, range(4))), "x")
        for places, told in (((("a.py", OWN, "f()"), through), True), ((through,), False)):
            output = report(*places, error="ValueError: x")
            shown = explain(
                match := Match("x", card, values, fault_in(output)), scene_of(match, around, output=output), language
            )
            text = as_text(shown, language, 200)
            assert str(THEIRS) not in text and "{line}" not in text, card.id
            words = card.words[language]
            if told and "{line}" in words.first:
                assert re.search(rf"(?:[Ll]ine|第) {OWN}\b", text), card.id
            assert not re.search(r"(?:[Ll]ine|第) ?(?:0|\?|行)", text), card.id


def test_several_reports_in_one_output_are_told_apart() -> None:
    first = report(("a.py", 1, "a"), error="KeyError: 'a'")
    second = report(("b.py", 2, "b"), (f"{STDLIB}/os.py", THEIRS, "c"), error="struct.error: bad")
    assert [(fault.kind, fault.line) for fault in faults_in(f"hello\n{first}between\n{second}after\n")] == [
        ("error", 2),
        ("KeyError", 1),
    ]
    found = next(match for match in cards_in(first + second) if match.line == "KeyError: 'a'")
    assert found.fault is not None and found.fault.line == 1


def test_a_card_with_from_is_only_for_what_comes_from_there(tmp_path: Path) -> None:
    path = tmp_path / "x.md"
    path.write_text(CARD.replace("- same", "- from: own rclpy\n- same"), encoding="utf-8")
    (card,) = read_topic(path)[1]
    own = report(("a.py", 1, "f"), error="KeyError: 'a'")
    ours = report(
        ("a.py", 1, "f"), (f"{PYTHON_PATH}/rclpy/x.py", 2, "f"), (f"{STDLIB}/os.py", 2, "f"), error="KeyError: 'a'"
    )
    theirs = report(("a.py", 1, "f"), (f"{STDLIB}/os.py", 2, "f"), error="KeyError: 'a'")
    seen = [card.seen_in(fault_in(output)) for output in (own, ours, theirs, "no report")]
    assert seen == [{}, {}, None, None]
    path.write_text(CARD.replace("- same", "- from: \n- same"), encoding="utf-8")
    with pytest.raises(CardError):
        read_topic(path)


def test_no_card_guesses_beside_a_cause_that_is_known() -> None:
    """What is only likely is a check, and checks go when a looker has found the cause."""
    guess = re.compile(r"[Oo]ften|most likely|mostly|多半|常常|可能")
    told = {
        card.id
        for card in all_cards()
        for words in card.words.values()
        if card.look and guess.search(f"{words.first} {words.more}")
    }
    assert not told


NODE = """import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.{make}

    def work({takes}):
        print('hi')


rclpy.init()
rclpy.spin(Talker())
"""

CALLBACKS = {
    # How the callback is handed over, what it takes -> the hint.
    ("create_timer(0.01, self.work)", ""): "self is missing in line 11: write def work(self):",
    ("create_timer(0.01, self.work())", "self"): "line 9 calls the function at once: pass the function itself, "
    "without (): self.work",
    ("create_timer(0.01, self.work)", "self, msg"): "a timer calls work without arguments: in line 11 write def work(self):",
    ("create_subscription(String, 'x', self.work, 10)", "msg"): "self is missing in line 11: write def work(self, msg):",
    ("create_subscription(String, 'x', self.work, 10)", ""): "self is missing in line 11: write def work(self):",
    ("create_subscription(String, 'x', self.work, 10)", "self"): "a subscription calls work with the message, but line 11 "
    "takes none: write def work(self, msg):",
    ("create_subscription(String, 'x', self.work(), 10)", "self"): "line 9 calls the function at once: pass the "
    "function itself, without (): self.work",
    ("work()", ""): "self is missing in line 11: write def work(self):",
    ("work(1)", "speed"): "self is missing in line 11: write def work(self, speed):",
    ("work(1)", "self"): "",
    ("create_timer(0.01, None)", "self"): "",
}  # fmt: skip


@pytest.mark.process
@pytest.mark.parametrize(("case", "hint"), CALLBACKS.items(), ids=map(" ".join, CALLBACKS))
def test_what_is_wrong_with_a_callback_is_read_in_the_program(tmp_path: Path, case: tuple[str, str], hint: str) -> None:
    make, takes = case
    output = failed(NODE.format(make=make, takes=takes), tmp_path)
    around = Surroundings({**program_environment(), "HOME": str(tmp_path)}, tmp_path)
    assert hint_below(output, around) == (f"hint: {hint}" if hint else "")
    match = next(cards_in(output))
    shown = as_text(explain(match, scene_of(match, around, output=output), "en"), "en", 200)
    assert hint in shown and (hint == "" or "What to check" not in shown)
    chinese = Surroundings({**around.variables, "DAY6_LANG": "zh"}, tmp_path)
    assert (hint_below(output, chinese) or first_line_below(output, chinese)).startswith("提示：" if hint else "意思：")


def test_a_program_that_has_gone_or_is_no_python_shows_no_cause(tmp_path: Path) -> None:
    error = "ValueError: invalid method signature"
    output = report((str(tmp_path / "a.py"), 3, "spin()"), (f"{PYTHON_PATH}/rclpy/x.py", 2, "f"), error=error)
    around = Surroundings({"HOME": str(tmp_path)}, tmp_path)
    write: Callable[[bytes], int] = (tmp_path / "a.py").write_bytes
    assert hint_below(output, around) == ""
    for content in (b"def f(:\n", b"\xff\xfe\x00", b"x = 1\n", b"(" * 5000):
        write(content)
        assert hint_below(output, around) == ""


@pytest.mark.process
@pytest.mark.parametrize(
    ("program", "told", "never"),
    [
        ("open('/home/your_name/ros2_ws/src/a.urdf')", "os.path.expanduser('~/ros2_ws/src/a.urdf')", "bag"),
        ("open('/home/your_name/urdf/a.urdf')", "/home/your_name is the home folder in the example", "bag"),
        ("open('~/a.urdf')", "os.path.expanduser('~/a.urdf')", "$HOME"),
        ("open('$HOME/a.urdf')", "os.path.expanduser('~/a.urdf')", "bag"),
        ("open('progam.py')", "there is program.py", "bag"),
        ("import subprocess\nsubprocess.run(['ros3'])", "tries to start ros3", "opens"),
        (
            "import rosbag2_py, shutil\nshutil.copy('a.urdf', 'b')",
            "The program opens a.urdf, but there is no such file",
            "bag",
        ),
    ],
)
def test_a_file_that_a_program_does_not_find(tmp_path: Path, program: str, told: str, never: str) -> None:
    (tmp_path / "ros2_ws").mkdir()
    output = failed(program, tmp_path, "program.py")
    around = Surroundings({**program_environment(), "HOME": str(tmp_path)}, tmp_path)
    match = next(cards_in(output))
    shown = as_text(
        explain(match, scene_of(match, around, output=output, command="python3 program.py"), "en"), "en", 300
    )
    assert told in shown.replace("There", "there") and never not in shown.replace(str(tmp_path), "")


def test_the_home_folder_is_written_as_it_is_typed() -> None:
    home = "/tmp/x/home"
    assert {
        text: at_home(text, home) for text in ("cd /tmp/x/home", "nano /tmp/x/home/a.py", "/tmp/x/home2 /a/tmp/x/home")
    } == {
        "cd /tmp/x/home": "cd ~",
        "nano /tmp/x/home/a.py": "nano ~/a.py",
        "/tmp/x/home2 /a/tmp/x/home": "/tmp/x/home2 /a/tmp/x/home",
    }
    quoted = "cd '/tmp/x/home/my folder'"
    assert at_home(quoted, home) == quoted and at_home(quoted, "") == quoted and at_home("/", "/") == "/"
