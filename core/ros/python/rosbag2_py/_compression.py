"""Zstandard and LZ4, through whichever library this Python has: its own (3.14), `zstandard`, `backports.zstd`, `lz4`.

Nothing here needs them to be installed: without one, bags are written and read uncompressed, and a compressed one says so.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from enum import IntEnum
from importlib import import_module
from typing import Any

Codec = Callable[[bytes], bytes]


class CompressionMode(IntEnum):
    """What is compressed: nothing, each finished file, each message."""

    NONE = 0
    FILE = 1
    MESSAGE = 2


@dataclass
class CompressionOptions:
    """How a bag is compressed; threads and queues of the real one are accepted and not needed."""

    compression_format: str = ""
    compression_mode: CompressionMode = CompressionMode.NONE
    compression_queue_size: int = 1
    compression_threads: int = 0
    compression_threads_priority: int = 0


def compression_mode_from_string(text: str) -> CompressionMode:
    """Return the mode called 'NONE', 'FILE' or 'MESSAGE'; 'NONE' for anything else."""
    return CompressionMode.__members__.get(text.upper(), CompressionMode.NONE)


def compression_mode_to_string(mode: CompressionMode) -> str:
    """Return the name of a mode."""
    return CompressionMode(mode).name


def get_registered_compressors() -> set[str]:
    """Return the formats of `--compression-format`."""
    return {"zstd"}


def zstd_codec() -> tuple[Callable[[bytes, int], bytes], Codec]:
    """Return `(compress(data, level), decompress(data))`; RuntimeError without a library for it."""
    for name in ("compression.zstd", "backports.zstd"):
        with suppress(ImportError):
            return _codec_of(import_module(name))
    try:
        library: Any = import_module("zstandard")
    except ImportError:
        raise RuntimeError("zstd compression needs a library that is not installed: pip install zstandard") from None
    compress: Callable[[bytes, int], bytes] = lambda data, level: bytes(  # noqa: E731
        library.ZstdCompressor(level=level).compress(data)
    )
    return compress, lambda data: bytes(library.ZstdDecompressor().decompressobj().decompress(data))


def _codec_of(module: Any) -> tuple[Callable[[bytes, int], bytes], Codec]:
    return (lambda data, level: bytes(module.compress(data, level))), lambda data: bytes(module.decompress(data))


def lz4_decompress() -> Codec:
    """Return what unpacks LZ4 frames; RuntimeError without a library for it."""
    try:
        library: Any = import_module("lz4.frame")
    except ImportError:
        raise RuntimeError("lz4 compression needs a library that is not installed: pip install lz4") from None
    return lambda data: bytes(library.decompress(data))


def decompress(name: str, data: bytes) -> bytes:
    """Unpack data compressed as `name` ('' is not compressed). RuntimeError for an unknown name or a missing library."""
    if not name:
        return data
    if name == "zstd":
        return zstd_codec()[1](data)
    if name == "lz4":
        return lz4_decompress()(data)
    raise RuntimeError(f"unsupported compression: {name}")
