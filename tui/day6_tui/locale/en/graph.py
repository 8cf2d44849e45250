"""rqt_graph."""

TEXTS = {
    "rqt.hidden": "{count} hidden: {reasons}",
    "rqt.hides": "{option} hides {names}",
    "rqt.hides_some": "{option} {count}",
    "rqt.separator": "; ",
    "rqt.nothing_hidden": "nothing is hidden",
    "rqt.empty": "No node is publishing or subscribing.",
    "rqt.shown_by": "{keys} shows what is hidden ({count})",
    "rqt.type": "type",
    "rqt.hide": "Hide",
    "rqt.refresh": "refresh",
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
    "rqt.filter_note": (
        "Names or regular expressions, separated by commas; a leading - excludes, / means all. Example: -/rqt.*"
    ),
    "rqt.save": "Save the graph as",
    "rqt.save_note": ".dot for Graphviz, .pdf, .svg or .png for a picture",
    "rqt.load": "Open a DOT file",
    "rqt.load_note": "Shown instead of the live graph until r refreshes.",
    "rqt.loaded": "from the file {name}; r shows the live graph",
    "rqt.node": "{name}: {arriving} arrows in, {leaving} out",
    "rqt.topic": "{name}: published by {arriving}, subscribed to by {leaving}",
    "help.rqt_graph": (
        "Which node talks to which. Round boxes (ellipses in the real rqt_graph) are nodes; arrows and square boxes are "
        "topics. A pulse runs along an arrow when messages pass. The line below says what the filters hide; if there is no "
        "room for the check boxes, it says which key shows the rest.\n\n"
        "If the window is too small for the picture, each arrow becomes a line: from the publishing node, over the topic, "
        "to the subscribing one.\n\n"
        "Drag or arrow keys: move. Wheel, + and -: zoom, from full names to an overview. v (Fit) fits the graph to the "
        "window and keeps it there until you move. An arrow with a number at an edge says how many boxes lie beyond it. A "
        "click, or j and k, chooses a box; the line below describes it."
    ),
}
