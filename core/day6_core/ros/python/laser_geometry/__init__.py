"""The ROS package laser_geometry: laser scans as point clouds."""

from laser_geometry.laser_geometry import LaserProjection as LaserProjection
