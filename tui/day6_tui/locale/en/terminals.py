"""Terminals, and one window on a real terminal."""

TEXTS = {
    # one window on a real terminal
    "single.end": "End",
    "single.help": "Help",
    "single.log": "Log",
    "single.next": "Next",
    "single.no_log": "The program hasn't written anything yet.",
    "help.single.end": "ends the program",
    "help.single.help": "explains this window",
    "help.single.log": "shows what the program has written; it also appears in the terminal afterwards",
    "help.single.next": "goes to the program's next window, if it has more than one",
    "help.single.glyphs": "changes how pictures are drawn",
    "help.single.language": "changes the language: 中文",
    "help.single.suspend": "stops the program and returns to the shell; fg resumes it",
    # terminal
    "window.hidden": "{title} is open: {key} shows it",
    "terminal.stubborn": "It ignores Ctrl-C. Ctrl-\\ ends it; or Ctrl-Z, then: kill -9 %%",
    "glyphs.no_chinese": "Chinese needs a UTF-8 locale such as LANG=C.UTF-8, so this is in English",
    "input.gbk": "Your terminal sends GBK, not UTF-8: set it to UTF-8 (PuTTY: Window > Translation)",
    "input.not_utf8": "Your terminal sends bytes that are not UTF-8: set it to UTF-8",
    "pixels.slow": "Pixels are too slow over this connection: pictures are now drawn with characters",
    "pixels.missing": "Pictures of pixels need pillow, which isn't installed: pip install pillow",
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
    "terminal.copied": "Copied",
    "terminal.no_room": (
        "No new terminal: too many programs are running. End some of them (Ctrl-C, kill, or close their terminals)"
    ),
    "help.terminal": (
        "A terminal: type a command and press Enter.\n\n"
        "Tab completes what you have started to type, Up brings back earlier commands, Ctrl-R searches them. Ctrl-C ends "
        "the running program, Ctrl-D on an empty line ends the shell. Ctrl-Z and then bg let a program continue in the "
        "background; so does & at the end of a command.\n\n"
        "After an error, F1 (or why) says what it means, why it happened and what to type next. Clicking the message does "
        "the same, and so does F1 on a selection.\n\n"
        "Shift+PageUp, or the mouse wheel, scrolls back. Drag with the mouse to copy; Shift+Insert or the middle button "
        "pastes.\n\n"
        "~ is your home folder. Here it isn't /home/NAME: type cd, then pwd, to see where it is on the disk."
    ),
}
