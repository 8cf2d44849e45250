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
    "rqt.filter_note": "Names or regular expressions separated by commas; a leading - leaves out, / is all. Example: -/rqt.*",
    "rqt.save": "Save the graph as",
    "rqt.save_note": ".dot for Graphviz, .pdf, .svg or .png for a picture",
    "rqt.load": "Open a DOT file",
    "rqt.load_note": "It is shown instead of the live graph, until r refreshes.",
    "rqt.loaded": "from the file {name}; r shows the live graph",
    "rqt.node": "{name}: {arriving} arrows in, {leaving} out",
    "rqt.topic": "{name}: published by {arriving}, subscribed to by {leaving}",
    "help.rqt_graph": (
        "Which node talks to which. Round boxes (ellipses in the real rqt_graph) are nodes, arrows and square boxes are topics. "
        "A pulse runs along an arrow when messages pass. "
        "The line below says what the filters hide; where the check boxes have no room, which key shows it.\n\n"
        "A small window has no room for the picture: there each arrow is a line, from the node that publishes over the topic to "
        "the one that subscribes.\n\n"
        "Drag or arrow keys: move. Wheel, + and -: zoom, from names in full to an overview. v (Fit) fits it to the "
        "window again, and keeps to it until you move. An arrow with a number at an edge says how many boxes lie beyond it. "
        "A click, or j and k, chooses a box: the line below describes it."
    ),
}
