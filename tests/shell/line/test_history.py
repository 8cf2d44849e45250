"""What the history keeps of a command of several lines is what bash keeps of it."""

from __future__ import annotations

import errno
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from day6_core.shell.line.history import History, in_one_line

COMMANDS = [
    "for i in 1 2 3\ndo\n echo $i\ndone",
    "if true\nthen echo y; else\necho n\nfi",
    "f() {\necho f\n}",
    "g()\n{\necho do\necho then\n}",
    "case a in\na)\necho a\n;;\nesac",
    'echo "x\ny"',
    "echo a |\ncat",
    "echo a \\\nb",
    "cat <<E\nx\nE",
    "while false\ndo :\ndone",
    "( echo\necho )",
    "true &&\necho z",
    "{ echo 1\necho 2; }",
    "for i in 1\ndo if true; then\necho $i\nfi\ndone",
]


@pytest.mark.process
@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_of_several_lines_is_kept_as_bash_keeps_it(command: str, tmp_path: Path) -> None:
    bash = shutil.which("bash")
    if bash is None or os.name != "posix":
        pytest.skip("no bash to compare with")
    file = tmp_path / "history"
    environment = {**os.environ, "HISTFILE": str(file), "HISTCONTROL": "", "HISTIGNORE": ""}
    environment.pop("HISTTIMEFORMAT", None)
    subprocess.run(
        [bash, "--norc", "-i"],
        input=command + "\n",
        env=environment,
        capture_output=True,
        text=True,
        start_new_session=True,
        timeout=60,
    )
    assert in_one_line(command).rstrip("\n") == file.read_text(encoding="utf-8").rstrip("\n")


def test_a_long_function_that_is_pasted_stays_one_command_that_runs() -> None:
    body = "\n".join(f"  echo {number}" for number in range(400))
    assert in_one_line(f"f() {{\n{body}\n}}").count("; ") == 400


def test_bytes_that_are_not_utf8_are_kept_in_the_file(tmp_path: Path) -> None:
    history = History(tmp_path / "h")
    history.add("echo \udcff")
    assert (tmp_path / "h").read_bytes() == b"echo \xff\n"
    assert History(tmp_path / "h").lines == ["echo \udcff"]


def test_lines_that_a_full_disk_did_not_take_are_written_later(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(path: Path, data: bytes) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))

    history = History(tmp_path / "h")
    with monkeypatch.context() as patched:
        patched.setattr("day6_core.shell.line.history.append_private", full)
        history.add("echo one")
        history.add("echo two")
    assert history.lines == ["echo one", "echo two"] and not (tmp_path / "h").exists()
    history.add("echo three")
    assert (tmp_path / "h").read_text() == "echo one\necho two\necho three\n"
