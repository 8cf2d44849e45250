"""ROS_DOMAIN_ID as rcl reads it (rcl/domain_id.c): by C's `strtoul` with base 0, so also hexadecimal or octal."""

from __future__ import annotations

import re

VARIABLE = "ROS_DOMAIN_ID"
_LARGEST = 2**64 - 1
"""The largest size_t of 64-bit systems. As a domain it is rcl's "default domain"."""
_NUMBER = re.compile(r"[ \t\n\v\f\r]*([+-]?)(?:0[xX]([0-9a-fA-F]+)|(0[0-7]*)|([1-9][0-9]*))", re.ASCII)


class DomainError(RuntimeError):
    """ROS_DOMAIN_ID is not a domain id; the text is rcl's."""


def domain_from_text(text: str) -> int:
    """Return the domain id in a value of ROS_DOMAIN_ID.

    Characters after a number are ignored ("5x" is 5) and a negative number wraps around, as in C; unset or empty is 0. There is
    no upper bound: only Fast DDS has none above 232, for lack of ports; rmw_zenoh accepts any.

    Raises:
        DomainError: rcl refuses the value.
    """
    if not text:
        return 0
    found = _NUMBER.match(text)
    sign, hexadecimal, octal, decimal = found.groups() if found else ("", None, None, None)
    number = int(hexadecimal, 16) if hexadecimal else int(octal, 8) if octal else int(decimal or "0")
    if number > _LARGEST:
        raise DomainError("failed to initialize rcl: ROS_DOMAIN_ID is out of range, at /project/src/rcl/domain_id.c:53")
    if number == 0 and (found is None or found.end() != len(text)):
        raise DomainError(
            "failed to initialize rcl: ROS_DOMAIN_ID is not an integral number, at /project/src/rcl/domain_id.c:49"
        )
    if sign == "-" and number:
        number = _LARGEST + 1 - number
    return 0 if number == _LARGEST else number
