"""What services and clients tell about their calls."""

from rclpy._rclpy_pybind11 import ServiceIntrospectionState as ServiceIntrospectionState
