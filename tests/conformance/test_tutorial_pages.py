"""The player of the official tutorials: what it reads from a page, what it types, how it judges, and the table that it wrote."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.conformance.tutorial_pages.commands import is_form, opens_window, runs_on, split
from tests.conformance.tutorial_pages.documentation import Block, Documentation, as_of_today
from tests.conformance.tutorial_pages.files import Workspace
from tests.conformance.tutorial_pages.judge import Verdict, compare
from tests.conformance.tutorial_pages.pages import pages
from tests.conformance.tutorial_pages.player import Row, is_from_home, put_right, starts_the_same, takes_arrows
from tests.conformance.tutorial_pages.table import TABLE, Table, digest

PAGE = """\
A page
======

Open a new terminal in ``ros2_ws/src`` and type:

.. code-block:: console

  ros2 run {DISTRO}_package talker

.. tabs::

  .. group-tab:: Linux

    .. code-block:: console

      mkdir a
      cd a

  .. group-tab:: Windows

    .. code-block:: console

      md a

Shown
-----

This is shown::

   hello
     you

.. include:: ../more.txt
.. literalinclude:: scripts/program.py
   :language: python
   :lines: 2-3
"""
MORE = """\
.. note::

   .. code-block:: bash

      ls
"""


@pytest.fixture
def documentation(tmp_path: Path) -> Documentation:
    """A documentation of our own with one page, in a clone."""
    for name, text in {
        "source/Tutorials/Own/Page.rst": PAGE,
        "source/Tutorials/more.txt": MORE,
        "source/Tutorials/Own/scripts/program.py": "import a\nimport b\nprint(1)\nprint(2)\n",
    }.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    person = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    for words in (["init", "-q", "-b", "own"], ["add", "."], [*person, "commit", "-q", "-m", "first"]):
        subprocess.run(["git", "-C", str(tmp_path), *words], check=True)
    return Documentation(tmp_path, "own")


@pytest.mark.process
def test_a_page_is_read_with_its_tabs_included_files_and_macros(documentation: Documentation) -> None:
    assert documentation.pages("source/Tutorials") == ["source/Tutorials/Own/Page.rst"]
    blocks = documentation.blocks("source/Tutorials/Own/Page.rst")
    assert [(block.language, block.text) for block in blocks] == [
        ("console", "ros2 run own_package talker"),
        ("console", "mkdir a\ncd a"),
        ("", "hello\n  you"),
        ("bash", "ls"),
        ("python", "import b\nprint(1)"),
    ]
    assert blocks[0].before.startswith("Open a new terminal in ``ros2_ws/src``") and blocks[0].heading == "A page"
    assert blocks[1].tab == "Linux" and blocks[2].heading == "Shown"


def test_commands_and_what_they_print_are_told_apart() -> None:
    assert split("$ ros2 topic list\n/chatter\n/rosout") == [("ros2 topic list", "/chatter\n/rosout")]
    assert split("cd a\nls b") == [("cd a", ""), ("ls b", "")]
    assert split("ros2 topic pub /a b/msg/C \\\n  '{x: 1}'") == [("ros2 topic pub /a b/msg/C '{x: 1}'", "")]
    assert split("/chatter\n/rosout") is None
    assert is_form("ros2 topic echo <topic_name>") and not is_form("cat < a > b") and not is_form("ros2 topic list")
    assert runs_on("ros2 topic echo /a") and not runs_on("ros2 topic echo /a --once")
    assert runs_on("ros2 topic pub /a b/msg/C '{z: -1.8}'") and not runs_on("ros2 topic pub --once /a b/msg/C")
    assert opens_window("rviz2 -d a.rviz") and not opens_window("sudo apt install ros-jazzy-rviz2")


@pytest.mark.parametrize(
    ("listing", "output", "verdict"),
    [
        ("Sum: 3", "Sum: 5\n", Verdict.EQUAL),
        ("[INFO] [talker]: Hello 1", "[INFO] [1700000000.123456789] [talker]: Hello 7\n", Verdict.EQUAL),
        ("/a\n...\n/z", "/a\n/b\n/z\n", Verdict.EQUAL),
        ("(... components of others here)\n/z", "/a\n/z\n", Verdict.EQUAL),
        ("/a\n/b", "/b\n/a\n", Verdict.ORDER),
        ("/a", "/a\n/b\n", Verdict.MORE),
        ("one line that\nis broken", "one line that is broken\n", Verdict.EQUAL),
        ("Result: 3", "Answer: 3\n", Verdict.DIFFERS),
        ("/a\n/b", "/a\n", Verdict.DIFFERS),
        ("id 0123456789abcdef0123456789abcdef", "id 00000000000000000000000000000000\n", Verdict.EQUAL),
    ],
)
def test_an_output_is_equal_in_kind_or_not(listing: str, output: str, verdict: Verdict) -> None:
    assert compare(listing, output, goes_on=False)[0] is verdict


def test_what_goes_on_may_say_more_than_its_page_shows() -> None:
    assert compare("Hello 1\nHello 2", "start\nHello 1\nHello 2\nHello 3\n", goes_on=True)[0] is Verdict.EQUAL
    assert compare("Hello 1\nBye", "Hello 1\nHello 2\n", goes_on=True)[0] is Verdict.DIFFERS


def test_listings_change_the_files_of_a_package(tmp_path: Path) -> None:
    folder = tmp_path / "ros2_ws/src/car"
    (folder / "car").mkdir(parents=True)
    (folder / "setup.py").write_text(
        "from setuptools import setup\n\nsetup(data_files=[\n        ('share/' + package_name, ['package.xml']),\n    ],\n"
        "    entry_points={\n        'console_scripts': [\n        ],\n    })\n"
    )
    (folder / "package.xml").write_text("<package>\n  <license>TODO</license>\n\n  <export>\n  </export>\n</package>\n")
    workspace = Workspace(tmp_path)
    workspace.write("ros2_ws/src/car/setup.py", "'drive = car.drive:main',", "entry")
    workspace.write(
        "ros2_ws/src/car/setup.py", "(os.path.join('share', package_name, 'launch'), glob('launch/*')),", "data"
    )
    workspace.write(
        "ros2_ws/src/car/setup.py",
        "(os.path.join('share', package_name, 'config'),\n   glob(os.path.join('config', '*.yaml'))),",
        "data",
    )
    workspace.write(
        "ros2_ws/src/car/package.xml", "<license>MIT</license>\n<exec_depend>rclpy</exec_depend>", "manifest"
    )
    workspace.write("ros2_ws/src/car/car/drive.py", "def main():\n    pass", "whole")
    workspace.write("ros2_ws/src/car/car/drive.py", "return 1", "before ^    pass")
    setup = (folder / "setup.py").read_text()
    assert "            'drive = car.drive:main',\n" in setup and setup.startswith("import os\nfrom glob import glob\n")
    assert "(os.path.join('share', package_name, 'launch'), glob('launch/*'))," in setup
    assert "(os.path.join('share', package_name, 'config'), glob(os.path.join('config', '*.yaml')))," in setup
    manifest = (folder / "package.xml").read_text()
    assert "<license>MIT</license>" in manifest and manifest.index("rclpy") < manifest.index("<export>")
    assert (folder / "car/drive.py").read_text() == "def main():\n    return 1\n    pass\n"


def test_lines_for_cmakelists_are_known_by_what_they_say(tmp_path: Path) -> None:
    lists = tmp_path / "ros2_ws/src/car/CMakeLists.txt"
    lists.parent.mkdir(parents=True)
    lists.write_text("project(car)\n\nament_package()\n")
    workspace = Workspace(tmp_path)
    workspace.package = "car"
    added = "add_executable(drive src/drive.cpp)\nament_target_dependencies(drive rclcpp)"
    assert workspace.heed(Block("console", added, "", "", 1, "", "")) == ["ros2_ws/src/car/CMakeLists.txt"]
    assert lists.read_text() == f"project(car)\n\n{added}\n\nament_package()\n"
    whole = "cmake_minimum_required(VERSION 3.5)\nproject(car)\n\nament_package()"
    assert workspace.heed(Block("console", whole, "", "", 1, "", ""))
    assert lists.read_text() == whole + "\n"
    assert workspace.heed(Block("console", "[INFO] [drive]: add_executable(drive)", "", "", 1, "", "")) == []


def test_a_path_that_is_there_only_from_home_is_typed_at_home(tmp_path: Path) -> None:
    (tmp_path / "ws/install").mkdir(parents=True)
    (tmp_path / "ws/install/r.rviz").write_text("")
    assert is_from_home("rviz2 -d ws/install/r.rviz", tmp_path / "ws", tmp_path)
    assert not is_from_home("rviz2 -d ws/install/r.rviz", tmp_path, tmp_path)
    assert not is_from_home("rviz2 -d install/r.rviz", tmp_path / "ws", tmp_path)
    assert not is_from_home("ros2 topic pub /a/b c/d/E '{x: 1}'", tmp_path / "ws", tmp_path)


def test_a_launch_with_other_arguments_takes_the_place_of_the_one_before() -> None:
    assert starts_the_same("ros2 launch car drive.py ", "ros2 launch car drive.py speed:=2")
    assert starts_the_same("ros2 run car drive", "ros2 run car drive")
    assert not starts_the_same("ros2 launch car drive.py", "ros2 launch car park.py")
    assert not starts_the_same("ros2 run car drive", "ros2 run car drive --ros-args -r __ns:=/a")
    assert not starts_the_same("ros2 run turtlesim turtle_teleop_key", "ros2 run turtlesim turtle_teleop_key")


def test_what_comes_of_ctrl_c_is_no_failure_of_the_program_even_where_its_beginning_is_forgotten() -> None:
    died = "[ERROR] [a-1]: process has died [pid 1, exit code -2]"
    assert Row("ros2 launch a b", 1, output=f"ready\n^C{died}", interrupted=True).by_itself == "ready\n"
    assert Row("ros2 launch a b", 1, output=died, interrupted=True, before_ctrl_c="ready\n").by_itself == "ready\n"
    assert Row("ros2 launch a b", 1, output=died).by_itself == died


def test_pages_are_found_where_a_branch_has_moved_them() -> None:
    moved = ["source/ROS/Understanding-ROS2-Nodes/Understanding-ROS2-Nodes.rst", "source/Dev/Testing/Python.rst"]
    found = pages([*moved, "source/Tutorials/Intermediate/Rosdep.rst", "source/Other/Python.rst"])
    assert [(page.path, page.chain) for page in found] == [
        (moved[0], "Beginner-CLI-Tools/Understanding-ROS2-Nodes/Understanding-ROS2-Nodes"),
        ("source/Tutorials/Intermediate/Rosdep.rst", "Intermediate/Rosdep"),
        (moved[1], "Beginner-Client-Libraries"),
    ]


def test_what_is_chance_leaves_no_mark_on_a_row() -> None:
    waits = [Row("x", 1, difference=compare("at", "wait\n" * count, goes_on=True)[1]) for count in (2, 3)]
    assert digest(waits[0]) == digest(waits[1]) != ""
    bags = [compare("Files: a", f"Files: 0_a_2026_11_25-19_02_0{second}.mcap", goes_on=False)[1] for second in (1, 2)]
    assert bags[0] == bags[1]


def test_only_what_steers_a_turtle_is_given_the_arrows() -> None:
    assert takes_arrows("ros2 run turtlesim turtle_teleop_key") and not takes_arrows("ros2 bag play subset")


def test_a_reader_puts_right_what_todays_recorder_refuses() -> None:
    refusal = "ros2: error: unrecognized arguments: /a /b\n"
    assert put_right("ros2 bag record -o x /a /b", refusal) == "ros2 bag record -o x --topics /a /b"
    assert put_right("ros2 bag record -o x /a /b", "Recording...") == put_right("ros2 topic info /a /b", refusal) == ""


def test_a_file_of_the_mirror_imports_the_interfaces_of_today(in_distribution: Callable[[str], None]) -> None:
    text = "from turtlesim.msg import Pose\nimport turtlesim.srv\n# turtlesim\n"
    in_distribution("jazzy")
    assert as_of_today(text) == text
    in_distribution("lyrical")
    assert as_of_today(text) == "from turtlesim_msgs.msg import Pose\nimport turtlesim_msgs.srv\n# turtlesim\n"


def test_a_row_that_differs_otherwise_than_before_is_noticed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def row(difference: list[str]) -> dict[str, object]:
        each = {"command": "ros2 x", "is": "output differs", "reason": "words: ours"}
        rest = [{**each, "difference": digest(Row("ros2 x", 1, difference=difference))}]
        return {**dict.fromkeys(("commands", "run", "shown"), 1), "files": 0, "windows": 0, "equal": 0, "rest": rest}

    table = Table(tmp_path / "table.json")
    first, other = row(["--- listing", "-a", "+b"]), row(["--- listing", "-a", "+c"])
    assert table.take("jazzy", {"page": first}, write=True) == 1  # new
    assert table.take("jazzy", {"page": first}, write=False) == 0
    capsys.readouterr()
    assert table.take("jazzy", {"page": other}, write=False) == 1
    assert "  * output differs" in capsys.readouterr().out


def test_the_table_counts_and_gives_each_row_a_reason() -> None:
    table = TABLE.read()
    assert {"jazzy", "lyrical"} <= table.keys()
    for branch, rows in table.items():
        for path, row in rows.items():
            assert row["equal"] <= row["shown"] <= row["commands"] >= row["run"], (branch, path)
            assert row["run"] + sum("output" not in each["is"] for each in row["rest"]) == row["commands"], (
                branch,
                path,
            )
            assert all(each["reason"] for each in row["rest"]), (branch, path)
