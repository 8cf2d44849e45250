"""Panes, their places, and the session that is opened again."""

TEXTS = {
    "help.panes": (
        "Alt+←↑↓→\tthe pane on that side\nAlt+1 … 9\tthe pane with that number\nShift+Alt+←\tand ↑ ↓ →: move the "
        "border\nMouse\tdrag borders and titles; double-click a title to enlarge"
    ),
    "help.option": (
        "Option\tAlt on other keyboards: goes to panes and splits them as soon as the terminal sends it (Terminal: Settings, "
        "Profiles, Keyboard, Use Option as Meta key). F4 and F7 do the same"
    ),
    "drop.told": "{name}: drop it {where}",
    "drop.left": "to the left of {name}",
    "drop.right": "to the right of {name}",
    "drop.above": "above {name}",
    "drop.below": "below {name}",
    "drop.tab": "behind {name}, as a tab",
    "layout.name": "A name for this layout",
    "layout.no_name": "It needs a name",
    "layout.saved": "Layout saved as {name}",
    "layout.own": "saved",
    "layout.foreign": "not a layout file of version {version}",
    "layout.unreadable": "{file}: {reason}",
    "session.title": "Continue from last time",
    "session.ask": "These were running when you left. Start them again?\n\n{what}",
    "session.back": "Not now",
    "session.start": "Start again",
    "session.restored": "from {when}",
    "session.not_kept": "layout and terminals can't be saved: {reason}",
    "session.foreign": "not a session of this version; left unchanged",
}
