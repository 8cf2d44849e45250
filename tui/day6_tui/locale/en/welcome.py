"""The choices at the start, and the guide of an empty desk."""

TEXTS = {
    # welcome
    "welcome.title": "Welcome",
    "welcome.heading": "ROS 2, right here in your terminal",
    "welcome.question": "What would you like to do?",
    "welcome.lessons": "Lessons",
    "welcome.lessons.on": "continue: {title}",
    "welcome.lessons.more": "six days of lessons, and bugs to find",
    "welcome.keys": "Choose with ↑ ↓ Enter or a number, or type a command",
    "welcome.truth": "The commands are typed for you, right in front of you, and they are the real ones.",
    # guide
    "guide.title": "Desk",
    "guide.heading": "No window is open. These commands open one:",
    "guide.try": "Enter or a click types it into a terminal; you run it",
    "guide.ask": "See what is going on:",
    "guide.scene": "or watch a demo:",
    "help.guide": (
        "No window is open, so here are some commands to try. Choose one with the arrow keys and Enter, or click it: it is "
        "typed into a terminal and runs when you press Enter there.\n\n"
        "The last ones type a whole lesson's commands for you, one after another, as a teacher would."
    ),
    "help.welcome": (
        "Choose with the arrow keys and Enter, with a number, or with the mouse. The first choices type their commands "
        "into terminals, one after another, as a teacher would.\n\n"
        "Or just start typing a command: it goes to a terminal."
    ),
}
