"""The simulator. Knows nothing of Textual: `tui` may import it, it imports neither `tui` nor `textual` nor `rich`."""
