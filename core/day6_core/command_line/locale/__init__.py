"""The texts of the command line: a module for each language, with the same keys."""
