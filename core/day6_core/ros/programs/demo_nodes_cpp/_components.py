"""The nodes of this package that a container can load."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.demo_nodes_cpp.add_two_ints_server import ServerNode
from day6_core.ros.programs.demo_nodes_cpp.content_filtering_publisher import ContentFilteringPublisher
from day6_core.ros.programs.demo_nodes_cpp.content_filtering_subscriber import ContentFilteringSubscriber
from day6_core.ros.programs.demo_nodes_cpp.even_parameters_node import EvenParameterNode
from day6_core.ros.programs.demo_nodes_cpp.introspection_client import IntrospectionClientNode
from day6_core.ros.programs.demo_nodes_cpp.introspection_service import IntrospectionServiceNode
from day6_core.ros.programs.demo_nodes_cpp.listener import Listener
from day6_core.ros.programs.demo_nodes_cpp.listener_best_effort import ListenerBestEffort
from day6_core.ros.programs.demo_nodes_cpp.one_off_timer import OneOffTimerNode
from day6_core.ros.programs.demo_nodes_cpp.parameter_blackboard import ParameterBlackboard
from day6_core.ros.programs.demo_nodes_cpp.reuse_timer import ReuseTimerNode
from day6_core.ros.programs.demo_nodes_cpp.set_parameters_callback import SetParametersCallback
from day6_core.ros.programs.demo_nodes_cpp.talker import Talker
from day6_core.ros.programs.demo_nodes_cpp.talker_loaned_message import LoanedMessageTalker

if TYPE_CHECKING:
    from day6_core.ros.programs._component import Component

COMPONENTS: dict[str, type[Component]] = {
    f"demo_nodes_cpp::{kind.__name__}": kind
    for kind in (
        Talker,
        Listener,
        ListenerBestEffort,
        LoanedMessageTalker,
        ContentFilteringPublisher,
        ContentFilteringSubscriber,
        ServerNode,
        IntrospectionServiceNode,
        IntrospectionClientNode,
        ParameterBlackboard,
        EvenParameterNode,
        SetParametersCallback,
        OneOffTimerNode,
        ReuseTimerNode,
    )
}
