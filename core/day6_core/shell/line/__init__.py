"""The line at the prompt: typing it as readline does, history, completion, the prompt itself."""
