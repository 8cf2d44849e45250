"""The world."""

TEXTS = {
    "world.pose": "x {x:.2f}  y {y:.2f}  {degrees}°  v {v:.2f} m/s",
    "world.line": "line",
    "world.factor": "RTF {factor:.2f}",
    "world.zoom": "zoom",
    "world.follow": "follow",
    "world.lidar": "lidar",
    "world.step": "step",
    "world.reset": "back to the start",
    "help.world": (
        "A small world with physics, where a real lesson would use Gazebo. The wheels touch the floor, so the robot rolls "
        "when they turn: /cmd_vel or /joint_commands turns them. The robot publishes its position on /odom, as measured by "
        "the wheels, and its sensors on /scan and /line_sensor.\n\n"
        "To enter this world, every link needs <inertial>; a link without <collision> passes through walls.\n\n"
        "+ and - zoom, arrows move the view, f follows the robot, 0 shows everything. l shows the lidar, t wipes the "
        "trail. Space pauses, n takes one step, [ and ] change the speed of time, r puts the robot back to its start. RTF "
        "is the real-time factor, as in Gazebo: the seconds that pass in here while one passes on your watch."
    ),
}
