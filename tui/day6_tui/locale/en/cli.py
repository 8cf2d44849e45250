"""The command line, and a desktop that outlives its terminal."""

TEXTS = {
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
}
