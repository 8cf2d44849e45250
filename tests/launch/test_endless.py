"""Launch files that never end: what the real launch (ros2/launch, December 2024, run as it is) says of them, or a signal.

An XML or YAML file that includes itself does not end in the real one (quadratic reading), which answers Ctrl-C only.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.waiting import communicate

pytestmark = pytest.mark.process

PYTHON = "from launch import *\nfrom launch.actions import *\nfrom launch.event_handler import EventHandler\n"
PYTHON += "from launch.substitutions import *\nimport time\n"
SAY = "print('begun', flush=True)\n"


def described(*lines: str) -> str:
    return PYTHON + "\n".join(lines) + "\n"


RECURSIVE = {
    "self.launch.py": described(
        "def generate_launch_description(): return LaunchDescription([IncludeLaunchDescription(__file__)])"
    ),
    "self.launch.xml": '<launch><include file="{folder}/self.launch.xml"/></launch>',
    "self.launch.yaml": "launch:\n- include:\n    file: {folder}/self.launch.yaml\n",
    "one.launch.xml": '<launch><include file="{folder}/other.launch.xml"/></launch>',
    "opaque.launch.py": described(
        "def again(context): return [OpaqueFunction(function=again)]",
        "def generate_launch_description(): return LaunchDescription([OpaqueFunction(function=again)])",
    ),
    "substitution.launch.py": described(
        "class Self(Substitution):",
        "    def perform(self, context): return context.perform_substitution(self)",
        "def generate_launch_description(): return LaunchDescription([LogInfo(msg=Self())])",
    ),
}
ENDLESS = {
    "sleeps.launch.py": described("def generate_launch_description():", f"    {SAY.strip()}", "    time.sleep(999)"),
    "spins.launch.py": described("def generate_launch_description():", f"    {SAY.strip()}", "    while True: pass"),
    "events.launch.py": described(
        "class Again(Event): name = 'again'",
        "def generate_launch_description():",
        f"    {SAY.strip()}",
        "    handler = EventHandler(matcher=lambda e: isinstance(e, Again), entities=[EmitEvent(event=Again())])",
        "    return LaunchDescription([RegisterEventHandler(handler), EmitEvent(event=Again())])",
    ),
    "timers.launch.py": described(
        "def again(context): return [TimerAction(period=0.0, actions=[OpaqueFunction(function=again)])]",
        "def generate_launch_description():",
        f"    {SAY.strip()}",
        "    return LaunchDescription([OpaqueFunction(function=again)])",
    ),
    "command.launch.py": described(
        "def generate_launch_description():",
        f"    {SAY.strip()}",
        "    return LaunchDescription([LogInfo(msg=Command('sleep 999'))])",
    ),
}
UNENDING_EVENTS = 1
"""The status where only events are left, that lead to events for ever; the real one has to be killed."""


def start(folder: Path, name: str, text: str) -> subprocess.Popen[str]:
    (folder / name).write_text(text.replace("{folder}", str(folder)), encoding="utf-8")
    return subprocess.Popen(
        [sys.executable, "-m", "day6_tui.main", "ros2", "launch", str(folder / name)],
        env={**os.environ, "DAY6_LINK": "off", "ROS_LOG_DIR": str(folder / "log")},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        encoding="utf-8",
        start_new_session=os.name == "posix",
    )


@pytest.mark.parametrize("name", RECURSIVE)
def test_a_launch_file_that_leads_to_itself_ends_with_what_python_says_of_it(name: str, tmp_path: Path) -> None:
    (tmp_path / "other.launch.xml").write_text(
        f'<launch><include file="{tmp_path}/one.launch.xml"/></launch>', encoding="utf-8"
    )
    launch = start(tmp_path, name, RECURSIVE[name])
    try:
        said, _ = communicate(launch)
    finally:
        launch.kill()
    assert launch.returncode == 1
    assert "[ERROR] [launch]: Caught exception in launch (see debug for traceback): " in said
    assert "maximum recursion depth exceeded" in said
    assert "Traceback" not in said


@pytest.mark.skipif(os.name != "posix", reason="the signals of Unix")
@pytest.mark.parametrize("name", ENDLESS)
@pytest.mark.parametrize("signalled", ["SIGINT", "SIGTERM"])
def test_a_launch_file_that_never_ends_hears_signals(name: str, signalled: str, tmp_path: Path) -> None:
    launch = start(tmp_path, name, ENDLESS[name])
    assert launch.stdout is not None
    try:
        while launch.stdout.readline() != "begun\n":
            pass
        launch.send_signal(getattr(signal, signalled))
        said, _ = communicate(launch)
    finally:
        launch.kill()
    if signalled == "SIGTERM":
        assert (launch.returncode, "run task was canceled" in said) == (1, True)
    else:
        assert "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)" in said
        assert launch.returncode == (UNENDING_EVENTS if name.startswith("events") else 0)
    assert "Traceback" not in said
