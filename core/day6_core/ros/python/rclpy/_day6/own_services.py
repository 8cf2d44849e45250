"""The services every node has: their types, without making the classes before they are used.

The hashes are those of the real interfaces; tests compare them with computed ones.
"""

from __future__ import annotations

from typing import Any

from day6_core.ros.differences import value

PARAMETER_EVENT = "rcl_interfaces/msg/ParameterEvent"
LOG = "rcl_interfaces/msg/Log"
GET_TYPE_DESCRIPTION = "type_description_interfaces/srv/GetTypeDescription"
PARAMETER_SERVICES = (
    ("describe_parameters", "rcl_interfaces/srv/DescribeParameters"),
    ("get_parameters", "rcl_interfaces/srv/GetParameters"),
    ("get_parameter_types", "rcl_interfaces/srv/GetParameterTypes"),
    ("list_parameters", "rcl_interfaces/srv/ListParameters"),
    ("set_parameters", "rcl_interfaces/srv/SetParameters"),
    ("set_parameters_atomically", "rcl_interfaces/srv/SetParametersAtomically"),
)
_HASHES = {
    "rcl_interfaces/msg/ParameterEvent": "RIHS01_043e627780fcad87a22d225bc2a037361dba713fca6a6b9f4b869a5aa0393204",
    "rcl_interfaces/msg/Log": "RIHS01_e28ce254ca8abc06abf92773b74602cdbf116ed34fbaf294fb9f81da9f318eac",
    GET_TYPE_DESCRIPTION: "RIHS01_69b9c19c1021405984cc60dbbb1edceb147a6538b411d812ba6afabeed962cd5",
    "rcl_interfaces/srv/DescribeParameters": "RIHS01_845b484d71eb0673dae682f2e3ba3c4851a65a3dcfb97bddd82c5b57e91e4cff",
    "rcl_interfaces/srv/GetParameters": "RIHS01_bf9803d5c74cf989a5de3e0c2e99444599a627c7ff75f97b8c05b01003675cbc",
    "rcl_interfaces/srv/GetParameterTypes": "RIHS01_da199c878688b3e530bdfe3ca8f74cb9fa0c303101e980a9e8f260e25e1c80ca",
    "rcl_interfaces/srv/ListParameters": "RIHS01_3e6062bfbb27bfb8730d4cef2558221f51a11646d78e7bb30a1e83afac3aad9d",
    "rcl_interfaces/srv/SetParameters": "RIHS01_56eed9a67e169f9cb6c1f987bc88f868c14a8fc9f743a263bc734c154015d7e0",
    "rcl_interfaces/srv/SetParametersAtomically": "RIHS01_0e192ef259c07fc3c07a13191d27002222e65e00ccec653ca05e856f79285fcd",
}
HASHES = _HASHES if value("messages.have_hashes") else dict.fromkeys(_HASHES, "")


def copy_any(message: Any) -> Any:
    """Copy a message; the copy function of its class is made on first use."""
    from day6_core.interfaces import copy_message

    return copy_message(message)
