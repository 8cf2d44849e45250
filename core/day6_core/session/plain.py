"""What programs printed, as a person reads it: without what only a terminal understands."""

from __future__ import annotations

import re

_SEQUENCE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|\][^\x07\x1b]*(?:\x07|\x1b\\)?|[@-Z\\^_=>()#][0-9A-Z]?)")
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")


def without_sequences(text: str) -> str:
    """`text` without colours, movements of the cursor and other sequences, and with plain line ends."""
    return _SEQUENCE.sub("", text).replace("\r\n", "\n")


def plain(text: str) -> str:
    """`text` without sequences and without any control character but tab and newline."""
    return _CONTROL.sub("", without_sequences(text)).replace("\r", "")
