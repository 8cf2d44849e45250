"""Panes: how they stand, what frames them, how they are moved by keys and mouse, and what they draw with."""
