"""The states of service introspection."""

from rclpy._rclpy_pybind11 import ServiceIntrospectionState as ServiceIntrospectionState
