"""The Blender side: thin, one thing a file."""
