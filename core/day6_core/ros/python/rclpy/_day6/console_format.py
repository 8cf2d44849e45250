"""Expands the `{tokens}` of RCUTILS_CONSOLE_OUTPUT_FORMAT."""

from __future__ import annotations

import re
import time

from rclpy._day6.logging_settings import NAMES

_TOKEN = re.compile(r"\{(\w+)\}")
_ESCAPES = {r"\a": "\a", r"\b": "\b", r"\n": "\n", r"\r": "\r", r"\t": "\t"}
_ESCAPE = re.compile(r"\\[abnrt]")


def expand(form: str, severity: int, name: str, message: str, function: str, file: str, line: int, stamp: int) -> str:
    """Return a console line in the format `form`; unknown tokens stay as they are. `stamp` is in epoch nanoseconds."""
    seconds, rest = divmod(stamp, 1_000_000_000)

    def value(match: re.Match[str]) -> str:
        token = match[1]
        if token == "severity":
            return NAMES[severity]
        if token == "name":
            return name
        if token == "message":
            return message
        if token == "function_name":
            return function
        if token == "file_name":
            return file
        if token == "line_number":
            return str(line)
        if token == "time":
            return f"{seconds}.{rest:09}"
        if token == "time_as_nanoseconds":
            return str(stamp)
        if token == "date_time_with_ms":
            return time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(seconds)) + f".{rest // 1_000_000:03}"
        return match[0]

    return _TOKEN.sub(value, _ESCAPE.sub(lambda match: _ESCAPES[match[0]], form))
