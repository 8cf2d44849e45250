"""Exceptions of C++: their class names and texts (rclcpp/exceptions/exceptions.hpp, .cpp), in place of rclpy's."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from day6_core.graph.domain import DomainError
from day6_core.session.session import Crash
from rclpy._rclpy_pybind11 import RCLError, RCLInvalidROSArgsError, UnknownROSArgsError
from rclpy.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    NameValidationException,
    ParameterNotDeclaredException,
)

SIGABRT = 6

_NAME_ERRORS: dict[type[Exception], str] = {
    InvalidNodeNameException: "InvalidNodeNameError",
    InvalidNamespaceException: "InvalidNamespaceError",
    InvalidTopicNameException: "InvalidTopicNameError",
    InvalidServiceNameException: "InvalidServiceNameError",
}

_PREFIXES = {
    "error creating node: ": "failed to initialize rcl node: ",
    "Failed to parse ROS arguments: ": "failed to parse arguments: ",
}
"""How rclpy and how rclcpp introduce the same text of rcl."""


class CppException(Crash):
    """An exception of C++, of the class `kind`. Where nothing catches it, it ends the program as std::terminate does."""

    def __init__(self, what: str, kind: str = "std::runtime_error") -> None:
        report = f"terminate called after throwing an instance of '{kind}'\n  what():  {what}"
        Crash.__init__(self, what, report, SIGABRT)
        self.kind = kind


class RclcppException(CppException):
    """An exception of the namespace rclcpp::exceptions."""

    def __init__(self, what: str, kind: str) -> None:
        super().__init__(what, f"rclcpp::exceptions::{kind}")


class ParameterNotDeclared(RclcppException, ParameterNotDeclaredException):
    """A parameter that is not declared was to be set; rclpy's services catch it, too."""

    def __init__(self, name: str) -> None:
        what = f"parameter '{name}' cannot be set because it was not declared"
        super().__init__(what, "ParameterNotDeclaredException")


@contextmanager
def thrown_as_cpp() -> Iterator[None]:
    """Raise CppException for an exception of rclpy."""
    try:
        yield
    except NameValidationException as error:
        raise RclcppException(f"{error}\n", _NAME_ERRORS[type(error)]) from error
    except UnknownROSArgsError as error:
        words = "', '".join(error.args[0])
        raise RclcppException(f"found unknown ROS arguments: '{words}'", "UnknownROSArgsError") from error
    except (RCLError, DomainError) as error:
        text = str(error)
        for theirs, ours in _PREFIXES.items():
            text = text.replace(theirs, ours)
        of_arguments = isinstance(error, RCLInvalidROSArgsError) or "Couldn't parse" in text
        raise RclcppException(text, "RCLInvalidROSArgsError" if of_arguments else "RCLError") from error
