"""The tool that models the built-in head."""
