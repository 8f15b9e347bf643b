"""The published scale by nodes: four times as bright, where a closure's weight is held to 1."""

from ...operands import part

__all__ = ["in_scale"]


@part("In Scale")
def in_scale(builder, specular, published):
    """A closure in the scale that `published` says, 0 or 1: four equal closures are added up."""
    twice = builder.add_shaders(specular, specular)
    return builder.node("ShaderNodeMixShader", {
        "Fac": published, "Shader": specular, "Shader_001": builder.add_shaders(twice, twice)})
