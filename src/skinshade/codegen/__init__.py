"""Build time only: from one Slang library and one set of parameters to every language's text.

Run ``make shaders`` after a change to ``shaders/skin`` or ``params``; a test proves that what is committed
is what it makes. Users never need it, nor the compiler.
"""
