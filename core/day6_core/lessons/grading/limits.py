"""What a submission may take, unless `day6-tui grade` is given other limits."""

from __future__ import annotations

SECONDS = 60.0
LONGEST = 3600
"""The most seconds that may be asked for."""

MOST_JOBS = 64
