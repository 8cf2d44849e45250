"""The kitchen."""

TEXTS = {
    "action.kitchen": "Kitchen: the graph as cooks, belts and dishes",
    "help.action.kitchen": "shows the live graph as a kitchen where dishes move when messages pass; again closes it",
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
    "kitchen.leave": "deselect",
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
    "kitchen.note.left": "{note}: {count} left",
    "kitchen.more_cooks": "+{count} cooks",
    "kitchen.more_belts": "+{count} belts",
    "kitchen.cook": "{name} is a cook.",
    "kitchen.cook.gives": "Puts dishes on {belts}.",
    "kitchen.cook.takes": "Takes dishes from {belts}.",
    "kitchen.cook.idle": "Not at any of the belts shown.",
    "kitchen.cook.twins": "{count} cooks have this name, so nobody can tell them apart!",
    "kitchen.cook.ros": "ROS: node {name}, publishes {gives} of these topics, subscribes to {takes}.",
    "kitchen.belt.moves": "The belt {belt} carries {shape} from {givers} to {takers}.",
    "kitchen.belt.unheard": "{givers} puts {shape} on the belt {belt}, but nobody takes it: dishes pile up at the end.",
    "kitchen.belt.unfilled": "{takers} waits at the belt {belt} for {shape}, but nobody puts any on it.",
    "kitchen.belt.type": "{giver} puts {shape} on the belt {belt}, but the hatch of {taker} only fits {wanted}: nothing gets in.",
    "kitchen.belt.qos": (
        "{giver} puts {shape} on the belt {belt}, but {taker} only takes dishes on other terms and gets none."
    ),
    "kitchen.belt.ros": "ROS: topic {belt}, type {type}; publishers: {givers}; subscribers: {takers}.",
    "kitchen.belt.type.ros": (
        "ROS: on {belt}, {giver} publishes {sent} and {taker} subscribes to {detail}: not the same type."
    ),
    "kitchen.belt.qos.ros": "ROS: on {belt}, the QoS of {giver} does not satisfy {taker}: {detail}.",
    "kitchen.belt.rate": "{rate} messages a second, measured.",
    "kitchen.belt.still": "No messages are passing right now.",
    "kitchen.belt.unknown": "The messages cannot be counted from here.",
    "help.kitchen": (
        "The live graph as a kitchen. Cooks are nodes, belts are topics, dishes are messages. A dish looks like its "
        "message type: the same type means the same shape, letter and colour. If a cook's hatch has another shape, nothing "
        "gets through, and the belt is marked.\n\n"
        "Shapes: ( ) a plate of commands (Twist); { } a bowl of words (String); [ ] a box of numbers (Int32, Float64); < > "
        "a cover over a place (Pose, TFMessage); # # a frame around a picture (Image, Color); \\ / a cup of measurements "
        "(JointState, LaserScan); = = a parcel, everything else.\n\n"
        "A dish moves when a message has really passed. If many pass, only some are drawn; the number beside the type is "
        "the measured rate. ?/s means that they cannot be counted from here. Dishes that nobody takes stay at the end of "
        "the belt; their number is counted from when you opened the kitchen.\n\n"
        "■ puts dishes on a belt, ► takes them, × cannot take them; a belt passes under the counters of all others. Dotted "
        "belts are empty: nobody puts anything on them.\n\n"
        "/rosout, /parameter_events and hidden nodes are left out; h shows them. Click a cook or a belt for an "
        "explanation. The kitchen itself subscribes to nothing and isn't in the picture."
    ),
}
