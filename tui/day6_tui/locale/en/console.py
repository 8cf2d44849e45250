"""rqt_console."""

TEXTS = {
    "console.message": "Message",
    "console.severity": "Severity",
    "console.node": "Node",
    "console.stamp": "Stamp",
    "console.location": "Location",
    "console.none": "No log messages yet: they come from /rosout.",
    "console.filtered": "All messages are excluded; a shows them.",
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
    "console.text.note": "Takes effect as you type; an empty line turns it off.",
    "console.regexp": "Regex",
    "console.as_text": "plain text",
    "console.enabled": "Enabled",
    "console.remove": "Remove this filter",
    "console.start_ns": "From",
    "console.stop_ns": "Until",
    "console.no_end": "no end",
    "console.start_ns.note": "Like 14:05:01.250 or 2026-01-31 14:05.",
    "console.stop_ns.note": "Like 14:05:01.250 or 2026-01-31 14:05; leave it empty for no end.",
    "console.wrong_time": "Not a time, like 14:05:01.250.",
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
    "console.undone": "undone",
    "help.rqt_console": (
        "The log messages of all nodes, from the topic /rosout, newest last. Choose one with the arrow keys or a click: it "
        "is shown below the table, and Enter or a double click shows it in full. Esc follows the newest again. A click on "
        "a column's name sorts by it, a second click reverses the order; s and S do the same.\n\n"
        "/ excludes messages that contain a text, h highlights them: what you type takes effect at once, Tab makes it a "
        "regular expression, Enter keeps it, Esc undoes it. Capital letters, or a click on a box, exclude severities: D, "
        "I, W, E, F. n excludes the node of the chosen message, a shows everything again. f lists all filters, both "
        "excluding and highlighting, like the area below the table of the real window: Enter changes one, Del removes "
        "it.\n\n"
        "Space pauses: messages that arrive meanwhile are lost, as in the real one. c clears. w saves the messages shown "
        "to a file, o loads one; the real rqt_console reads and writes the same files.\n\n"
        "What a node doesn't log at all depends on its level: see --log-level and the logger services. The location is the "
        "file, function and line that logs: a full path for a Python node; for a C++ node, as in a binary installation, a "
        "path that starts at its package's folder. It is the location in the program that runs here, which isn't written "
        "in C++."
    ),
}
