"""Plays programs with our rclpy or with a real one and makes what they do comparable.

What is made equal: time stamps, addresses, paths, and everything that shows the inside of an implementation (its frames in a
traceback, the line of its warnings). What a student reads of their own program stays.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from day6_core.ros.environment import PYTHON_PATH, program_environment

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(__file__).with_name("programs")
RECORDED = Path(__file__).with_name("recorded.jsonl")
REFERENCE = Path(__file__).with_name("golden") / "rclpy_behaviour.jsonl"
SITE = "<PREFIX>/lib/python3.11/site-packages"
TIMEOUT_S = 120

_REPLACEMENTS = (
    (re.compile(r"\[\d{9,}\.\d{9}\]"), "[<TIME>]"),
    (re.compile(r"\b0x[0-9a-f]{4,}\b"), "<ADDR>"),
    (re.compile(r"Goal ID: \[[\d\s]+\]"), "Goal ID: [<UUID_BYTES>]"),
    (re.compile(r"goal ID: \[[\d\s]+\]"), "goal ID: [<UUID_BYTES>]"),
)
_FRAME = re.compile(r'  File "([^"]+)", line \d+, in ')
_INSIDE = re.compile(rf"({re.escape(SITE)}/rclpy/|<frozen)")
_WARNING = re.compile(rf"^{re.escape(SITE)}/rclpy/[\w/]+\.py:\d+: ")
_SOURCE_LINES = ("  warnings.warn(",)
_POINTERS = re.compile(r"\s*[\^~]+\s*")


@dataclass(frozen=True)
class Outcome:
    """What a program did."""

    stdout: str
    stderr: str
    exit_code: int


@dataclass(frozen=True)
class Case:
    """One program, the lines it may read, and what it did with real rclpy."""

    name: str
    code: str
    expected: Outcome
    stdin: str = ""


def reference_cases() -> list[Case]:
    """Return the programs of `golden/`."""
    entries = [json.loads(line) for line in REFERENCE.read_text(encoding="utf-8").splitlines()]
    return [
        Case(entry["name"], entry["code"], comparable(Outcome(entry["stdout"], entry["stderr"], entry["exit_code"])))
        for entry in entries
    ]


def program_cases() -> list[Case]:
    """Return the programs of `programs/` with what is recorded of them (nothing yet: an empty outcome with status -1)."""
    recorded: dict[str, Outcome] = {}
    if RECORDED.is_file():
        for line in RECORDED.read_text(encoding="utf-8").splitlines():
            entry = json.loads(line)
            name = entry.pop("name")
            recorded[name] = Outcome(**entry)
    return [
        Case(
            path.stem,
            path.read_text(encoding="utf-8"),
            recorded.get(path.stem, Outcome("", "", -1)),
            path.with_suffix(".input").read_text(encoding="utf-8") if path.with_suffix(".input").is_file() else "",
        )
        for path in sorted(PROGRAMS.glob("*.py"))
    ]


def play(case: Case, folder: Path, *, real: str | None = None, domain: int = 0, fast: bool = False) -> Outcome:
    """Run a program as a process in an empty folder, with our rclpy or that of the interpreter `real`.

    -9 after `TIMEOUT_S` seconds. A real one uses the ROS domain `domain` and checks messages, as ours does always. `fast`: in
    virtual time.
    """
    (folder / "prog.py").write_text(case.code, encoding="utf-8")
    env = dict(os.environ) if real is not None else program_environment()
    env.update(LANG="C.UTF-8", DAY6_LINK="off", PYTHONDONTWRITEBYTECODE="1")
    for name in ("COLUMNS", "RCUTILS_CONSOLE_OUTPUT_FORMAT", "ROS_PYTHON_CHECK_FIELDS"):
        env.pop(name, None)
    if real is not None:
        env.pop("PYTHONPATH", None)
        env.update(ROS_AUTOMATIC_DISCOVERY_RANGE="LOCALHOST", ROS_PYTHON_CHECK_FIELDS="1", ROS_DOMAIN_ID=str(domain))
    command = [sys.executable, "-m", "day6_tui.main", "python", "--fast"] if fast else [real or sys.executable]
    process = subprocess.Popen(
        [*command, "prog.py"],
        cwd=folder,
        env=env,
        stdin=subprocess.PIPE if case.stdin else subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        stdout, stderr = process.communicate(case.stdin or None, timeout=TIMEOUT_S)
    except subprocess.TimeoutExpired:
        process.kill()
        stdout, stderr = process.communicate()
    site = "" if real is None else str(Path(real).absolute().parents[1] / "lib" / "python3.11" / "site-packages")
    prefixes = ((str(folder) + os.sep, ""), (site or str(PYTHON_PATH), SITE), (str(ROOT), SITE))
    for path, placeholder in prefixes:
        stdout, stderr = stdout.replace(path, placeholder), stderr.replace(path, placeholder)
    return comparable(Outcome(stdout, stderr, process.returncode))


def comparable(outcome: Outcome) -> Outcome:
    """Make equal what may differ."""
    return Outcome(_even(outcome.stdout), _without_insides(_even(outcome.stderr)), outcome.exit_code)


def _even(text: str) -> str:
    for pattern, placeholder in _REPLACEMENTS:
        text = pattern.sub(placeholder, text)
    return text


def _without_insides(text: str) -> str:
    """Drop frames of the implementation, markers under source lines, and lines that show the implementation's source."""
    kept: list[str] = []
    inside = False
    for line in _without_ignored(text.splitlines()):
        frame = _FRAME.match(line)
        if frame:
            inside = bool(_INSIDE.match(frame[1]))
        elif not line.startswith("    "):
            inside = False
        if inside or _POINTERS.fullmatch(line) or line.startswith(_SOURCE_LINES):
            continue
        line = _WARNING.sub("<rclpy>: ", line)
        kept.append(line)
    return "\n".join(kept)


def _without_ignored(lines: list[str]) -> list[str]:
    """Drop what real rclpy prints when its own clean-up fails (slips, not behaviour)."""
    kept: list[str] = []
    dropping = False
    source_follows = False
    for line in lines:
        if source_follows and line.startswith("  "):
            source_follows = False
            continue
        source_follows = "RuntimeWarning: Failed to fini " in line
        if source_follows:
            continue
        if line.startswith("Exception ignored in: <function Executor.__del__"):
            dropping = True
        elif dropping and (line.startswith((" ", "Traceback")) or "_sigint_gc" in line):
            continue
        else:
            dropping = False
            kept.append(line)
    return kept
