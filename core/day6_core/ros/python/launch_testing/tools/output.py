"""Compares output with what is expected."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable
from typing import Any

from launch_testing._text_match import build_line_match, build_text_match, without_ansi_colours


def get_default_filtered_prefixes() -> list[str]:
    return ["pid", "rc"]


def get_default_filtered_patterns() -> list[str]:
    return []


def basic_output_filter(
    filtered_prefixes: Iterable[str] | None = None, filtered_patterns: Iterable[str] | None = None
) -> Callable[[str], str]:
    """Return a function that leaves out the lines with one of these beginnings, or that match one of these patterns.

    Without beginnings the lines of a process's number ('pid') and its exit code ('rc') are left out.
    """
    prefixes = tuple(get_default_filtered_prefixes() if filtered_prefixes is None else filtered_prefixes)
    patterns = [re.compile(each) for each in filtered_patterns or get_default_filtered_patterns()]

    def keep(line: str) -> bool:
        return not line.startswith(prefixes) and not any(pattern.match(line) for pattern in patterns)

    return lambda output: "".join(filter(keep, output.splitlines(keepends=True)))


def expected_output_from_file(path: str, encoding: str | None = None) -> list[str] | list[re.Pattern[str]]:
    """Return the lines of the file `path`.txt, or, if there is none, the patterns in the lines of `path`.regex.

    Raises RuntimeError if there is neither.
    """
    for ending in (".txt", ".regex"):
        if os.path.isfile(path + ending):
            with open(path + ending, encoding=encoding) as file:
                lines = file.read().splitlines()
            return lines if ending == ".txt" else [re.compile(line) for line in lines]
    raise RuntimeError(f"could not find output check file: {path}")


def expect_output(
    text: str | None = None,
    *,
    lines: list[str] | None = None,
    expected_text: Any = None,
    expected_lines: Any = None,
    strip_ansi_escape_sequences: bool = True,
    strict: bool = False,
) -> bool:
    """Return whether output, as a text or as lines, is as expected: see `tools.text`.

    Raises ValueError unless there is one of `text` and `lines`, and one of `expected_text` and `expected_lines`.
    """
    if (text is None) == (lines is None):
        raise ValueError("Either lines or text, but not both, must be specified")
    if (expected_text is None) == (expected_lines is None):
        raise ValueError("Either expected lines or text, but not both, must be specified")
    whole = "\n".join(lines or ()) if text is None else text
    if strip_ansi_escape_sequences:
        whole = without_ansi_colours(whole)
    if expected_text is not None:
        return build_text_match(expected_text, strict=strict)(whole) is not None
    single = whole.splitlines() if text is not None else whole.split("\n") if lines else []
    return build_line_match(expected_lines, strict=strict)(single) is not None
