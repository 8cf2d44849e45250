"""The English texts; those of the programs' remarks stand with the programs, which print them without a screen too."""

from day6_core.ros import remark_texts

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
    "action.close": "Close this terminal or window",
    "action.copy": "Copy the selection",
    "action.paste": "Paste",
    "action.find": "Search the terminal",
    "action.clear": "Clear the terminal's scrollback",
    "action.language": "中文 / English",
    "action.theme": "Theme: dark, light, high contrast, colour-blind",
    "action.distro": "Distribution of ROS 2: Humble, Jazzy, Kilted, Rolling",
    "action.glyphs": "Next set of characters (pixels, half, braille, cell, ascii)",
    "action.split.right": "Split: terminal on the right",
    "action.split.below": "Split: terminal below",
    "action.stack": "Tab: put this pane behind its neighbour, or beside it again",
    "action.move.left": "Move this pane to the left",
    "action.move.right": "Move this pane to the right",
    "action.move.above": "Move this pane up",
    "action.move.below": "Move this pane down",
    "action.layout.load": "Layouts",
    "action.layout.save": "Save this layout",
    "action.layout.lesson": "Layout: lesson, everything where it is seen best",
    "action.layout.four": "Layout: four terminals",
    "action.layout.presenter": "Layout: presenter, a big picture and one terminal",
    "action.step": "One time step (while paused)",
    "action.faster": "Faster time",
    "action.slower": "Slower time",
    "action.normal": "Normal time",
    "action.motion": "Less motion on or off",
    "action.detach": "Detach",
    "help.action.terminal": "opens another terminal, with its own shell",
    "help.action.next": "moves the keyboard focus to the next terminal or window",
    "help.action.previous": "the same, in reverse order",
    "help.action.windows": "lists everything that is open",
    "help.action.enlarge": "makes the focused pane fill the screen, or restores it",
    "help.action.pause": "pauses or resumes the simulated world",
    "help.action.palette": "finds any command by name",
    "help.action.quit": "closes the desktop, and asks first if programs are running; in the editor ^Q closes the file",
    "help.action.help": "explains the focused pane",
    "help.action.close": "ends the shell, or the program that opened the window",
    "help.action.copy": "copies what is selected with the mouse",
    "help.action.paste": "types what was copied",
    "help.action.find": "finds a text in what a terminal has shown",
    "help.action.clear": "discards the lines that have scrolled out of view",
    "help.action.language": "changes the language of the desktop",
    "help.action.theme": "chooses the colours; the choice is remembered",
    "help.action.distro": "chooses whose packages, paths and defaults there are; from the next start on",
    "help.action.glyphs": "changes how pictures are drawn",
    "help.action.split.right": "opens a terminal to the right of this pane",
    "help.action.split.below": "opens a terminal below this pane",
    "help.action.stack": "makes it a tab of the pane beside it, or gives a tab a place of its own",
    "help.action.move.left": "changes places with the pane on the left",
    "help.action.move.right": "changes places with the pane on the right",
    "help.action.move.above": "changes places with the pane above",
    "help.action.move.below": "changes places with the pane below",
    "help.panes": "Alt+←↑↓→\tthe pane on that side\nAlt+1 … 9\tthe pane with that number\n"
    "Shift+Alt+←\tand ↑ ↓ →: moves the border\nMouse\tdrag borders and titles; double-click a title to enlarge",
    "help.action.layout.load": "lists the ready layouts and those you have saved",
    "help.action.layout.save": "keeps the places of the panes under a name",
    "help.action.layout.lesson": "arranges all panes anew",
    "help.action.layout.four": "two by two, with the windows beside them",
    "help.action.layout.presenter": "for a projector; the other panes are tabs",
    "help.action.step": "advances the paused world by one turtlesim tick (16 ms)",
    "help.action.faster": "up to ten times",
    "help.action.slower": "down to a tenth",
    "help.action.normal": "one second is one second",
    "help.action.motion": "turns typing effects and pulses off or on",
    "help.action.detach": "gives the terminal back; everything goes on, and day6-tui attach comes back to it",
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
    "bar.door.nobody": "nothing at {host}:{port}",
    "bar.door.no_answer": "no answer: {host}",
    "bar.door.not_let_in": "refused by {host}",
    "bar.door.no_class": "no class at {host}",
    "bar.door.name_taken": "your name is taken",
    "bar.door.class_full": "the class is full",
    "bar.door.other_domain": "another ROS_DOMAIN_ID",
    "bar.door.failed": "{host}: failed",
    "bar.door.joined": "joined {host}",
    "bar.door.joined.short": "joined",
    "bar.door.calling": "connecting {host}",
    "notice.open_class": "anyone who reaches port {port} can join the class; --secret keeps others out",
    "notice.open": "anyone who reaches port {port} can read and command; --secret keeps others out",
    "bar.help": "F1 Help",
    "bar.starting": "starting …",
    "bar.playing": "typing for you",
    "bar.external": "student processes run at normal speed",
    # one window on a real terminal
    "single.end": "End",
    "single.help": "Help",
    "single.log": "Log",
    "single.next": "Next",
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
    "pixels.slow": "Pixels come too slowly over this connection: characters draw the pictures now",
    "terminal.hint": "{keys} work only in here: click or {key}",
    "terminal.hint.short": "{keys}: click here or {key}",
    "terminal.arrows": "{keys} only drive in terminal {number}: {key} goes there",
    "terminal.not_arrows": "Arrow keys do nothing here. {keys} drive",
    "teleop.arrows": "Arrow keys",
    "teleop.twist_keyboard": "The keys i j k l and ,",
    "teleop.turtlebot3": "The keys w a d x and s",
    "teleop.other": "This program's keys",
    "terminal.scrolled": "{count} more lines below · any key goes there",
    "terminal.close.title": "Close the terminal",
    "terminal.close.ask": "{what} is still running in it. End it?",
    "drop.told": "{name}: let go to put it {where}",
    "drop.left": "to the left of {name}",
    "drop.right": "to the right of {name}",
    "drop.above": "above {name}",
    "drop.below": "below {name}",
    "drop.tab": "behind {name}, as a tab",
    "layout.name": "A name for this layout",
    "layout.no_name": "It needs a name",
    "layout.saved": "The layout is saved as {name}",
    "layout.own": "saved",
    "layout.foreign": "not a file of layouts of version {version}",
    "layout.unreadable": "{file}: {reason}",
    "session.title": "As you left it",
    "session.ask": "When you left, these were running. Start them again?\n\n{what}",
    "session.back": "Not now",
    "session.start": "Start again",
    "session.restored": "from {when}",
    "session.foreign": "not a session of this version; it stays as it is",
    "find.title": "Search",
    "find.keys": "Enter ↑ older   ↓ newer   Esc back",
    "find.what": "type what to look for",
    "find.none": "not found",
    "find.count": "{number} of {count}",
    "menu.program": "start",
    "terminal.copied": "Copied",
    "terminal.no_room": "No new terminal: too many programs are running. End some of them (Ctrl-C, kill, close their terminals)",
    # welcome
    "welcome.title": "Welcome",
    "welcome.heading": "ROS 2, right here in your terminal",
    "welcome.question": "What would you like to do?",
    "welcome.lessons": "Lessons",
    "welcome.lessons.on": "go on: {title}",
    "welcome.lessons.more": "six days, and faults to find",
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
    "turtlesim.from": "from",
    "turtlesim.undriven": "nobody publishes here; to drive it:",
    "turtlesim.label": "names",
    # car
    "car.zoom": "zoom",
    "car.lines": "lines",
    # world
    "world.pose": "x {x:.2f}  y {y:.2f}  {degrees}°  v {v:.2f} m/s",
    "world.line": "line",
    "world.factor": "RTF {factor:.2f}",
    "world.zoom": "zoom",
    "world.follow": "follow",
    "world.lidar": "lidar",
    "world.step": "step",
    "world.reset": "back to the start",
    # joint sliders
    "sliders.waiting": "Waiting for a robot on /robot_description: is robot_state_publisher running?",
    "sliders.none": "This robot has no joint that can be moved.",
    "sliders.conflict.short": "{nodes} sets joints too",
    "sliders.conflict": "{nodes} publishes the same joints: the robot jitters between two commands. One of the two has to stop.",
    "sliders.degrees": "degrees",
    "sliders.move": "move",
    "sliders.finest": "move as little as possible",
    "sliders.value": "number",
    "sliders.zero": "zero",
    "sliders.accept": "accept",
    "sliders.cancel": "cancel",
    # rqt_graph
    "rqt.hidden": "{count} hidden: {reasons}",
    "rqt.hides": "{option} hides {names}",
    "rqt.hides_some": "{option} {count}",
    "rqt.separator": "; ",
    "rqt.nothing_hidden": "nothing is hidden",
    "rqt.empty": "No node is publishing or subscribing.",
    "rqt.type": "type",
    "rqt.hide": "Hide",
    "rqt.refresh": "refresh",
    "inspector.title": "Inspector",
    "inspector.count": "{errors} errors, {all} in all",
    "inspector.count.one": "{errors} error, {all} in all",
    "inspector.quiet": "quiet",
    "action.inspector": "Inspect",
    "help.action.inspector": "what is wrong right now, and what to type next",
    "editor.save": "save",
    "editor.find": "find",
    "editor.line": "go to line",
    "editor.close": "close",
    "editor.write": "save (Enter)",
    "editor.write.name": "File Name to Write",
    "editor.name": "a name is needed",
    "editor.exists": "{name} exists: Enter again overwrites it",
    "editor.modified": "Save modified buffer?",
    "editor.modified.text": "{file} has unsaved changes.",
    "editor.modified.save": "Save",
    "editor.modified.discard": "Don't save",
    "editor.cut": "cut lines, put them back",
    "editor.tab": "completes modules, message types and fields; elsewhere indents, all selected lines if there are any",
    "editor.complete": "Which one?",
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
    "editor.lose": "the same answer again loses the text, no copy: {reason}",
    "editor.gone": "file gone from disk; ^S writes it again",
    "quit.title": "Something would be lost",
    "quit.lost": "Neither saved nor kept: {what}",
    "quit.anyway": "Quit anyway",
    "quit.running": "Programs are still running",
    "quit.runs": "{what} still runs. End it and quit?",
    "quit.run": "{what} still run. End all and quit?",
    "quit.more": " and {count} more",
    "quit.class": "Pupils are joined",
    "quit.joined.one": "1 pupil is joined, whose desktop goes on without you. End the class and quit?",
    "quit.joined": "{count} pupils are joined, whose desktops go on without you. End the class and quit?",
    "quit.leave": "Quit",
    "quit.end": "End",
    "quit.detach": "Detach",
    "quit.was_lost": "day6-tui: unsaved work was lost: {what}",
    # A desktop that outlives its terminal
    "detached.asked": "detached: {command} comes back",
    "detached.taken": "detached, because another terminal was attached: {command} comes back",
    "detached.none": "no desktop runs that was started by {command}",
    "detached.runs": "the desktop runs already: {command} comes to it",
    "detached.started": "the desktop runs: {command} comes to it",
    "detached.lost": "the desktop's keeper has ended, and the desktop with it; what was typed and the layout are kept",
    "detached.inside": "this is a terminal of that desktop",
    "detached.no_terminal": "attach needs a terminal",
    "detached.windows": "--detach and attach need pseudo-terminals, which Windows does not have here",
    "editor.not_found": "{text} not found",
    "editor.lines": "1 to {count}",
    "prompt.replaces": "{file} already exists; Enter again replaces it",
    "prompt.keys": "Enter accept   Esc back",
    "rqt.choose": "choose",
    "rqt.pan": "move",
    "rqt.zoom": "zoom",
    "rqt.fit": "Fit",
    "rqt.filter": "filter nodes, topics",
    "rqt.namespaces": "namespaces",
    "rqt.group": "Group",
    "rqt.view": "Highlight",
    "rqt.files": "save, open",
    "rqt.auto": "auto refresh",
    "rqt.node_filter": "Node filter",
    "rqt.topic_filter": "Topic filter",
    "rqt.filter_note": "Names or regular expressions separated by commas; a leading - leaves out, / is all. Example: -/rqt.*",
    "rqt.save": "Save the graph as",
    "rqt.save_note": ".dot for Graphviz, .pdf, .svg or .png for a picture",
    "rqt.load": "Open a DOT file",
    "rqt.load_note": "It is shown instead of the live graph, until r refreshes.",
    "rqt.loaded": "from the file {name}; r shows the live graph",
    "rqt.node": "{name}: {arriving} arrows in, {leaving} out",
    "rqt.topic": "{name}: published by {arriving}, subscribed to by {leaving}",
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
    # rviz2
    "rviz.key.view": "view",
    "rviz.key.panel": "panel",
    "rviz.key.edit": "change",
    "rviz.key.add": "add",
    "rviz.key.focus": "focus",
    "rviz.key.turn": "turn",
    "rviz.key.zoom": "zoom",
    "rviz.key.above": "45° from above",
    "rviz.key.cursor": "move the cursor",
    "rviz.key.direction": "turn",
    "rviz.key.fine": "finer",
    "rviz.key.send": "send",
    "rviz.key.place": "place",
    "rviz.key.click": "click",
    "rviz.key.leave_tool": "leave the tool",
    "rviz.key.control": "grasp a control",
    "rviz.key.next_control": "next control",
    "rviz.key.grasp": "hold it",
    "rviz.key.let_go": "let go",
    "rviz.key.move": "move",
    "rviz.key.away": "away, nearer",
    "rviz.key.roll": "roll",
    "rviz.key.menu": "menu",
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
    "rviz.find": "Find a property",
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
    "rviz.offer": "see the robot up close",
    "rviz.leave.title": "There are unsaved changes",
    "rviz.leave.save": "to {file}, then close",
    "rviz.leave.discard": "close without saving",
    "rviz.leave.cancel": "go on",
    "rviz.unsaved": "the view of RViz (^S in its window saves it)",
    "rviz.quality": "quality: {name}",
    "rviz.nothing_to_focus": "there is nothing to look at yet",
    "rviz.view_saved": "view saved as {name}: its line below Views (Enter) leads back, ^R renames it, ^X removes it",
    "rviz.no_controls": "There is no interactive marker: add the display InteractiveMarkers and start a server",
    "rviz.tool.bad_topic": "{topic} is no name for a topic; the tool sends nothing",
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
    "rviz.type.PoseWithCovariance": "a pose and how sure it is",
    "rviz.type.Range": "the cone of a distance sensor",
    "rviz.type.RobotModel": "a robot from its URDF",
    "rviz.type.TF": "all frames",
    "rviz.type.AccelStamped": "an acceleration",
    "rviz.type.Camera": "an image with the scene in it",
    "rviz.type.CameraInfo": "what a camera sees, as a pyramid",
    "rviz.type.Effort": "efforts of joints",
    "rviz.type.InteractiveMarkers": "things to drag and click",
    "rviz.type.PointCloud": "points (the old message)",
    "rviz.type.FluidPressure": "a pressure sensor",
    "rviz.type.GridCells": "filled cells of a grid",
    "rviz.type.Illuminance": "a light sensor",
    "rviz.type.Polygon": "a closed outline",
    "rviz.type.RelativeHumidity": "a humidity sensor",
    "rviz.type.Temperature": "a thermometer",
    "rviz.type.TwistStamped": "a velocity",
    "rviz.type.Wrench": "force and torque",
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
    "rviz.seen.unknown": "{name}: nothing, its class is not here",
    "rviz.seen.left_out": "{name}: {type} is the one display left out here; PointCloud2 shows clouds of points",
    "rviz.seen.waiting": "{name}: {count} messages wait for a transform from {frame} to {fixed}",
    "rviz.seen.markers": "{name}: interactive markers: {count}",
    "rviz.seen.nameless": "{name}: {count} messages without a frame in their header, which cannot be placed",
    "rviz.seen.point": "{name}: {count} point",
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
    # rqt_image_view
    "images.none": "There is no topic with images (sensor_msgs/msg/Image) yet. Start a camera.",
    "images.choose": "t chooses a topic.",
    "images.no_topic": "Nobody publishes {topic}.",
    "images.waiting": "Waiting for an image on {topic}.",
    "images.topic": "topic",
    "images.fit": "fit",
    "images.zoom_1": "1:1",
    "images.rotate": "rotate",
    "images.rotate_back": "rotate to the left",
    "images.save": "save",
    "images.save_title": "Save as image",
    "images.dynamic": "dynamic range",
    "images.range": "greatest range",
    "images.range_note": "Metres that are white in an image of distances.",
    "images.bad_range": "A number from 0.01 to 100.",
    "images.mouse": "publish clicks",
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
    # rqt_console
    "console.message": "Message",
    "console.severity": "Severity",
    "console.node": "Node",
    "console.stamp": "Stamp",
    "console.location": "Location",
    "console.none": "No log message yet: they come from /rosout.",
    "console.filtered": "All messages are left out; a shows them.",
    "console.newest": "follow the newest",
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
    "console.sort": "sort",
    "console.reverse": "sort the other way",
    "console.read": "read",
    "console.done": "apply",
    "console.excludes": "Exclude",
    "console.excludes.also": "also",
    "console.highlights.also": "highlight",
    "console.excludes.add": "Exclude messages …",
    "console.highlights.add": "Highlight messages …",
    "console.kind.message": "...containing",
    "console.kind.severity": "...with severities",
    "console.kind.node": "...from node",
    "console.kind.time": "...from time range",
    "console.kind.location": "...from location",
    "console.kind.custom": "Custom",
    "console.excludes.this.node": "Exclude this node",
    "console.excludes.this.severity": "Exclude this severity",
    "console.excludes.this.message": "Exclude this message",
    "console.highlights.this.node": "Highlight this node",
    "console.highlights.this.severity": "Highlight this severity",
    "console.highlights.this.message": "Highlight this message",
    "console.only": "Show highlighted messages only",
    "console.only.short": "only these",
    "console.text": "Text",
    "console.text.note": "Takes effect while it is typed; an empty line turns it off.",
    "console.regexp": "Regex",
    "console.as_text": "plain text",
    "console.enabled": "Enabled",
    "console.remove": "Remove this filter",
    "console.start_ns": "From",
    "console.stop_ns": "Until",
    "console.no_end": "no end",
    "console.start_ns.note": "Like 14:05:01.250 or 2026-01-31 14:05.",
    "console.stop_ns.note": "Like 14:05:01.250 or 2026-01-31 14:05; an empty line: no end.",
    "console.wrong_time": "This is no time, like 14:05:01.250.",
    "console.filters": "filters",
    "console.filters.title": "Filters",
    "console.files": "save, load",
    "console.save": "Save to File",
    "console.load": "Load from File",
    "console.excludes.kind.message": "Exclude messages containing",
    "console.excludes.kind.severity": "Exclude messages with severities",
    "console.excludes.kind.node": "Exclude messages from nodes",
    "console.excludes.kind.time": "Exclude messages from a time range",
    "console.excludes.kind.location": "Exclude messages from a location",
    "console.excludes.kind.custom": "Exclude messages: custom",
    "console.highlights.kind.message": "Highlight messages containing",
    "console.highlights.kind.severity": "Highlight messages with severities",
    "console.highlights.kind.node": "Highlight messages from nodes",
    "console.highlights.kind.time": "Highlight messages from a time range",
    "console.highlights.kind.location": "Highlight messages from a location",
    "console.highlights.kind.custom": "Highlight messages: custom",
    "console.undone": "as it was",
    # rqt_plot
    "bag.none": "No bag is open: o opens one.",
    "bag.cut": "'{name}' is not complete: it is shown as far as it goes.",
    "bag.cancelled": "Cancelled: '{name}' is shown as far as it was read.",
    "bag.empty": "'{name}' has no messages.",
    "bag.messages": "{count} messages",
    "bag.open": "open",
    "bag.open.title": "Open a bag",
    "bag.open.note": "The bag's folder, or a file of it (.mcap, .db3).",
    "bag.play": "play",
    "bag.pause": "pause",
    "bag.publish": "publish",
    "bag.unpublish": "no longer publish",
    "bag.publish_all": "publish all, none",
    "bag.speed": "faster, slower",
    "bag.step": "previous, next message",
    "bag.choose": "choose a topic",
    "bag.pan": "move what is seen",
    "bag.scrub": "move the playhead",
    "bag.zoom": "zoom in, out",
    "bag.fit": "see everything",
    "bag.ends": "to the beginning, the end",
    "bag.region": "select from here, until here",
    "bag.no_region": "select nothing",
    "bag.open.other": "another one …",
    "bag.view": "message",
    "bag.no_message": "no message before the playhead",
    "bag.panel": "to the fields of the message, and back",
    "bag.timeline": "back to the timeline",
    "bag.open_field": "open, close",
    "bag.plot": "plot",
    "bag.thumbnails": "thumbnails of images",
    "bag.record": "record",
    "bag.record.title": "Select name for new rosbag",
    "bag.record.topics": "Select the topics you want to record",
    "bag.recording": "recording: {count} messages, {size}; r stops",
    "bag.recording_paused": "recording paused: {count} messages, {size}; Space goes on",
    "bag.stop_recording": "stop recording",
    "bag.hold_recording": "pause, go on",
    "bag.save": "export the selected region",
    "bag.save.title": "Save selected region...",
    "bag.save.topics": "Which topics are exported?",
    "bag.name.note": "A new folder: nothing is overwritten.",
    "bag.name.none": "It needs a name.",
    "bag.all": "All",
    "bag.tick": "tick",
    "bag.go_on": "go on",
    "bag.cancel": "cancel",
    "bag.menu": "menu",
    "bag.menu.publish": "Publish",
    "bag.menu.unpublish": "No longer publish",
    "bag.menu.publish_all": "Publish All",
    "bag.menu.publish_none": "Publish None",
    "bag.menu.view": "View the message",
    "bag.menu.thumbnails": "Thumbnails",
    "bag.menu.reset": "Reset Timeline",
    "bag.menu.save": "Save Bag",
    "bag.menu.open": "Load Bag",
    "bag.menu.record": "Record Bag",
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
    # menus
    "menu.palette": "Commands",
    "menu.layouts": "Layouts",
    "menu.windows": "Windows and terminals",
    "menu.filter": "type to search",
    "menu.none": "nothing by that name",
    "menu.keys": "↑ ↓ choose   Enter go   Esc back",
    "menu.keys.close": "↑ ↓ choose   Enter go   Del close   Esc back",
    "menu.keys.remove": "↑ ↓ choose   Enter go   Del remove   Esc back",
    "menu.terminal": "terminal",
    "menu.window": "window",
    # help
    "help.title": "Help",
    "help.keys": "↑ ↓ scroll   Tab next page   Esc back",
    "log.keys": "↑ ↓ scroll   c copy   Esc back",
    "log.copied": "copied   Esc back",
    "list.head": "{name}: ",
    "help.everywhere": "Keys that work everywhere",
    "help.desk": (
        "This is the desk of a small Ubuntu computer with ROS 2. On it are terminals, in which you type commands, and the "
        "windows that programs open.\n\nNothing happens here that a command did not cause. Everything you learn here works the "
        "same on a real Ubuntu.\n\nStarted by day6-tui --detach, the desk outlives its terminal: F7, Detach leaves it (so does a "
        "closed window), and everything goes on; day6-tui attach comes back."
    ),
    "help.terminal": (
        "A terminal: type a command and press Enter.\n\n"
        "Tab completes what you began to type, Up brings back earlier commands, Ctrl-R searches them. Ctrl-C ends the running "
        "program, Ctrl-D on an empty line ends the shell. Ctrl-Z and bg let a program go on in the background; so does & at "
        "the end of a command.\n\n"
        "After an error F1 (or why) says what it means, why it happened here and what to type next. A click on the message does "
        "the same, and so does F1 on a selection.\n\n"
        "Shift+PageUp, or the mouse wheel, scrolls back. Drag with the mouse to copy; Shift+Insert or the middle button pastes."
        "\n\n~ is your home folder. Here it is not /home/NAME: type cd, then pwd to see where it is on the disk."
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
        "Tab\tpanel or view; in a narrow window the panel folds away meanwhile\nEnter\tchange a value, open a branch\n"
        "Space\tcheck box\n/\tfind a property, also in closed branches\n"
        "^N or a\tadd a display, like the button Add at the lower left (↓ below the last line or Shift Tab goes there)\n"
        "^X ^D ^R\tremove, duplicate, rename a display\nShift ↑ ↓\tmove a display\n"
        "d\thide or show the panel, like the arrow at its edge\n"
        "arrows\tturn the view, with Shift pan it\n+ -\tzoom\nf\tlook at the robot, or at what is selected\n"
        "4\t45° from above\nz\tview as at the start\nv\tOrbit, XYOrbit, TopDownOrtho, FPS, ThirdPersonFollower\n"
        "k\tkeep the view: a line below Views leads back\nl\tquality: less detail is faster\nr\treset\n"
        "^S w ^O\tsave, save as, open\ne\tsave a picture\n"
        "m i s … u\tthe tools, in RViz's own letters (a second press or Esc leaves one): m Move Camera, i Interact, s Select, "
        "c Focus Camera, n Measure, p 2D Pose Estimate, g 2D Goal Pose, u Publish Point\n\n"
        "A pose: press where it shall be, drag to where it shall look, let go. With keys: arrows and Enter for the place, arrows "
        "and Enter for the direction; Shift makes finer steps. The other tools: click, or arrows and Enter.\n\n"
        "Interactive markers: drag their controls; the right button opens their menu. With keys: x goes from one control to the "
        "next, Enter takes it and lets it go, arrows and Page keys move or turn it, Space opens the menu or changes between "
        "moving and turning.\n\n"
        "Mouse: drag turns, Shift or Ctrl and drag pans, the wheel zooms."
    ),
    "help.rqt_graph": (
        "Which node talks to which. Round boxes (ellipses in the real rqt_graph) are nodes, arrows and square boxes are topics. "
        "A pulse runs along an arrow when messages pass. "
        "The line below says what the filters hide.\n\n"
        "Drag or arrow keys: move. Wheel, + and -: zoom, from names in full to an overview. v (Fit) shows the whole graph again, "
        "and keeps to it until you move. An arrow with a number at an edge says how many boxes lie beyond it. "
        "A click, or j and k, chooses a box: the line below describes it."
    ),
    "help.editor": (
        "A file of your home folder. What is wrong in it is named below and underlined, while you type. Unsaved text is kept and "
        "comes back, whatever happens. Any other editor on the same files works as well: a change on the disk shows up here."
    ),
    "help.inspector": (
        "What is wrong right now: in the graph (names that differ by a letter, types and QoS that do not match, two publishers "
        "that fight, joints the robot does not have), in the terminals (nothing sourced or built, what a program failed of), "
        "in the files (changed and not built again, what setup.py lacks), and inside programs (nobody spins, a callback that "
        "does not come back).\n\nRed keeps something from working. The line below is a command that helps: Enter, or a click, "
        "writes it into a terminal, where another Enter runs it.\n\nThe inspector only looks on: it is in no list and no count. "
        "In a drill and in an exam it is quiet until the fault is mended or given up."
    ),
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
    "help.rqt_image_view": (
        "The images of a topic. t, or a click on its name, chooses one of the topics with images. The newest image is shown, a "
        "few times a second, however many come.\n\n"
        "1 shows every pixel of the image, arrows then move the part that is seen; 1 again fits all of it into the window. r "
        "rotates, R to the left. The line below tells size and encoding, and which pixel the mouse is on. w saves the whole "
        "image (png, jpg, bmp, tiff).\n\n"
        "Images of distances (16UC1, 32FC1) are grey: black is 0, white the greatest range, which x changes. d takes the least "
        "and the greatest distance there are. m publishes where you click, on <topic>_mouse_left."
    ),
    "help.showimage": (
        "The newest image of the topic image, fitted into the window, a few times a second, however many come. The line below "
        "tells size and encoding, and which pixel the mouse is on. `ros2 run image_tools cam2image --ros-args -p "
        "burger_mode:=true` publishes images without a camera.\n\n"
        "In real ROS 2 this is a window of OpenCV, as large as the image. Closing it ends the program; there it would come back "
        "with the next image."
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
    "help.world": (
        "A small world with physics, in place of the Gazebo of a real lesson. The wheels touch the floor, so when they turn the "
        "robot rolls: /cmd_vel or /joint_commands turns them. It publishes its position on /odom as the wheels measure it, "
        "and senses with /scan and /line_sensor.\n\n"
        "To enter, every link needs <inertial>; a link without <collision> goes through walls.\n\n"
        "+ and - zoom, arrows move the view, f follows the robot, 0 shows everything. l shows the lidar, t wipes the trail. "
        "Space pauses, n takes one step, [ and ] change the speed of time, r puts the robot back to its start. "
        "RTF is the real-time factor, as in Gazebo: how many seconds passed in here while one passed on your watch."
    ),
    "help.joint_state_publisher": (
        "A slider for every joint that can move. What you set here goes to /joint_states ten times a second; "
        "robot_state_publisher turns it into the poses of the links.\n\n"
        "Up and down choose a joint, left and right move it, with Shift ten times as far, with Ctrl as little as possible, Home "
        "and End go to its limits, z to zero. A digit, Enter or a click on a number begins an exact one. "
        "r is Randomize, c is Center, d changes between radians and degrees. With the mouse: drag the knob.\n\n"
        "If another node publishes the same joints, the robot jitters: both send commands, and the last one counts."
    ),
    "help.rqt": (
        "rqt collects the windows of the ROS tools. The arrow keys choose one, Enter opens it, and once more if it is open; "
        "each is a pane of its own, and all of them are one program with one node. x closes the one under the cursor, "
        "the cross of this window all of them.\n\n"
        "What is open, with its settings, is a perspective: rqt begins with the last one. p switches to another, makes a new "
        "one, and reads or writes a file that the real rqt can read, too. Each window is also a command: "
        "ros2 run rqt_plot rqt_plot. It gets the keyboard, unless & stands at the end: then you go on typing."
    ),
    "help.rqt_console": (
        "The log messages of all nodes, from the topic /rosout, the newest at the end. The arrow keys or a click choose one: "
        "it is shown below the table, and Enter or a double click shows all of it. Esc follows the newest again. "
        "A click on a column's name sorts by it, a second one the other way round; s and S do the same.\n\n"
        "/ leaves out messages that contain a text, h highlights them: what you type takes effect at once, Tab makes a regular "
        "expression of it, Enter keeps it, Esc takes it back. The capital letters, or a click on a box, leave out severities: "
        "D, I, W, E, F. n leaves out the node of the chosen message, a shows everything again. f lists all filters, those that "
        "leave out and those that highlight, as below the table of the real window: Enter changes one, Del removes it.\n\n"
        "Space pauses: what comes meanwhile is lost, as in the real one. c clears. w saves what is shown to a file, o loads one; "
        "such files go to and from the real rqt_console.\n\n"
        "What a node does not log at all is decided by its level: see --log-level, and the logger services. The location is the "
        "file, function and line that logs: of a Python node a whole path, of a C++ node, as in a binary installation, from its "
        "package's folder on; it is that of the program that runs here, which is not written in C++."
    ),
    "help.rqt_bag": (
        "A bag on a timeline: a line for each topic, with higher bars where there are more messages. The red line is the "
        "playhead.\n\nTick a topic (Enter) and its messages are published, with the recorded quality of service: its newest "
        "message wherever the playhead is moved to, and every message while it plays. So Plot and RViz follow the playhead. "
        "(The real rqt_bag publishes only while it plays.) Frames go back in time only in an RViz that goes by the bag's clock: "
        "rqt_bag --clock, and use_sim_time for RViz.\n\nClick or drag in the timeline to move the playhead, drag in the "
        "ruler to select a region, turn the wheel to zoom, drag with the middle button or Shift to move what is seen. Playing "
        "goes around in the selected region, or in everything. Of a bag only its index is read: large ones open at once.\n\n"
        "v shows the message or image of the chosen topic at the playhead; Tab goes to its fields, where g types the command "
        "that plots one. w exports the selected region to a new bag, r records a new one in place of what is open.\n\n"
        "Keys are the real one's, but for Up and Down: they choose a topic here, there they zoom as Page Up and Page Down do. "
        "A perspective of rqt keeps the open bags, the ticked topics, the region and what is seen."
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
    "error.close": "Close",
    "list.comma": ", ",
    # the card of a message (F1)
    "why.title": "What does this mean?",
    "why.keys.next": "Enter types the command   F1 manual   Esc back",
    "why.keys": "↑ ↓ scroll   F1 manual   Esc back",
    "why.next": "Type next",
    "question.back": "Back",
    "theme.title": "Theme",
    "theme.dark": "Dark",
    "theme.light": "Light",
    "theme.contrast": "High contrast",
    "theme.colourblind": "Safe for colour-blind eyes",
    "settings.fault": "{path} cannot be read and is left as it is: {reason}",
    "settings.not_kept": "The choice holds until the end only: {reason}",
    "distro.title": "Distribution of ROS 2",
    "distro.next_start": "{name} from the next start of day6-tui on (day6-tui --distro {name})",
    # the manual
    "help.search": "type to search all pages",
    "manual.desk": "The desk",
    "manual.welcome": "The choices at the start",
    "manual.guide": "Commands to try",
    "manual.terminal": "Terminals",
    "manual.editor": "The editor",
    "manual.turtlesim": "turtlesim",
    "manual.car": "The car from above",
    "manual.world": "The world",
    "manual.joint_state_publisher": "Joint sliders",
    "manual.rviz2": "RViz",
    "manual.rqt": "rqt",
    "manual.rqt_graph": "rqt_graph",
    "manual.rqt_console": "rqt_console",
    "manual.rqt_bag": "rqt_bag",
    "manual.rqt_plot": "rqt_plot",
    "manual.service_caller": "Service Caller",
    "manual.publisher": "Message Publisher",
    "manual.type_browser": "Type browsers",
    "manual.action_browser": "Action Type Browser",
    "manual.topics": "Topic Monitor",
    "manual.rqt_tf_tree": "TF Tree",
    "manual.rqt_reconfigure": "Parameter Reconfigure",
    "manual.rqt_logger_level": "Logger Level",
    "manual.rqt_image_view": "Image View",
    "manual.showimage": "showimage",
    "manual.rqt_shell": "Shell of rqt",
    "manual.rqt_py_console": "Python Console of rqt",
    "manual.rqt_robot_steering": "Robot Steering",
    "manual.inspector": "Inspector",
    # The command line
    "cli.description": "ROS 2 for people who have no ROS 2. Without a command, opens the desktop.",
    "cli.usage": "usage: ",
    "cli.options": "options",
    "cli.help": "show this help and exit",
    "cli.scene": "what to begin with (default: the welcome choices)",
    "cli.robot": "a URDF file of your own instead of the shipped car",
    "cli.distro": "the distribution of ROS 2 (default: ROS_DISTRO, else as chosen last, else jazzy)",
    "cli.lang": "language of the screen (default: that of the system)",
    "cli.glyphs": "what pictures are drawn with (default: by terminal; pixels where it shows them)",
    "cli.theme": "the colours (default: as chosen last)",
    "cli.fps": "most frames a second (default: 30)",
    "cli.reduced_motion": "no pulses and no animation",
    "cli.home": "the folder that is ~ in the terminals",
    "cli.detach": "a desktop that goes on when this terminal is closed; day6-tui attach comes back to it",
    "cli.attach": "Come back to the desktop started by --detach, from any terminal of this machine.",
    "cli.attach.home": "the folder that is ~ in that desktop, if it was started with --home",
    "cli.attach.lang": "language of what attach says (default: that of the system)",
    "cli.class": "A class on a network: each desktop keeps its own graph, and the teacher sees all of them.",
    "cli.class.group": "class",
    "cli.class.teacher": "this desktop is the teacher's, on port {port} (--listen for another); pupils see nothing of each other",
    "cli.class.room": "with --teacher: one graph for all, to play together",
    "cli.class.join": "join the class of this teacher: HOST or HOST:PORT, e.g. 192.168.1.5; without a port it is {port}",
    "cli.class.name": "your name in the class: letters a-z, digits and single _, a letter first, e.g. wang_xiaoming",
    "cli.class.one": "choose --teacher, or --join HOST --name NAME",
    "cli.class.no_name": "--join needs --name NAME",
    "cli.class.name.letters": "'{name}' cannot be a name: a letter a-z first, then letters, digits and _, e.g. wang_xiaoming",
    "cli.class.name.double": "'{name}' cannot be a name: no two _ in a row, as in ROS names",
    "cli.class.name.long": "'{name}' cannot be a name: at most {most} characters",
    "cli.class.name.teacher": "'{name}' cannot be a name: it is the teacher's",
    "cli.class.with_teacher": "{option} goes with --teacher",
    "cli.class.with_join": "{option} goes with --join",
    "cli.class.connect": "in a class, --join HOST takes the place of --connect",
    "cli.class.endpoint": "'{text}' is no host name or address",
    "cli.class.port": "'{text}': {port} is no port; ports are 1 to 65535",
    "cli.listen": (
        "let other machines in, e.g. tcp/0.0.0.0:7447; without --secret anyone who reaches this port can read and command"
    ),
    "cli.connect": "join another machine, e.g. tcp/192.168.1.5:7447",
    "cli.secret": (
        "what the machines of --listen and --connect must have in common: better a file that only you can read (chmod 600) than "
        "a word, which every user of this machine can see in the list of processes"
    ),
    "cli.version": "print the version and exit",
    "cli.commands": """\
commands:
  shell                       a real sub-shell in which ros2, colcon, rviz2, python3 … are these
  attach [--home DIR]         come back to the desktop that was started with --detach
  serve [--class FILE.csv]    a class in browser tabs: a desktop for each pupil
  class --teacher             the desktop of a teacher, whom the pupils of the network join
  class --join HOST --name NAME
                              the desktop of a pupil in that class
  wheelhouse DIR              all that installs day6-tui without internet, for a USB stick
  lessons VERB                lesson files: list, new, check, preview, play, help (how to write them)
  demo DAY                    play a day of lessons by itself, for a hall
  exec [-c COMMANDS] [FILE]   run lines of the simulated terminal without a screen
  python FILE [ARG ...]       run a Python file unmodified as a ROS program
  ros2 ...                    the ros2 command, on the graph of this machine
  colcon ...                  build a workspace
  rviz2                       the robot in 3-D; a window takes this terminal
  rqt, rqt_graph, rqt_console, rqt_plot, rqt_topic
                              the windows of rqt
  check_urdf FILE             check a robot description
  urdf_to_graphviz FILE       draw a robot description
  xacro FILE [NAME:=VALUE]    write the URDF that a xacro file stands for
  cast FILE.cast [--svg FILE] play a recording of the screen, or write its picture as SVG
  why [TEXT]                  explain a message; A 2>&1 | day6-tui why explains what A said
  export [PKG ...] [-o FILE]  packages of the workspace as a zip that builds on a real ROS 2
  submit [-o FILE.zip]        pack your programs and answers for the teacher
  grade FILE ...              run submissions again on hidden scenarios (--csv, --html)
  report [--csv|--html FILE]  how far all pupils of this machine are
  env [--vscode|--pycharm]    print the variables that do the same for this shell, or set up an IDE""",
    "cli.more": "day6-tui COMMAND --help says more.",
    "cli.no_command": "there is no command '{name}'; day6-tui --help lists them",
    "cli.no_terminal": "the desktop needs a terminal; day6-tui exec runs commands without one",
    "cli.textual": "Textual {version} is installed; this day6-tui needs {tested}: pip install 'textual=={tested}.*'",
    # Lessons
    "lesson.title": "Lessons",
    "lesson.days": "Six days",
    "lesson.none": "there are no lessons here",
    "lesson.drill.open": "Not mended yet. Look for the cause; h gives a hint.",
    "lesson.topic.environment": "Environment",
    "lesson.topic.workspace": "Workspace",
    "lesson.topic.package": "Packages",
    "lesson.topic.code": "Programs",
    "lesson.topic.names": "Names",
    "lesson.topic.types": "Message types",
    "lesson.topic.qos": "QoS",
    "lesson.topic.parameters": "Parameters",
    "lesson.topic.services": "Services and actions",
    "lesson.topic.tf": "Transforms",
    "lesson.topic.rviz": "RViz and models",
    "lesson.topic.time": "Time",
    "lesson.topic.network": "Network",
    "lesson.unknown": "there is no lesson {name}",
    "lesson.minutes": "{minutes} min",
    "lesson.drills": "Find the fault",
    "lesson.own": "Lessons of this folder",
    "lesson.drills.own": "Find the fault (of this folder)",
    "lesson.drills.more": "Something does not work; find out why. All in a folder of its own: your files are not touched.",
    "lesson.step": "Step {number} of {all}",
    "lesson.working": "typing for you …",
    "lesson.more": "↓ more",
    "lesson.answer": "Press F5 to come to this window, choose with {letters}, then Enter",
    "lesson.answer.here": "Choose with {letters}, then press Enter",
    "lesson.hint": "Hint {number} of {all}",
    "lesson.hint.key": "h hint",
    "lesson.next.key": "F5 next step",
    "lesson.solved": "Done! {key} goes on to the next step.",
    "lesson.already": "You have done this already. Have a look, then {key} goes on.",
    "lesson.done_before": "You have solved this step before: do it again, or go on with F5 and →.",
    "lesson.finished": "{title}: done! {solved} of {all} steps solved, {hints} hints read. Enter opens what comes next.",
    "lesson.leftovers": "Still running from before: {names}. To begin with an empty desk press F5, then C (capital): I end them.",
    "lesson.key.clear": "end what runs",
    "lesson.missing": "This step needs an earlier one: {names}. Press P (capital) and I set it up.",
    "lesson.problem": "That did not work: {reason}",
    "lesson.something_runs": "Programs are still running. End them with Ctrl-C in their terminals, then open this drill again.",
    "lesson.not_saved": "Your progress was not saved: {reason}",
    "lesson.key.choose": "choose",
    "lesson.key.open": "open",
    "lesson.key.next": "next step",
    "lesson.key.hint": "hint",
    "lesson.key.type": "type it for me",
    "lesson.key.prepare": "set it up",
    "lesson.key.steps": "back, on",
    "lesson.key.list": "lessons",
    "lesson.key.scroll": "pages",
    "lesson.key.solution": "show me how",
    "lesson.key.again": "this step again",
    "lesson.key.terminal": "to the terminal",
    "lesson.key.random": "any drill",
    "lesson.key.exam": "exam",
    "lesson.key.hold": "hold",
    "lesson.key.on": "on",
    "lesson.key.speed": "speed",
    "lesson.key.stop": "stop the demo",
    "lesson.key.demo": "demonstrate from here on",
    "lesson.key.notes": "notes for the teacher",
    "lesson.demo": "demonstration {speed}×",
    "lesson.demo.held": "demonstration held",
    "lesson.notes": "For the teacher",
    "lesson.exam.step": "Exam {number} of {all}",
    "lesson.exam.over": "The exam is over: {solved} of {all} solved",
    "lesson.exam.result": "{seconds} s, {hints} hints",
    "lesson.name": "What is your name?",
    "lesson.name.note": "Progress is kept under your name",
    "lesson.name.empty": "a name is needed",
    "lesson.name.long": "this name is too long",
    "lesson.name.control": "this name has characters that cannot be shown",
    "action.lessons": "Lessons",
    "help.action.lessons": "lessons, step by step; on to the next step when one is done",
    "action.pupil": "Another pupil",
    "help.action.pupil": "progress is kept under a pupil's name",
    "help.lesson": (
        "Learning step by step. The terminal beside it is yours: do what it says; it watches the running system, ticks off "
        "what is there and says what it saw where something is not.\n\n"
        "F5 goes on when a step is done; otherwise it goes between lesson and terminal. h gives a hint, three in all, "
        "the last one is the command; then Enter types it for you. A question is answered by a letter and Enter.\n\n"
        "Left and Right show the step before and after, L (capital) the list of lessons, P sets up the steps that are needed, "
        "C ends what runs from before, S shows you how (a file of yours is copied to .mine first). "
        "What is typed here goes to the terminal. Progress is kept after every step."
    ),
    "manual.lesson": "Lessons",
    "cli.lesson": "open this lesson at once (day1 … day6, or the name of a drill)",
    "cli.lessons": "take the lessons of this folder (day6-tui lessons help says how they are written)",
    # the kitchen
    "action.kitchen": "Kitchen: the graph as cooks, belts and dishes",
    "help.action.kitchen": "shows the live graph as a kitchen in which dishes move when messages pass; once more closes it",
    "kitchen.title": "Kitchen",
    "kitchen.count": "cooks: {cooks}, belts: {belts}",
    "kitchen.hidden": ", hidden: {count}",
    "kitchen.trouble": "belts that do not work: {count}",
    "kitchen.belts": "belt",
    "kitchen.cooks": "cook",
    "kitchen.explain": "explain",
    "kitchen.show_hidden": "hidden ones",
    "kitchen.hide": "hide again",
    "kitchen.scroll": "scroll",
    "kitchen.leave": "choose nothing",
    "kitchen.empty": (
        "The kitchen is empty: no node is running.\nStart a cook in a terminal, for example\n"
        "ros2 run turtlesim turtlesim_node"
    ),
    "kitchen.space": " ",
    "kitchen.nobody": "nobody",
    "kitchen.unseen": "{count} hidden",
    "kitchen.note.type": "wrong shape",
    "kitchen.note.qos": "QoS differs",
    "kitchen.note.unheard": "nobody takes",
    "kitchen.note.unfilled": "nobody gives",
    "kitchen.cook": "{name} is a cook.",
    "kitchen.cook.gives": "Puts dishes on {belts}.",
    "kitchen.cook.takes": "Takes dishes from {belts}.",
    "kitchen.cook.idle": "Stands at no belt that is shown.",
    "kitchen.cook.twins": "{count} cooks have this name, and nobody can tell them apart!",
    "kitchen.cook.ros": "ROS: node {name}, publishes {gives}, subscribes to {takes} of these topics.",
    "kitchen.belt.moves": "The belt {belt} carries {shape} from {givers} to {takers}.",
    "kitchen.belt.unheard": "{givers} puts {shape} on the belt {belt}, but nobody takes them: they fall off at the end.",
    "kitchen.belt.unfilled": "{takers} waits at the belt {belt} for {shape}, but nobody puts any on it.",
    "kitchen.belt.type": "{giver} puts {shape} on the belt {belt}, but the hatch of {taker} only fits {wanted}: nothing gets in.",
    "kitchen.belt.qos": (
        "{giver} puts {shape} on the belt {belt}, but {taker} takes dishes on other terms only, and gets none."
    ),
    "kitchen.belt.ros": "ROS: topic {belt}, type {type}; publishers: {givers}; subscribers: {takers}.",
    "kitchen.belt.type.ros": "ROS: on {belt} {giver} publishes {sent} and {taker} subscribes to {detail}: not the same type.",
    "kitchen.belt.qos.ros": "ROS: on {belt} the QoS of {giver} does not satisfy {taker}: {detail}.",
    "kitchen.belt.rate": "{rate} messages a second, measured.",
    "kitchen.belt.still": "No message passes at the moment.",
    "kitchen.belt.unknown": ("How many messages pass cannot be counted from here: none comes by."),
    "help.kitchen": (
        "The live graph as a kitchen. Cooks are nodes, belts are topics, dishes are messages. A dish looks like its message "
        "type: the same type, the same shape, letter and colour. A cook whose hatch fits another shape gets nothing, and the "
        "belt is marked.\n\n"
        "A dish moves when a message really passed. Where many pass, only some are drawn; the number beside the type is the "
        "measured rate. ?/s: nobody here can count them, because nobody takes them or both cooks are on another machine.\n\n"
        "■ puts dishes on a belt, ► takes them, × cannot take them. Dotted belts are empty: nobody puts anything on them.\n\n"
        "/rosout, /parameter_events and hidden nodes are left out; h shows them. A click on a cook or a belt explains it. "
        "The kitchen itself subscribes to nothing and is not in the picture."
    ),
    "manual.kitchen": "Kitchen",
    # recordings
    "action.record": "Record the screen, or end the recording",
    "help.action.record": "writes everything the screen shows into a file for asciinema or day6-tui cast; keys are not recorded",
    "record.running": "recording {time}",
    "record.file": "Record the screen into",
    "record.note": "What the screen shows is recorded, no keys. F7 Record ends it. To play it: day6-tui cast FILE",
    "record.no_name": "a file needs a name",
    "record.not_here": "the screen cannot be recorded on this system",
    "record.broken": "The recording {file} has ended: {reason}",
    "record.done": "recorded: {file}",
    "cast.keys": "space pause   + - speed   <- -> 5 s   . step   q quit",
    "cast.larger": "recorded at {columns}x{lines}",
    "cast.windows": "casts can be played in a terminal of Linux and macOS; here, --svg writes their pictures",
    "cast.no_terminal": "to play a cast a terminal is needed; --at SECONDS prints its text, --svg FILE writes its picture",
    "cast.exists": "exists already; --force overwrites it",
    "cast.exists.record": "exists already; nothing is overwritten",
    "cast.no_folder": "no file can be made there",
    "cast.fault.large": "larger than {most} MB",
    "cast.fault.text": "this is no text in UTF-8",
    "cast.fault.head": "this is no asciinema cast: its first line is no JSON object with a version",
    "cast.fault.version": "version {version} of the format is unknown; version 2 can be played",
    "cast.fault.size": "the size of the screen is no number of columns and rows from 1 to {most}",
    "cast.fault.long": "this line is too long",
    "cast.fault.json": "this is no JSON",
    "cast.fault.event": "this is no event: [seconds, kind, text]",
    "cast.fault.time": "this time is no number of seconds, or lies before that of the line above",
    "cli.record": "record the screen into a new file, for asciinema or day6-tui cast",
    "cli.cast": "Play a recording of the desktop, or any asciinema cast; or write its picture as SVG.",
    "cli.cast.file": "a recording in asciinema's format, version 2",
    "cli.cast.svg": "write the picture at --at, or at the end, into this file",
    "cli.cast.at": "the time in seconds; without --svg, print the text of the screen then",
    "cli.cast.frames": "so many pictures from beginning to end, as one moving SVG",
    "cli.cast.force": "overwrite the SVG file if it exists",
    # presenting
    "bar.scene.paused": "paused: type what you like",
    "bar.scene.pause": "pause",
    "bar.scene.resume": "go on",
    "bar.scene.step": "step",
    "bar.scene.stop": "stop",
    "action.scene.pause": "Scene: pause or go on",
    "action.scene.step": "Scene: one command, then pause",
    "action.scene.faster": "Scene: type faster",
    "action.scene.slower": "Scene: type slower",
    "action.layout.speaker": "Layout: speaker, a big terminal and one picture",
    "help.action.scene.pause": "stops typing, and goes on where it stopped; F9 and Space do the same while a scene is typed",
    "help.action.scene.step": "goes on up to the next command; Page Down, or a presenter's clicker, does the same",
    "help.action.scene.faster": "up to four times; + does the same while a scene is typed",
    "help.action.scene.slower": "down to a quarter; - does the same while a scene is typed",
    "help.action.layout.speaker": "for a hall; F8 shows the picture alone, and goes back to the terminal",
    # -- keeping pupils apart (day6_core/isolation): what a mode is, and why one is not to be had --
    "isolation.is.users": "each pupil is a Unix user of their own: no pupil can read, change or end what is another's; "
    "names of processes and of files in /tmp can be seen, and ports on this machine are everybody's",
    "isolation.is.bubblewrap": "each pupil is in a sandbox of their own (bubblewrap): nothing of other pupils can be seen, "
    "read or ended; programs have no network unless you allow it",
    "isolation.is.landlock": "each pupil can open only their own files and end only their own programs (Landlock), "
    "but can connect to the sockets of another pupil's desktop and type into it: this does not keep pupils apart",
    "isolation.is.none": "all pupils are the same user: each can read, change and end everything of every other pupil, "
    "and everything else that belongs to this user",
    "isolation.no.linux": "exists on Linux only",
    "isolation.no.root": "needs a server that is started as root",
    "isolation.no.as_root": "is for a server that is not root",
    "isolation.no.bwrap": "needs bubblewrap (Debian, Ubuntu: apt install bubblewrap)",
    "isolation.no.landlock": "this Linux has no Landlock (5.13 or later, and switched on)",
    "isolation.no.fails": "was tried and does not start: {reason}",
    "isolation.no.open": "was tried and does not keep pupils apart here; this went through: {names}",
    "isolation.no.closed": "other users cannot go into {folder}: put day6-tui, its Python and the homes where all may go "
    "(for example python3 -m venv /opt/day6-tui)",
    "isolation.no.owner": "{folder} has files of another user; if they are the pupil's: chown -R {uid}:{uid} {folder}",
    "isolation.no.inside": "{folder} lies in a folder that every pupil may read: choose another place for it",
    "isolation.no.taken": "{folder} belongs to user {uid}, whose number another server on this machine uses",
    "isolation.no.uids": "all user numbers from {first} to {last} are in use",
    # -- a class in browser tabs: `day6-tui serve` --
    "cli.serve": "A desktop in every browser tab, for a class: each pupil gets a link, or chooses a name with the class word.",
    "cli.serve.word": "class word: whoever knows it chooses a name and gets a desktop",
    "cli.serve.host": "address to listen on (default: 127.0.0.1, this machine only)",
    "cli.serve.port": "port to listen on (default: 8006; 0: any that is free)",
    "cli.serve.data": "folder for the homes of the pupils and what the server remembers",
    "cli.serve.isolation": "how pupils are kept apart (default: the best this machine has)",
    "cli.serve.memory": "memory of each pupil at most (default: 1024), where the way pupils are kept apart can see to it",
    "cli.serve.disk": "home folder of each pupil at most (default: 512); above it the pupil is told, at one and a half it ends",
    "cli.serve.processes": "processes and threads of each pupil at most (default: 256), where it can be seen to",
    "cli.serve.cpu_weight": "share of the processors when all want them (default: 100), where there are control groups",
    "cli.serve.trust": "open to others although pupils are not kept apart",
    "cli.serve.most": "desktops at a time (default: 40)",
    "cli.serve.lang": "language of the desktops and of what the server says (default: that of the system)",
    "serve.windows": "serve needs Unix sockets and pseudo-terminals: Linux or macOS (on Windows: inside WSL)",
    "serve.no_mode": "--isolation {name}: {reason}",
    "serve.not_mode": "not --isolation {name}: {reason}",
    "serve.as_before": "--isolation {name}, as before in this folder",
    "serve.other_mode": "{name}: the desktop of the last server was ended: it was kept apart by --isolation {mode}",
    "serve.at": "open {address} in a browser",
    "serve.apart": "how pupils are kept apart: {what}",
    "serve.back": "To the start page",
    "serve.start.what": "ROS 2 in a browser tab: turtlesim, RViz, rqt_graph and terminals, on a desktop of your own.",
    "serve.start.word": "Class word",
    "serve.start.name": "Your name",
    "serve.start.enter": "Open my desktop",
    "serve.start.go_on": "Go on as {name}",
    "serve.start.leave": "I am not {name}",
    "serve.start.by_link": "Use the link or the QR code your teacher gave you.",
    "serve.start.apart": "How pupils are kept apart here:",
    "serve.start.none": "All of you share one account here: everybody can open, change and end what the others have. "
    "Please leave it alone, and keep no secrets here.",
    "serve.wrong.word": "That is not the class word.",
    "serve.wrong.often": "Too many wrong tries. Wait a minute.",
    "serve.wrong.name": "Somebody is called {name} already. Choose another name; if it is you, use the browser you began with.",
    "serve.wrong.link": "This link is not valid (any more). Ask your teacher for a new one.",
    "serve.wrong.stranger": "This page needs a link from your teacher.",
    "serve.wrong.host": "Open the address your teacher gave you.",
    "serve.wrong.address": "There is no page at this address.",
    "serve.name.empty": "Type a name.",
    "serve.name.long": "This name is too long: 32 characters at most.",
    "serve.name.letters": "A name has letters and digits, and perhaps blanks, dots and dashes.",
    "cli.serve.class": "the names of the class, one a line or in a column `name`: each gets a link",
    "cli.serve.new_links": "make all links anew; the old ones are no longer good",
    "cli.serve.idle": "end a desktop after so many minutes without a key (default: 120; 0: never); files stay",
    "cli.serve.keep": "let the desktops go on when the server is ended; the next server finds them",
    "cli.serve.cert": "certificate for https (PEM), with --key if that is a file of its own",
    "cli.serve.key": "the certificate's private key (PEM)",
    "cli.serve.base_url": "address or path at which browsers reach the server, behind a proxy",
    "cli.serve.unix": "listen on a Unix socket, for a proxy",
    "cli.serve.home": "with --proxied: the folder that is ~ in the desktop",
    "cli.serve.proxied": "whoever reaches the server is the user: one desktop, no link (for jupyter-server-proxy)",
    "serve.no_packages": "serve needs more packages: pip install 'day6-tui[serve]'",
    "serve.not_apart": "--host {host}: pupils are not kept apart here (--isolation {name}), "
    "so each could read and change everything of this user; if you trust them: --trust-pupils",
    "serve.in_use": "{folder}: another server uses this folder",
    "serve.bad_tokens": "{file} is not what this program writes there: move it away, and all links are made anew",
    "serve.again": "{number} desktops of the last server go on",
    "serve.link": "{name}: {link}",
    "serve.teacher": "the teacher: {link}",
    "serve.kept": "{number} desktops go on; the next server with this folder finds them",
    "serve.ending": "ending {number} desktops; the files stay in {folder}",
    "serve.left": "{name}: not everything of the last desktop could be ended",
    "serve.idle": "{name}: ended after {minutes} minutes without a key; the files stay",
    "serve.refused": "{name}: no desktop: {reason}",
    "serve.full": "{name}: no desktop: {most} are running, and --most allows no more",
    "serve.no_record": "{file}: cannot be written ({reason})",
    "serve.bad_record": "{file} is not what this program writes there; the last desktops are found by the names of the pupils",
    "serve.disk.over": "{name}: {used} MB in the home folder, more than {most} MB",
    "serve.disk.ended": "{name}: ended, {used} MB in the home folder where {most} MB are allowed; the files stay",
    "serve.class.large": "{file} is too large for a list of names",
    "serve.class.encoding": "{file}: neither UTF-8 nor GBK",
    "serve.class.line": "not a line of a table",
    "serve.class.twice": "this name is there twice",
    "serve.class.bad": "{file}, line {line} “{text}”: {reason}",
    "serve.class.nameless": "no name",
    "serve.class.empty": "{file}: no names",
    "serve.wrong.disk": "The server's disk is full. Tell your teacher.",
    "serve.links.what": "Print this page and cut it up: each pupil gets one link. Whoever has the link has the desktop.",
    "serve.links.none": "Nobody is on the list yet.",
    "serve.links.back": "Back to the class",
    "serve.links.local": "These links work on this machine only: other devices cannot use them. "
    "For other devices, end the server and start it with --host 0.0.0.0.",
    "serve.links.unknown": "The link you gave out before still works. It cannot be shown again; a new link makes it invalid.",
    "serve.links.by_word": "Not on the list of names: whoever chose this name with the class word needs no link.",
    "serve.links.not_kept": "The new links work until the server ends: they could not be written down ({reason}).",
    "serve.links.watching": "To watch only:",
    "serve.links.new": "New link…",
    "serve.links.new.sure": "Every older link of {name} stops working, on paper and in every browser. "
    "{name} then needs the new one.",
    "serve.links.new.yes": "Make a new link",
    "serve.links.watch": "Link for watching…",
    "serve.links.watch.sure": "Whoever has it sees the desktop of {name} and cannot type; {name} is told that somebody watches. "
    "An older link for watching stops working.",
    "serve.links.watch.yes": "Make a link for watching",
    "serve.links.all": "New links for all…",
    "serve.links.all.sure": "All {count} pupils of the list get new links, to be printed here. "
    "Every older one stops working, on paper and in every browser.",
    "serve.links.all.yes": "Make new links for all",
    # a class: what a pupil sees
    "action.hand": "Raise your hand, or lower it",
    "action.sayings": "What the teacher said",
    "action.take_back": "Let the teacher type no longer",
    "help.action.hand": "the teacher of the class sees it",
    "help.action.sayings": "every message of the teacher to you",
    "help.action.take_back": "only you type, from now on",
    "class.hand.raised": "Your hand is up: the teacher sees it",
    "class.hand.alone": "Your hand is up; no teacher is connected now",
    "class.hand.lowered": "Your hand is down",
    "class.taken_back": "The teacher can no longer type",
    "class.hand.seen": "Your teacher has seen your hand",
    "class.ended": "Your teacher has ended this desktop. Your files are kept.",
    "class.sayings": "The teacher said",
    "class.log.time": "time",
    "class.log.name": "name",
    "class.log.what": "what",
    "class.log.text": "text",
    "class.log.came": "came",
    "class.log.left": "left",
    "class.log.lesson": "opened a lesson",
    "class.log.step": "next step",
    "class.log.error": "error",
    "class.log.mended": "error mended",
    "class.log.hand": "hand up",
    "class.log.lowered": "hand down",
    "class.sayings.none": "Nothing yet.",
    # The teacher's window of a class on a network
    "action.class": "The class: who is where, their screens, orders",
    "help.action.class": "the teacher's view of the pupils who have joined",
    "teacher.title": "Class",
    "teacher.here": "{here} of {all} here",
    "teacher.hand": "1 hand up",
    "teacher.hands": "{count} hands up",
    "teacher.bar.hand": "1 hand",
    "teacher.bar.hands": "{count} hands",
    "teacher.raised": "{name} has raised a hand",
    "teacher.frozen": "the class is frozen",
    "teacher.stuck": "{count} stuck",
    "teacher.typing": "you type for {name}",
    "teacher.awaited": "asked whether you may type: it begins with the yes",
    "teacher.over.taken_back": "{name} has taken it back: Ctrl-] or Esc",
    "teacher.over.gone": "{name} is gone: Ctrl-] or Esc",
    "teacher.key.large": "screen",
    "teacher.key.back": "table",
    "teacher.key.say": "say",
    "teacher.key.open": "open",
    "teacher.key.freeze": "freeze",
    "teacher.key.thaw": "let go on",
    "teacher.key.type": "type",
    "teacher.key.end_typing": "end typing",
    "teacher.key.acknowledge": "go on",
    "teacher.key.next": "next, previous",
    "teacher.key.preview": "preview",
    "teacher.key.invite": "how to join",
    "teacher.key.scroll": "scroll",
    "teacher.key.page": "a page up, down",
    "teacher.key.ends": "first, last",
    "teacher.key.forget": "remove the row of who is gone",
    "teacher.key.compare": "compare",
    "teacher.key.all": "say to all, open for all",
    "teacher.key.lower": "lower the hand",
    "teacher.key.csv": "report and log for a spreadsheet",
    "teacher.key.end": "end the desktop of the pupil",
    "teacher.empty": "Nobody has joined yet. On a pupil's machine in the same network:",
    "teacher.join": "To join: {command}",
    "teacher.opening": "The way in is being opened; nobody can join yet.",
    "teacher.port_in_use": "Nobody can join: another program, perhaps another class, listens on port {port}. "
    "End it, or start with --listen tcp/0.0.0.0:PORT and another port.",
    "teacher.shut": "Nobody can join: {reason}",
    "teacher.turned.taken": "{name} is taken: another machine asks for this name",
    "teacher.turned.full": "{name} cannot join: the class is full",
    "teacher.turned.domain": "{name} cannot join: another ROS_DOMAIN_ID there",
    "teacher.invite": "How to join",
    "teacher.invite.text": "On a pupil's machine in the same network, each with a name of their own:\n",
    "teacher.invite.keys": "Enter copies  Esc closes",
    "teacher.head.name": "Name",
    "teacher.head.lesson": "Lesson",
    "teacher.head.state": "Now",
    "teacher.head.frozen": "Now: the class is frozen",
    "teacher.above": "↑ {count} more",
    "teacher.below": "↓ {count} more",
    "teacher.state.gone": "away",
    "teacher.state.silent": "has not said anything yet",
    "teacher.state.hand_now": "hand up",
    "teacher.state.hand.short": "hand {minutes} min",
    "teacher.state.asked": "asked whether you may type",
    "teacher.state.may_type": "you may type: t",
    "teacher.state.idle.short": "idle {minutes} min",
    "teacher.state.hand": "hand up for {minutes} min",
    "teacher.state.frozen": "frozen",
    "teacher.state.idle": "no key for {minutes} min",
    "teacher.hints": "hints: {count}",
    "teacher.no_screen": "waiting for the screen",
    "teacher.missed": "not reached: {names}",
    "teacher.sent": "sent to {name}",
    "teacher.sent.all": "sent to {count}",
    "teacher.away": "{name} (away)",
    "teacher.alone": "nobody else is here",
    "teacher.no_room": "no room for a preview: F8 enlarges the window",
    "teacher.not_gone": "{name} is here: only who is gone can be removed",
    "teacher.say": "Say to {name}",
    "teacher.say.all": "Say to all",
    "teacher.say.nothing": "there is nothing to say",
    "teacher.open": "Open",
    "teacher.open.lesson": "lesson",
    "teacher.open.scene": "scene",
    "teacher.end": "End the desktop of {name}?",
    "teacher.end.text": "Programs there end; files stay.",
    "teacher.end.yes": "end it",
    "teacher.csv": "Write the report, and the log beside it, into",
    "teacher.csv.name": "name",
    "teacher.csv.lesson": "lesson",
    "teacher.csv.step": "step reached",
    "teacher.csv.steps": "steps",
    "teacher.csv.exists": "{file} is there already",
    "teacher.csv.written": "written: {files}",
    "help.classroom": (
        "The class that has joined this desktop over the network: who is at which step of which lesson, whose hand is up, whose "
        "last command failed and with which card, who has not touched a key for a while. Raised hands come first, then those "
        "with an error that stands for a minute, and last who has gone. The lower edge has the command by which others join; i "
        "shows it to be copied.\n\n"
        "Nobody is watched before you ask for it. Enter shows the screen of the chosen pupil, n and p the next and the previous "
        "one, c another one beside it; v shows the chosen one below the table. The pupil sees that you watch.\n\n"
        "t asks the pupil whether you may type. With the yes it begins by itself if you are still looking at that screen; else t "
        "again. From then on the keys go to the pupil's terminal until Ctrl-]. Only F1 to F9, Alt with digits and arrows, and "
        "Ctrl-Q stay your desktop's, as in every terminal. If the pupil takes it back, or is gone, keys do nothing until "
        "Ctrl-] or Esc.\n\n"
        "s says a sentence and o opens a lesson, a drill or a scene there; S and O do so for all. f freezes all screens, also of "
        "those who come later, until f again, at most ten minutes. x ends the desktop of the pupil, not yours. d removes the "
        "row of somebody who is gone.\n\n"
        "e writes how far everybody came, and beside it the log of the lesson; it overwrites nothing.\n\n"
        "In your terminals each pupil's graph is below the pupil's name: ros2 topic echo /anna/turtle1/pose."
    ),
    "manual.classroom": "Class",
    "help.classroom_pupil": (
        "A class: your teacher's desktop, or the teacher's page, knows of yours. The top line says so, and what the teacher "
        "does there.\n\n"
        "Raise your hand: click “raise hand” in the top line, or F7 and hand. Click again to lower it. The teacher can lower it "
        "too, and then has seen it.\n\n"
        "The teacher sees which lesson and step you are in, the names of your nodes, the card of your last error, and since "
        "when you have not touched a key. The teacher may say something (F7: what the teacher said), and open a lesson or a "
        "scene; what runs goes on.\n\n"
        "Your screen is seen only while the top line says “teacher watching”. Nothing changes for you.\n\n"
        "“Eyes to the front”: the teacher has frozen the screens of all. Your programs go on, nothing is lost, and it goes away "
        "by itself, after ten minutes at the latest.\n\n"
        "The teacher can type in your terminal only if you say yes. You can take that back at any time: click “teacher may "
        "type” in the top line, or F7 and teacher. What is typed goes to the terminal that has your keyboard.\n\n"
        "The teacher can end your desktop; your files stay.\n\n"
        "To join a class on a network: day6-tui class --join HOST --name NAME, in which the teacher's window tells HOST. "
        "Pupils see nothing of each other, unless it is a room (--room): then all are in one graph, and a scene runs below "
        "your name."
    ),
    "manual.classroom_pupil": "Class: hand, teacher",
    "class.says": "Your teacher",
    "class.opened": "Your teacher opened this lesson",
    "class.bar.unread": "new from the teacher: {count}",
    "class.bar.unread.short": "teacher: {count}",
    "class.bar.raise": "raise hand",
    "class.bar.raise.short": "hand",
    "class.bar.hand": "hand up",
    "class.bar.hand.short": "hand up",
    "class.bar.types": "teacher may type: click to end",
    "class.bar.types.short": "teacher types: end",
    "class.bar.watched": "teacher watching",
    "class.bar.watched.short": "watched",
    "class.bar.seen": "somebody watches",
    "class.bar.seen.short": "watched",
    "class.frozen.title": "Eyes to the front",
    "class.frozen.text": "Your teacher has stopped the keyboards for a moment.\nYour programs go on, and nothing is lost.",
    "class.frozen.keys": "it goes away by itself",
    "class.consent.title": "May your teacher type?",
    "class.consent.text": "Your teacher asks to type in your terminal.\n"
    "You can take it back at any time: click the words in the top line, or F7.",
    "class.consent.yes": "Yes",
    "class.consent.no": "No",
    "class.refused.busy": "a question is open on that screen",
    "class.refused.type": "the pupil has not agreed",
    "class.refused.no": "the pupil said no",
    "class.refused.taken_back": "the pupil has taken it back",
    "class.refused.full": "something is open on that desk",
    "class.refused.place": "the keyboard is in no terminal there",
    "class.refused.unknown": "it is not there",
    "serve.disk.say": "Your home folder holds {used} MB, and {most} MB are allowed. "
    "Remove what you do not need, or your desktop will be ended.",
    # notebook
    "notebook.here": "ROS 2 is here: import rclpy, and %ros2 topic list. Nodes go on after their cell.",
    "notebook.init_again": "ROS is initialised already, so this rclpy.init() does nothing. rclpy.shutdown() ends ROS.",
    "notebook.again": "{name}: the node made here before has been destroyed",
    "notebook.goes_on": "{name} goes on in the background; {end} ends it",
    "notebook.go_on": "{names} go on in the background; destroy_node() ends one of them, rclpy.shutdown() all",
    "notebook.failed": (
        "{name} is not spun any more after this error, as a program would have ended. "
        "Correct it, and run the cell again that makes the node."
    ),
    "notebook.ended": "{name} is not spun any more: a callback has called exit, which would have ended a program",
    "notebook.stuck": (
        "{name}: a callback has not returned for {seconds} s{where}. Until it does, no other callback of this node runs. "
        "destroy_node() ends it."
    ),
    "notebook.ros2.background": "goes on in the background until the kernel ends; {end} ends it now",
    # wheelhouse
    "cli.wheelhouse": "Put everything that installs day6-tui without internet into a folder, for a USB stick.",
    "wheelhouse.folder": "a new folder, an empty one, or one that this command has made",
    "wheelhouse.platform": (
        "for these machines, more than once for several: linux-x86_64, linux-aarch64 (Raspberry Pi OS, 64 bit), "
        "windows-x86_64, macos-arm64, macos-x86_64 (default: machines like this one)"
    ),
    "wheelhouse.python": "for this version of Python, more than once for several: 3.10 to 3.14 (default: this one)",
    "wheelhouse.no_platform": "no wheels are known for machines like this one; say for which with --platform",
    "wheelhouse.no_pip": "there is no pip here, which fetches the files ({command})",
    "wheelhouse.foreign": "{file} is not from an earlier run, or was changed since: choose another folder",
    "wheelhouse.failed": "nothing was written: {reason}",
    "wheelhouse.no_internet": "no internet: what is needed could not be fetched ({reason}), and nothing was written",
    "wheelhouse.done": "{count} wheels, {size} MB in {folder}",
    "wheelhouse.next": "how to install them is in {file}",
    "wheelhouse.guide.unix": "Linux, Raspberry Pi OS, macOS:",
    "wheelhouse.guide.windows": "Windows (PowerShell):",
    "wheelhouse.guide.other": "\nFor another version of Python that is named above write its number in place of {python}.\n",
    "wheelhouse.guide": """\
Installing day6-tui without internet
====================================

This folder is for

{targets}

and for no other machine or version of Python. linux-aarch64 is also Raspberry Pi OS with 64 bits. On Debian, Ubuntu and
Raspberry Pi OS the package python3-venv is needed, too. Copy this folder to the machine, open a terminal in it, and type:

1. Is it the right folder, and are all files whole?
{check}

2. Install.
{install}
{other}
3. Run.
{run}

For the teacher's machine, whose browsers' tabs are desktops (day6-tui serve), write "day6-tui[serve]" instead of day6-tui in 2.
""",
}
