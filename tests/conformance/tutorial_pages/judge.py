"""Whether two outputs are equal in kind: the same lines once numbers, times, paths and ids are masked.

What a page shows is an extract: `...` stands for any lines, a program that goes on may say more. The order counts but where it is
chance (several programs in one terminal), and then the same lines in another order are told apart from equal ones.
"""

from __future__ import annotations

import difflib
import re
from enum import Enum
from pathlib import Path

_MASKS: tuple[tuple[re.Pattern[str], str], ...] = tuple(
    (re.compile(pattern), shown)
    for pattern, shown in (
        (r"\x1b\[[0-9;?]*[ -/]*[@-~]", ""),
        (r"\x1b\][^\x07]*\x07", ""),
        (r"[\r\x00-\x08]", ""),
        (r"^\$ ", ""),
        (r"\x1b.", ""),
        (r"rosbag2_\d{4}_\d\d_\d\d-\d\d_\d\d_\d\d(_\d+)?", "<BAG>"),
        (r"(?<=_)\d{4}_\d\d_\d\d-\d\d_\d\d_\d\d", "<TIME>"),
        (r"(?<=frames_)\d{4}-\d\d-\d\d_\d\d\.\d\d\.\d\d", "<TIME>"),
        (re.escape(str(Path(__file__).parents[3] / "core" / "day6_core" / "ros")), "<PREFIX>"),
        (r"\d{4}-\d\d-\d\d-\d\d-\d\d-\d\d-\d{6}-[\w.-]+-\d+", "<LOG>"),
        (r"(?:/home/[\w.-]+|~|/tmp/[\w.-]+(?:/home)?)(?=/|\b|$)", "<HOME>"),
        (r"(?:[0-9a-f]{1,2}[:.]){7,}[0-9a-f]{1,2}", "<ID>"),
        (r"RIHS01_[0-9a-f]{64}", "<HASH>"),
        (r"\b[0-9a-f]{32}\b|\b[0-9a-f]{8}(?:-[0-9a-f]{4}){3}-[0-9a-f]{12}\b", "<ID>"),
        (r"(?:_ros2cli|launch_ros|_ros2cli_daemon)_\w+", "<NODE>"),
        (r"0x[0-9a-fA-F]+", "<ADDRESS>"),
        (r"\[(DEBUG|INFO|WARN|ERROR|FATAL)\] ?(?:\[\d+\.\d+\] ?)?", r"[\1] "),
        (r"\[([\w./]+)\]: ", r"[\1]: "),
        (r"\b(?:Mon|Tue|Wed|Thu|Fri|Sat|Sun|Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec)\b", "<DAY>"),
        (r"-?\b\d+(?:\.\d+)?(?:e[+-]?\d+)?(?=\b|s\b|ms\b|KB|MB|Ki|Mi)", "N"),
        (r"-?\bN\b", "N"),
        (r"(?:N[,;] ?)+N\b", "N…"),
        (r"<n>", "N"),
        (r"^maintainer: .*", "maintainer: …"),
        (r"\s+", " "),
    )
)
_ANY = re.compile(r"^(?:<HOME>)?\s*(?:\.\.\.+|…|# ?\.\.\.+|# etc\.|\[\.\.\.\]|\(\.\.\. .*\))\s*$")


class Verdict(str, Enum):
    """How an output compares with a listing."""

    EQUAL = "equal"
    ORDER = "equal but for the order"
    MORE = "equal, and more"
    DIFFERS = "differs"


def masked(text: str, home: str = "") -> list[str]:
    """Return the lines of a text with what is chance masked; empty ones are left out."""
    if home:
        text = text.replace(home, "~")
    lines = []
    for line in text.splitlines():
        for pattern, shown in _MASKS:
            line = pattern.sub(shown, line)
        if line.strip():
            lines.append(line.strip())
    return lines


def compare(listing: str, output: str, *, goes_on: bool, home: str = "") -> tuple[Verdict, list[str]]:
    """Return how an output compares with a listing, and the difference as lines.

    `goes_on`: of a program that has not ended the listing is an extract by nature.
    """
    wanted, have = masked(listing), masked(output, home)
    extract = goes_on or any(_ANY.match(line) for line in wanted)
    wanted = [line for line in wanted if not _ANY.match(line)]
    if _within(wanted, have):
        return (Verdict.EQUAL if extract or set(have) <= set(wanted) else Verdict.MORE), _difference(wanted, have)
    if set(wanted) <= set(have):
        return Verdict.ORDER, _difference(wanted, have)
    if " ".join(wanted) in " ".join(have):  # the page breaks long lines
        return Verdict.EQUAL, _difference(wanted, have)
    return Verdict.DIFFERS, _difference(wanted, have)


def _within(wanted: list[str], have: list[str]) -> bool:
    """Say whether the lines come in this order, others between them; a repeated line may come less often."""
    rest = iter(have)
    before = ""
    for line in wanted:
        if line == before:
            continue
        if line not in rest:
            return False
        before = line
    return True


def _difference(wanted: list[str], have: list[str]) -> list[str]:
    return list(difflib.unified_diff(wanted[:80], have[:80], "listing", "here", lineterm="", n=1))
