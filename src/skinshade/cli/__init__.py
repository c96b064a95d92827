"""Command line: one file per command. `main` is the program ``skinshade``."""

__all__ = ["main"]


def main() -> None:
    """Run the program.

    Exit codes: 0 success, 2 faulty input or request, 1 any other error, and 128 + its number after a signal.
    """
    try:  # the imports are inside, because an interruption of them must not print a traceback
        from . import signals, terminal

        try:
            terminal.prepare_streams()
            signals.handle()
            from .app import run

            run()
        finally:
            signals.exit_at_next()
    except KeyboardInterrupt:  # before `handle`, or within the `finally` clause
        from . import signals

        signals.exit_interrupted()
