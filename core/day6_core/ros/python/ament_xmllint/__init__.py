"""The check of XML files that the tests of a package run."""
