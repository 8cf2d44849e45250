"""The check and the report of the network of `ros2 doctor`."""

from ros2doctor.api import own_check, own_report

NetworkCheck = own_check("network")
NetworkReport = own_report("NETWORK CONFIGURATION")
