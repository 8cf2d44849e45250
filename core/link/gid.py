"""GIDs: the 16 bytes that name an endpoint among all processes.

rmw_zenoh does not send them: everybody computes XXH3-128 (xxHash specification 0.2, seed 0) of an endpoint's liveliness
token, and puts the low 64 bits before the high ones, little endian.

The package xxhash was tried and taken out again: with it the desktop did not see the node of a student's process in most starts
(tests/e2e/test_students.py, three of three on an idle machine; none without it). Why is not known.
"""

from __future__ import annotations

from struct import Struct

_SECRET = bytes.fromhex(
    "b8fe6c3923a44bbe7c01812cf721ad1cded46de9839097db7240a4a4b7b3671f"
    "cb79e64eccc0e578825ad07dccff7221b8084674f743248ee03590e6813a264c"
    "3c2852bb91c300cb88d0658b1b532ea371644897a20df94e3819ef46a9deacd8"
    "a8fa763fe39c343ff9dcbbc7c70b4f1d8a51e04bcdb45931c89f7ec9d9787364"
    "eac5ac8334d3ebc3c581a0fffa1363eb170ddd51b7f0da49d316552629d4689e"
    "2b16be587d47a1fc8ff8b8d17ad031ce45cb3a8f95160428afd7fbcabb4b407e"
)
_MASK = 0xFFFFFFFFFFFFFFFF
_PRIME32_1, _PRIME32_2, _PRIME32_3 = 0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D
_PRIME64_1, _PRIME64_2, _PRIME64_3 = 0x9E3779B185EBCA87, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9
_PRIME64_4, _PRIME64_5 = 0x85EBCA77C2B2AE63, 0x27D4EB2F165667C5
_AVALANCHE = 0x165667919E3779F9
_ACCUMULATORS = (
    _PRIME32_3,
    _PRIME64_1,
    _PRIME64_2,
    _PRIME64_3,
    _PRIME64_4,
    _PRIME32_2,
    _PRIME64_5,
    _PRIME32_1,
)
_STRIPE = 64
_STRIPES_PER_BLOCK = (len(_SECRET) - _STRIPE) // 8
_BLOCK = _STRIPE * _STRIPES_PER_BLOCK

_two = Struct("<2Q").unpack_from
_eight = Struct("<8Q").unpack_from


def gid_of(token: str) -> bytes:
    """Return the 16-byte GID of the endpoint that a liveliness token (at least 17 bytes of text) announces."""
    low, high = xxh3_128(token.encode())
    return low.to_bytes(8, "little") + high.to_bytes(8, "little")


def xxh3_128(data: bytes) -> tuple[int, int]:
    """Return `(low, high)` 64 bits of XXH3-128 of at least 17 bytes; shorter data raises ValueError."""
    if len(data) < 17:
        raise ValueError(f"a token of {len(data)} bytes has no GID")
    if len(data) > 240:
        return _long(data)
    return _short(data)


def _fold(left: int, right: int) -> int:
    product = left * right
    return (product ^ (product >> 64)) & _MASK


def _avalanche(value: int) -> int:
    value = ((value ^ (value >> 37)) * _AVALANCHE) & _MASK
    return value ^ (value >> 32)


def _short(data: bytes) -> tuple[int, int]:
    length = len(data)
    low, high = (length * _PRIME64_1) & _MASK, 0

    def mix(first: int, second: int, secret: int) -> None:
        nonlocal low, high
        a, b = _two(data, first)
        c, d = _two(data, second)
        s, t = _two(_SECRET, secret)
        u, v = _two(_SECRET, secret + 16)
        low = ((low + _fold(a ^ s, b ^ t)) & _MASK) ^ ((c + d) & _MASK)
        high = ((high + _fold(c ^ u, d ^ v)) & _MASK) ^ ((a + b) & _MASK)

    if length <= 128:
        for pair in range((length - 1) // 32, -1, -1):
            mix(16 * pair, length - 16 * (pair + 1), 32 * pair)
    else:
        for start in range(0, 128, 32):
            mix(start, start + 16, start)
        low, high = _avalanche(low), _avalanche(high)
        for end in range(160, length + 1, 32):
            mix(end - 32, end - 16, 3 + end - 160)
        mix(length - 16, length - 32, 136 - 17 - 16)
    total = (low * _PRIME64_1 + high * _PRIME64_4 + length * _PRIME64_2) & _MASK
    return _avalanche((low + high) & _MASK), -_avalanche(total) & _MASK


def _long(data: bytes) -> tuple[int, int]:
    length = len(data)
    sums = list(_ACCUMULATORS)

    def accumulate(offset: int, secret: int) -> None:
        words = _eight(data, offset)
        for lane, (word, key) in enumerate(zip(words, _eight(_SECRET, secret), strict=True)):
            key ^= word
            sums[lane ^ 1] += word
            sums[lane] = (sums[lane] + (key & 0xFFFFFFFF) * (key >> 32)) & _MASK

    blocks = (length - 1) // _BLOCK
    for block in range(blocks):
        for stripe in range(_STRIPES_PER_BLOCK):
            accumulate(block * _BLOCK + stripe * _STRIPE, 8 * stripe)
        keys = _eight(_SECRET, len(_SECRET) - _STRIPE)
        for lane in range(8):
            value = sums[lane] & _MASK
            sums[lane] = ((value ^ (value >> 47) ^ keys[lane]) * _PRIME32_1) & _MASK
    for stripe in range((length - 1 - blocks * _BLOCK) // _STRIPE):
        accumulate(blocks * _BLOCK + stripe * _STRIPE, 8 * stripe)
    accumulate(length - _STRIPE, len(_SECRET) - _STRIPE - 7)

    def merge(secret: int, start: int) -> int:
        keys = _eight(_SECRET, secret)
        for lane in range(0, 8, 2):
            start += _fold((sums[lane] & _MASK) ^ keys[lane], (sums[lane + 1] & _MASK) ^ keys[lane + 1])
        return _avalanche(start & _MASK)

    low = merge(11, length * _PRIME64_1)
    high = merge(len(_SECRET) - _STRIPE - 11, ~(length * _PRIME64_2) & _MASK)
    return low, high
