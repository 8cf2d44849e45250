"""What makes a class a message, service or action."""

from __future__ import annotations

from typing import Any, TypeVar

from rclpy._incidental import also
from rclpy.exceptions import NoTypeSupportImportedException

__getattr__ = also(
    __name__,
    "Action CommonMsgSrvMetaClass EventMessage FeedbackMessage GetResultService GetResultServiceRequest "
    "GetResultServiceResponse Msg MsgMetaClass PyCapsule SendGoalService SendGoalServiceRequest SendGoalServiceResponse Srv",
)

MsgT = TypeVar("MsgT")
SrvT = TypeVar("SrvT")
SrvRequestT = TypeVar("SrvRequestT")
SrvResponseT = TypeVar("SrvResponseT")
ActionT = TypeVar("ActionT")
GoalT = TypeVar("GoalT")
ResultT = TypeVar("ResultT")
FeedbackT = TypeVar("FeedbackT")

_HINT = (
    " This might be a ROS 1 message type but it should be a ROS 2 message type. "
    "Make sure to source your ROS 2 workspace after your ROS 1 workspace."
)


def check_for_type_support(msg_or_srv_type: Any) -> None:
    """Raise AttributeError for what is neither message, service nor action."""
    try:
        support = msg_or_srv_type._TYPE_SUPPORT
    except AttributeError as error:
        error.args = (error.args[0] + _HINT, *error.args[1:])
        raise
    if support is None:
        msg_or_srv_type.__import_type_support__()
        if msg_or_srv_type._TYPE_SUPPORT is None:
            raise NoTypeSupportImportedException


def check_is_valid_msg_type(msg_type: Any) -> None:
    """Raise AttributeError or RuntimeError for what is no message class."""
    if getattr(msg_type, "_structure", None) is not None and isinstance(msg_type, type):
        return
    check_for_type_support(msg_type)
    raise RuntimeError(f"The message type provided is not valid ({msg_type}), this might be a service or action")


def check_is_valid_srv_type(srv_type: Any) -> None:
    """Raise AttributeError or RuntimeError for what is no service class."""
    check_for_type_support(srv_type)
    if getattr(srv_type, "Response", None) is None or getattr(srv_type, "Request", None) is None:
        raise RuntimeError(f"The service type provided is not valid ({srv_type}), this might be a message or action")
