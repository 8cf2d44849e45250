"""One window on a real terminal."""

TEXTS = {
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
}
