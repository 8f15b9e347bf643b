"""Node groups built from Python: a small builder, and one file a group."""
