"""Fuzzer of all readers of skinshade: ``python -m fuzz --seconds 600 --seed 3``.

A case is one file: an honest one, changed by a few mutations. A child process reads it, and an oracle
judges the result. Nothing here is part of the package.
"""
