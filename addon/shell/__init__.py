"""What stands behind the shell's door."""
