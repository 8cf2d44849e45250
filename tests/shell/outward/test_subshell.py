"""`day6-tui shell`: a real shell in which our commands are found first."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from day6_core.shell.outward import subshell

posix = pytest.mark.skipif(os.name != "posix", reason="shell scripts")


def bash(folder: Path, home: Path, line: str) -> subprocess.CompletedProcess[str]:
    """Run one line as bash would in our sub-shell of a user with this home."""
    folder.mkdir()
    env = {**subshell.environment(), "HOME": str(home)}
    rc = subshell._start_file("bash", folder, env)[1]
    return subprocess.run(["bash", "-c", f". '{rc}'; {line}"], env=env, capture_output=True, encoding="utf-8")


@pytest.mark.process
@posix
def test_our_commands_come_first_even_if_the_users_own_file_puts_others_there(tmp_path: Path) -> None:
    home, scripts = tmp_path / "home", tmp_path / "scripts"
    (home / "bin").mkdir(parents=True)
    (home / "bin" / "python3").write_text("#!/bin/sh\necho the wrong one\n")
    (home / "bin" / "python3").chmod(0o755)
    (home / ".bashrc").write_text(f'export PATH="{home}/bin:$PATH" OWN=kept\n')
    done = bash(scripts, home, "python3 -c 'import sys, rclpy; print(sys.executable)'; type -p ros2; echo $OWN")
    executable, place, kept = done.stdout.splitlines()
    assert (executable, kept) == (sys.executable, "kept"), done.stderr
    assert place == f"{subshell.environment()['PATH'].split(os.pathsep)[0]}/ros2"


@pytest.mark.process
@posix
def test_every_command_of_ours_runs(tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.urdf"
    wrong.write_text("<robot/>")
    done = bash(
        tmp_path / "scripts", tmp_path, f"ros2 pkg prefix turtlesim; check_urdf '{wrong}'; urdf_to_graphviz; true"
    )
    assert done.stdout.splitlines()[0].endswith("ros"), done.stdout
    assert "No name given for the robot" in done.stderr
    assert "command not found" not in done.stderr


@posix
def test_zsh_reads_the_users_file_and_then_ours(tmp_path: Path) -> None:
    env = {"HOME": "/home/ada", "PYTHONPATH": "/ros", "PATH": "/ours:/bin"}
    assert subshell._start_file("zsh", tmp_path, env) == ["-i"]
    assert env["ZDOTDIR"] == str(tmp_path)
    lines = (tmp_path / ".zshrc").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "[ -f /home/ada/.zshrc ] && . /home/ada/.zshrc"
    assert lines[1] == 'export PATH=/ours:"$PATH"'


@pytest.mark.process
def test_a_child_that_has_the_terminal_gets_ctrl_c_alone(tmp_path: Path) -> None:
    code = "import os, signal; os.kill(os.getppid(), signal.SIGINT); os.kill(os.getpid(), signal.SIGINT)"
    if os.name != "posix":
        pytest.skip("needs signals")
    assert subshell.call([sys.executable, "-c", code], dict(os.environ)) == 130
