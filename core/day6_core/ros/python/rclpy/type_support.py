"""Checks that a class is a message, service or action."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar

from rclpy._day6.incidental import also
from rclpy.exceptions import NoTypeSupportImportedException

__getattr__ = also(
    __name__,
    "Action CommonMsgSrvMetaClass EventMessage FeedbackMessage GetResultService GetResultServiceRequest "
    "GetResultServiceResponse Msg MsgMetaClass PyCapsule SendGoalService SendGoalServiceRequest SendGoalServiceResponse Srv",
)

if TYPE_CHECKING:
    from rclpy._day6.typing_names import Action as Action
    from rclpy._day6.typing_names import CommonMsgSrvMetaClass as CommonMsgSrvMetaClass
    from rclpy._day6.typing_names import EventMessage as EventMessage
    from rclpy._day6.typing_names import FeedbackMessage as FeedbackMessage
    from rclpy._day6.typing_names import GetResultService as GetResultService
    from rclpy._day6.typing_names import GetResultServiceRequest as GetResultServiceRequest
    from rclpy._day6.typing_names import GetResultServiceResponse as GetResultServiceResponse
    from rclpy._day6.typing_names import Msg as Msg
    from rclpy._day6.typing_names import MsgMetaClass as MsgMetaClass
    from rclpy._day6.typing_names import PyCapsule as PyCapsule
    from rclpy._day6.typing_names import SendGoalService as SendGoalService
    from rclpy._day6.typing_names import SendGoalServiceRequest as SendGoalServiceRequest
    from rclpy._day6.typing_names import SendGoalServiceResponse as SendGoalServiceResponse
    from rclpy._day6.typing_names import Srv as Srv

MsgT = TypeVar("MsgT", bound="Msg")
SrvT = TypeVar("SrvT", bound="Srv")
SrvRequestT = TypeVar("SrvRequestT", bound="Msg")
SrvResponseT = TypeVar("SrvResponseT", bound="Msg")
ActionT = TypeVar("ActionT", bound="Action")
GoalT = TypeVar("GoalT", bound="Msg")
ResultT = TypeVar("ResultT", bound="Msg")
FeedbackT = TypeVar("FeedbackT", bound="Msg")

_HINT = (
    " This might be a ROS 1 message type but it should be a ROS 2 message type. "
    "Make sure to source your ROS 2 workspace after your ROS 1 workspace."
)


def check_for_type_support(msg_or_srv_type: type[Msg | Srv | Action]) -> None:
    """Raise AttributeError for anything other than a message, service or action class."""
    try:
        support = msg_or_srv_type._TYPE_SUPPORT
    except AttributeError as error:
        error.args = (error.args[0] + _HINT, *error.args[1:])
        raise
    if support is None:
        msg_or_srv_type.__import_type_support__()
        if msg_or_srv_type._TYPE_SUPPORT is None:
            raise NoTypeSupportImportedException


def check_is_valid_msg_type(msg_type: type[Msg]) -> None:
    """Raise AttributeError or RuntimeError for anything other than a message class."""
    if getattr(msg_type, "_structure", None) is not None and isinstance(msg_type, type):
        return
    check_for_type_support(msg_type)
    raise RuntimeError(f"The message type provided is not valid ({msg_type}), this might be a service or action")


def check_is_valid_srv_type(srv_type: type[Srv]) -> None:
    """Raise AttributeError or RuntimeError for anything other than a service class."""
    check_for_type_support(srv_type)
    if getattr(srv_type, "Response", None) is None or getattr(srv_type, "Request", None) is None:
        raise RuntimeError(f"The service type provided is not valid ({srv_type}), this might be a message or action")
