"""The choices at the start, and the guide of an empty desk."""

TEXTS = {
    # welcome
    "welcome.title": "Welcome",
    "welcome.heading": "ROS 2, right here in your terminal",
    "welcome.question": "What would you like to do?",
    "welcome.lessons": "Lessons",
    "welcome.lessons.on": "go on: {title}",
    "welcome.lessons.more": "six days, and faults to find",
    "welcome.keys": "Choose with ↑ ↓ Enter or a number, or type a command",
    "welcome.truth": "The commands are typed for you, where you can see them. They are the real ones.",
    # guide
    "guide.title": "Desk",
    "guide.heading": "No window is open. A command opens one:",
    "guide.try": "Enter or a click types it into a terminal; you run it",
    "guide.ask": "Ask what is going on:",
    "guide.scene": "or watch it being done:",
    "help.guide": (
        "No window is open at present, so here are commands worth trying. Choose one with the arrow keys and Enter, or click it: "
        "it is typed into a terminal, and runs when you press Enter there.\n\n"
        "The last ones type all commands of a lesson for you, one after the other, as a teacher would."
    ),
    "help.welcome": (
        "Choose with the arrow keys and Enter, with a number, or with the mouse. The first choices type their commands into "
        "terminals, one after the other, as a teacher would.\n\nOr simply begin to type a command: it goes to a terminal."
    ),
}
