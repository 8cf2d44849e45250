"""A desktop that outlives its terminal."""

TEXTS = {
    "detached.asked": "detached: {command} comes back",
    "detached.taken": "detached, because another terminal was attached: {command} comes back",
    "detached.none": "no desktop runs that was started by {command}",
    "detached.runs": "the desktop runs already: {command} comes to it",
    "detached.started": "the desktop runs: {command} comes to it",
    "detached.lost": "the desktop's keeper has ended, and the desktop with it; what was typed and the layout are kept",
    "detached.inside": "this is a terminal of that desktop",
    "detached.no_terminal": "attach needs a terminal",
    "detached.windows": "--detach and attach need pseudo-terminals, which Windows does not have here",
}
