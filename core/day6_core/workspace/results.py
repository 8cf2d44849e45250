"""`colcon test-result`: reads the xUnit files that tests left."""

from __future__ import annotations

import os
from argparse import Namespace
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.plain_xml import plain_xml
from day6_core.reason import reason
from day6_core.workspace.events import Console
from day6_core.workspace.files import BuildOutput

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

_COUNTED = {"test": "tests", "error": "errors", "failure": "failures"}
_SKIPPED = ("skip", "skipped", "disabled")


@dataclass
class TestResult:
    """The counts of one file, or of all files."""

    name: str
    tests: int = 0
    errors: int = 0
    failures: int = 0
    skipped: int = 0
    details: list[str] = field(default_factory=list)

    def __str__(self) -> str:
        counts = [
            f"{number} {word if number == 1 else word + 's'}"
            for word, number in (("test", self.tests), ("error", self.errors), ("failure", self.failures))
        ]
        return f"{self.name}: {', '.join(counts)}, {self.skipped} skipped"

    def add(self, other: TestResult) -> None:
        """Add the counts and details of another result."""
        for name in ("tests", "errors", "failures", "skipped"):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        self.details += other.details


def show_results(cwd: Path, args: Namespace, console: Console) -> int:
    """Print the results below a folder; returns 1 if there was a failure."""
    base = cwd / args.test_result_base
    if not base.is_dir():
        what = "is not a directory" if base.exists() else "does not exist"
        console.err(
            "usage: colcon test-result [-h] [--test-result-base TEST_RESULT_BASE] [--all]\n"
            "                          [--result-files-only] [--verbose] [--delete]\n"
            "                          [--delete-yes]\n"
            f"colcon test-result: error: argument --test-result-base: Path '{args.test_result_base}' {what}\n"
        )
        return 2
    results = [result for path in _files(base) if (result := _read(path, cwd, console)) is not None]
    if args.delete or args.delete_yes:
        return _delete(results, cwd, BuildOutput([base]), args, console)
    total = TestResult("Summary")
    for result in results:
        total.add(result)
    listed = [result for result in results if result.errors or result.failures or args.all]
    for result in listed:
        console.out(f"{result.name if args.result_files_only else result}\n")
        if args.verbose and not args.result_files_only:
            for detail in result.details:
                lines = detail.splitlines()
                console.out("".join(f"{'-' if not at else ' '} {line}\n" for at, line in enumerate(lines)))
    if not args.result_files_only:
        console.out(f"\n{total}\n" if listed else f"{total}\n")
    return 1 if total.errors or total.failures else 0


def _delete(results: list[TestResult], cwd: Path, output: BuildOutput, args: Namespace, console: Console) -> int:
    if not results:
        console.out("No result files found to delete\n")
        return 0
    console.out("".join(f"- {result.name}\n" for result in results))
    if not args.delete_yes:
        console.err("colcon test-result: --delete asks before it deletes, which it cannot here; use --delete-yes\n")
        return 1
    for result in results:
        output.remove(cwd / result.name)
    console.out(f"Deleted {len(results)} files\n")
    return 0


def _files(base: Path) -> list[Path]:
    found = []
    for folder, folders, files in os.walk(base):
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        found += [Path(folder, name) for name in files if name.endswith(".xml")]
    return sorted(found)


def _read(path: Path, cwd: Path, console: Console) -> TestResult | None:
    name = path.relative_to(cwd).as_posix() if cwd in path.parents else str(path)
    try:
        root = plain_xml(path.read_bytes())
    except (ValueError, OSError) as error:
        console.warn("colcon.colcon_test_result.test_result.xunit", f"Skipping '{name}': {reason(error)}")
        return None
    suites = [root] if root.tag == "testsuite" else list(root.findall("testsuite")) if root.tag == "testsuites" else []
    result = TestResult(name)
    for suite in suites:
        try:
            part = TestResult(
                "",
                int(suite.attrib["tests"]),
                int(suite.get("errors", "0")),
                int(suite.attrib["failures"]),
                sum(int(suite.get(each, "0")) for each in _SKIPPED),
                _details(suite),
            )
        except (KeyError, ValueError):
            return None
        result.add(part)
    return result if suites else None


def _details(suite: Element) -> list[str]:
    details = []
    for case in suite.iter("testcase"):
        lines = [f"{case.get('classname', '')} {case.get('name', '')}".strip()]
        for kind in ("error", "failure"):
            for node in case.findall(kind):
                message = node.get("message")
                if message:
                    lines += [f"<<< {kind} message", *(f"  {line}" for line in message.splitlines()), ">>>"]
        if len(lines) > 1:
            details.append("\n".join(lines))
    return details
