"""rqt: a menu of the windows that tools of ROS have here."""
