"""rqt and its plugins, and the fields of messages in some of them."""

TEXTS = {
    # topics
    "topics.columns.topic": "Topic",
    "topics.columns.type": "Type",
    "topics.columns.bandwidth": "Bandwidth",
    "topics.columns.hz": "Hz",
    "topics.columns.value": "Value",
    "topics.none": "There are no topics yet. Start a node.",
    "topics.no_match": "No topic matches. Esc shows all.",
    "topics.publishers": "publishers",
    "topics.subscriptions": "subscriptions",
    "topics.history": "recent rate",
    "topics.quiet": "not monitored",
    "topics.waiting": "nothing yet",
    "topics.listen": "listen",
    "topics.stop": "stop",
    "topics.open": "open",
    "topics.sort": "sort",
    "topics.reverse": "sort the other way",
    "topics.filter": "filter",
    "topics.view": "view",
    "topics.filter_note": "Part of a topic's name or type; leave it empty to show all.",
    "topics.filtered": "of {count}, filter: {text}",
    "topics.unfilter": "show all",
    # fields of messages
    "fields.request": "Request: Topic",
    "fields.response": "Response: Field",
    "fields.type": "Type",
    "fields.expression": "Expression",
    "fields.value": "Value",
    "fields.edit": "change",
    "fields.take": "accept",
    "fields.on": "and go to the next field",
    "fields.leave": "keep the old value",
    "fields.next": "next field, while typing",
    "fields.default": "default value",
    "fields.in_force": "in force: {text}",
    "fields.elements": "add, remove an element",
    # service_caller
    "service.call": "Call",
    "service.cancel": "Cancel",
    "service.refresh": "Refresh",
    "service.choose": "service",
    "service.choose_title": "Service",
    "service.none": "no service",
    "service.count": "{count} services",
    "service.waiting_for_any": "There are no services yet. Start a node.",
    "service.waiting": "Called. Waiting for the response.",
    "service.waiting.long": "No response for {seconds} s. x stops waiting.",
    "service.cancelled": "Cancelled: no longer waiting for the response. The node may still be working.",
    "service.gone": "The node that offered this service is gone: there will be no response.",
    # publisher
    "publisher.columns.topic": "Topic",
    "publisher.columns.type": "Type",
    "publisher.columns.rate": "Rate",
    "publisher.columns.expression": "Expression",
    "publisher.columns.both": "Rate, expression",
    "publisher.add": "Add",
    "publisher.once": "Publish once",
    "publisher.remove": "Remove",
    "publisher.clear": "Clear",
    "publisher.tick": "publish",
    "publisher.new": "add a new topic",
    "publisher.none": "No publishers yet. a adds one: choose its topic, then tick its box.",
    "publisher.choose_topic": "Topic to publish on",
    "publisher.new_topic": "another topic …",
    "publisher.new_topic.note": "The name of a topic; you choose its type next.",
    "publisher.choose_type": "Type of the topic",
    # type browsers
    "types.columns.tree": "Tree",
    "types.columns.type": "Type",
    "types.columns.path": "Path",
    "types.package": "Package",
    "types.no_package": "no package",
    "types.add": "Add a type",
    "types.text": "view text",
    "types.remove": "remove",
    "types.choose.msg": "Message",
    "types.choose.srv": "Service",
    "types.choose.action": "Action",
    "types.none.msg": "p chooses a package, then a one of its message types.",
    "types.none.srv": "p chooses a package, then a one of its service types.",
    "types.none.action": "p chooses a package, then a one of its action types.",
    # action_browser
    "actions.live": "Action",
    "actions.none": "No action server is running.",
    "actions.ends": "servers {servers}, clients {clients}",
    "actions.server": "server",
    "actions.client": "client",
    "actions.goal": "Goal to send",
    "actions.id": "goal {id}",
    "actions.own": "sent from here",
    "actions.feedback": "Feedback",
    "actions.result": "Result",
    "actions.watch": "watch",
    "actions.send": "Send goal",
    "actions.cancel": "Cancel goal",
    "actions.state.sent": "Sent. The server has not accepted it yet.",
    "actions.state.rejected": "Goal was rejected.",
    "actions.state.no_server": "No server offers this action right now.",
    # rqt
    "rqt.open": "open",
    "rqt.close": "close",
    "rqt.is_open": "open: {name}",
    "rqt.perspective": "perspective {name}",
    "rqt.perspectives": "perspectives",
    "rqt.create": "New perspective",
    "rqt.create.note": "from what is open now",
    "rqt.import": "Open a file",
    "rqt.export": "Write to a file",
    "rqt.wrong_name": "Not a valid name.",
    "rqt.name_taken": "This name is taken.",
    "rqt.about.rqt_action": "action types, and their goals",
    "rqt.about.rqt_reconfigure": "parameters of running nodes",
    "rqt.about.rqt_graph": "who talks to whom",
    "rqt.about.rqt_bag": "record, view and play bags",
    "rqt.about.rqt_console": "the log messages of all nodes",
    "rqt.about.rqt_logger_level": "how much a node logs",
    "rqt.about.rqt_shell": "a command line",
    "rqt.about.rqt_py_console": "a Python prompt",
    "rqt.about.rqt_robot_steering": "drive a robot with two sliders",
    "rqt.about.rqt_service_caller": "call a service",
    "rqt.about.rqt_srv": "service types",
    "rqt.about.rqt_publisher": "publish your own messages",
    "rqt.about.rqt_msg": "message types",
    "rqt.about.rqt_topic": "topics, their rates and messages",
    "rqt.about.rqt_image_view": "images of a camera",
    "rqt.about.rqt_plot": "numbers over time",
    "rqt.about.rqt_tf_tree": "which frame is whose parent",
    # rqt_tf_tree
    "tf_tree.columns.frame": "Frame",
    "tf_tree.columns.age": "Age s",
    "tf_tree.columns.rate": "Rate Hz",
    "tf_tree.columns.buffer": "Buffer s",
    "tf_tree.columns.broadcaster": "Broadcaster",
    "tf_tree.none": "No tf data received",
    "tf_tree.static": "static",
    "tf_tree.again": "(again: a loop)",
    "tf_tree.root": "{name}: a root. Nobody sends a transform to it from a parent.",
    "tf_tree.old": "{count} old",
    "tf_tree.recorded": "Recorded at time: {time}",
    "tf_tree.refresh": "refresh",
    "tf_tree.clear": "clear buffer",
    "tf_tree.auto": "auto refresh",
    "tf_tree.sideways": "move the names",
    "tf_tree.save": "save as",
    "tf_tree.saved": "saved: {name}",
    "tf_tree.save_note": "The suffix decides the format: .pdf, .svg and .png for a picture, .dot for Graphviz.",
    # rqt_reconfigure
    "reconfigure.none": "No node has parameters yet. Start a node.",
    "reconfigure.no_match": "No node matches. Esc shows all.",
    "reconfigure.choose": "Enter opens a node on the left: its parameters appear here.",
    "reconfigure.reading": "reading the parameters …",
    "reconfigure.unread": "not read; r reads again",
    "reconfigure.waiting": "no response for {seconds} s: {reason}. Esc stops waiting.",
    "reconfigure.gone": "This node is gone: these were its parameters.",
    "reconfigure.not_there": "This node does not exist.",
    "reconfigure.no_parameters": "no parameters",
    "reconfigure.read_only": "read-only",
    "reconfigure.sent": "sent, no response yet",
    "reconfigure.nodes": "nodes: {count}",
    "reconfigure.filtered": "filter: {text}",
    "reconfigure.open": "open",
    "reconfigure.close": "close",
    "reconfigure.read": "read again",
    "reconfigure.switch": "switch",
    "reconfigure.move": "move",
    "reconfigure.far": "move ten steps",
    "reconfigure.ends": "minimum, maximum",
    "reconfigure.value": "value",
    "reconfigure.side": "other side",
    "reconfigure.filter": "filter",
    "reconfigure.cancel": "stop waiting; show all",
    "reconfigure.files": "save, load",
    "reconfigure.filter_nodes": "Nodes with",
    "reconfigure.filter_parameters": "Parameters with",
    "reconfigure.unfitting": "Not a value of type {type}.",
    "reconfigure.save": "Save parameters to file...",
    "reconfigure.load": "Load from File",
    "reconfigure.saved": "saved: {file}",
    # rqt_logger_level
    "loggers.nodes": "Nodes",
    "loggers.loggers": "Loggers",
    "loggers.levels": "Levels",
    "loggers.choose": "Enter chooses a node. Grey ones don't let others read or set their levels.",
    "loggers.gone": "{node} is gone.",
    "loggers.not_served": (
        "{node} doesn't let others read or set its levels: it was created without enable_logger_service=True (rclcpp: "
        "NodeOptions().enable_logger_service(true))."
    ),
    "loggers.waiting": "No response for {seconds} s: the node may not be spinning. Esc stops waiting.",
    "loggers.not_set": "This logger has no level of its own: its parent's level counts, INFO unless changed.",
    "loggers.show": "choose",
    "loggers.to_levels": "to its level",
    "loggers.set": "set",
    "loggers.column": "column",
    "loggers.add": "add a logger",
    "loggers.name": "Name of a logger",
    "loggers.cancel": "stop waiting",
    # rqt_shell
    "shell.run": "run",
    "shell.history": "earlier lines",
    "shell.stop": "stop",
    "shell.running": "running …",
    "shell.no_desktop": (
        "This shell runs commands on the desktop (day6-tui), and there is none here: use your own terminal."
    ),
    # rqt_py_console
    "py_console.no_desktop": (
        "This console runs Python on the desktop (day6-tui), and there is none here: run python3 in your terminal."
    ),
    "py_console.ended": "Python exited with status {status}. Enter starts a new one.",
    "py_console.begin": "new Python",
    "py_console.indent": "indent",
    "py_console.end": "end Python",
    # rqt_robot_steering
    "steering.topic": "topic",
    "steering.topic_title": "Topic for the velocities",
    "steering.no_topic": "(no topic)",
    "steering.space": "Space",
    "steering.stop": "Stop",
    "steering.linear": "linear",
    "steering.angular": "angular",
    "steering.minimum": "minimum",
    "steering.maximum": "maximum",
    "steering.limits": "limits",
    "steering.next": "next limit",
    "steering.change": "by 0.1",
    "steering.far": "ten times as far",
    "steering.zero": "linear, angular to zero",
    "steering.bad_limit": "A number from {low} to {high}.",
    "steering.nothing": "Nothing is published without a topic.",
    "steering.unheard": "Nobody subscribes to {topic}.",
    "steering.heard": "subscriptions: {count}",
    "steering.other_type": "{topic} has type {types}, not {type}.",
    "steering.other_stamp": "{topic} has type {types}, not {type}: m changes that.",
    # rqt_plot
    "plot.none": "Nothing is plotted yet: a chooses a field, e lets you type one, like /turtle1/pose/x.",
    "plot.waiting": "waiting for the topic",
    "plot.quiet": "nothing received yet",
    "plot.paused": "paused",
    "plot.seconds": "{count} s",
    "plot.add": "add",
    "plot.type": "type a field",
    "plot.type.note": (
        "A topic and a field, like /turtle1/pose/x or /joint_states/position[0]; /turtle1/pose/x:y gives two."
    ),
    "plot.choose": "Plot a field",
    "plot.remove": "remove",
    "plot.pause": "pause",
    "plot.resume": "resume",
    "plot.span": "time",
    "plot.fine": "finer, coarser",
    "plot.curve": "choose a curve",
    "plot.clear": "clear",
    # the pages of the manual
    "help.topics": (
        "All topics, with their types. Enter, or a click on the box, listens to a topic: then its bandwidth, rate and "
        "newest message are shown. Listening is a real subscription, so it is counted as one.\n\n"
        "The right arrow key, or a click on the small arrow, opens a topic: the fields of its message, and its publishers "
        "and subscribers. The left arrow closes it. s sorts by the next column, S reverses the order; so does a click on a "
        "column's name. / filters by part of a name or type, Esc shows all again.\n\n"
        "v shows a value in full if it doesn't fit on its line, or the definition of the type if nothing has arrived yet; "
        "there, c copies it."
    ),
    "help.rqt_tf_tree": (
        "The tree of frames, each below its parent. Age is the time since its newest transform was sent, rate is how often "
        "transforms arrive, buffer is how many seconds of them are kept. Static frames arrive once, from /tf_static, and "
        "stay valid for ever. A frame that is no longer sent turns to the warning colour and shows its age.\n\n"
        "Several roots mean that parts of the tree are not connected: no transform leads from one to the other. A frame "
        "that appears a second time is part of a loop.\n\n"
        "Up and down choose a frame, described in more detail below the tree; left and right move the names, and so does "
        "the wheel with Shift. The tree updates once a second; a turns that off, and then r updates it, like the "
        "original's button. c forgets all transforms except static ones. w saves the drawing as .pdf, .svg, .png or .dot."
    ),
    "help.service_caller": (
        "Calls a service by hand, like ros2 service call. s chooses the service; the tree below shows the fields of its "
        "request with their default values. Enter, or a click on a value, edits it; Enter accepts, Tab goes on to the next "
        "field, Esc keeps the old value, Del restores the default. Then c, or Call, sends the request, and the response is "
        "shown below.\n\n"
        "An expression is a piece of Python: 1.5, 2*pi, sin(0.3), [1, 2] or 'text'; a string may also go without quotes. "
        "If a value doesn't fit its field, it is marked and the field is sent with its default, as in the real rqt. + and "
        "- on a list's line add an element or remove the last one.\n\n"
        "If there is no response, the window shows for how long, and x stops waiting. What the node thinks of the call "
        "appears in its own terminal: turtlesim, for example, returns an empty name if a turtle with that name already "
        "exists."
    ),
    "help.publisher": (
        "Publishes messages by hand, like ros2 topic pub. a adds a publisher: choose an existing topic, or enter another "
        "name and then its type. Space, or a click on the box, starts publishing at the rate in its line (in Hz; Enter on "
        "the line changes it, 0 publishes only by hand). o publishes one message, d removes the publisher, C removes them "
        "all.\n\n"
        "Enter on a field, or a click on its value, lets you type an expression, as in Service Caller. It is evaluated "
        "again for each message: i counts the messages, so sin(i/10) swings. now() is the time, for a stamp; random() and "
        "uniform(0, 1) change every time. A string may go without quotes. Errors are marked, and the previous expression "
        "is used until you fix them, as in the real rqt; if an expression fails only now and then, those messages get the "
        "default.\n\n"
        "An array has a line for each element, which takes an expression, too; + and - on the array's own line add an "
        "element or remove the last one, and an expression there sets all of them at once, like [0.5, i, 2*i]."
    ),
    "help.type_browser": (
        "The message or service types available here, like ros2 interface show. p chooses a package, a adds one of its "
        "types as a tree of fields. Enter, or v, shows the definition of the type on the line, and c then copies it; d "
        "removes the tree."
    ),
    "help.action_browser": (
        "Below, the action types, as in the real rqt: p chooses a package, a adds one of its types, Enter shows its "
        "definition.\n\n"
        "Above, the actions of the graph, which the real one doesn't have. Enter, or the right arrow key, opens one: its "
        "servers and clients, a goal to fill in (Enter on a field), and all goals with their status, feedback and result. "
        "g sends the goal, x cancels it. While an action is open, this window listens to it, so it is counted as one of "
        "its clients."
    ),
    "help.rqt_reconfigure": (
        "The parameters of running nodes, like ros2 param with a window. On the left are the nodes, in their namespaces: "
        "Enter or a click opens one or more. On the right are their parameters. Tab changes sides.\n\n"
        "A number with a range set by the node has a slider: left and right move it one step, with Shift ten, Home and End "
        "to its ends; with the mouse, it sends its value when you let go, as in the real rqt. A digit or Enter lets you "
        "type an exact number. Other values are typed: arrays as [1, 2, 3]. Enter switches true and false.\n\n"
        "Setting a parameter is a request. The node may refuse: then you see its reason and the old value. Values that "
        "others set, for example with ros2 param set, appear here, too.\n\n"
        "/ filters the nodes or the parameters, r reads a node again, x closes it. w saves its parameters as YAML, o loads "
        "such a file. A node that doesn't spin doesn't respond: the seconds are counted, and Esc stops waiting."
    ),
    "help.rqt_logger_level": (
        "The lowest level that a node logs. Choose a node, then one of its loggers, then the level: DEBUG shows most, "
        "FATAL least. Clicks work, too. The change lasts until the node ends; it does what --log-level does at the "
        "start.\n\n"
        "Only nodes created with enable_logger_service=True can be asked, as `ros2 run demo_nodes_py use_logger_service` "
        "shows; the others are grey. A node doesn't say which loggers it has: a adds one by name, like rcl.\n\n"
        "Real ROS 2 has this window only as a draft, with other services. The services used here are ROS 2's own, "
        "get_logger_levels and set_logger_levels."
    ),
    "help.rqt_shell": (
        "A shell for commands that finish without asking anything, like ros2 topic list: rqt's SimpleShell, the only one "
        "that the real rqt still has. A command's output appears above the line. ^C stops one that doesn't end.\n\n"
        "Up and Down bring back earlier lines, Page Up shows earlier output. Every line has a shell of its own, so cd "
        "lasts only until the end of the line. For everything else there are terminals: F2."
    ),
    "help.rqt_py_console": (
        "A Python prompt, like python3 in a terminal. Enter runs a line; after a line that ends with a colon, type the "
        "lines of its block and run them with an empty one. Errors appear as Python prints them, and input() asks here.\n\n"
        "Nodes that you create are real: import rclpy, rclpy.init(), node = rclpy.create_node('mine'), and ros2 node list "
        "shows /mine. Python runs in its own process: ^C interrupts code that doesn't end, exit() or ^D ends it, and Enter "
        "starts a new one. Closing the window ends it, too.\n\n"
        "In the real rqt, the lines run inside rqt itself: there an endless loop stops all windows, and exit() closes this "
        "one."
    ),
    "help.rqt_robot_steering": (
        "Drives anything that listens to velocities: geometry_msgs/Twist on /cmd_vel, or on another topic that t sets, "
        "like /turtle1/cmd_vel. With stamped, it sends TwistStamped, which newer robots expect.\n\n"
        "w and s make the robot faster and slower, a and d turn it left and right; with Shift ten times as far. x sets the "
        "linear velocity to zero, z the angular one, Space both. The arrows do the same, and the sliders can be dragged. "
        "Tab goes to the ends of the sliders, and Enter sets one.\n\n"
        "The velocity is published ten times a second, but zero only once, so that others can drive. Stop before you close "
        "the window: like the real one, it sends nothing when it closes, and a robot that doesn't watch for that drives on."
    ),
    "help.rqt": (
        "rqt collects the windows of the ROS tools. Choose one with the arrow keys; Enter opens it, and opens it once more "
        "if it is already open. Each is a pane of its own, and all of them are one program with one node. x closes the one "
        "under the cursor, the cross of this window closes them all.\n\n"
        "The open windows with their settings are a perspective: rqt starts with the last one. p switches to another, "
        "makes a new one, and reads or writes files that the real rqt can read, too. Each window is also a command: ros2 "
        "run rqt_plot rqt_plot. It takes the keyboard, unless you put & at the end: then you can keep typing."
    ),
    "help.rqt_plot": (
        "Numbers from messages, over time. Each curve is one field of one topic; the legend shows its newest value. The "
        "value axis adapts to what is visible.\n\n"
        "A field is written like a path: /turtle1/pose/x, or /joint_states/position[0] for an element of a list. Listening "
        "is a real subscription, so it is counted as one."
    ),
}
