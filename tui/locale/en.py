"""The English texts; those of the programs' remarks stand with the programs, which print them without a screen too."""

from day6_tui.core.ros import remark_texts

TEXTS = {
    **remark_texts.TEXTS,
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
    "action.scene.world": "Drive the car in a world",
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
    "action.step": "One time step (while paused)",
    "action.faster": "Faster time",
    "action.slower": "Slower time",
    "action.normal": "Normal time",
    "action.motion": "Less motion on or off",
    "help.action.terminal": "opens another terminal, with its own shell",
    "help.action.next": "moves the keyboard focus to the next terminal or window",
    "help.action.previous": "the same, in reverse order",
    "help.action.windows": "lists everything that is open",
    "help.action.enlarge": "makes the focused pane fill the screen, or restores it",
    "help.action.pause": "pauses or resumes the simulated world",
    "help.action.palette": "finds any command by name",
    "help.action.quit": "ends every program and closes the desktop",
    "help.action.help": "explains the focused pane",
    "help.action.scene.turtle": "types the two commands of the turtle lesson",
    "help.action.scene.world": "types the commands that put the car into a world with walls and drive it from the keyboard",
    "help.action.scene.car": "types the commands that show the car and turn its wheels",
    "help.action.close": "ends the shell, or the program that opened the window",
    "help.action.copy": "copies what is selected with the mouse",
    "help.action.paste": "types what was copied",
    "help.action.clear": "discards the lines that have scrolled out of view",
    "help.action.language": "changes the language of the desktop",
    "help.action.theme": "changes the colours",
    "help.action.glyphs": "changes how pictures are drawn",
    "help.action.grow": "gives the windows more room",
    "help.action.shrink": "gives the terminals more room",
    "help.action.step": "advances the paused world by one turtlesim tick (16 ms)",
    "help.action.faster": "up to ten times",
    "help.action.slower": "down to a tenth",
    "help.action.normal": "one second is one second",
    "help.action.motion": "turns typing effects and pulses off or on",
    # bars
    "bar.desk": "Desk",
    "bar.turtle": "Turtle",
    "bar.car": "Car",
    "bar.world": "World",
    "bar.nodes": "nodes {count}",
    "bar.topics": "topics {count}",
    "bar.paused": "paused",
    "bar.language": "中文",
    "bar.door.open": "open {port}: {joined}",
    "bar.door.opening": "opening {port}",
    "bar.door.in_use": "port {port} in use",
    "bar.door.no_name": "{host} unknown",
    "bar.door.nobody": "no answer: {host}",
    "bar.door.no_answer": "no answer: {host}",
    "bar.door.not_let_in": "refused by {host}",
    "bar.door.failed": "{host}: failed",
    "bar.door.joined": "joined {host}",
    "bar.door.calling": "connecting {host}",
    "notice.open": "anyone who reaches port {port} can read and command; --secret keeps others out",
    "bar.help": "F1 Help",
    "bar.starting": "starting …",
    "bar.playing": "typing for you … Esc stops it",
    "bar.external": "student processes run at normal speed",
    # one window on a real terminal
    "single.end": "End",
    "single.help": "Help",
    "single.log": "Log",
    "single.no_log": "The program has written nothing yet.",
    "help.single.end": "ends the program",
    "help.single.help": "explains this window",
    "help.single.log": "shows what the program has written; it is also on the terminal afterwards",
    "help.single.next": "goes to the program's next window, if it has more than one",
    "help.single.glyphs": "changes how pictures are drawn",
    "help.single.language": "changes the language: 中文",
    "help.single.suspend": "stops the program and returns to the shell; fg resumes it",
    # terminal
    "window.hidden": "{title} is open: {key} shows it",
    "terminal.stubborn": "It ignores Ctrl-C. Ctrl-\\ ends it; or Ctrl-Z, then: kill -9 %%",
    "input.gbk": "Your terminal sends GBK, not UTF-8: set it to UTF-8 (PuTTY: Window > Translation)",
    "input.not_utf8": "Your terminal sends bytes that are not UTF-8: set it to UTF-8",
    "terminal.hint": "Arrow keys work only in here: click or {key}",
    "terminal.arrows": "Arrow keys only drive in terminal {number}: {key} goes there",
    "terminal.scrolled": "{count} more lines below · any key goes there",
    "terminal.copied": "Copied",
    "terminal.no_room": "No new terminal: too many programs are running. End some of them (Ctrl-C, kill, close their terminals)",
    # welcome
    "welcome.title": "Welcome",
    "welcome.heading": "ROS 2, right here in your terminal",
    "welcome.question": "What would you like to do?",
    "welcome.turtle": "Drive the turtle",
    "welcome.turtle.more": "turtlesim and the keyboard",
    "welcome.car": "Make the car's wheels turn",
    "welcome.car.more": "a URDF robot and /joint_states",
    "welcome.world": "Drive the car in a world",
    "welcome.world.more": "day6_world and /cmd_vel",
    "welcome.empty": "An empty desk",
    "welcome.empty.more": "just a terminal",
    "welcome.keys": "Choose with ↑ ↓ Enter or a number, or type a command",
    "welcome.truth": "The commands are typed for you, where you can see them. They are the real ones.",
    # guide
    "guide.title": "Desk",
    "guide.heading": "No window is open. A command opens one:",
    "guide.try": "Enter or a click types it into a terminal; you run it",
    "guide.ask": "Ask what is going on:",
    "guide.scene": "or watch it being done:",
    # turtlesim
    "turtlesim.pose": "x {x:.2f}  y {y:.2f}  θ {theta:.2f}  v {v:.1f}",
    "turtlesim.none": "no turtle",
    "turtlesim.more": "{count} more",
    "turtlesim.label": "names",
    # car
    "car.zoom": "zoom",
    "car.lines": "lines",
    # world
    "world.pose": "x {x:.2f}  y {y:.2f}  {degrees}°  v {v:.2f} m/s",
    "world.line": "line",
    "world.zoom": "zoom",
    "world.follow": "follow",
    "world.lidar": "lidar",
    "world.step": "step",
    "world.reset": "back to the start",
    # joint sliders
    "sliders.waiting": "Waiting for a robot on /robot_description: is robot_state_publisher running?",
    "sliders.none": "This robot has no joint that can be moved.",
    "sliders.conflict": "{nodes} publishes the same joints: the robot jitters between two commands. One of the two has to stop.",
    "sliders.degrees": "degrees",
    "sliders.move": "move",
    "sliders.value": "number",
    "sliders.zero": "zero",
    "sliders.accept": "accept",
    "sliders.cancel": "cancel",
    # rqt_graph
    "rqt.hidden": "{count} hidden: {reasons}",
    "rqt.hides": "{option} hides {names}",
    "rqt.separator": "; ",
    "rqt.nothing_hidden": "nothing is hidden",
    "rqt.empty": "No node is publishing or subscribing.",
    "rqt.type": "type",
    "rqt.hide": "Hide",
    "rqt.refresh": "refresh",
    "inspector.title": "Inspector",
    "inspector.count": "{errors} errors, {all} in all",
    "action.inspector": "Inspect",
    "help.action.inspector": "what is wrong with the graph right now",
    "editor.save": "save",
    "editor.find": "find",
    "editor.line": "go to line",
    "editor.close": "close",
    "editor.write": "save (Enter)",
    "editor.write.name": "File Name to Write",
    "editor.name": "a name is needed",
    "editor.exists": "{name} exists: Enter again overwrites it",
    "editor.modified": "Save modified buffer?",
    "editor.modified.keys": "Y  save    N  discard the changes    Esc  go on editing",
    "editor.cut": "cut lines, put them back",
    "editor.indent": "indent; all selected lines if there are any",
    "editor.outdent": "unindent",
    "editor.new": "A new file …",
    "editor.no_folder": "there is no folder {name}",
    "editor.undo": "undo, redo",
    "editor.open": "other file",
    "editor.reload": "as on disk",
    "editor.files": "Open a file",
    "editor.choose": "Enter chooses a file of this folder.",
    "editor.problem": "line {line}: {text}",
    "editor.recovered": "not saved last time, restored here; ^R loads the file from disk",
    "editor.outside": "the file was changed elsewhere; ^R loads that, ^S keeps this",
    "editor.beyond": "outside your home folder: again changes it anyway",
    "editor.overwrite": "the file was changed elsewhere: ^S again overwrites it",
    "editor.not_saved": "not saved: {reason}",
    "editor.not_kept": "no copy of the unsaved text: {reason}",
    "editor.unsaved": "not saved: ^S saves, the same key again closes (a copy is kept)",
    "editor.lose": "again loses the text, no copy: {reason}",
    "editor.gone": "file gone from disk; ^S writes it again",
    "quit.title": "A text would be lost",
    "quit.lost": "Neither saved nor kept: {what}. Y  quit anyway    Esc  go back",
    "quit.was_lost": "day6-tui: unsaved text was lost: {what}",
    "editor.not_found": "{text} not found",
    "editor.lines": "1 to {count}",
    "prompt.replaces": "{file} already exists; Enter again replaces it",
    "prompt.keys": "Enter accept   Esc back",
    "rqt.choose": "choose",
    "rqt.filter": "filter nodes, topics",
    "rqt.namespaces": "namespaces",
    "rqt.group": "Group",
    "rqt.view": "Highlight, Fit",
    "rqt.files": "save, open",
    "rqt.auto": "auto refresh",
    "rqt.node_filter": "Node filter",
    "rqt.topic_filter": "Topic filter",
    "rqt.filter_note": "Names or regular expressions separated by commas; a leading - leaves out, / is all. Example: -/rqt.*",
    "rqt.save": "Save the graph as",
    "rqt.save_note": ".dot for Graphviz, .svg or .png for a picture",
    "rqt.load": "Open a DOT file",
    "rqt.load_note": "It is shown instead of the live graph, until r refreshes.",
    "rqt.loaded": "from the file {name}; r shows the live graph",
    "rqt.node": "{name}: {arriving} arrows in, {leaving} out",
    "rqt.topic": "{name}: published by {arriving}, subscribed to by {leaving}",
    # topics
    "topics.columns.topic": "topic",
    "topics.columns.publishers": "pub",
    "topics.columns.subscriptions": "sub",
    "topics.none": "There are no topics yet. Start a node.",
    "topics.publishers": "publishers",
    "topics.subscriptions": "subscriptions",
    "topics.last": "last message",
    "topics.quiet": "not listening: Enter listens",
    "topics.waiting": "listening, nothing received yet",
    "topics.listen": "listen",
    "topics.stop": "stop",
    # rviz2
    "rviz.key.view": "view",
    "rviz.key.panel": "panel",
    "rviz.key.edit": "change",
    "rviz.key.add": "add",
    "rviz.key.focus": "focus",
    "rviz.key.turn": "turn",
    "rviz.key.zoom": "zoom",
    "rviz.key.above": "45° from above",
    "rviz.loading": "reading {what}",
    "rviz.hint.topic": "No topic yet. Enter on {name} lets you choose: {options}",
    "rviz.hint.no_topic": "No topic yet, and nobody publishes one for {name}: is the node running?",
    "rviz.hint.description": "the robot description is broken: {reason}",
    "rviz.hint.config": "{file} could not be read: {reason}",
    "rviz.hint.no_config": "there is no file {file}; this is the default view",
    "rviz.bad.bool": "true or false, please",
    "rviz.bad.int": "a whole number, please",
    "rviz.bad.float": "a number, please",
    "rviz.bad.finite": "this number is not finite",
    "rviz.bad.vector": "three numbers, please: 0; 0; 0.5",
    "rviz.bad.quaternion": "four numbers, please: x; y; z; w",
    "rviz.bad.colour": "three numbers from 0 to 255, please: red; green; blue",
    "rviz.bad.enum": "one of these, please: {options}",
    "rviz.bad.name": "a name, please",
    "rviz.bad.picture": "the name must end in .png or .svg",
    "rviz.choose": "Choose",
    "rviz.type_it": "type another …",
    "rviz.add.title": "Add",
    "rviz.add.by_type": "by display type",
    "rviz.add.by_topic": "by topic",
    "rviz.rename": "Rename",
    "rviz.save_as": "Save as",
    "rviz.load": "Open a .rviz file",
    "rviz.saved": "saved: {file}",
    "rviz.not_saved": "{file} could not be saved: {reason}",
    "rviz.not_loaded": "{file} could not be loaded: {reason}",
    "rviz.picture": "Save a picture",
    "rviz.picture_note": ".png or .svg",
    "rviz.quality": "quality: {name}",
    "rviz.nothing_to_focus": "there is nothing to look at yet",
    "rviz.type.Axes": "the axes of a frame",
    "rviz.type.Grid": "lines on the ground",
    "rviz.type.LaserScan": "points of a laser scanner",
    "rviz.type.Map": "an occupancy grid",
    "rviz.type.Marker": "a program's own shapes",
    "rviz.type.MarkerArray": "many markers",
    "rviz.type.Odometry": "where a robot has been",
    "rviz.type.Path": "a planned path",
    "rviz.type.Image": "the picture of a camera",
    "rviz.type.PointCloud2": "points of a depth camera",
    "rviz.type.PointStamped": "single points",
    "rviz.type.Pose": "a position and orientation",
    "rviz.type.PoseArray": "many poses",
    "rviz.type.Range": "the cone of a distance sensor",
    "rviz.type.RobotModel": "a robot from its URDF",
    "rviz.type.TF": "all frames",
    "rviz.colour.black": "black",
    "rviz.colour.dark": "dark",
    "rviz.colour.grey": "grey",
    "rviz.colour.white": "white",
    "rviz.colour.red": "red",
    "rviz.colour.orange": "orange",
    "rviz.colour.yellow": "yellow",
    "rviz.colour.green": "green",
    "rviz.colour.cyan": "cyan",
    "rviz.colour.blue": "blue",
    "rviz.colour.purple": "purple",
    "rviz.kind.box": "box",
    "rviz.kind.cylinder": "cylinder",
    "rviz.kind.sphere": "sphere",
    "rviz.kind.mesh": "mesh",
    "rviz.seen.grid": "a grid of {cells}×{cells} cells of {size} m",
    "rviz.seen.frames": "the axes of {count} frames",
    "rviz.seen.no_frames": "no frames: nobody publishes /tf",
    "rviz.seen.axes": "the axes of {frame}",
    "rviz.seen.points": "{name}: {count} points",
    "rviz.seen.image": "{name}: image of {size} pixels",
    "rviz.seen.messages": "{name}: {count} messages",
    "rviz.seen.separator": "; ",
    "rviz.seen.comma": ", ",
    "rviz.seen.nothing": "nothing: no display is enabled",
    "rviz.seen.no_robot": "no robot yet",
    "rviz.seen.robot": "robot {name}: {parts}",
    "rviz.seen.link": "{colour} {kind} {name} {size}",
    "rviz.seen.lost": " (no transform: white, out of place)",
    "rviz.seen.all_lost": "robot {name}, all white: none of its links has a transform to {frame}",
    "rviz.seen.turned": ", turned {degrees}°",
    "rviz.seen.more": "and {count} more links",
    # rqt
    "rqt.plugins": "Which window? Each is also a command of its own.",
    "rqt.open": "open",
    "rqt.about.rqt_graph": "who talks to whom",
    "rqt.about.rqt_console": "the log messages of all nodes",
    "rqt.about.rqt_topic": "topics, their rates and messages",
    "rqt.about.rqt_plot": "numbers over time",
    # rqt_console
    "console.message": "Message",
    "console.severity": "Severity",
    "console.node": "Node",
    "console.stamp": "Stamp",
    "console.location": "Location",
    "console.none": "No log message yet: they come from /rosout.",
    "console.filtered": "All messages are left out; a shows them.",
    "console.exclude": "Exclude",
    "console.containing": "Exclude messages containing",
    "console.containing.note": "Messages with this text are left out; an empty line shows them again.",
    "console.highlighted": "Highlight messages containing",
    "console.highlighted.note": "Messages with this text stand out; an empty line turns this off.",
    "console.nodes": "without",
    "console.count": "{count} messages",
    "console.shown": "{count} of {total} messages",
    "console.paused": "paused",
    "console.pause": "pause",
    "console.resume": "resume",
    "console.clear": "clear",
    "console.leave_out": "exclude text",
    "console.highlight": "highlight",
    "console.node_out": "exclude node",
    "console.all": "show all",
    # rqt_plot
    "plot.none": "Nothing is plotted yet: a chooses a field, e types one, like /turtle1/pose/x.",
    "plot.waiting": "waiting for the topic",
    "plot.quiet": "nothing received yet",
    "plot.paused": "paused",
    "plot.seconds": "{count} s",
    "plot.add": "add",
    "plot.type": "type a field",
    "plot.type.note": "A topic and a field, like /turtle1/pose/x or /joint_states/position[0]; /turtle1/pose/x:y is two.",
    "plot.choose": "Plot a field",
    "plot.remove": "remove",
    "plot.pause": "pause",
    "plot.resume": "resume",
    "plot.span": "time",
    "plot.clear": "clear",
    # menus
    "menu.palette": "Commands",
    "menu.windows": "Windows and terminals",
    "menu.filter": "type to search",
    "menu.none": "nothing by that name",
    "menu.keys": "↑ ↓ choose   Enter go   Esc back",
    "menu.keys.close": "↑ ↓ choose   Enter go   Del close   Esc back",
    "menu.terminal": "terminal",
    "menu.window": "window",
    # help
    "help.title": "Help",
    "help.keys": "↑ ↓ scroll   Esc back",
    "list.head": "{name}: ",
    "help.everywhere": "Keys that work everywhere",
    "help.desk": (
        "This is the desk of a small Ubuntu computer with ROS 2. On it are terminals, in which you type commands, and the "
        "windows that programs open.\n\nNothing happens here that a command did not cause. Everything you learn here works the "
        "same on a real Ubuntu."
    ),
    "help.terminal": (
        "A terminal: type a command and press Enter.\n\n"
        "Tab completes what you began to type, Up brings back earlier commands, Ctrl-R searches them. Ctrl-C ends the running "
        "program, Ctrl-D on an empty line ends the shell. Ctrl-Z and bg let a program go on in the background; so does & at "
        "the end of a command.\n\n"
        "Shift+PageUp, or the mouse wheel, scrolls back. Drag with the mouse to copy; Shift+Insert or the middle button pastes."
    ),
    "help.turtlesim": (
        "The world of turtlesim, 11.09 metres wide. The node /turtlesim subscribes to velocities on /turtle1/cmd_vel and "
        "publishes where the turtle is on /turtle1/pose.\n\n"
        "To drive, start ros2 run turtlesim turtle_teleop_key in a terminal and keep the keyboard there: the arrow "
        "keys work only in the terminal that runs it.\n\n"
        "Ctrl-C in the terminal of turtlesim_node closes this window."
    ),
    "help.car": (
        "Your robot from above, drawn from its URDF. The wheels turn as /joint_states and /tf say: if nobody publishes, nothing "
        "turns. In this picture the car stays where it is; turning wheels move nothing, just as in RViz.\n\n"
        "+ and - enlarge and shrink the picture, the arrow keys move it, 0 shows everything, b changes the lines."
    ),
    "help.rviz2": (
        "RViz shows what ROS knows: robots, frames, sensor data. It moves nothing. On the left is the Displays panel, on the "
        "right the 3-D view.\n\n"
        "Three settings show your robot: Fixed Frame (a frame that exists, such as base_link), Add RobotModel, and in it "
        "Description Topic /robot_description. Red and yellow lines say what is missing; the line at the bottom says it in "
        "full.\n\n"
        "Tab\tpanel or view\nEnter\tchange a value, open a branch\nSpace\tcheck box\n^N or a\tadd a display\n"
        "^X ^D ^R\tremove, duplicate, rename a display\nShift ↑ ↓\tmove a display\nd\thide or show the panel\n"
        "arrows\tturn the view, with Shift pan it\n+ -\tzoom\nf\tlook at the robot\n4\t45° from above\nz\tview as at the "
        "start\nv\tOrbit, XYOrbit, TopDownOrtho, FPS\np\tquality: less detail is faster\nr\treset\n"
        "^S w ^O\tsave, save as, open\ng\tsave a picture\n\n"
        "Mouse: drag turns, Shift or Ctrl and drag pans, the wheel zooms."
    ),
    "help.rqt_graph": (
        "Which node talks to which. Ellipses are nodes, arrows are topics. A pulse runs along an arrow when messages pass. "
        "The line below says what the filters hide."
    ),
    "help.editor": (
        "A file of your home folder. What is wrong in it is named below and underlined, while you type. Unsaved text is kept and "
        "comes back, whatever happens. Any other editor on the same files works as well: a change on the disk shows up here."
    ),
    "help.inspector": (
        "What is wrong with the graph right now: names that differ by a letter, types and QoS that do not match, two publishers "
        "that fight, joints the robot does not have. Red keeps messages from arriving."
    ),
    "help.topics": (
        "All topics, with their type and how many publish and subscribe. Enter listens to the chosen topic and measures its "
        "rate and bandwidth; the last message is shown below. Listening is a subscription, so it counts as one."
    ),
    "help.world": (
        "A small world with physics, in place of the Gazebo of a real lesson. The wheels touch the floor, so when they turn the "
        "robot rolls: /cmd_vel or /joint_commands turns them. It publishes its position on /odom as the wheels measure it, "
        "and senses with /scan and /line_sensor.\n\n"
        "To enter, every link needs <inertial>; a link without <collision> goes through walls.\n\n"
        "+ and - zoom, arrows move the view, f follows the robot, 0 shows everything. l shows the lidar, t wipes the trail. "
        "Space pauses, n takes one step, [ and ] change the speed of time, r puts the robot back to its start."
    ),
    "help.joint_state_publisher": (
        "A slider for every joint that can move. What you set here goes to /joint_states ten times a second; "
        "robot_state_publisher turns it into the poses of the links.\n\n"
        "Up and down choose a joint, left and right move it (with Shift: finely), PageUp and PageDown move it far, Home and "
        "End go to its limits, z to zero. A digit or Enter begins an exact number. r is Randomize, c is Center, d changes "
        "between radians and degrees. With the mouse: drag the knob.\n\n"
        "If another node publishes the same joints, the robot jitters: both send commands, and the last one counts."
    ),
    "help.rqt": (
        "rqt collects the windows of the ROS tools. The arrow keys choose one, Enter opens it in place of this list."
    ),
    "help.rqt_console": (
        "The log messages of all nodes, from the topic /rosout. The arrow keys choose one; it is shown in full "
        "below the table.\n\nThe letters leave out severities: d Debug, i Info, w Warn, e Error, f Fatal. What a node does not "
        "log at all is decided by its level: see --log-level, and the logger services."
    ),
    "help.rqt_plot": (
        "Numbers from messages, over time. Each curve is one field of one topic; the legend shows its newest value. "
        "The value axis adapts to what is visible.\n\nA field is written like a path: /turtle1/pose/x, for an "
        "element of a list /joint_states/position[0]. Listening is a subscription, so it counts as one."
    ),
    "help.guide": (
        "No window is open at present, so here are commands worth trying. Choose one with the arrow keys and Enter, or click it: "
        "it is typed into a terminal, and runs when you press Enter there.\n\n"
        "The last ones type all commands of a lesson for you, one after the other, as a teacher would."
    ),
    "help.welcome": (
        "Choose with the arrow keys and Enter, with a number, or with the mouse. The first choices type their commands into "
        "terminals, one after the other, as a teacher would.\n\nOr simply begin to type a command: it goes to a terminal."
    ),
    # errors
    "error.home": "The home folder {path} cannot be used: {reason}",
    "error.window": "This window cannot be drawn: {reason}",
    "error.continue": "Esc closes this message",
    "error.title": "Something went wrong",
}
