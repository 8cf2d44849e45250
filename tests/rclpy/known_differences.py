"""Recorded cases that ours does not repeat, each with the reason."""

from __future__ import annotations

UNCHECKED_FIELDS: frozenset[str] = frozenset(())
"""Agreed (shared/reference/golden/README.md): the recordings show values reaching the wire that our field checks refuse."""

KNOWN: dict[str, str] = {}
