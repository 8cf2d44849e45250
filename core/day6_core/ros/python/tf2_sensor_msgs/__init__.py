"""The ROS package tf2_sensor_msgs: importing it registers the transform of point clouds with tf2_ros."""

from tf2_sensor_msgs.tf2_sensor_msgs import do_transform_cloud as do_transform_cloud
from tf2_sensor_msgs.tf2_sensor_msgs import transform_points as transform_points

__all__ = ["do_transform_cloud", "transform_points"]
