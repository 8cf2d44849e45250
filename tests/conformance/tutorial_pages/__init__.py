"""Plays the pages of the official tutorials: `python tests/conformance/tutorial_pages --help`."""
