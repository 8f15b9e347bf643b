"""What Blender's exporters are told of materials of ours, each by the hook that it has."""
