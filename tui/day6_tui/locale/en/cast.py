"""Recordings."""

TEXTS = {
    "action.record": "Record the screen, or stop recording",
    "help.action.record": (
        "records everything on the screen to a file for asciinema or day6-tui cast; keys are not recorded"
    ),
    "record.running": "recording {time}",
    "record.file": "Record the screen to",
    "record.note": "The screen is recorded, but not your keys. F7 Record stops it. To play it: day6-tui cast FILE",
    "record.no_name": "it needs a file name",
    "record.not_here": "the screen cannot be recorded on this system",
    "record.broken": "Recording {file} has stopped: {reason}",
    "record.done": "recorded: {file}",
    "cast.keys": "space pause   + - speed   <- -> 5 s   . step   q quit",
    "cast.larger": "recorded at {columns}x{lines}",
    "cast.windows": "casts can only be played in a terminal on Linux and macOS; here, --svg turns them into pictures",
    "cast.no_terminal": "playing a cast needs a terminal; --at SECONDS prints its text, --svg FILE writes its picture",
    "cast.exists": "already exists; --force overwrites it",
    "cast.exists.record": "already exists; nothing is overwritten",
    "cast.no_folder": "no file can be created there",
    "cast.fault.large": "larger than {most} MB",
    "cast.fault.text": "not UTF-8 text",
    "cast.fault.head": "not an asciinema cast: its first line isn't a JSON object with a version",
    "cast.fault.version": "format version {version} is not supported; version 2 can be played",
    "cast.fault.size": "the screen size isn't a number of columns and rows from 1 to {most}",
    "cast.fault.long": "this line is too long",
    "cast.fault.json": "not valid JSON",
    "cast.fault.event": "not an event: [seconds, kind, text]",
    "cast.fault.time": "this time isn't a number of seconds, or is earlier than the line above",
}
