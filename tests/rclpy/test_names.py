"""Every public name of real rclpy 9.1.2 (Kilted) is here, with the same arguments; recorded in names.json."""

from __future__ import annotations

import importlib
import inspect
import json
import sys
import warnings
from operator import attrgetter

import pytest

from day6_core.ros.differences import RCLPY
from rclpy import qos
from rclpy.clock_type import ClockType
from rclpy.duration import Duration
from rclpy.signals import SignalHandlerOptions
from tests.conformance.names import RECORDED, Table, collect, differences

_INSTANCE_ATTRIBUTES = [
    "rclpy.lifecycle.publisher.LifecyclePublisher.event_handlers",
    "rclpy.publisher.Publisher.event_handlers",
    "rclpy.service.Service.srv_type",
    "rclpy.subscription.Subscription.event_handlers",
    "rclpy.timer.Timer.callback",
]
"""Properties here, attributes of the objects in real rclpy: programs cannot tell."""


_NEWER_ARGUMENTS = [
    "rclpy.action.server.ActionServer.__init__",
    *(f"rclpy.action.server.ServerGoalHandle.{name}" for name in ("abort", "canceled", "succeed")),
]
"""Have what Lyrical has, and refuse it before (`action.execute_callback_is_optional`)."""


@pytest.fixture(scope="module")
def recorded() -> Table:
    table: Table = json.loads(RECORDED.read_text(encoding="utf-8"))
    return table


def test_nothing_of_real_rclpys_names_is_missing(recorded: Table) -> None:
    assert len(recorded) > 55
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert sorted(line.partition("(")[0] for line in differences(recorded)) == _NEWER_ARGUMENTS


def test_a_lost_name_and_a_changed_argument_are_noticed(recorded: Table) -> None:
    wanted = {"rclpy": dict(recorded["rclpy"], no_such_name={"kind": "function", "arguments": []})}
    wanted["rclpy"]["spin"] = {"kind": "function", "arguments": ["node"]}
    assert sorted(line.split(" ")[0].split("(")[0] for line in differences(wanted)) == [
        "rclpy.no_such_name:",
        "rclpy.spin",
    ]


def test_what_is_ours_alone_begins_with_an_underscore(recorded: Table) -> None:
    """Otherwise a program could use it here and miss it on the robot."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        own = collect()
    extra: list[str] = []
    for module, names in own.items():
        for name, each in names.items():
            known = recorded.get(module, {}).get(name)
            if known is None and getattr(getattr(sys.modules[module], name), "__module__", "") == module:
                extra.append(f"{module}.{name}")
            if known is not None and "members" in known:
                members = (member for member in each.get("members", ()) if not member.startswith("__"))
                extra += [f"{module}.{name}.{member}" for member in members if member not in known["members"]]
    newer = {key.rpartition(".")[2] for key, (there, _) in RCLPY.items() if "kilted" not in there}
    newer.add("TimeSourceChangedError")  # AsyncNode's
    theirs = ("rclpy.experimental.async_", "rclpy.endpoint_info.")
    known = [name for name in extra if name.rpartition(".")[2] not in newer and not name.startswith(theirs)]
    assert sorted(known) == _INSTANCE_ATTRIBUTES


def test_names_of_pythons_library_are_found_where_editors_take_them_from() -> None:
    import threading
    import time
    import typing

    import rclpy.executors
    import rclpy.node

    assert rclpy.Union is typing.Union
    assert rclpy.node.Optional is typing.Optional
    assert rclpy.executors.Lock is threading.Lock
    assert rclpy.node.time is time
    with pytest.raises(AttributeError, match=r"module 'rclpy\.node' has no attribute 'Lock'"):
        _ = rclpy.node.Lock


DEFAULTS = {
    "rclpy:create_node": {"rosout_qos_profile": qos.qos_profile_rosout_default},
    "rclpy:install_signal_handlers": {"options": SignalHandlerOptions.ALL},
    "rclpy.action:ActionClient": {
        "goal_service_qos_profile": qos.qos_profile_services_default,
        "result_service_qos_profile": qos.qos_profile_services_default,
        "cancel_service_qos_profile": qos.qos_profile_services_default,
        "feedback_sub_qos_profile": qos.QoSProfile(depth=10),
        "status_sub_qos_profile": qos.qos_profile_action_status_default,
    },
    "rclpy.action:ActionServer": {
        "goal_service_qos_profile": qos.qos_profile_services_default,
        "result_service_qos_profile": qos.qos_profile_services_default,
        "cancel_service_qos_profile": qos.qos_profile_services_default,
        "feedback_pub_qos_profile": qos.QoSProfile(depth=10),
        "status_pub_qos_profile": qos.qos_profile_action_status_default,
        "result_timeout": 10,
    },
    "rclpy.node:Node.create_client": {"qos_profile": qos.qos_profile_services_default},
    "rclpy.node:Node.create_service": {"qos_profile": qos.qos_profile_services_default},
    "rclpy.parameter_client:AsyncParameterClient": {"qos_profile": qos.qos_profile_services_default},
    "rclpy.parameter_event_handler:ParameterEventHandler": {"qos_profile": qos.qos_profile_parameter_events},
    "rclpy.publisher:Publisher.wait_for_all_acked": {"timeout": Duration(seconds=-1)},
    "rclpy.time:Time": {"clock_type": ClockType.SYSTEM_TIME},
    "rclpy.time:Time.from_msg": {"clock_type": ClockType.ROS_TIME},
    "rclpy.timer:TimerInfo": {"clock_type": ClockType.SYSTEM_TIME},
    "rclpy.type_hash:TypeHash": {"version": -1, "value": bytes(32)},
}


@pytest.mark.parametrize("name", DEFAULTS)
def test_defaults_that_are_objects_are_those_of_rclpy(name: str) -> None:
    module, _, path = name.partition(":")
    arguments = inspect.signature(attrgetter(path)(importlib.import_module(module))).parameters
    assert {each: arguments[each].default for each in DEFAULTS[name]} == DEFAULTS[name]
