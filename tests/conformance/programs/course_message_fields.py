"""Messages: defaults, keywords, nesting, equality, printing, slots."""

from geometry_msgs.msg import Point, PoseStamped, Twist, Vector3
from sensor_msgs.msg import JointState, LaserScan
from std_msgs.msg import ColorRGBA, Header, String

twist = Twist(linear=Vector3(x=1.0))
print(twist)
print(twist == Twist(linear=Vector3(x=1.0)), twist == Twist(), twist != String())
print(String(data="a").data, String().data == "", ColorRGBA(r=0.5))
pose = PoseStamped()
pose.header.frame_id = "map"
pose.pose.position = Point(x=1.0, y=2.0)
print(pose.pose.orientation.w, pose.header)
scan = LaserScan(ranges=[1.0, 2.0, 3.5])
print(type(scan.ranges).__name__, len(scan.ranges), scan.ranges[2], list(scan.intensities))
joint = JointState(name=["a", "b"], position=[0.1, 0.2])
joint.name.append("c")
print(joint.name, list(joint.position))
print(Twist.get_fields_and_field_types())
print(JointState.get_fields_and_field_types())
print(Header.__slots__[:2])
for wrong in (lambda: String("positional"), lambda: Twist().no_such_field):
    try:
        wrong()
    except Exception as error:
        print(type(error).__name__, error)
