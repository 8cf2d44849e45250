"""The command line in English. The first line of a command's own text, `cli.<command>`, is its line in the list of commands."""

TEXTS = {
    # What every command has
    "cli.usage": "usage: ",
    "cli.arguments": "arguments",
    "cli.options": "options",
    "cli.verbs": "verbs",
    "cli.options.help": "show this help and exit",
    "cli.options.lang": "language, zh or en (default: DAY6_LANG, else the system's)",
    "cli.options.home": "the folder that is ~ (default: the desktop's)",
    "cli.options.force": "overwrite existing files",
    "cli.options.csv": "write a table for a spreadsheet",
    "cli.options.html": "write a web page",
    "cli.verb": "what to do; day6-tui {command} VERB --help says more",
    # What is wrong with a command line
    "cli.error": "{prog}: error: {problem}",
    "cli.error.argument": "argument {name}: {problem}",
    "cli.error.required": "the following arguments are required: {names}",
    "cli.error.one_of": "one of the arguments {names} is required",
    "cli.error.unrecognized": "unrecognized arguments: {words}",
    "cli.error.not_with": "not allowed with argument {other}",
    "cli.error.one_value": "expected one argument",
    "cli.error.at_most_one": "expected at most one argument",
    "cli.error.at_least_one": "expected at least one argument",
    "cli.error.count": "expected {count} arguments",
    "cli.error.no_value": "takes no value, but got {value}",
    "cli.error.choice": "invalid choice: {value} (choose from {choices})",
    "cli.error.kind": "invalid value: {value}",
    "cli.error.close": "{problem}; did you mean {name}?",
    "cli.error.needs": "needs {other}",
    "cli.error.command": "there is no command '{name}'; day6-tui --help lists them",
    "cli.error.command.close": "there is no command '{name}'; did you mean {close}?",
    "cli.error.command.behind": "the command {name} comes first, its options after it: day6-tui {name} …",
    # Values
    "cli.wrong.folder": "'{text}' isn't a folder",
    "cli.wrong.home": "'{text}' isn't a folder, and can't become one",
    "cli.wrong.file": "'{text}': {reason}",
    "cli.wrong.file.missing": "there is no file '{text}'",
    "cli.wrong.file.folder": "'{text}' is a folder; a file is needed",
    "cli.wrong.number": "'{text}' isn't a number from {least} to {most}",
    "cli.wrong.seconds": "'{text}' isn't a number of seconds",
    "cli.wrong.minutes": "'{text}' isn't a number of minutes",
    "cli.wrong.word": "'{text}' is too easy to guess; use at least {least} characters",
    "cli.wrong.address": "'{text}' isn't an address: http://…, https://… or /…",
    "cli.wrong.lesson": (
        "there is no lesson '{name}'; the lessons are {names} (day6-tui lessons list names the drills, too)"
    ),
    "cli.wrong.lesson.close": "there is no lesson '{name}'; did you mean {close}?",
    "cli.wrong.lesson.none": "there is no lesson '{name}', nor any other",
    # The list of commands
    "cli.group.desktop": "desktop and class",
    "cli.group.lessons": "lessons and homework",
    "cli.group.programs": "your programs, without the desktop",
    "cli.group.ros": "commands of ROS 2, as in a real one",
    "cli.group.own": "day6-tui itself",
    "cli.more": "day6-tui COMMAND --help says more about a command.",
    # The desktop
    "cli.desktop": "ROS 2 for people who have no ROS 2.\nWithout a command, opens the desktop.",
    "cli.desktop.scene": "what to start with (default: the choices of the welcome page)",
    "cli.desktop.robot": "your own URDF file instead of the car that comes with day6-tui",
    "cli.desktop.distro": "the ROS 2 distribution (default: ROS_DISTRO, else your last choice, else jazzy)",
    "cli.desktop.glyphs": "characters to draw pictures with; detected automatically, this overrides it",
    "cli.desktop.theme": "the colours (default: your last choice)",
    "cli.desktop.fps": "maximum frames per second (default: 30)",
    "cli.desktop.reduced_motion": "no pulses and no animation",
    "cli.desktop.home": "the folder that is ~ in the terminals",
    "cli.desktop.lesson": "open this lesson at once (day1 … day6, or the name of a drill)",
    "cli.desktop.lessons": "use the lessons in this folder (day6-tui lessons help explains how to write them)",
    "cli.desktop.record": "record the screen into a new file, for asciinema or day6-tui cast",
    "cli.desktop.detach": "keep the desktop running when this terminal closes; day6-tui attach returns to it",
    "cli.desktop.listen": (
        "let other machines in, e.g. tcp/0.0.0.0:7447; without --secret, anyone who reaches this port can read and command"
    ),
    "cli.desktop.connect": "join another machine, e.g. tcp/192.168.1.5:7447",
    "cli.desktop.secret": (
        "shared secret of the machines that --listen and --connect join: best a file that only you can read (chmod 600); "
        "a word can be seen by every user of this machine in the list of processes"
    ),
    "cli.desktop.version": "print the version and exit",
    "cli.no_terminal": "the desktop needs a terminal; day6-tui exec runs commands without one",
    "cli.textual": "Textual {version} is installed; this day6-tui needs {tested}: pip install 'textual=={tested}.*'",
    "cli.demo": "Play a whole lesson by itself; Space pauses.\nEverything is typed and explained.",
    "cli.demo.day": "a day from 1 to 6, or the name of a lesson or drill",
    "cli.attach": "Return to the desktop started with --detach.\nFrom any terminal on this machine.",
    "cli.attach.home": "the folder that is ~ on that desktop, if it was started with --home",
    # A class on a network
    "cli.class": (
        "A class on a network: a teacher's or a pupil's desktop.\n"
        "Each desktop keeps its own graph, and the teacher sees all of them."
    ),
    "cli.class.group": "class",
    "cli.class.teacher": (
        "this desktop is the teacher's, on port {port} (--listen for another); pupils don't see each other"
    ),
    "cli.class.room": "with --teacher: one graph for everyone, to play together",
    "cli.class.join": "join this teacher's class: HOST or HOST:PORT, e.g. 192.168.1.5; the default port is {port}",
    "cli.class.name": (
        "your name in the class: letters a-z, digits and single _, starting with a letter, e.g. wang_xiaoming"
    ),
    "cli.class.one": "choose --teacher, or --join HOST --name NAME",
    "cli.class.no_name": "--join needs --name NAME",
    "cli.class.name.letters": (
        "'{name}' can't be a name: a letter a-z first, then letters, digits and _, e.g. wang_xiaoming"
    ),
    "cli.class.name.double": "'{name}' can't be a name: no two _ in a row, as in ROS names",
    "cli.class.name.long": "'{name}' can't be a name: at most {most} characters",
    "cli.class.name.teacher": "'{name}' can't be a name: it is the teacher's",
    "cli.class.with_teacher": "{option} goes with --teacher",
    "cli.class.with_join": "{option} goes with --join",
    "cli.class.connect": "in a class, use --join HOST instead of --connect",
    "cli.class.endpoint": "'{text}' isn't a host name or address",
    "cli.class.port": "'{text}': {port} isn't a port; ports are 1 to 65535",
    # A class in browser tabs
    "cli.serve": (
        "A class in browser tabs: a desktop for each pupil.\n"
        "Each pupil gets a link, or chooses a name with the class word."
    ),
    "cli.serve.class": "the names of the class, one a line or in a column `name`; each gets a link",
    "cli.serve.new_links": "make new links for everyone; the old ones stop working",
    "cli.serve.word": "class word: whoever knows it chooses a name and gets a desktop",
    "cli.serve.data": "folder for the pupils' home folders and the server's records",
    "cli.serve.most": "maximum number of desktops at a time (default: 40)",
    "cli.serve.idle": "end a desktop after this many minutes without a key (default: 120; 0: never); files stay",
    "cli.serve.keep": "leave the desktops running when the server ends; the next server finds them",
    "cli.serve.isolation": "how to keep pupils apart (default: the best that this machine offers)",
    "cli.serve.memory": "memory limit of each pupil (default: 1024), where the isolation can enforce it",
    "cli.serve.disk": (
        "limit of each home folder (default: 512); above it the pupil is warned, at 1.5 times the desktop ends"
    ),
    "cli.serve.processes": (
        "limit of processes and threads of each pupil (default: 256), where the isolation can enforce it"
    ),
    "cli.serve.cpu_weight": (
        "share of the processors when everyone wants them (default: 100), where there are control groups"
    ),
    "cli.serve.trust": "let others in although pupils are not kept apart",
    "cli.serve.host": "address to listen on (default: 127.0.0.1, this machine only)",
    "cli.serve.port": "port to listen on (default: 8006; 0: any free port)",
    "cli.serve.cert": "certificate for https (PEM); add --key if the key is in another file",
    "cli.serve.key": "the certificate's private key (PEM)",
    "cli.serve.base_url": "address or path by which browsers reach the server behind a proxy",
    "cli.serve.unix": "listen on a Unix socket, for a proxy",
    "cli.serve.proxied": "whoever reaches the server is the user: one desktop, no link (for jupyter-server-proxy)",
    "cli.serve.home": "with --proxied: the folder that is ~ on the desktop",
    "cli.serve.not_with": "not allowed with --class or --word",
    # Installing without internet
    "cli.wheelhouse": (
        "Everything for an offline install, for a USB stick.\n"
        "It is put into a folder, with a file that explains how to install day6-tui from there."
    ),
    "cli.wheelhouse.folder": "a new folder, an empty one, or one that this command has made",
    "cli.wheelhouse.platform": (
        "kind of machine, may be repeated: linux-x86_64, linux-aarch64 (64-bit Raspberry Pi OS), "
        "windows-x86_64, macos-arm64, macos-x86_64 (default: like this one)"
    ),
    "cli.wheelhouse.python": "version of Python, may be repeated: 3.10 to 3.14 (default: this one)",
    # Lessons
    "cli.lessons": "Lesson files: list, write, check, preview and play them.",
    "cli.lessons.more": "day6-tui lessons help explains how to write lessons.",
    "cli.lessons.list": "list all lessons and drills",
    "cli.lessons.help": "explain how to write lessons",
    "cli.lessons.new": "write a small lesson that works",
    "cli.lessons.new.file": "the file to write; its name ends in .md",
    "cli.lessons.new.drill": "write a drill: a bug, its fix and three wrong answers",
    "cli.lessons.check": "name every mistake with its line",
    "cli.lessons.preview": "show how a lesson looks",
    "cli.lessons.play": "try out the solutions and the wrong answers on a separate machine",
    "cli.lessons.file": "a file, or a folder with lessons (*.md)",
    "cli.lessons.step": "only this step, after the solutions of the steps it needs",
    "cli.submit": "Pack your programs and answers for your teacher.\nThey become one file.",
    "cli.submit.lesson": "only the answers of this lesson (default: all)",
    "cli.submit.pupil": "whose work it is (needed if several pupils learn here)",
    "cli.submit.output": "the file to write (default: NAME.zip, here)",
    "cli.grade": (
        "Run submissions on hidden scenarios.\nNothing that the submissions (day6-tui submit) claim is believed."
    ),
    "cli.grade.files": "submissions, or folders of them (*.zip)",
    "cli.grade.lesson": "only the scenarios of this lesson (default: all)",
    "cli.grade.scenarios": "your own scenarios instead of those that come with day6-tui",
    "cli.grade.jobs": "how many submissions to grade at a time (default: as many as this machine can)",
    "cli.grade.seconds": "time limit of a submission in seconds (default: {seconds:g}; {twice:g} for several lessons)",
    "cli.grade.seed": "draw the same names and numbers as another run",
    "cli.report": "Show how far all pupils of this machine are.\nPrints a table, or writes CSV and HTML files.",
    "cli.report.lessons": "count the lessons of this folder",
    # Programs without the desktop
    "cli.exec": (
        "Run lines of the simulated terminal without a screen.\n"
        "Prints what the terminal would show, and exits with the last status."
    ),
    "cli.exec.commands": "the lines to run (default: those of FILE, else of standard input)",
    "cli.exec.file": "a file of lines",
    "cli.exec.arguments": "$1, $2 … in these lines",
    "cli.exec.timeout": "end everything after S seconds, with status {status}",
    "cli.exec.home.failed": "the home folder cannot be used: {reason}",
    "cli.shell": (
        "A real sub-shell with day6-tui's ros2 and python3.\ncolcon, rviz2 and the windows of rqt are there, too."
    ),
    "cli.shell.starts": "ros2 and python3 are day6-tui's in this shell ({name}); exit ends it.",
    "cli.env": 'Print variables for your shell, or set up an editor.\nFor the shell: eval "$(day6-tui env)"',
    "cli.env.vscode": "write .vscode/settings.json, .vscode/launch.json and .env",
    "cli.env.pycharm": "write source roots and variables into .idea",
    "cli.env.project": "the project's folder (default: this one)",
    "cli.env.stubs": "{count} packages of interfaces are in {folder}",
    "cli.env.not_understood": "{file} is not understood and was left as it is: {reason}",
    "cli.env.wrote": "wrote {file}",
    "cli.python": "Run a Python file unmodified as a ROS program.\nThat is python3 with rclpy on its path.",
    "cli.python.file": "the file to run, or any option of python3 (without one: python3 itself)",
    "cli.python.arguments": "arguments for the program",
    "cli.why": "Explain a message of ROS 2, Python, colcon or launch.\nA 2>&1 | day6-tui why explains what A said.",
    "cli.why.text": "the message, or a topic; without one, what is piped in",
    "cli.bag-csv": "Write the messages of a bag as tables for a spreadsheet.\nOne file for each topic, one row for each message.",
    "cli.bag-csv.bag": "the bag: its folder, or one file of it",
    "cli.bag-csv.topics": "topics (default: all)",
    "cli.bag-csv.output": "the folder for the tables (default: the bag's name with _csv, here)",
    "cli.bag-csv.force": "replace tables that were written before",
    "cli.bag-csv.done": "{file}: {topic}, {rows} rows, {columns} columns",
    "cli.bag-csv.missing": "there is no bag '{bag}'",
    "cli.bag-csv.unreadable": "'{bag}' can't be read: {reason}",
    "cli.bag-csv.reindex": "metadata.yaml is missing; this may make it again: {command}",
    "cli.bag-csv.no_topic": "there is no topic {topic} in '{bag}'; it has {topics}",
    "cli.bag-csv.empty": "'{bag}' has no topics",
    "cli.bag-csv.unknown_type": "{topic} is left out: its type {type} isn't known here; source the workspace that has it",
    "cli.bag-csv.cut": "{topic}: of {names} only the length is written, it is up to {most}",
    "cli.bag-csv.left_out": "{topic}: {count} messages don't fit their type and are left out",
    "cli.bag-csv.damaged": "'{bag}' is damaged, the tables end there: {reason}",
    "cli.bag-csv.exists": "'{file}' exists: --force replaces it, -o DIR chooses another folder",
    "cli.bag-csv.foreign": "'{file}' exists and isn't a table from a bag: it is left alone; choose another folder with -o",
    "cli.cast": "Play a recording of the screen, or draw it as SVG.\nAny asciinema cast will do.",
    "cli.cast.file": "a recording in asciinema's format, version 2",
    "cli.cast.svg": "write the picture at --at, or at the end, into this file",
    "cli.cast.at": "the time in seconds; without --svg, print the screen's text at that time",
    "cli.cast.frames": "write this many pictures from start to end, as one animated SVG (default: 1)",
    "cli.cast.force": "overwrite the SVG file if it exists",
    "cli.export": "Pack packages into a zip for a real ROS 2.\nThey build there unchanged.",
    "cli.export.packages": "names of packages (default: all)",
    "cli.export.workspace": "the workspace (default: the one you are in, or ros2_ws in this folder)",
    "cli.export.output": "the zip to write (default: the workspace's name, here)",
    "cli.export.home": "pack ros2_ws of the desktop with this home folder",
    "cli.export.force": "replace a zip that exists",
    "cli.export.nowhere": "{folder} isn't in a workspace: there is no package.xml, and no folder src with packages",
    "cli.export.go_there": "go to your workspace with cd, or name it: day6-tui export --workspace DIR",
    "cli.export.there_is": "for example: day6-tui export --workspace {workspace}",
    "cli.export.done": "{file}: {names} (from {workspace})",
    "cli.export.left_out": "left out: {what}",
    "cli.export.no_workspace": "there is no workspace {folder}",
    "cli.export.no_package": "no package '{name}' in {folder}",
    "cli.export.no_package.there": "no package '{name}' in {folder}; there are {names}",
    "cli.export.empty": "no package in {folder}",
    "cli.export.not_zip": "'{file}' exists and isn't a zip: it is left alone; choose another file with -o",
    "cli.export.exists": "'{file}' exists: --force replaces it, -o FILE chooses another file",
    "cli.export.inside": "'{file}' would be inside {folder}, which is packed: choose a place outside with -o",
    "cli.export.gone": "{file} is not a file any more",
    "cli.export.large": "{file} has {size} MB, at most {most} MB are packed: move it out of the package",
    "cli.export.encoding": "the name of {file} is not UTF-8: a zip cannot hold it",
    "cli.export.link": "{file} is a link to {target}, outside the package: replace it with a copy, or remove it",
    "cli.export.packed": "{file} leads to a folder that is packed already",
    "cli.export.broken": "{file} is a broken link",
    "cli.export.strange": "{file} is not a file",
    # Commands of ROS 2, whose own help is theirs
    "cli.ros2": "The ros2 command, on the graph of this machine.",
    "cli.colcon": "Build and test a workspace.",
    "cli.rviz2": "The robot in 3-D; the window takes this terminal.",
    "cli.rqt": "All windows of rqt.",
    "cli.rqt_bag": "Look into bags, record and play them.",
    "cli.rqt_graph": "Nodes and topics as a graph.",
    "cli.rqt_console": "The log messages of all nodes.",
    "cli.rqt_plot": "Values of topics as curves.",
    "cli.rqt_topic": "All topics with their messages.",
    "cli.check_urdf": "Check a robot description.",
    "cli.urdf_to_graphviz": "Draw the links and joints of a robot description.",
    "cli.xacro": "Expand a xacro file into URDF.",
    # day6-tui itself
    "cli.doctor": "Check this installation.\nPrints what a bug report needs: plain text without secrets, ready to paste.",
    "cli.uninstall": "List or remove what day6-tui has written.\nAlso says how to remove the package itself.",
    "cli.uninstall.data": "remove what belongs to day6-tui itself, after a question; your files stay",
    "cli.uninstall.files": "with --data: also remove your files, after another question: desktops, programs, progress, classes",
    "cli.uninstall.yes": "ask no questions",
    "cli.help": "Show the help of a command.",
    "cli.help.command": "the command, and its verb if it has some",
    "cli.completion": "Print a script for Tab completion in your shell.",
    "cli.completion.shell": "your shell",
    "cli.completion.more": """\
bash:        day6-tui completion bash >> ~/.bashrc
zsh:         day6-tui completion zsh >> ~/.zshrc
fish:        day6-tui completion fish >> ~/.config/fish/config.fish
PowerShell:  day6-tui completion powershell >> $PROFILE

In day6-tui shell, Tab completes day6-tui, ros2 and colcon without this.""",
}
