"""ROS_DOMAIN_ID as rcl reads it (rcl/domain_id.c): by C's `strtoul` with base 0, whose ways a number may be written in."""

from __future__ import annotations

import re

VARIABLE = "ROS_DOMAIN_ID"
_LARGEST = 2**64 - 1
"""A size_t of all 64-bit systems. As a domain it is rcl's word for "the default one"."""
_NUMBER = re.compile(r"[ \t\n\v\f\r]*([+-]?)(?:0[xX]([0-9a-fA-F]+)|(0[0-7]*)|([1-9][0-9]*))", re.ASCII)


class DomainError(RuntimeError):
    """ROS_DOMAIN_ID holds no domain; the text is rcl's."""


def domain_from_text(text: str) -> int:
    """Return the domain that a value of ROS_DOMAIN_ID stands for; raises DomainError for one that rcl refuses.

    What follows a number is passed over ("5x" is 5) and a negative one wraps around, as in C; unset or empty is 0. There is no
    upper bound: it is Fast DDS that has no ports for more than 232, rmw_zenoh takes any.
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
