"""Chance that is the same in every run: `os.urandom`, and what `random` and NumPy begin with.

The module secrets stays as it is: what it makes has to be unlike anything else on the machine.
"""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import os
from collections.abc import Callable
from typing import Any

from day6_core.virtual.follow.builtin import put
from day6_core.virtual.follow.imports import when_imported

_real_urandom = os.urandom


def install(number: Callable[[], int]) -> None:
    """Have what begins from the system's random numbers begin from the process's number in its world."""
    stream = None

    def bits(k: int) -> int:
        nonlocal stream
        if stream is None:
            import _random

            stream = _random.Random(number() + 1)
        return stream.getrandbits(k)

    def urandom(size: int, /) -> bytes:
        return (
            bits(8 * size).to_bytes(size, sys.byteorder) if isinstance(size, int) and size > 0 else _real_urandom(size)
        )

    put(os, urandom=urandom)
    when_imported("random", lambda module: _follow_random(module, bits))
    when_imported("secrets", lambda module: setattr(module, "randbits", bits))  # NumPy's seed


def _follow_random(module: Any, bits: Callable[[int], int]) -> None:
    module._urandom = _real_urandom  # of SystemRandom
    original = module.Random.seed

    def seed(self: Any, a: Any = None, version: int = 2) -> None:
        original(self, bits(64) if a is None else a, version)

    module.Random.seed = seed
    module.seed = module._inst.seed
    module.seed()
