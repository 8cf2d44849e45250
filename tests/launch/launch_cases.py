"""Plays recorded launches of the real `ros2 launch` with ours and makes both outcomes comparable.

A case is a folder of files with the words after `ros2 launch`, run where the package `lab` beside this file is installed. Made
equal are numbers of processes, folders, stamps and addresses; lines of different processes may come in another order.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
RECORDED = HERE / "recorded.jsonl"
LAB = HERE / "lab"
PATIENCE = 300.0
"""Seconds after which a launch that does not end is killed."""


@dataclass(frozen=True)
class Outcome:
    """What a launch wrote and left behind. `log`: the files of its log folder."""

    stdout: str
    stderr: str
    exit_code: int
    log: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Case:
    """One launch. `interrupt`: Ctrl-C comes when the output has this text. `log`: its log files are compared too."""

    name: str
    files: Mapping[str, str]
    argv: Sequence[str] = ("main.launch.py",)
    interrupt: str = ""
    log: bool = False
    expected: Outcome | None = None


def load_cases() -> list[Case]:
    """Read what was recorded."""
    return [_case(json.loads(line)) for line in RECORDED.read_text(encoding="utf-8").splitlines()]


def _case(entry: dict[str, Any]) -> Case:
    expected = entry.pop("expected")
    return Case(**entry, expected=Outcome(**expected))


def play(case: Case, folder: Path, command: Sequence[str], environment: Mapping[str, str]) -> Outcome:
    """Run `command launch ARGV…` in a new folder, and return its outcome, comparable."""
    here, logs = folder / "here", folder / "log"
    for name, text in case.files.items():
        path = here / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    prefix = folder / "install"
    shutil.copytree(LAB, prefix)
    prefixes = os.pathsep.join(filter(None, (str(prefix), environment.get("AMENT_PREFIX_PATH"))))
    env = {**environment, "AMENT_PREFIX_PATH": prefixes, "ROS_LOG_DIR": str(logs), "COLUMNS": "80", "LANG": "C.UTF-8"}
    env.pop("PYTHONUNBUFFERED", None)  # with it, what is printed comes in two pieces
    process = subprocess.Popen(
        [*command, "launch", *case.argv],
        cwd=here,
        env=env,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    limit = threading.Timer(PATIENCE, os.killpg, (process.pid, signal.SIGKILL))  # only against a launch that never ends
    limit.start()
    errors: list[bytes] = []
    assert process.stdout is not None and process.stderr is not None
    reader = threading.Thread(target=lambda: errors.append(process.stderr.read()), daemon=True)
    reader.start()
    lines = []
    waiting = case.interrupt
    for line in process.stdout:
        lines.append(line)
        if waiting and waiting in line.decode("utf-8", "replace"):
            process.send_signal(signal.SIGINT)
            waiting = ""
    code = process.wait()
    limit.cancel()
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)  # after an exception the real launch leaves processes behind
    reader.join()
    log = {}
    if case.log:
        folders = [each for each in logs.iterdir() if not each.is_symlink()]
        log = {path.name: path.read_text(encoding="utf-8") for path in sorted(folders[0].iterdir())}

    def even(text: str) -> str:
        return comparable(text, folder)

    texts = (b"".join(lines).decode("utf-8", "replace"), b"".join(errors).decode("utf-8", "replace"))
    return Outcome(even(texts[0]), _told(even(texts[1])), code, {name: even(text) for name, text in log.items()})


_MASKS = (
    (re.compile(r"pid \[?\d+\]?"), "pid <PID>"),
    (re.compile(r"(<LOG>|log files can be found below) ?\S+"), "<LOG>"),
    (re.compile(r"\b\d{10}\.\d{7,9}\b"), "<TIME>"),
    (re.compile(r"\b0x[0-9a-f]{4,}\b"), "<ADDR>"),
    (re.compile(r"/\S*/launch_params_\w+"), "<PARAMETERS>"),
    (re.compile(r"launch_ros_\d+"), "launch_ros_<PID>"),
    (re.compile(r"\(/[^)\n]+/(launch\w*/\S+\.py)\)"), r"(<SITE>/\1)"),
    # The other prefixes of this machine
    (re.compile(r"(searching: \['<PREFIX>')(, '[^']+')*"), r"\1, …"),
)
_TAG = re.compile(r"^(?:<TIME> )?(\[[A-Z]+\] )?\[([^\]]+)\]")
_FRAMES = re.compile(r"Traceback \(most recent call last\):\n(?: .*\n)+")
_WARNING = re.compile(r"(?m)^.*: \w+Warning: .*\n(?:[ \t].*\n)*")


def comparable(text: str, folder: Path) -> str:
    """Replace what differs from run to run."""
    text = text.replace(str(folder / "install"), "<PREFIX>").replace(str(folder / "here"), "<HERE>")
    text = text.replace(str(folder / "log"), "<LOG>")
    for pattern, token in _MASKS:
        text = pattern.sub(token, text)
    text = re.sub(r"(?m)(^\t\* \w+\n)+", lambda wanted: "".join(sorted(set(wanted[0].splitlines(True)))), text)
    return _FRAMES.sub("", text)


def _told(text: str) -> str:
    """Return what standard error says without warnings, and of an exception of `ros2` itself the last line."""
    text = _WARNING.sub("", text)
    if re.match(r"[\w.]+(Error|Exception)\b", text):
        return text.rstrip("\n").rpartition("\n")[2] + "\n"
    return text


def by_source(text: str) -> dict[str, list[str]]:
    """Return the lines of each process and about it, and of each logger; a line without a tag belongs to the one before it."""
    found: dict[str, list[str]] = {}
    source = ""
    for line in text.splitlines():
        tag = _TAG.match(line)
        source = f"{'about' if tag[1] else 'of'} {tag[2]}" if tag else source
        lines = found.setdefault(source, [])
        if source.startswith("of ") and (not line or lines[-1:] == [line]):
            continue  # at a process's end the real launch may write its last line once more, and an empty one
        lines.append(line)
    return found


def differences(expected: Outcome, actual: Outcome) -> str:
    """Return what differs, '' if nothing does."""
    found = []
    if expected.exit_code != actual.exit_code:
        found.append(f"exit code {actual.exit_code}, recorded {expected.exit_code}")
    streams = {"stdout": (expected.stdout, actual.stdout), "stderr": (expected.stderr, actual.stderr)}
    for name in sorted({*expected.log, *actual.log}):
        streams[name] = (expected.log.get(name, "(none)"), actual.log.get(name, "(none)"))
    for name, (want, have) in streams.items():
        if by_source(want) != by_source(have):
            found.append(_diff(name, want, have))
    return "\n".join(found)


def _diff(name: str, want: str, have: str) -> str:
    import difflib

    return "\n".join(
        difflib.unified_diff(want.splitlines(), have.splitlines(), f"recorded {name}", f"our {name}", lineterm="", n=1)
    )


def our_command() -> tuple[list[str], dict[str, str]]:
    """Return `ros2` of ours as a command of the real terminal, and its environment."""
    env = {
        key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "AMENT_PREFIX_PATH", "DAY6_LINK")
    }
    code = "import sys; from day6_tui.main import main; sys.exit(main())"
    return [sys.executable, "-c", code, "ros2"], env
