"""`python -m day6_tui` is `day6-tui`."""

from __future__ import annotations

import sys

from day6_tui.main import main

if __name__ == "__main__":
    sys.exit(main())
