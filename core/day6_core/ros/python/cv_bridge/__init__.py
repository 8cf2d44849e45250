"""The ROS package cv_bridge: sensor_msgs/Image to numpy arrays, which are OpenCV's images, and back.

numpy is enough for the usual encodings; OpenCV (`cv2`) is asked, where it is installed, for the others and for compressed images.
"""

from cv_bridge.boost.cv_bridge_boost import cvtColorForDisplay as cvtColorForDisplay
from cv_bridge.boost.cv_bridge_boost import getCvType as getCvType
from cv_bridge.core import CvBridge as CvBridge
from cv_bridge.core import CvBridgeError as CvBridgeError

__all__ = ["CvBridge", "CvBridgeError", "cvtColorForDisplay", "getCvType"]
