"""Tests of output for `LaunchTestService.add_output_test`, over bytes."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable
from typing import Any

OutputTest = tuple[bytes, Callable[[bytes, bytes], bytes], Callable[[bytes, Any], bool], Iterable[Any]]
"""What was written so far, how more is added to it, how an expected thing is looked for in it, and the expected things."""


def get_default_filtered_prefixes() -> list[bytes]:
    return [b"pid", b"rc"]


def get_default_filtered_patterns() -> list[bytes]:
    return []


def create_output_lines_filter(
    filtered_prefixes: Iterable[bytes] | None = None,
    filtered_patterns: Iterable[bytes] | None = None,
    filtered_rmw_implementation: str | None = None,
) -> Callable[[bytes], bytes]:
    """Return a function that leaves out the lines with one of these beginnings, or that match one of these patterns.

    The third argument names an rmw implementation whose own lines are left out; day6-tui's prints none.
    """
    prefixes = tuple(filtered_prefixes or get_default_filtered_prefixes())
    patterns = [re.compile(each) for each in filtered_patterns or get_default_filtered_patterns()]

    def keep(line: bytes) -> bool:
        return not line.startswith(prefixes) and not any(pattern.match(line) for pattern in patterns)

    return lambda output: b"".join(line for line in output.splitlines(keepends=True) if keep(line))


def create_output_lines_test(expected_lines: Iterable[bytes]) -> OutputTest:
    """Return a test: each of these is a part of some line."""
    return b"", bytes.__add__, lambda written, line: any(line in each for each in written.splitlines()), expected_lines


def create_output_regex_test(expected_patterns: Iterable[re.Pattern[bytes]]) -> OutputTest:
    """Return a test: each of these patterns is found."""

    def add(written: bytes, more: bytes) -> bytes:
        return written + more.replace(b"\r\n", b"\n")  # what is written at once may end within a line, or with one

    return b"", add, lambda written, pattern: pattern.search(written) is not None, expected_patterns


def create_output_test_from_file(output_file: str) -> OutputTest:
    """Return a test of the lines in `output_file`.txt, or else of the patterns in `output_file`.regex.

    Raises RuntimeError if there is neither.
    """
    for ending in (".txt", ".regex"):
        if os.path.isfile(output_file + ending):
            with open(output_file + ending, "rb") as file:
                lines = file.read().splitlines()
            if ending == ".txt":
                return create_output_lines_test(lines)
            return create_output_regex_test([re.compile(line) for line in lines])
    raise RuntimeError(f"could not find output check file: {output_file}")
