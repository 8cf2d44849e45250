"""The check of docstrings that the tests of a new package run."""
