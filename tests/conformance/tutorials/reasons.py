"""Why a command does not run here, or prints something else than its page shows."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from player import Row

KNOWN: dict[str, tuple[tuple[str, str], ...]] = {}
"""By page, or '' for all: a pattern of commands and the reason, in our own words."""


def reason(page: str, row: Row) -> str:
    """Return the reason of a row, '' where there is none to be told."""
    if row.reason and row.verdict not in ("run", "window"):
        return row.reason
    for pattern, text in (*KNOWN.get(page, ()), *KNOWN.get("", ())):
        if re.search(pattern, row.command):
            return text
    return ""
