"""parameter_event_handler: callbacks for one parameter of its own, one of another node, and all events of both."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import ParameterEvent

from day6_core.ros.programs.demo_nodes_cpp._calls import value_text
from day6_core.ros.programs.rclcpp import STOPPED, create_node, log_interrupt
from day6_core.ros.programs.rclcpp.parameters import TYPE_NAMES
from rclpy.parameter import parameter_value_to_python
from rclpy.qos import qos_profile_parameter_events

if TYPE_CHECKING:
    from day6_core.session.session import Session

OWN, OWN_PARAMETER = "this_node", "an_int_param"
REMOTE, NAMESPACE, REMOTE_PARAMETER = "a_remote_node", "/a_namespace", "a_string_param"
BOTH = re.compile(r"(/a_namespace/.*)|(/this_node)")


async def main(session: Session) -> int:
    node = create_node(session, OWN)
    node.declare_parameter(OWN_PARAMETER, 0)
    remote = create_node(session, REMOTE, namespace=NAMESPACE)
    remote.declare_parameter(REMOTE_PARAMETER, "default_string_value")
    remote_name = f"{NAMESPACE}/{REMOTE}"

    def tell(who: str, parameter: Any, colon: str = ":") -> None:
        kind = parameter.value.type
        text = value_text(kind, parameter_value_to_python(parameter.value))
        node.get_logger().info(
            f'{who}: Received an update to parameter "{parameter.name}" of type{colon} {TYPE_NAMES[kind]}: "{text}"'
        )

    def hear(event: ParameterEvent) -> None:
        changes = [*event.new_parameters, *event.changed_parameters]
        for each in changes:
            if event.node == node.get_fully_qualified_name() and each.name == OWN_PARAMETER:
                tell("cb1", each, "")
            if event.node == remote_name and each.name == REMOTE_PARAMETER:
                tell("cb2", each)
        if BOTH.fullmatch(event.node):
            for each in changes:
                if event.node == remote_name and each.name == REMOTE_PARAMETER:
                    tell("cb3", each)
            for each in changes:
                tell("cb3", each)

    # Parameters declared so far cause no events.
    node.create_subscription(ParameterEvent, "/parameter_events", hear, qos_profile_parameter_events)
    session.print(
        "This demo is monitoring for the following parameter changes:\n\n"
        f'\tnode: "{OWN}"\n\tparameter: "{OWN_PARAMETER}"\n\n'
        f'\tnode: "{remote_name}"\n\tparameter: "{REMOTE_PARAMETER}"\n\n'
        "To activate the callbacks, from a separate shell/console window, execute either of the following "
        f"example commands:\n\n\t$ ros2 param set {OWN} {OWN_PARAMETER} 21\n"
        f'\t$ ros2 param set {remote_name} {REMOTE_PARAMETER} "string value to set"\n'
    )
    try:
        await session.spin(node, remote)
    except STOPPED:
        log_interrupt(session)
    return 0
