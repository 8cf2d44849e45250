"""ROS_DOMAIN_ID and the discovery range as rcl reads them."""

from __future__ import annotations

import pytest

from day6_core.graph.discovery import discovery_is_off, discovery_warning
from day6_core.graph.domain import DomainError, domain_from_text
from tests.support.folded import folded

LARGEST = 2**64 - 1


@folded(
    "text, domain",
    [
        ("", 0),
        ("0", 0),
        ("5", 5),
        ("232", 232),
        ("233", 233),
        ("+5", 5),
        (" \t5", 5),
        ("5x", 5),
        ("5 6", 5),
        ("0x1f", 31),
        ("0X1Fg", 31),
        ("010", 8),
        ("0o", None),
        ("019", 1),
        ("00", 0),
        ("-1", 1),
        ("-0", 0),
        ("-18446744073709551614", 2),
        ("18446744073709551614", 18446744073709551614),
        ("18446744073709551615", 0),
        ("-5", 18446744073709551611),
        ("x", None),
        ("0x", None),
        ("0 ", None),
        (" ", None),
        ("-", None),
        ("0x0", 0),
    ],
)
def test_a_domain_is_read_as_c_reads_it(text: str, domain: int | None) -> None:
    if domain is None:
        with pytest.raises(DomainError, match=r"ROS_DOMAIN_ID is not an integral number, at .*domain_id.c:49"):
            domain_from_text(text)
    else:
        # All bits set is rcl's word for the default domain, which -1 is as well.
        expected = 0 if text == "-1" else domain
        assert domain_from_text(text) == expected


@pytest.mark.parametrize("text", ["18446744073709551616", "0x10000000000000000", "99999999999999999999999"])
def test_a_domain_that_no_machine_can_count_is_out_of_range(text: str) -> None:
    with pytest.raises(DomainError, match=r"ROS_DOMAIN_ID is out of range, at .*domain_id.c:53"):
        domain_from_text(text)


@pytest.mark.parametrize(
    ("value", "alone", "warned"),
    [
        (None, False, False),
        ("", False, False),
        ("OFF", True, False),
        ("off", False, True),
        ("LOCALHOST", False, False),
        ("SUBNET", False, False),
        ("SYSTEM_DEFAULT", False, False),
        ("everywhere", False, True),
    ],
)
def test_a_program_may_want_to_be_alone(value: str | None, alone: bool, warned: bool) -> None:
    environment = {} if value is None else {"ROS_AUTOMATIC_DISCOVERY_RANGE": value}
    assert discovery_is_off(environment) is alone
    text = f"Invalid value '{value}' specified for 'ROS_AUTOMATIC_DISCOVERY_RANGE', assuming localhost only"
    assert discovery_warning(environment) == (text if warned else None)
