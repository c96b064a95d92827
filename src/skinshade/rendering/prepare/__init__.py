"""Data that both backends need: tables, vertex attributes, mips, ambient light and shadow maps."""
