"""The reports of the machine and the distribution of `ros2 doctor`."""

from ros2doctor.api import own_report

PlatformReport = own_report("PLATFORM INFORMATION")
RosdistroReport = own_report("ROS 2 INFORMATION")
