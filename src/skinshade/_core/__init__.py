"""What every layer stands on: errors, units, array checks, files, progress."""
