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
    "topics.filter_note": "Part of a topic's name or type; nothing shows all.",
    "topics.filtered": "of {count}, filter: {text}",
    "topics.unfilter": "show all",
    # fields of messages
    "fields.request": "Request: Topic",
    "fields.response": "Response: Field",
    "fields.type": "Type",
    "fields.expression": "Expression",
    "fields.value": "Value",
    "fields.edit": "change",
    "fields.take": "take it",
    "fields.on": "and the next field",
    "fields.leave": "old value",
    "fields.next": "next field, while typing",
    "fields.default": "default value",
    "fields.in_force": "in force: {text}",
    "fields.elements": "one element more, less",
    # service_caller
    "service.call": "Call",
    "service.cancel": "Cancel",
    "service.refresh": "Refresh",
    "service.choose": "service",
    "service.choose_title": "Service",
    "service.none": "no service",
    "service.count": "{count} services",
    "service.waiting_for_any": "There are no services yet. Start a node.",
    "service.waiting": "Called. Waiting for the answer.",
    "service.waiting.long": "Nobody has answered yet, for {seconds} s. x waits no longer.",
    "service.cancelled": "Cancelled: nothing waits for the answer now. The node may still be working.",
    "service.gone": "The node that offered this service is gone: there will be no answer.",
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
    "publisher.new_topic.note": "The name of a topic; its type is asked for next.",
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
    "types.none.msg": "p chooses a package, a one of its message types.",
    "types.none.srv": "p chooses a package, a one of its service types.",
    "types.none.action": "p chooses a package, a one of its action types.",
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
    "actions.state.no_server": "No server offers this action now.",
    # rqt
    "rqt.open": "open",
    "rqt.close": "close",
    "rqt.is_open": "open: {name}",
    "rqt.perspective": "perspective {name}",
    "rqt.perspectives": "perspectives",
    "rqt.create": "New perspective",
    "rqt.create.note": "of what is open",
    "rqt.import": "Open a file",
    "rqt.export": "Write to a file",
    "rqt.wrong_name": "This cannot be its name.",
    "rqt.name_taken": "There is one of this name.",
    "rqt.about.rqt_action": "the types of actions, their goals",
    "rqt.about.rqt_reconfigure": "parameters of running nodes",
    "rqt.about.rqt_graph": "who talks to whom",
    "rqt.about.rqt_bag": "record, look at and play bags",
    "rqt.about.rqt_console": "the log messages of all nodes",
    "rqt.about.rqt_logger_level": "how much a node logs",
    "rqt.about.rqt_shell": "a line for commands",
    "rqt.about.rqt_py_console": "lines of Python",
    "rqt.about.rqt_robot_steering": "drive a robot by two sliders",
    "rqt.about.rqt_service_caller": "call a service",
    "rqt.about.rqt_srv": "the types of services",
    "rqt.about.rqt_publisher": "publish messages of your own",
    "rqt.about.rqt_msg": "the types of messages",
    "rqt.about.rqt_topic": "topics, their rates and messages",
    "rqt.about.rqt_image_view": "images of a camera",
    "rqt.about.rqt_plot": "numbers over time",
    "rqt.about.rqt_tf_tree": "which frame hangs on which",
    # rqt_tf_tree
    "tf_tree.columns.frame": "Frame",
    "tf_tree.columns.age": "Age s",
    "tf_tree.columns.rate": "Rate Hz",
    "tf_tree.columns.buffer": "Buffer s",
    "tf_tree.columns.broadcaster": "Broadcaster",
    "tf_tree.none": "No tf data received",
    "tf_tree.static": "static",
    "tf_tree.again": "(again: a circle)",
    "tf_tree.root": "{name}: a root. Nobody sends a transform that leads to it.",
    "tf_tree.old": "{count} old",
    "tf_tree.recorded": "Recorded at time: {time}",
    "tf_tree.refresh": "refresh",
    "tf_tree.clear": "clear buffer",
    "tf_tree.auto": "auto refresh",
    "tf_tree.sideways": "move the names",
    "tf_tree.save": "save as",
    "tf_tree.saved": "saved: {name}",
    "tf_tree.save_note": "The suffix says as what: .pdf, .svg and .png are the drawing, .dot is for Graphviz.",
    # rqt_reconfigure
    "reconfigure.none": "No node has parameters yet. Start a node.",
    "reconfigure.no_match": "No node matches. Esc shows all.",
    "reconfigure.choose": "Enter opens a node at the left: its parameters come here.",
    "reconfigure.reading": "reading the parameters …",
    "reconfigure.unread": "not read; r reads again",
    "reconfigure.waiting": "no response for {seconds} s: {reason}. Esc stops waiting.",
    "reconfigure.gone": "This node is gone: these were its parameters.",
    "reconfigure.not_there": "This node is not there.",
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
    "reconfigure.far": "move by ten steps",
    "reconfigure.ends": "least, greatest",
    "reconfigure.value": "value",
    "reconfigure.side": "other side",
    "reconfigure.filter": "filter",
    "reconfigure.cancel": "stop waiting; show all",
    "reconfigure.files": "save, load",
    "reconfigure.filter_nodes": "Nodes with",
    "reconfigure.filter_parameters": "Parameters with",
    "reconfigure.unfitting": "This is not a value of type {type}.",
    "reconfigure.save": "Save parameters to file...",
    "reconfigure.load": "Load from File",
    "reconfigure.saved": "saved: {file}",
    # rqt_logger_level
    "loggers.nodes": "Nodes",
    "loggers.loggers": "Loggers",
    "loggers.levels": "Levels",
    "loggers.choose": "Enter chooses a node. Grey ones do not let others read or set their levels.",
    "loggers.gone": "{node} is gone.",
    "loggers.not_served": (
        "{node} does not let others read or set its levels: it was made without enable_logger_service=True "
        "(rclcpp: NodeOptions().enable_logger_service(true))."
    ),
    "loggers.waiting": "No response for {seconds} s: the node may not be spinning. Esc stops waiting.",
    "loggers.not_set": "This logger has no level of its own: that of its parent counts, INFO unless another was given.",
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
    "shell.no_desktop": "This shell runs commands of the desktop (day6-tui). Here is none: type them into your own terminal.",
    # rqt_py_console
    "py_console.no_desktop": "This console runs Python in the desktop (day6-tui). Here is none: type python3 in your terminal.",
    "py_console.ended": "Python has ended with status {status}. Enter begins a new one.",
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
    "steering.minimum": "least",
    "steering.maximum": "greatest",
    "steering.limits": "limits",
    "steering.next": "next limit",
    "steering.change": "by 0.1",
    "steering.far": "ten times as far",
    "steering.zero": "linear, angular to zero",
    "steering.bad_limit": "A number from {low} to {high}.",
    "steering.nothing": "Nothing is published without a topic.",
    "steering.unheard": "Nobody subscribes to {topic}.",
    "steering.heard": "subscriptions: {count}",
    "steering.other_type": "{topic} has the type {types}, not {type}.",
    "steering.other_stamp": "{topic} has the type {types}, not {type}: m changes that.",
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
    "plot.fine": "finer, coarser",
    "plot.curve": "choose a curve",
    "plot.clear": "clear",
    # the pages of the manual
    "help.topics": (
        "All topics, with their types. Enter, or a click on the box, listens to a topic: then its bandwidth, its rate and its "
        "newest message are shown. Listening is a subscription, so it counts as one.\n\n"
        "The right arrow key, or a click on the small arrow, opens a topic: the fields of its message, and who publishes and "
        "subscribes. The left one closes it. s sorts by the next column, S the other way round; so does a click on a column's "
        "name. / filters by part of a name or type, Esc shows all again.\n\n"
        "v shows all of a value that has no room on its line, or what the type is while nothing has come; there, c copies it."
    ),
    "help.rqt_tf_tree": (
        "The tree of frames: each stands below its parent. Age is how long ago its newest transform was sent, rate how often "
        "it came, buffer how many seconds of it are kept. Static frames come once, from /tf_static, and hold for ever. "
        "A frame that is not sent any more turns to the warning colour and says how old it is.\n\n"
        "Several roots mean that parts of the tree are not connected: no transform leads from one to the other. A frame that is "
        "named a second time stands in a circle.\n\n"
        "The arrow keys up and down choose a frame, about which more is said below; left and right move the names, so do the "
        "wheel and Shift with it. The tree is looked at once a second; a turns that off, then r looks again, as the original's "
        "button. c forgets all transforms but the static ones. w saves the drawing: as .pdf, .svg, .png or .dot."
    ),
    "help.service_caller": (
        "Calls a service by hand, like ros2 service call. s chooses the service; the tree below shows the fields of its "
        "request with their default values. Enter, or a click on a value, changes it; Enter takes it, Tab goes on to the next "
        "field, Esc leaves the old one, Del brings the default back. Then c, or Call, sends the request, and the response is "
        "shown below.\n\n"
        "An expression is a part of Python: 1.5, 2*pi, sin(0.3), [1, 2], 'text' or, for a text, also without quotes. What does "
        "not fit its field is marked, and the field is sent with its default, as in the real rqt. + and - on the line of a list "
        "add an element or take the last one away.\n\n"
        "If nobody answers, the window says for how long, and x waits no longer. What the node thinks of the call stands in its "
        "own terminal: turtlesim, for example, answers an empty name if a turtle of that name exists already."
    ),
    "help.publisher": (
        "Publishes messages by hand, like ros2 topic pub. a adds a publisher: choose one of the topics there are, or another "
        "name and then its type. Space, or a click on the box, begins to publish, at the rate in its line (in Hz; Enter on the "
        "line changes it, 0 publishes only by hand). o publishes one message, d removes the publisher, C all of them.\n\n"
        "Enter on a field, or a click on its value, types an expression, as in Service Caller. It is computed anew for each "
        "message: i counts the messages, so sin(i/10) swings. now() is the time, for a stamp; random() and uniform(0, 1) change "
        "every time. A text may stand without quotes. What is wrong is marked, and the expression before it counts until it is "
        "mended, as in the real rqt; one that fails only now and then gives that message the default.\n\n"
        "An array has a line for each element, which takes an expression, too; + and - on the array's own line add an element or "
        "take the last one away, and an expression there gives all at once, like [0.5, i, 2*i]."
    ),
    "help.type_browser": (
        "The types of messages or services that there are here, like ros2 interface show. p chooses a package, a adds one of its "
        "types as a tree of fields. Enter, or v, shows the text that defines the type of the line, which c "
        "then copies; d removes the tree."
    ),
    "help.action_browser": (
        "Below, the types of actions, as in the real rqt: p chooses a package, a adds one of its types, Enter shows its text.\n\n"
        "Above, which the real one does not have, the actions of the graph. Enter, or the right arrow key, opens one: its "
        "servers and clients, a goal to fill in (Enter on a field), and all goals with their status, feedback and result. g "
        "sends the goal, x cancels it. While an action is open this window listens to it, so it counts as a client of it."
    ),
    "help.rqt_reconfigure": (
        "The parameters of running nodes, like ros2 param with a window. At the left are the nodes, in their namespaces: Enter "
        "or a click opens one, or several. At the right are their parameters. Tab changes the side.\n\n"
        "A number for which the node allows a range is a slider: left and right move it by a step, with Shift by ten, Home and "
        "End to its ends; with the mouse it sends its value when it is let go, as in the real rqt. A digit or Enter begins an "
        "exact number. Other values are typed: arrays as [1, 2, 3]. Enter switches true and false.\n\n"
        "What you set is a request. The node answers, and may refuse: then its reason is shown, and the old value. Values that "
        "others set, as with ros2 param set, show up by themselves.\n\n"
        "/ filters the nodes or the parameters, r reads a node again, x closes it. w saves its parameters as YAML, o loads "
        "such a file. A node that does not spin does not answer: the seconds are counted, and Esc stops waiting."
    ),
    "help.rqt_logger_level": (
        "From which level on a node logs. Choose a node, then one of its loggers, then the level: DEBUG shows most, FATAL least. "
        "A click does the same. The change lasts until the node ends; it is what --log-level does at the start.\n\n"
        "Only nodes that were made with enable_logger_service=True can be asked, as `ros2 run demo_nodes_py use_logger_service` "
        "shows; the others are grey. A node does not tell which loggers it has: a adds one by its name, like rcl.\n\n"
        "The real ROS 2 has this window only as a draft, with other services. The services used here are ROS 2's own, "
        "get_logger_levels and set_logger_levels."
    ),
    "help.rqt_shell": (
        "A shell for commands that end by themselves and ask nothing, like ros2 topic list: rqt's SimpleShell, which is the only "
        "one that the real rqt still has. What a command prints is shown above the line. ^C stops one that does not end.\n\n"
        "Up and Down bring back earlier lines, Page Up shows what was printed before. "
        "Every line has a shell of its own, so cd lasts only to the end of the line. For everything else there are terminals: F2."
    ),
    "help.rqt_py_console": (
        "Lines of Python, as after python3 in a terminal. Enter runs a line; after one that ends with a colon follow the lines "
        "of its block, and an empty one runs them. Errors are shown as Python prints them, and input() asks here.\n\n"
        "Nodes that you make are real: import rclpy, rclpy.init(), node = rclpy.create_node('mine'), and ros2 node list shows "
        "/mine. Python runs in a process of its own: ^C interrupts what does not end, exit() or ^D ends it, and Enter begins a "
        "new one. Closing the window ends it, too.\n\n"
        "In the real rqt the lines run inside rqt itself: there a loop without end stops all windows, and exit() closes this one."
    ),
    "help.rqt_robot_steering": (
        "Drives what listens to velocities: geometry_msgs/Twist on /cmd_vel, or on another topic that t sets, like "
        "/turtle1/cmd_vel. With stamped it is TwistStamped, which newer robots want.\n\n"
        "w and s make the robot faster and slower, a and d turn it to the left and to the right; with Shift ten times as far. x "
        "sets the linear, z the angular velocity to zero, Space both. The arrows do the same, and the sliders can be dragged. "
        "Tab goes to the ends of the sliders, and Enter sets one.\n\n"
        "The velocity is published ten times a second, zero only once: then others can drive. Stop before you close the window: "
        "as the real one it says nothing when it goes, and a robot that does not watch for that drives on."
    ),
    "help.rqt": (
        "rqt collects the windows of the ROS tools. The arrow keys choose one, Enter opens it, and once more if it is open; "
        "each is a pane of its own, and all of them are one program with one node. x closes the one under the cursor, "
        "the cross of this window all of them.\n\n"
        "What is open, with its settings, is a perspective: rqt begins with the last one. p switches to another, makes a new "
        "one, and reads or writes a file that the real rqt can read, too. Each window is also a command: "
        "ros2 run rqt_plot rqt_plot. It gets the keyboard, unless & stands at the end: then you go on typing."
    ),
    "help.rqt_plot": (
        "Numbers from messages, over time. Each curve is one field of one topic; the legend shows its newest value. "
        "The value axis adapts to what is visible.\n\nA field is written like a path: /turtle1/pose/x, for an "
        "element of a list /joint_states/position[0]. Listening is a subscription, so it counts as one."
    ),
}
