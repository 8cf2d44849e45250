"""What a submission may take."""

from __future__ import annotations

LONGEST = 3600
"""The most seconds that may be asked for."""

START_SECONDS = 20.0
"""For unpacking, and until the first scenario begins."""

BUILD_SECONDS = 40.0
ANSWER_SECONDS = 10.0
"""For somebody who has to be there: one who listens, one who answers."""

IDLE_SECONDS = 1.5
"""Seconds after which nothing more is expected once no program of the pupil's runs."""

ENDING_SECONDS = 1.0
"""For programs to end when they are asked to, and again when they are not asked."""

MOST_JOBS = 64

OVER = b'{"over": true}\n'
"""What a warden says at the end of each submission."""
