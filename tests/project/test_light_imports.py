"""What a student's process and the command line must not load: they start on slow machines, many at a time."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from day6_core.ros.environment import program_environment

pytestmark = pytest.mark.process

HEAVY = {"numpy", "asyncio", "yaml", "textual", "rich", "zenoh", "yourdfpy", "trimesh", "scipy", "pyte", "pygments"}


def loaded(code: str) -> set[str]:
    """Return the names of all modules a fresh interpreter has after running `code`."""
    script = f"{code}\nimport sys, json\nprint(json.dumps(sorted(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, env=program_environment())
    assert done.returncode == 0, done.stderr
    return set(json.loads(done.stdout.splitlines()[-1]))


@pytest.mark.parametrize(
    "code",
    [
        "import rclpy",
        "import rclpy; from rclpy.node import Node; from std_msgs.msg import String",
        "from sensor_msgs.msg import JointState; JointState()",
        "import rclpy; rclpy.init(); n = rclpy.create_node('n')",
        "import day6_tui.main",
        "from day6_tui.commands.desktop import build_parser; build_parser()",
        "from day6_tui.commands.table import commands; [each.parser('zh') for each in commands()]",
        "from day6_tui.commands.complete import own_words; own_words(['serve', '--'])",
        "import day6_core.ros.ros2",
        "import day6_core.link",
        "import day6_urdf",
    ],
)
def test_nothing_heavy_is_imported(code: str) -> None:
    assert {name.split(".")[0] for name in loaded(code)} & HEAVY == set()


@pytest.mark.skipif(sys.platform == "win32", reason="a process cannot become another one there")
def test_a_program_of_a_user_waits_for_no_parser_and_no_texts_of_the_command_line() -> None:
    code = (
        "import os\nfrom day6_tui.main import main\ndef become(*words): raise SystemExit\nos.execve = become\n"
        "try: main(['python', 'file.py', '--lang', 'zh'])\nexcept SystemExit: pass"
    )
    found = loaded(code)
    assert "day6_core.shell.outward.python_file" in found
    assert not {"argparse", "gettext"} & (found - loaded("pass"))
    assert not {name for name in found if name.startswith(("day6_core.command_line", "day6_core.session.s"))}


def test_import_rclpy_stays_small() -> None:
    bare, ours = loaded("pass"), loaded("import rclpy")
    assert len(ours - bare) < 180, sorted(ours - bare)


def test_a_talker_on_the_link_waits_for_nothing_it_does_not_need(short_folder: Path) -> None:
    code = (
        f"import os; os.environ |= {{'DAY6_LINK': 'on', 'DAY6_RUNTIME_DIR': {str(short_folder)!r}}}\n"
        "import rclpy\nfrom std_msgs.msg import String\nrclpy.init()\nnode = rclpy.create_node('talker')\n"
        "node.create_publisher(String, 'chatter', 10).publish(String())"
    )
    ours = loaded(code) - loaded("pass")
    assert "day6_core.link.announcing" in ours
    other_machines = {"socket", "day6_core.link.gateway", "day6_core.link.state", "day6_core.link.classroom.part"}
    assert not ours & {"inspect", "logging", "traceback", *other_machines}


def test_a_talker_runs_beside_files_with_our_folders_names(tmp_path: Path) -> None:
    for name in ("core.py", "tui.py", "urdf.py", "day6.py", "graph.py", "session.py"):
        (tmp_path / name).write_text("raise SystemExit('the wrong module was imported: ' + __name__)\n")
    package = tmp_path / "day6"
    package.mkdir()
    (package / "__init__.py").write_text("raise SystemExit('the wrong package was imported')\n")
    (tmp_path / "talker.py").write_text(
        "import rclpy\n"
        "from rclpy.node import Node\n"
        "from std_msgs.msg import String\n"
        "rclpy.init()\n"
        "node = Node('day6_talker')\n"
        "heard = []\n"
        "node.create_subscription(String, 'chatter', heard.append, 10)\n"
        "node.create_publisher(String, 'chatter', 10).publish(String(data='Hello from Day 6'))\n"
        "rclpy.spin_once(node, timeout_sec=5)\n"
        "print(heard)\n"
        "rclpy.shutdown()\n"
    )
    done = subprocess.run(
        [sys.executable, "talker.py"], cwd=tmp_path, capture_output=True, text=True, env=program_environment()
    )
    assert done.stdout == "[std_msgs.msg.String(data='Hello from Day 6')]\n", done.stderr


def test_a_terminal_does_without_other_tables_of_widths() -> None:
    code = "from day6_core.shell.screen.screen import Screen; s = Screen(9, 2); s.feed('a海'); assert s.cursor.x == 3"
    assert "wcwidth" not in loaded(code)
