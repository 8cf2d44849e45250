"""Compression of whole bag files or of each message, by Zstandard. MCAP's chunks are compressed by the mcap library."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import zstandard


class CompressionMode(IntEnum):
    """The unit of compression: none, each finished file, each message."""

    NONE = 0
    FILE = 1
    MESSAGE = 2


@dataclass
class CompressionOptions:
    """How a bag is compressed; the real one's threads and queues are accepted and ignored."""

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


def zstd_compress(data: bytes, level: int) -> bytes:
    """Compress data as one Zstandard frame."""
    return zstandard.ZstdCompressor(level=level).compress(data)


def decompress(name: str, data: bytes) -> bytes:
    """Decompress data; `name` is the format ('': not compressed).

    Raises:
        RuntimeError: the name is unknown, or the data are damaged.
    """
    if not name:
        return data
    if name == "zstd":
        try:
            return zstandard.ZstdDecompressor().decompressobj().decompress(data)
        except zstandard.ZstdError as error:
            raise RuntimeError(f"zstd: {error}") from None
    raise RuntimeError(f"unsupported compression: {name}")
