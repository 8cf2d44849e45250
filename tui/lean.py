"""Imports asyncio without ssl: the desktop opens no connections by it, and OpenSSL costs the first frame 4.4 MB and 10 ms.

asyncio itself is written for Pythons that have no ssl. Whoever imports ssl later gets it.
"""

from __future__ import annotations

import sys


def import_asyncio() -> None:
    """Import asyncio, without ssl unless somebody has it already. Afterwards `import ssl` works as ever."""
    if "asyncio" in sys.modules or "ssl" in sys.modules:
        return
    sys.modules["ssl"] = None  # type: ignore[assignment]
    try:
        import asyncio  # noqa: F401
    finally:
        del sys.modules["ssl"]
