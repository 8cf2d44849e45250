"""The ROS package tf2_geometry_msgs: importing it registers the transforms of points, vectors, poses, polygons with tf2_ros."""

from geometry_msgs.msg import Point as Point
from geometry_msgs.msg import Point32 as Point32
from geometry_msgs.msg import PointStamped as PointStamped
from geometry_msgs.msg import PolygonStamped as PolygonStamped
from geometry_msgs.msg import Pose as Pose
from geometry_msgs.msg import PoseStamped as PoseStamped
from geometry_msgs.msg import PoseWithCovarianceStamped as PoseWithCovarianceStamped
from geometry_msgs.msg import TransformStamped as TransformStamped
from geometry_msgs.msg import Vector3Stamped as Vector3Stamped

from tf2_geometry_msgs.tf2_geometry_msgs import do_transform_point as do_transform_point
from tf2_geometry_msgs.tf2_geometry_msgs import do_transform_polygon_stamped as do_transform_polygon_stamped
from tf2_geometry_msgs.tf2_geometry_msgs import do_transform_pose as do_transform_pose
from tf2_geometry_msgs.tf2_geometry_msgs import do_transform_pose_stamped as do_transform_pose_stamped
from tf2_geometry_msgs.tf2_geometry_msgs import (
    do_transform_pose_with_covariance_stamped as do_transform_pose_with_covariance_stamped,
)
from tf2_geometry_msgs.tf2_geometry_msgs import do_transform_vector3 as do_transform_vector3
from tf2_geometry_msgs.tf2_geometry_msgs import from_msg_msg as from_msg_msg
from tf2_geometry_msgs.tf2_geometry_msgs import to_msg_msg as to_msg_msg
from tf2_geometry_msgs.tf2_geometry_msgs import transform_covariance as transform_covariance
