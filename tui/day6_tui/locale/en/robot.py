"""The car from above, and the joint sliders."""

TEXTS = {
    # the car
    "car.zoom": "zoom",
    "car.letters": "ASCII",
    # joint sliders
    "sliders.waiting": "Waiting for a robot on /robot_description: is robot_state_publisher running?",
    "sliders.none": "This robot has no movable joints.",
    "sliders.conflict.short": "{nodes} sets joints too",
    "sliders.conflict": (
        "{nodes} publishes the same joints: the robot jitters between two commands. One of the two has to stop."
    ),
    "sliders.degrees": "degrees",
    "sliders.move": "move",
    "sliders.finest": "move as little as possible",
    "sliders.value": "number",
    "sliders.zero": "zero",
    "sliders.accept": "accept",
    "sliders.cancel": "cancel",
    "help.car": (
        "Your robot from above, drawn from its URDF. The wheels turn according to /joint_states and /tf: if nobody "
        "publishes, nothing turns. The car stays where it is in this picture; turning wheels move nothing, just as in "
        "RViz.\n\n"
        "+ and - zoom, the arrow keys move the picture, 0 shows everything, b draws it in plain ASCII."
    ),
    "help.joint_state_publisher": (
        "A slider for every movable joint. Your settings go to /joint_states ten times a second; robot_state_publisher "
        "turns them into the poses of the links.\n\n"
        "Up and down choose a joint, left and right move it, with Shift ten times as far, with Ctrl as little as possible; "
        "Home and End go to its limits, z to zero. To enter an exact number, type a digit, press Enter or click the "
        "number. r is Randomize, c is Center, d switches between radians and degrees. With the mouse: drag the knob.\n\n"
        "If another node publishes the same joints, the robot jitters: both send commands, and the last one counts."
    ),
}
