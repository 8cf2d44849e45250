"""The assertions about output."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch_testing._text_match import build_text_match, without_ansi_colours
from launch_testing.util.proc_lookup import resolveProcesses


def assertInStream(
    proc_output: Any,
    expected_output: Any,
    process: Any,
    cmd_args: Any = None,
    *,
    output_filter: Callable[[str], str] | None = None,
    strict_proc_matching: bool = True,
    strip_ansi_escape_sequences: bool = True,
    stream: str = "stderr",
) -> None:
    """Assert that one of the processes that are meant (see `resolveProcesses`) has written something to a stream.

    `expected_output` is a text, a compiled pattern, or a list of these that follow each other; `output_filter` is applied before
    the comparison. Raises ValueError for another `stream` than 'stdout' and 'stderr', or a filter that cannot be called.
    """
    found = resolveProcesses(proc_output, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching)
    if output_filter is not None and not callable(output_filter):
        raise ValueError("output_filter is not callable")
    if stream not in ("stdout", "stderr"):
        raise ValueError("Invalid value for stream; must be 'stdout' or 'stderr'")
    match = build_text_match(expected_output)
    for each in found:
        pieces = (io.text for io in proc_output[each] if getattr(io, f"from_{stream}"))
        text = b"".join(pieces).decode(errors="replace")
        if strip_ansi_escape_sequences:
            text = without_ansi_colours(text)
        if output_filter is not None:
            text = output_filter(text)
        if match(text) is not None:
            return
    names = ", ".join(sorted(each.process_details["name"] for each in found))
    raise AssertionError(f"Did not find '{expected_output}' in output for any of the matching processes: {names}")


def assertInStdout(proc_output: Any, expected_output: Any, process: Any, cmd_args: Any = None, **options: Any) -> None:
    """Assert as `assertInStream` does, of the standard output."""
    assertInStream(proc_output, expected_output, process, cmd_args, **options, stream="stdout")


def assertInStderr(proc_output: Any, expected_output: Any, process: Any, cmd_args: Any = None, **options: Any) -> None:
    """Assert as `assertInStream` does, of the standard error."""
    assertInStream(proc_output, expected_output, process, cmd_args, **options, stream="stderr")


def assertDefaultStream() -> str:
    """Return the stream that `assertInStream` looks at by default."""
    return "stderr"
