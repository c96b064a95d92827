"""Generator of shaders in every language from the Slang library, and of documents from the sources.

Run ``make shaders`` after a change to ``shading/*.slang``, ``rendering/gpu/passes``, ``params``, the scene
schema or the imports. The generated files are committed, and a test proves that they are current: users
need neither this package nor the Slang compiler.
"""
