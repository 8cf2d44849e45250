"""Helpers of this folder and of tests/tui are imported by name."""

from __future__ import annotations

import sys
from pathlib import Path

HERE = Path(__file__).parent
for folder in (HERE, HERE.parent / "tui", HERE.parent / "perf"):
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))
