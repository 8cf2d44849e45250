"""Lets the tests of this folder import their neighbours (`golden_cases`, `machine`), which are also a script's (`score.py`)."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
