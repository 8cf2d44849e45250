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
    "inspector.unknown_joint": "{topic}: {nodes} names the joint {joint}, which the robot description does not have",
    "inspector.unknown_joint_near": (
        "{topic}: {nodes} names the joint {joint}, which the robot description does not have, so TF has no place for {link}; "
        "did you mean {nearest}?"
    ),
    "inspector.other_joints": (
        "{topic}: {nodes} names {joint}, but the joints of the robot description are called {joints}: TF has no place "
        "for {links}"
    ),
    "inspector.silent_joint": "{topic}: {nodes} doesn't send the position of {joint}, so TF has no place for {links}",
    "inspector.no_joint_states": (
        "nobody publishes {topic}, so nothing says how far these joints have moved: {joints}. TF has no place for {links}"
    ),
    "inspector.trajectory_joint": "{topic}: {node} commands the joint {joint}, which the robot doesn't have",
    "inspector.trajectory_joint_near": (
        "{topic}: {node} commands the joint {joint}, which the robot doesn't have; did you mean {nearest}?"
    ),
    "inspector.joint_limits": (
        "{topic}: {node} sends {position} for {joint}, whose limits are {low} and {high}: are these degrees? ROS counts in "
        "radians"
    ),
    "inspector.two_descriptions": (
        "{nodes} send different robots on /robot_description: whoever starts next gets one of them by chance"
    ),
    "inspector.not_finite": "{topic}: {node} sends {value} in {field}; nobody can calculate with that",
    "inspector.quaternion": (
        "{topic}: the quaternion {field} of {node} has length {length} instead of 1, so it isn't a rotation; compute it from "
        "angles, or write w = 1 for no rotation"
    ),
    "inspector.data_size": "{topic}: {field} of {node} is {count}, but by the message's other fields it should be {expected}",
    "inspector.image_encoding": "{topic}: {node} calls the encoding {encoding}; it is written {right}",
    "inspector.map_resolution": "{topic}: the map of {node} has a resolution of {resolution} m: its cells have no size",
    "inspector.out_of_range": "{topic}: {node} sends {value} in {field}, which goes from {low} to {high}",
    "inspector.scan_angles": (
        "{topic}: {node} sends {ranges} ranges, but angle_min, angle_max and angle_increment ({step}) allow for {angles}"
    ),
    "inspector.scan_degrees": "{topic}: {node} scans up to the angle {angle}: those are degrees, and ROS counts in radians",
    "inspector.scan_empty": "{topic}: not one of the {ranges} ranges of {node} is a number: this laser sees nothing",
    "inspector.scan_ranges": "{topic}: range_min {low} and range_max {high} m of {node} leave no valid distance",
    "inspector.empty_frame": "{topic}: a {type} of {node} has an empty frame id, so nobody knows where it belongs",
    "inspector.unknown_frame": "{topic}: a {type} of {node} is in the frame {frame}, of which nobody sends a transform",
    "inspector.unknown_frame_near": (
        "{topic}: a {type} of {node} is in the frame {frame}, of which nobody sends a transform; did you mean {nearest}?"
    ),
    "inspector.stampless": "{topic}: header.stamp of {node} is 0: set it to node.get_clock().now().to_msg()",
    "inspector.stamp_1970": (
        "{topic}: {node} stamps with {stamp} s, which is 1970: its clock isn't that of the others. Use "
        "node.get_clock().now().to_msg()"
    ),
    "inspector.stamp_past": "{topic}: what {node} sends is stamped {time} ago, so it is too old for TF",
    "inspector.stamp_future": "{topic}: what {node} sends is stamped {time} ahead of now",
    "inspector.stamp_clock": (
        "{topic}: {node} stamps with this computer's time, but /clock says another: it needs use_sim_time"
    ),
    "inspector.tf_loop": "the transforms go round in a circle: {frames} (from {nodes}); nothing in it has a place",
    "inspector.tf_nameless": "{nodes} sends a transform with an empty frame id (the other is {frame})",
    "inspector.tf_fight": "{nodes} send different transforms from {parent} to {child}: it jumps to and fro",
    "inspector.two_parents": (
        "the frame {child} has several parents: {parents} (from {nodes}). A frame can have only one, so it jumps between them"
    ),
    "inspector.slow": "{topic} arrives {rate} times a second; the eye needs about 20",
    "inspector.late": (
        "this computer is too slow for everything running here: time passes at {pace}x instead of {speed}x, "
        "and topics arrive less often than intended"
    ),
    "inspector.open": (
        "{endpoint} is open, {joined} joined; there is no secret: anyone who reaches this port can read and control"
    ),
    "inspector.open_class": (
        "{endpoint} is open, {joined} joined; there is no secret: anyone who reaches this port can join the class"
    ),
    "inspector.open_secret": "{endpoint} is open to anyone who knows the secret, {joined} joined",
    "inspector.opening": "{endpoint} is about to be opened",
    "inspector.in_use": "{endpoint}: another program is using this port, so no other machine can join; retrying",
    "inspector.no_name": "{endpoint}: this name is unknown; retrying",
    "inspector.shut": "{endpoint} cannot be opened ({reason}), so no other machine can join; retrying",
    "inspector.calling": "connecting to {endpoint}",
    "inspector.joined": "joined {endpoint}",
    "inspector.nobody": "no answer from {endpoint}: the machine is there, but nothing listens on this port; retrying",
    "inspector.no_answer": "no answer from {endpoint}; retrying",
    "inspector.wrong_secret": "refused by {endpoint}: wrong secret, or it needs none",
    "inspector.no_secret": "refused by {endpoint}: it needs a secret, or it isn't ROS",
    "inspector.no_class": "{endpoint} answers, but there is no class; retrying",
    "inspector.name_taken": "{endpoint}: somebody else in the class has your name; retrying",
    "inspector.name_alike": "{endpoint}: somebody else in the class has a name that looks like yours; retrying",
    "inspector.class_full": "{endpoint}: the class is full; retrying",
    "inspector.other_domain": "{endpoint}: this room has another ROS_DOMAIN_ID; retrying",
    "inspector.unreachable": "cannot connect to {endpoint} ({reason}); retrying",
    "inspector.alone": "other processes cannot be seen: {reason}",
    "inspector.with_zenoh": "{count} of your processes use Zenoh, which isn't used here: they can't be seen",
    "inspector.elsewhere": "meeting other processes in an unusual folder: {reason}",
    "inspector.refused_many": "{count} announcements from other processes were refused: too many",
    "inspector.refused_names": "{count} announcements from other processes were refused: ROS doesn't allow such names",
    "inspector.refused_messages": "{count} messages from other processes could not be read and were dropped",
    "inspector.refused_sessions": "{count} items from other machines were refused: they claim to come from this one",
    "inspector.not_built": "`{line}`: {package} is in {folder}, but it hasn't been built yet",
    "inspector.not_sourced": (
        "`{line}`: {package} is built, but terminal {number} doesn't know it: it was opened before the build, or hasn't "
        "sourced it"
    ),
    "inspector.nowhere_sourced": "{packages}: built, but no terminal knows it yet",
    "inspector.no_entry_point": (
        "`{line}`: {executable} is a file in {package}, but entry_points in setup.py doesn't name it: add {entry} "
        "and build again"
    ),
    "inspector.entry_not_built": "`{line}`: setup.py names {executable}, but {package} hasn't been built since",
    "inspector.no_setup_cfg": (
        "{package}: its executables were installed where `ros2 run` doesn't look: setup.cfg with script_dir is missing"
    ),
    "inspector.entry_py": "{package}: the entry point {entry} says {wrong}; a module has no .py: write {right}",
    "inspector.entry_module": "{package}: the entry point {entry} names {module}, but there is no such file",
    "inspector.entry_function": (
        "{package}: the entry point {entry} names {module}:{function}, but that file has no function {function}"
    ),
    "inspector.entry_form": "{package}: the entry point {entry} isn't written as 'name = package.file:main'",
    "inspector.launch_not_built": "`{line}`: {file} was added to setup.py of {package}, but it hasn't been built since",
    "inspector.launch_not_installed": (
        "{package}: {file} isn't installed: {where} doesn't name it (data_files), so `ros2 launch` cannot find it"
    ),
    "inspector.not_rebuilt": "{package}: {files} was changed after the build; the old version is running",
    "inspector.inner_package": (
        "the package {inner} is inside the folder of {outer}: colcon doesn't look there. Move it into src"
    ),
    "inspector.stray_build": (
        "there is a second build in {folder}: somebody ran colcon there. Build only in the workspace, and remove "
        "this one"
    ),
    "inspector.unreadable": "could not be read: {what}",
    "inspector.mixed_types": "{topic}: {nodes} publish different types: {types}",
    "inspector.ctrl_c": "`{line}`: this traceback is only your Ctrl-C; nothing is broken",
    "inspector.no_server": "{nodes} wants to call {name}, but nobody offers it",
    "inspector.service_near": "{nodes} wants to call {name}, but only {near} is offered: is one of the names a typo?",
    "inspector.said_too_soon": (
        "{topic}: {node} published before any subscriber had found it, and nothing since: wait for a subscriber first"
    ),
    "inspector.gone_too_soon": (
        "{topic}: {node} existed for only {seconds} s and nobody heard it: to publish once, wait for a subscriber first"
    ),
    "inspector.never_spun": "{node} is never spun: its callbacks cannot run. {program} needs rclpy.spin(node)",
    "inspector.spin_ended": (
        "{node}: nothing spins it now, so its callbacks wait. Has {program} left its spin, or is it sleeping?"
    ),
    "inspector.ended_unspun": (
        "{program} ended at once: nothing in it spins, so no callback could run. It needs rclpy.spin(node)"
    ),
    "inspector.calls_in_callback": (
        "{node}: {what} waits for the answer of {name} ({where}), but it occupies the only thread, which would have to "
        "take that answer. Use call_async and a done callback"
    ),
    "inspector.calls_in_group": (
        "{node}: {what} waits for the answer of {name} ({where}), but the client is in the same "
        "MutuallyExclusiveCallbackGroup as {what}, so nobody takes the answer. Give the client a group of its own"
    ),
    "inspector.calls_own_service": (
        "{node}: {what} waits for {name} ({where}), which {other} of the same program serves; {other} cannot run while "
        "{what} occupies the only thread. Call a function instead, or use call_async"
    ),
    "inspector.calls_own_in_group": (
        "{node}: {what} waits for {name} ({where}), which {other} of the same program serves; {other} cannot run: it is in "
        "the same MutuallyExclusiveCallbackGroup as {what}. Give one of them a group of its own"
    ),
    "inspector.future_in_callback": (
        "{node}: {what} waits for a future ({where}: {text}), but the callback that completes it cannot run meanwhile. "
        "Use add_done_callback"
    ),
    "inspector.event_in_callback": (
        "{node}: {what} waits for an event ({where}: {text}); no other callback runs meanwhile, so none can set it"
    ),
    "inspector.input_in_callback": (
        "{node}: {what} waits for the keyboard ({where}: {text}); no other callback runs meanwhile. Ask in a thread of its own"
    ),
    "inspector.spins_in_callback": (
        "{node}: {what} spins inside a callback ({where}); that never returns. Use call_async and a done callback"
    ),
    "inspector.rate_in_callback": "{node}: {what} sleeps with a Rate ({where}), whose timer cannot run meanwhile. Use a timer",
    "inspector.waits_in_callback": "{node}: {what} waits for a service ({where}); no other callback runs meanwhile",
    "inspector.sleeps_in_callback": "{node}: {what} sleeps at {where}: {text}; no other callback runs meanwhile. Use a timer",
    "inspector.stays_in_callback": "{node}: {what} doesn't return ({where}: {text}); no other callback runs meanwhile",
    "inspector.rate_alone": "{node}: rate.sleep() at {where} waits for ever: a second thread has to spin the node",
    "inspector.call_alone": "{node}: call() at {where} waits for ever: a second thread has to spin the node",
    "inspector.program_waits_service": "{node} waits at {where} for the service {name}, which nobody offers",
    "inspector.program_waits_action": "{node} waits at {where} for the action {name}, which nobody offers",
    "inspector.program_waits_near": (
        "{node} waits at {where} for {name}, but only {near} is offered: is one of the names a typo?"
    ),
    "inspector.program_waits_type": (
        "{node} waits at {where} for {name}: it is offered, but with another type ({type})"
    ),
    "inspector.stays_in_init": (
        "{node}: its __init__ doesn't return ({where}: {text}), so the program never gets to spin. Put the loop into a timer"
    ),
    "inspector.thread_died": (
        "{program}: the error {error} ({where}) ended the thread {thread}; the rest of the program goes on without it"
    ),
    "inspector.exception_shown": "{where}: the program reported {error} and goes on",
    "inspector.swallowed": (
        "{node}: {what} fails at every call, and nobody sees it: {error} (raised at {raised}) is caught at {where}, which "
        "does nothing. At least log it there"
    ),
    "inspector.timer_late": (
        "{node}: the timer of {what} ({where}) should run {wanted} times a second, but only gets to {rate}: its callbacks "
        "take longer than its period"
    ),
    "inspector.timer_zero": (
        "{node}: the timer of {what} ({where}) has a period of 0: it runs as often as it can ({rate} times a second) and "
        "leaves no time for anything else"
    ),
    "inspector.timer_seldom": (
        "{node}: the timer of {what} ({where}) waits {period} seconds for each call; create_timer takes seconds, not "
        "milliseconds"
    ),
    "inspector.losses": (
        "{node} lost {lost} of the last {count} messages on {topic}: {rate} arrive a second, and {what} ({where}) cannot "
        "keep up; the oldest waiting ones are overwritten"
    ),
    "inspector.flood": (
        "{node} publishes {rate} messages a second on {topic}: is there a loop without a pause? Use a timer"
    ),
    "inspector.grows_publishers": (
        "{node} makes more and more publishers ({count} by now, the last one on {name}): create_publisher belongs in "
        "__init__, not in a callback or loop"
    ),
    "inspector.grows_subscriptions": (
        "{node} makes more and more subscriptions ({count} by now, the last one on {name}): create_subscription belongs "
        "in __init__, not in a callback or loop"
    ),
    "inspector.grows_clients": (
        "{node} makes more and more clients ({count} by now, the last one of {name}): create_client belongs in __init__, "
        "not in a callback or loop"
    ),
    "inspector.grows_services": (
        "{node} makes more and more services ({count} by now, the last one is {name}): create_service belongs in "
        "__init__, not in a callback or loop"
    ),
    "inspector.grows_timers": (
        "{node} makes more and more timers ({count} by now): {name} belongs in __init__, not in a callback or loop"
    ),
    "inspector.goal_unsettled": (
        "{node}: {what} ({where}) of the action {name} returned without succeed(), abort() or canceled(), so the goal "
        "counts as aborted"
    ),
    "inspector.goal_waits": (
        "{node}: a goal of {name} was accepted, but nothing executes it: {what} has to call goal_handle.execute()"
    ),
    "inspector.cancel_ignored": (
        "{node}: a goal of {name} is to be canceled, but {what} goes on: it has to look at goal_handle.is_cancel_requested "
        "and call canceled()"
    ),
    "inspector.cancel_unheard": (
        "{node}: somebody wants to cancel a goal of {name}, but {what} occupies the only thread: use a "
        "MultiThreadedExecutor and a ReentrantCallbackGroup"
    ),
    "inspector.empty_list": (
        "{node}: the parameter {name} is an empty list of bytes (BYTE_ARRAY), and no other list can be set: if [] was meant as "
        "a list of texts or numbers, declare it with Parameter.Type.STRING_ARRAY or the like"
    ),
    "inspector.launch_text": (
        '{node}: the parameter {name} is {value}: the launch file made a text of a LaunchConfiguration (f"…", str() or +) '
        "before it had a value; put it into a list instead"
    ),
    "inspector.launch_argument": (
        '{node} was started with {value}: the launch file made a text of a LaunchConfiguration (f"…", str() or +) before '
        "it had a value; put it into a list instead"
    ),
    "inspector.sync_silent": "{node} wants to match messages of {topics}, but nothing comes on {silent}",
    "inspector.sync_no_callback": (
        "{node} matches messages of {topics}, but nobody is called: registerCallback is missing"
    ),
    "inspector.sync_timeless": (
        "{node} wants to match messages of {topics}, but some have no header.stamp: allow_headerless=True would take the time of "
        "their arrival"
    ),
    "inspector.sync_queue": (
        "{node} never matches messages of {topics}: when the others arrive, {short} has already dropped what belongs to "
        "them ({gap} s older). {size} messages are too few: enlarge queue_size"
    ),
    "inspector.sync_stamps": (
        "{node} never matches messages of {topics}: their stamps lie {gap} s apart, and slop allows {slop} s. Does one of them "
        "use another clock?"
    ),
    "inspector.sync_exact": (
        "{node} never matches messages of {topics}: their stamps are never exactly equal ({gap} s apart). Use "
        "ApproximateTimeSynchronizer"
    ),
    "inspector.hidden_error": "{node} lost an exception that nobody saw: {error} ({where})",
    "inspector.no_clock": "{node} uses simulated time, but nobody has sent /clock: its timers stand still",
    "inspector.tells_nothing": (
        "{node}: its program doesn't answer; it is stopped (Ctrl-Z) or very busy, so nobody can look inside"
    ),
    "inspector.parameter_file": "the parameter file {file} cannot be read: {reason}",
    "inspector.parameter_keys": "{file} is for {keys}, but no node has that name (there is {nodes}): its values are ignored",
    "inspector.parameter_nothing": "{file} has no ros__parameters: its values are ignored",
    "inspector.domains": "terminal {number} is in ROS_DOMAIN_ID {domain} and cannot see {nodes}, in {other}",
    "inspector.no_stamp": "{topic}: header.stamp is 0, so robot_state_publisher ignores it: set it to the clock's now()",
    "inspector.unequal_joints": "{topic} has {names} names and {positions} positions; such messages are ignored",
    "inspector.no_state_publisher": (
        "{nodes} sends {topic}, but robot_state_publisher isn't running: nobody makes transforms from it"
    ),
    "inspector.rviz_no_description": (
        "RViz waits for a robot, but nobody publishes /robot_description: is robot_state_publisher running?"
    ),
    "inspector.bad_description": "the robot description is broken: {reason}",
    "inspector.wheel_tumbles": (
        "the wheel {link} doesn't turn about its cylinder's axis, so it tumbles: rpy=\"1.5707963 0 0\" in <visual>"
    ),
    "inspector.wheel_no_axis": "the joint {joint} has no axis to turn about: 0 0 0 is not a direction",
    "inspector.wheel_stuck": "the joint {joint} cannot move: its limits are equal. Wheels need the type continuous",
    "inspector.wheel_height": (
        "the wheels {links} are not at the same height: their lowest points are {difference} m apart (origin of their "
        "joints)"
    ),
    "inspector.body_low": (
        "{link} reaches {difference} m below the wheels {links}: the robot would lie on its belly (origin of the "
        "wheels' joints)"
    ),
    "inspector.fixed_frame": "RViz: nobody sends the Fixed Frame {frame}; choose {other} (known: {frames})",
    "inspector.no_transforms": "RViz: nobody sends transforms, so not even the Fixed Frame {frame} is known",
    "inspector.untransformed": "RViz: no transform from {links} to {frame}: nobody sends the joints in between",
    "inspector.no_robot_model": "RViz shows no robot, because it has no RobotModel display: Add, RobotModel",
    "inspector.robot_model_deaf": (
        "RViz: the RobotModel listens to {topic} and has no description: set its Description Topic to {right}"
    ),
    "inspector.unseen.terminals": "not looked at: the terminals (they exist only on the desktop)",
    "inspector.unseen.files": "not looked at: the files of the workspaces",
    "inspector.unseen.programs": "not looked into: the programs of {names}, which send no reports",
    "inspector.unseen.messages": "not looked at: {names}, whose messages cannot be read here",
    "inspector.unseen.topics": "not looked at: what is sent on {names} more topics, because there are so many",
    "inspector.looked": "looked at: {sights}",
    "inspector.absent": "not there, so not looked at: {sights}",
    "inspector.sight.nodes": "nodes",
    "inspector.sight.topics": "topics",
    "inspector.sight.messages": "messages",
    "inspector.sight.services": "services",
    "inspector.sight.frames": "frames",
    "inspector.sight.joints": "joints",
    "inspector.sight.windows": "RViz and world windows",
    "inspector.sight.programs": "programs (inside)",
    "inspector.sight.terminals": "terminals",
    "inspector.sight.packages": "packages",
    "inspector.sight.machines": "other machines",
    "inspector.quiet.drill": (
        "In a drill you find the bug yourself: the inspector is silent until you solve it or give up. Look at what the programs "
        "say, at `ros2 node list`, `ros2 topic list`, `ros2 topic info -v`; `why` explains a message."
    ),
    "inspector.quiet.exam": (
        "In an exam you find the bug yourself: the inspector is silent until you solve it. Look at what the programs say, at "
        "`ros2 node list`, `ros2 topic list`, `ros2 topic info -v`."
    ),
    "inspector.well": "no fault found in what was looked at",
    # Beside the car
    "car.waiting_for_description": "nobody has published /robot_description yet: is robot_state_publisher running?",
    "car.loading": "reading the robot description",
    "car.bad_description": "the robot description is broken: {text}",
    "car.no_wheels": "this robot has no wheels: nothing turns about a horizontal axis",
    "car.no_joint_states": "nobody publishes {topic}: the wheels don't turn",
    "car.wrong_type": "{topic} has type {type}, but it must be sensor_msgs/msg/JointState",
    "car.unknown_joint": "joint {joint} is not in the URDF",
    "car.unknown_joint_near": "joint {joint} is not in the URDF; did you mean {nearest}?",
    "car.no_transform": "no transform from {link} to {frame}",
    "car.no_transform_more": "no transform from {count} more links to {frame}",
    "car.many_publishers": "{count} publishers on {topic}: {nodes}",
    "car.slow": "{topic} arrives only {rate} times a second: the eye needs about 20",
    "car.silent": "nothing on {topic} for {seconds} s",
    "car.stays": "This only draws angles. To make it drive: ros2 launch day6_world world.launch.py",
    # Below the world
    "world.waiting_for_robot": "the world is empty: nobody has published /robot_description yet",
    "world.refused": "{robot} cannot enter this world:",
    "world.bad_description": "the robot description is broken: {text}",
    "world.left_away": "parts of the robot could not be read: {text}",
    "world.no_inertial": "{links}: no <inertial>. Forces cannot move a link without mass; it would be a ghost",
    "world.bad_mass": "{link}: a mass of {mass} kg is impossible",
    "world.bad_inertia": "{link}: the inertia is not greater than 0 about every axis",
    "world.bad_number": "{link}: a size or position is not a number",
    "world.no_drive": "it has no left and right wheel to drive it",
    "world.stands_in_wall": "at ({x:.2f}, {y:.2f}) it would stand in a wall",
    "world.no_collision": "{links}: no <collision>. They pass through walls like ghosts",
    "world.wheels_without_collision": "{links}: wheels without <collision> don't touch the floor. They turn but push nothing",
    "world.nobody_drives": "nobody publishes {topic}: drive with ros2 run teleop_twist_keyboard teleop_twist_keyboard",
    "world.keeps_going": "nobody publishes {topic} any more: the last command applies until another one arrives",
    "world.wrong_type": "{topic} has type {type}, but this world needs {wanted}: start it with stamped:={stamped}",
    "world.two_joint_states": (
        "{nodes} publishes {topic} as well. That topic reports where the wheels are; it is not a command, so nothing rolls. With "
        "-r joint_states:=joint_commands it becomes one"
    ),
    "world.bumped": "it touches a wall: the wheels slip, and /odom doesn't notice",
    "world.sideways": "linear.y is ignored: two wheels cannot go sideways",
    # Classes of a .rviz file
    "rviz.missing.particles": (
        "class {type} isn't here: it draws the particles of nav2_amcl (nav2_msgs/ParticleCloud); it stays in the file"
    ),
    "rviz.missing.nav2_goal": (
        "class {type} isn't here: it gives Navigation2 a goal; rviz_default_plugins/SetGoal publishes one on /goal_pose; "
        "it stays in the file"
    ),
    "rviz.missing.nav2": "class {type} isn't here: it is part of Navigation2; it stays in the file",
    "rviz.missing.moveit": "class {type} isn't here: it is part of MoveIt; it stays in the file",
    "rviz.missing.slam_toolbox": "class {type} isn't here: it is part of slam_toolbox; it stays in the file",
    "rviz.missing.imu": (
        "class {type} isn't here: it comes with the package rviz_imu_plugin and shows an Imu as axes or a box; it stays in "
        "the file"
    ),
    "rviz.missing.ros1_same": (
        "class {type} isn't here: the file is from ROS 1; in ROS 2 it is called rviz_default_plugins/{name}; it stays in "
        "the file"
    ),
    "rviz.missing.ros1": "class {type} isn't here: the file is from ROS 1; it stays in the file",
    "rviz.missing.misspelt": "class {type} isn't here: {package} has nothing of that name; it stays in the file",
    "rviz.missing.plugin": "class {type} isn't here: it comes with the package {package}; it stays in the file",
}
