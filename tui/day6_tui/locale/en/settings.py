"""Settings."""

TEXTS = {
    "theme.title": "Theme",
    "theme.dark": "Dark",
    "theme.light": "Light",
    "theme.contrast": "High contrast",
    "theme.colourblind": "Safe for colour-blind eyes",
    "settings.fault": "{path} cannot be read and is left as it is: {reason}",
    "settings.not_kept": "The choice holds until the end only: {reason}",
    "distro.title": "Distribution of ROS 2",
    "distro.next_start": "{name} from the next start of day6-tui on (day6-tui --distro {name})",
}
