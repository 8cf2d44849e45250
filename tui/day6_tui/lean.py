"""Imports asyncio without ssl: the desktop opens no connections with it, and OpenSSL costs the first frame 4.4 MB and 10 ms.

asyncio supports Pythons without ssl. Code that imports ssl later still gets it.
"""

from __future__ import annotations

import sys


def import_asyncio() -> None:
    """Import asyncio, without ssl unless it is imported already. Afterwards `import ssl` works as usual."""
    if "asyncio" in sys.modules or "ssl" in sys.modules:
        return
    sys.modules["ssl"] = None  # type: ignore[assignment]
    try:
        import asyncio  # noqa: F401
    finally:
        del sys.modules["ssl"]
