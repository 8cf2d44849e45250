"""Type hashes of interfaces without a recording, known from other implementations and from ROS itself."""

from __future__ import annotations

import pytest

from day6_core.interfaces import get_interface, type_hash


@pytest.mark.parametrize(
    ("name", "known"),
    [
        ("std_msgs/msg/String", "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"),
        ("sensor_msgs/msg/JointState", "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"),
        ("example_interfaces/srv/AddTwoInts", "RIHS01_e118de6bf5eeb66a2491b5bda11202e7b68f198d6f67922cf30364858239c81a"),
    ],
)  # fmt: skip
def test_known_hashes(name: str, known: str) -> None:
    assert type_hash(get_interface(name)) == known


def test_equal_fields_in_another_package_hash_otherwise() -> None:
    ours, theirs = get_interface("example_interfaces/srv/SetBool"), get_interface("std_srvs/srv/SetBool")
    assert type_hash(ours) != type_hash(theirs)


def test_what_is_no_interface_has_no_hash() -> None:
    with pytest.raises(TypeError, match="is not the class of a message, service or action"):
        type_hash(str)
