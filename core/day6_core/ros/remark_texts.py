"""The English texts of remarks by id (`programs/remark.py`); names of topics, links and types are in the parameters.

Those of findings about what a terminal printed stand in their cards (`day6_core/advice/cards`), in both languages.
The programs print them, and the catalogue of the windows (day6_tui/locale/en/remarks.py) has them from here. The Chinese ones
are in day6_tui/locale/zh/remarks.py: without a screen a remark is English.
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
    "inspector.open_class": (
        "{endpoint} is open, {joined} joined; there is no secret: anyone who reaches this port can join the class"
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
    "inspector.no_class": "{endpoint} answers, but no class is held there; trying again",
    "inspector.name_taken": "{endpoint}: somebody else in the class has your name; trying again",
    "inspector.class_full": "{endpoint}: the class is full; trying again",
    "inspector.other_domain": "{endpoint}: this room has another ROS_DOMAIN_ID; trying again",
    "inspector.unreachable": "cannot connect to {endpoint} ({reason}); retrying",
    "inspector.alone": "programs of other processes cannot be seen: {reason}",
    "inspector.elsewhere": "a folder other than the usual one is used to meet other processes: {reason}",
    "inspector.refused_many": "{count} announcements of other processes were refused: there are too many",
    "inspector.refused_names": "{count} announcements of other processes were refused: ROS does not allow such names",
    "inspector.refused_messages": "{count} messages of other processes could not be read and were dropped",
    "inspector.refused_sessions": "{count} items from other machines were refused: they claim to come from this one",
    "inspector.not_built": "`{line}`: {package} is in {folder}, but it has not been built yet",
    "inspector.not_sourced": (
        "`{line}`: {package} is built, but terminal {number} does not know it: it was opened before, or nothing was "
        "sourced in it"
    ),
    "inspector.nowhere_sourced": "{packages}: built, but no terminal knows it yet",
    "inspector.no_entry_point": (
        "`{line}`: {executable} is a file of {package}, but entry_points in setup.py does not name it: add {entry} "
        "and build again"
    ),
    "inspector.entry_not_built": "`{line}`: setup.py names {executable}, but {package} was not built since",
    "inspector.no_setup_cfg": (
        "{package}: its executables were installed where `ros2 run` does not look: setup.cfg with script_dir is missing"
    ),
    "inspector.entry_py": "{package}: the entry point {entry} says {wrong}; a module has no .py: write {right}",
    "inspector.entry_module": "{package}: the entry point {entry} names {module}, but there is no such file",
    "inspector.entry_function": (
        "{package}: the entry point {entry} names {module}:{function}, but that file has no function {function}"
    ),
    "inspector.entry_form": "{package}: the entry point {entry} is not written as 'name = package.file:main'",
    "inspector.launch_not_built": "`{line}`: {file} was added to setup.py of {package}, but it was not built since",
    "inspector.launch_not_installed": (
        "{package}: {file} is not installed: {where} does not name it (data_files), so `ros2 launch` cannot find it"
    ),
    "inspector.not_rebuilt": "{package}: {files} was changed after the build; what runs is the old one",
    "inspector.inner_package": (
        "the package {inner} is inside the folder of {outer}: colcon does not look there. Move it into src"
    ),
    "inspector.stray_build": (
        "there is a second build in {folder}: somebody ran colcon there. Build in the workspace only, and remove "
        "this one"
    ),
    "inspector.unreadable": "could not be read: {what}",
    "inspector.mixed_types": "{topic}: {nodes} publish different types: {types}",
    "inspector.ctrl_c": "`{line}`: this traceback is only your Ctrl-C; nothing is broken",
    "inspector.no_server": "{nodes} wants to call {name}, but nobody offers it",
    "inspector.service_near": "{nodes} wants to call {name}, but only {near} is offered: is one of the names a typo?",
    "inspector.said_too_soon": (
        "{topic}: {node} published before anybody who listens had found it, and nothing since: wait for a subscriber "
        "first"
    ),
    "inspector.gone_too_soon": (
        "{topic}: {node} was there for only {seconds} s and nobody has heard it: who publishes once waits for a "
        "subscriber first"
    ),
    "inspector.never_spun": "{node} is never spun: its callbacks cannot run. {program} needs rclpy.spin(node)",
    "inspector.spin_ended": (
        "{node}: nobody spins it now, so its callbacks wait. Has {program} left its spin, or does it sleep?"
    ),
    "inspector.ended_unspun": (
        "{program} ended at once: nothing in it spins, so no callback could run. It needs rclpy.spin(node)"
    ),
    "inspector.calls_in_callback": (
        "{node}: {what} waits for an answer by call() ({where}); while it waits nobody can receive the answer. Use "
        "call_async"
    ),
    "inspector.spins_in_callback": (
        "{node}: {what} spins inside a callback ({where}); that never comes back. Use call_async and a done callback"
    ),
    "inspector.rate_in_callback": "{node}: {what} sleeps by a Rate ({where}), whose timer cannot run meanwhile. Use a timer",
    "inspector.waits_in_callback": "{node}: {what} waits for a service ({where}); no other callback runs meanwhile",
    "inspector.sleeps_in_callback": "{node}: {what} sleeps at {where}: {text}; no other callback runs meanwhile. Use a timer",
    "inspector.stays_in_callback": "{node}: {what} does not come back ({where}: {text}); no other callback runs meanwhile",
    "inspector.rate_alone": "{node}: rate.sleep() at {where} waits for ever: a second thread has to spin the node",
    "inspector.call_alone": "{node}: call() at {where} waits for ever: a second thread has to spin the node",
    "inspector.program_waits_service": "{node} waits at {where} for the service {name}, which nobody offers",
    "inspector.program_waits_action": "{node} waits at {where} for the action {name}, which nobody offers",
    "inspector.hidden_error": "{node} has lost an exception that nobody sees: {error} ({where})",
    "inspector.no_clock": "{node} uses simulated time, but nobody has sent /clock: its timers stand still",
    "inspector.tells_nothing": (
        "{node}: its program does not answer; it is stopped (Ctrl-Z) or very busy, so nobody can look into it"
    ),
    "inspector.parameter_file": "the parameter file {file} cannot be read: {reason}",
    "inspector.parameter_keys": "{file} is for {keys}, but no node is called so (there is {nodes}): its values are ignored",
    "inspector.parameter_nothing": "{file} has no ros__parameters: its values are ignored",
    "inspector.domains": "terminal {number} is in ROS_DOMAIN_ID {domain} and sees nothing of {nodes}, which run in {other}",
    "inspector.no_stamp": "{topic}: header.stamp is 0, so robot_state_publisher ignores it: set it to the clock's now()",
    "inspector.unequal_joints": "{topic} has {names} names and {positions} positions; such messages are ignored",
    "inspector.no_state_publisher": (
        "{nodes} sends {topic}, but robot_state_publisher does not run: nobody makes transforms of it"
    ),
    "inspector.rviz_no_description": (
        "RViz waits for a robot, but nobody publishes /robot_description: does robot_state_publisher run?"
    ),
    "inspector.bad_description": "the robot description is broken: {reason}",
    "inspector.wheel_tumbles": (
        'the wheel {link} turns about another axis than its cylinder\'s, so it tumbles: rpy="1.5707963 0 0" in <visual>'
    ),
    "inspector.wheel_no_axis": "the joint {joint} has no axis to turn about: 0 0 0 is not a direction",
    "inspector.wheel_stuck": "the joint {joint} may only move from one angle to the same: wheels need the type continuous",
    "inspector.wheel_height": (
        "the wheels {links} do not stand on one floor: their lowest points are {difference} m apart (origin of their "
        "joints)"
    ),
    "inspector.body_low": (
        "{link} reaches {difference} m below the wheels {links}: the robot would lie on its belly (origin of the "
        "wheels' joints)"
    ),
    "inspector.fixed_frame": "RViz: nobody sends the Fixed Frame {frame}; choose {other} (known: {frames})",
    "inspector.no_transforms": "RViz: nobody sends transforms, so not even the Fixed Frame {frame} is known",
    "inspector.untransformed": "RViz: no transform from {links} to {frame}: nobody sends the joints that lead there",
    "inspector.no_robot_model": "RViz shows no robot, because it has no RobotModel display: Add, RobotModel",
    "inspector.robot_model_deaf": (
        "RViz: the RobotModel listens to {topic} and has no description: set its Description Topic to {right}"
    ),
    "inspector.unseen.terminals": "not looked at: the terminals (they are on the desktop only)",
    "inspector.unseen.files": "not looked at: the files of the workspaces",
    "inspector.unseen.programs": "not looked at: the insides of other programs",
    "inspector.quiet.drill": (
        "In a drill you search yourself: the inspector says nothing until it is solved or given up. Look at what the programs "
        "say, at `ros2 node list`, `ros2 topic list`, `ros2 topic info -v`; `why` explains a message."
    ),
    "inspector.quiet.exam": (
        "In an exam you search yourself: the inspector says nothing until the drill is solved. Look at what the programs say, at "
        "`ros2 node list`, `ros2 topic list`, `ros2 topic info -v`."
    ),
    "inspector.well": "nothing is wrong",
    "inspector.well_so_far": "nothing is wrong in what was looked at",
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
    "car.stays": "This draws angles only. To let it drive: ros2 launch day6_world world.launch.py",
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
