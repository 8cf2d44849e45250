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
        "A small world with physics, in place of the Gazebo of a real lesson. The wheels touch the floor, so when they turn the "
        "robot rolls: /cmd_vel or /joint_commands turns them. It publishes its position on /odom as the wheels measure it, "
        "and senses with /scan and /line_sensor.\n\n"
        "To enter, every link needs <inertial>; a link without <collision> goes through walls.\n\n"
        "+ and - zoom, arrows move the view, f follows the robot, 0 shows everything. l shows the lidar, t wipes the trail. "
        "Space pauses, n takes one step, [ and ] change the speed of time, r puts the robot back to its start. "
        "RTF is the real-time factor, as in Gazebo: how many seconds passed in here while one passed on your watch."
    ),
}
