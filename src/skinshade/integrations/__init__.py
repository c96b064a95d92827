"""Materials for pygfx and moderngl. Each module needs the library of the same name."""
