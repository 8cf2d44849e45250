"""The report of the middleware of `ros2 doctor`."""

from ros2doctor.api import own_report

RMWReport = own_report("RMW MIDDLEWARE")
