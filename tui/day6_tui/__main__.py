"""`python -m day6_tui` is `day6-tui`."""

from __future__ import annotations

import sys

from day6_tui.main import main

sys.exit(main())
