"""Students' programs and those of the real machine: processes on the streams of a session."""
