"""The type of file paths."""

from __future__ import annotations

import os
from typing import TypeVar

FilePath = TypeVar("FilePath", str, bytes, os.PathLike)  # type: ignore[type-arg]
