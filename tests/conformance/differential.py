"""Runs the programs of `programs/` with our rclpy and shows where they do something else than with a real one.

    python -m tests.conformance.differential [--real PATH-TO-PYTHON] [--record] [NAME…]

Without `--real` what is recorded in recorded.jsonl is compared with; with it the programs run on that rclpy too (`--record`:
and what they do is written down, for the tests). A NAME is the beginning of programs' names.
"""

from __future__ import annotations

import argparse
import difflib
import json
import tempfile
from dataclasses import asdict
from pathlib import Path

from tests.conformance.played import RECORDED, Case, Outcome, play, program_cases

_DOMAINS = range(20, 100)


def difference(expected: Outcome, found: Outcome) -> list[str]:
    """Return what differs as the lines of a diff, none if nothing does."""
    lines: list[str] = []
    if expected.exit_code != found.exit_code:
        lines.append(f"exit status {expected.exit_code}, ours {found.exit_code}")
    for name in ("stdout", "stderr"):
        one, other = getattr(expected, name).splitlines(), getattr(found, name).splitlines()
        lines += difflib.unified_diff(one, other, f"{name} of real rclpy", f"{name} of ours", lineterm="", n=1)
    return lines


def write(cases: list[Case]) -> None:
    """Write down what the programs did."""
    lines = [json.dumps({"name": case.name, **asdict(case.expected)}, ensure_ascii=False) for case in cases]
    RECORDED.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")


def main() -> int:
    """Print the differences; the status says whether there are any."""
    parser = argparse.ArgumentParser(description="Compares what programs do with our rclpy and with a real one.")
    parser.add_argument("--real", help="a Python interpreter that can import a real rclpy")
    parser.add_argument("--record", action="store_true", help="write down what the real one does")
    parser.add_argument("names", nargs="*", help="beginnings of names of programs (default: all)")
    chosen = parser.parse_args()
    cases = program_cases()
    different = played = 0
    for number, case in enumerate(cases):
        if chosen.names and not case.name.startswith(tuple(chosen.names)):
            continue
        played += 1
        with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as other:
            if chosen.real:
                domain = _DOMAINS[number % len(_DOMAINS)]
                case = Case(case.name, case.code, play(case, Path(one), real=chosen.real, domain=domain), case.stdin)
                cases[number] = case
            lines = difference(case.expected, play(case, Path(other)))
        print(f"{'!=' if lines else '=='} {case.name}", *lines, sep="\n   ", flush=True)
        different += bool(lines)
    if chosen.record and chosen.real:
        write(cases)
    print(f"{played - different} of {played} programs do the same")
    return bool(different)


if __name__ == "__main__":
    raise SystemExit(main())
