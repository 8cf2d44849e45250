"""The English texts."""

TEXTS = {
    # actions
    "action.terminal": "Terminal",
    "action.next": "Next",
    "action.previous": "Previous",
    "action.windows": "Windows",
    "action.enlarge": "Enlarge",
    "action.pause": "Pause",
    "action.resume": "Run",
    "action.palette": "Commands",
    "action.quit": "Quit",
    "action.help": "Help",
    "action.scene.turtle": "Drive the turtle",
    "action.scene.car": "Make the car's wheels turn",
    "action.close": "Close this terminal or window",
    "action.copy": "Copy the selection",
    "action.paste": "Paste",
    "action.clear": "Clear the terminal's scrollback",
    "action.language": "中文 / English",
    "action.theme": "Dark or light",
    "action.glyphs": "Next set of characters (half, braille, cell, ascii)",
    "action.grow": "Larger windows",
    "action.shrink": "Smaller windows",
    "action.step": "One step of time (while paused)",
    "action.faster": "Time faster",
    "action.slower": "Time slower",
    "action.normal": "Time at normal speed",
    "action.motion": "Less motion on or off",
    "help.action.terminal": "opens another terminal, with its own shell",
    "help.action.next": "gives the keyboard to the next terminal or window",
    "help.action.previous": "the same, backwards",
    "help.action.windows": "lists everything that is open",
    "help.action.enlarge": "makes the focused pane as large as the screen, and back",
    "help.action.pause": "lets the simulated world stand still, and run on",
    "help.action.palette": "finds every command by its name",
    "help.action.quit": "ends every program and closes the desktop",
    "help.action.help": "explains the focused pane",
    "help.action.scene.turtle": "types the two commands of the turtle lesson",
    "help.action.scene.car": "types the commands that show the car and turn its wheels",
    "help.action.close": "ends the shell, or the program that opened the window",
    "help.action.copy": "copies what is selected with the mouse",
    "help.action.paste": "types what was copied",
    "help.action.clear": "forgets what has scrolled away",
    "help.action.language": "changes the language of the desktop",
    "help.action.theme": "changes the colours",
    "help.action.glyphs": "changes how pictures are drawn",
    "help.action.grow": "gives the windows more room",
    "help.action.shrink": "gives the terminals more room",
    "help.action.step": "moves the paused world on by one tick of turtlesim (16 ms)",
    "help.action.faster": "up to ten times",
    "help.action.slower": "down to a tenth",
    "help.action.normal": "one second is one second",
    "help.action.motion": "without typing effects and pulses",
    # bars
    "bar.desk": "Desk",
    "bar.turtle": "Turtle",
    "bar.car": "Car",
    "bar.nodes": "nodes {count}",
    "bar.topics": "topics {count}",
    "bar.paused": "paused",
    "bar.language": "中文",
    "bar.help": "F1 Help",
    "bar.starting": "starting …",
    "bar.playing": "typing for you … Esc stops it",
    "bar.external": "student processes run at normal speed",
    # terminal
    "terminal.hint": "Arrow keys work only in here: click or {key}",
    "terminal.scrolled": "{count} lines further down · any key goes there",
    "terminal.copied": "Copied",
    "terminal.ended": "The shell has ended",
    "terminal.number": "Terminal {number}",
    # welcome
    "welcome.title": "Welcome",
    "welcome.heading": "ROS 2, right here in your terminal",
    "welcome.question": "What would you like to do?",
    "welcome.turtle": "Drive the turtle",
    "welcome.turtle.more": "turtlesim and the keyboard",
    "welcome.car": "Make the car's wheels turn",
    "welcome.car.more": "a URDF robot and /joint_states",
    "welcome.empty": "An empty desk",
    "welcome.empty.more": "just a terminal",
    "welcome.keys": "↑ ↓ choose   Enter go   or press the number",
    "welcome.truth": "The commands are typed for you, where you can see them. They are the real ones.",
    # guide
    "guide.title": "Desk",
    "guide.heading": "No window is open. A command opens one:",
    "guide.try": "Enter or a click types it into a terminal, you run it",
    "guide.ask": "Ask what is going on:",
    "guide.scene": "or let it be shown:",
    # turtlesim
    "turtlesim.pose": "x {x:.2f}  y {y:.2f}  θ {theta:.2f}  v {v:.1f}",
    "turtlesim.none": "no turtle",
    "turtlesim.more": "{count} more",
    "turtlesim.label": "names",
    # car
    "car.lines": "lines",
    "car.waiting_for_description": "nobody has published /robot_description yet: is robot_state_publisher running?",
    "car.loading": "reading the robot description",
    "car.bad_description": "the robot description is broken: {text}",
    "car.no_wheels": "this robot has no wheels: nothing that turns about a level axis",
    "car.no_joint_states": "nobody publishes {topic}: the wheels do not turn",
    "car.wrong_type": "{topic} has type {type}, sensor_msgs/msg/JointState is needed",
    "car.unknown_joint": "joint {joint} is not in the URDF",
    "car.unknown_joint_near": "joint {joint} is not in the URDF; did you mean {nearest}?",
    "car.no_transform": "no transform from {link} to {frame}",
    "car.no_transform_more": "no transform from {count} more links to {frame}",
    "car.many_publishers": "{count} publishers on {topic}: {nodes}",
    "car.slow": "{topic} comes only {rate} times a second: the eye needs about 20",
    "car.silent": "nothing on {topic} for {seconds} s",
    # rqt_graph
    "rqt.hidden": "{count} hidden:",
    "rqt.hides": "{option} hides {names}",
    "rqt.separator": "; ",
    "rqt.nothing_hidden": "nothing is hidden",
    "rqt.empty": "No node is publishing or subscribing.",
    "rqt.type": "type",
    "rqt.hide": "Hide",
    "rqt.refresh": "refresh",
    # topics
    "topics.columns.topic": "topic",
    "topics.columns.rate": "rate",
    "topics.columns.bandwidth": "bandwidth",
    "topics.none": "There is no topic yet. Start a node.",
    "topics.type": "type",
    "topics.publishers": "publishers",
    "topics.subscriptions": "subscriptions",
    "topics.last": "last message",
    "topics.quiet": "not listening: Enter listens",
    "topics.waiting": "listening, nothing came yet",
    "topics.listen": "listen",
    "topics.stop": "stop",
    # menus
    "menu.palette": "Commands",
    "menu.windows": "Windows and terminals",
    "menu.filter": "type to search",
    "menu.none": "nothing of that name",
    "menu.keys": "↑ ↓ choose   Enter go   Esc back",
    "menu.keys.close": "↑ ↓ choose   Enter go   Del close   Esc back",
    "menu.terminal": "terminal",
    "menu.window": "window",
    # help
    "help.title": "Help",
    "help.keys": "↑ ↓ scroll   Esc back",
    "help.everywhere": "Keys that work everywhere",
    "help.desk": (
        "This is the desk of a small Ubuntu computer with ROS 2. On it are terminals, in which you type commands, and the "
        "windows that programs open.\n\nNothing happens here that a command did not cause. Everything you learn here works the "
        "same on a real Ubuntu."
    ),
    "help.terminal": (
        "A terminal: type a command and press Enter.\n\n"
        "Tab completes what you began, Up brings back earlier commands, Ctrl-R searches them. Ctrl-C ends the program that runs, "
        "Ctrl-D on an empty line ends the shell. Ctrl-Z and bg let a program go on in the background; so does & at the end of a "
        "command.\n\n"
        "Shift+PageUp, or the mouse wheel, looks back. Drag with the mouse to copy; Shift+Insert or the middle button pastes."
    ),
    "help.turtlesim": (
        "The world of turtlesim, 11.09 metres wide. The node /turtlesim hears velocities on /turtle1/cmd_vel and tells "
        "where the turtle is on /turtle1/pose.\n\n"
        "To drive, start ros2 run turtlesim turtle_teleop_key in a terminal and keep the keyboard there: the arrow "
        "keys work only in the terminal that runs it.\n\n"
        "Ctrl-C in the terminal of turtlesim_node closes this window."
    ),
    "help.car": (
        "Your robot from above, drawn from its URDF. The wheels turn as /joint_states and /tf say: nobody publishes, nothing "
        "turns. In this picture the car stays where it is; turning wheels move nothing, just as in RViz."
    ),
    "help.rqt_graph": (
        "Which node talks to which. Ellipses are nodes, arrows are topics. A pulse runs along an arrow when messages pass. "
        "The line below says what the filters hide."
    ),
    "help.topics": (
        "All topics, with their type and how many publish and subscribe. Enter listens to the chosen topic and measures its "
        "rate and bandwidth; the last message is shown below. Listening is a subscription, so it counts as one."
    ),
    "help.welcome": (
        "Choose with the arrow keys and Enter, with a number, or with the mouse. The first choices type their commands into "
        "terminals, one after the other, as a teacher would."
    ),
    # errors
    "error.home": "The home folder {path} cannot be used: {reason}",
    "error.window": "This window cannot be drawn: {reason}",
    "error.desk": "The simulated machine could not start: {reason}",
    "error.small": "too small",
    "error.continue": "Esc closes this message",
    "error.title": "Something went wrong",
}
