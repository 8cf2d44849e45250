"""The check and the report of QoS of `ros2 doctor`."""

from ros2doctor.api import own_check, own_report

QoSCompatibilityCheck = own_check("middleware")
QoSCompatibilityReport = own_report("QOS COMPATIBILITY LIST")
