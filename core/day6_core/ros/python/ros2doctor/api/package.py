"""The report of packages of `ros2 doctor`."""

from ros2doctor.api import own_report

PackageReport = own_report("PACKAGE VERSIONS")
