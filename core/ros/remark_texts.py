"""The English texts of all remarks by id (`programs/remark.py`); names of topics, links and types are in the parameters.

The programs print them, and the catalogue of the windows (tui/locale/en.py) has them from here. The Chinese ones are in
tui/locale/zh.py: without a screen a remark is English.
"""

TEXTS = {
    # The inspector's findings
    "inspector.unheard": "{topic}: {nodes} publishes, but nobody subscribes",
    "inspector.unsaid": "{topic}: {nodes} subscribes, but nobody publishes",
    "inspector.near": "{published} is published and {subscribed} is subscribed to: is one of the names a typo?",
    "inspector.types": "{topic}: {publisher} sends {sent}, {subscriber} wants {wanted}; nothing arrives",
    "inspector.qos": "{topic}: the QoS of {publisher} is incompatible with {subscriber} ({policy}); nothing arrives",
    "inspector.fight": "{topic}: {count} nodes publish at the same time and fight over it: {nodes}",
    "inspector.twins": "{count} nodes are called {name}: lists and parameters cannot tell them apart",
    "inspector.unknown_joint": "{topic} names the joint {joint}, which the robot description does not have",
    "inspector.unknown_joint_near": (
        "{topic} names the joint {joint}, which the robot description does not have; did you mean {nearest}?"
    ),
    "inspector.silent_joint": "the joint {joint} can move, but nobody sends its position on {topic}",
    "inspector.slow": "{topic} arrives {rate} times a second; the eye needs about 20",
    "inspector.late": (
        "this computer is too slow for all that runs here: time passes at {pace}x instead of {speed}x, "
        "and topics arrive less often than their programs mean to"
    ),
    "inspector.open": (
        "{endpoint} is open, {joined} joined; there is no secret: anyone who reaches this port can read and command"
    ),
    "inspector.open_secret": "{endpoint} is open to anyone who knows the secret, {joined} joined",
    "inspector.opening": "{endpoint} is about to be opened",
    "inspector.in_use": "{endpoint}: another program uses this port, so no other machine can join; retrying",
    "inspector.no_name": "{endpoint}: this name is unknown; retrying",
    "inspector.shut": "{endpoint} cannot be opened ({reason}), so no other machine can join; retrying",
    "inspector.calling": "connecting to {endpoint}",
    "inspector.joined": "joined to {endpoint}",
    "inspector.nobody": "no answer from {endpoint}: the machine is there, but no program listens on this port; retrying",
    "inspector.no_answer": "no answer from {endpoint}; retrying",
    "inspector.wrong_secret": "refused by {endpoint}: wrong secret, or it asks for none",
    "inspector.no_secret": "refused by {endpoint}: it asks for a secret, or it is not ROS",
    "inspector.unreachable": "cannot connect to {endpoint} ({reason}); retrying",
    "inspector.alone": "programs of other processes cannot be seen: {reason}",
    "inspector.elsewhere": "a folder other than the usual one is used to meet other processes: {reason}",
    "inspector.refused_many": "{count} announcements of other processes were refused: there are too many",
    "inspector.refused_names": "{count} announcements of other processes were refused: ROS does not allow such names",
    "inspector.refused_messages": "{count} messages of other processes could not be read and were dropped",
    "inspector.refused_sessions": "{count} items from other machines were refused: they claim to come from this one",
    "inspector.well": "nothing is wrong",
    # Beside the car
    "car.waiting_for_description": "nobody has published /robot_description yet: is robot_state_publisher running?",
    "car.loading": "reading the robot description",
    "car.bad_description": "the robot description is broken: {text}",
    "car.no_wheels": "this robot has no wheels: nothing turns about a horizontal axis",
    "car.no_joint_states": "nobody publishes {topic}: the wheels do not turn",
    "car.wrong_type": "{topic} has type {type}, but it must be sensor_msgs/msg/JointState",
    "car.unknown_joint": "joint {joint} is not in the URDF",
    "car.unknown_joint_near": "joint {joint} is not in the URDF; did you mean {nearest}?",
    "car.no_transform": "no transform from {link} to {frame}",
    "car.no_transform_more": "no transform from {count} more links to {frame}",
    "car.many_publishers": "{count} publishers on {topic}: {nodes}",
    "car.slow": "{topic} arrives only {rate} times a second: the eye needs about 20",
    "car.silent": "nothing on {topic} for {seconds} s",
    "car.stays": (
        "The wheels turn, so why does the car not move? Like RViz, this picture only draws angles. To roll on a floor: "
        "ros2 launch day6_world world.launch.py"
    ),
    # Below the world
    "world.waiting_for_robot": "the world is empty: nobody has published /robot_description yet",
    "world.refused": "{robot} may not enter this world:",
    "world.bad_description": "the robot description is broken: {text}",
    "world.left_away": "parts of the robot could not be read: {text}",
    "world.no_inertial": "{links}: no <inertial>. Forces cannot move a link without mass; it would be a ghost",
    "world.bad_mass": "{link}: a mass of {mass} kg is impossible",
    "world.bad_inertia": "{link}: the inertia is not greater than 0 about every axis",
    "world.bad_number": "{link}: a size or position is not a number",
    "world.no_drive": "it has no left and right wheels that could drive it",
    "world.stands_in_wall": "at ({x:.2f}, {y:.2f}) it would stand in a wall",
    "world.no_collision": "{links}: no <collision>. They go through walls like ghosts",
    "world.wheels_without_collision": "{links}: wheels without <collision> do not touch the floor. They turn and push nothing",
    "world.nobody_drives": "nobody publishes {topic}: drive with ros2 run teleop_twist_keyboard teleop_twist_keyboard",
    "world.keeps_going": "nobody publishes {topic} any more: the last command applies until another one arrives",
    "world.wrong_type": "{topic} has type {type}, but this world needs {wanted}: start it with stamped:={stamped}",
    "world.two_joint_states": (
        "{nodes} publishes {topic} as well. That topic reports where the wheels are; it is not a command, so nothing rolls. With "
        "-r joint_states:=joint_commands it becomes one"
    ),
    "world.bumped": "it touches a wall: the wheels slip, and /odom does not notice",
    "world.sideways": "linear.y is ignored: two wheels cannot go sideways",
}
