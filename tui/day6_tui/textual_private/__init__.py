"""What relies on Textual's private names: nothing else of day6-tui touches them (`tests/tui/test_textual_private.py`)."""
