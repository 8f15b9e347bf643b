"""What the materials look like: the shelves of the catalogue.  Read when Blender starts, so it loads nothing."""

__all__ = ["CATEGORIES"]

CATEGORIES = {
    "metal": "Metals", "precious": "Precious Metals", "coating": "Coloured Metals & Coatings",
    "iridescent": "Iridescent", "glass": "Glass & Gems", "liquid": "Liquids", "plastic": "Plastics & Rubber",
    "paint": "Paints & Wraps", "fabric": "Paper & Fabric", "stone": "Stone, Earth & Oxides",
    "figure": "The Papers' Figures",
}
"""A category of the catalogue, in the order in which lists show them -> what people call it."""
