"""The asset library, and small pictures of presets."""
