"""The simulated machine's terminals as panes: what they show, search and send."""
