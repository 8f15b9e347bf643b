"""What the materials look like: the shelves of the catalogue.  Read when Blender starts, so it loads nothing."""

__all__ = ["CATEGORIES"]

CATEGORIES = {
    "metal": "Bare metals", "precious": "Bare metals/Precious", "coating": "Coloured metals & coatings",
    "glass": "Glass & gems", "iridescent": "Iridescent", "liquid": "Liquids", "paint": "Paints & wraps",
    "fabric": "Paper & fabric", "plastic": "Plastics & rubber", "stone": "Stone, earth & oxides",
    "figure": "The papers' figures",
}
"""A category -> its place in the tree of catalogues, which Blender sorts by the alphabet; what people call it is what
stands after the last stroke.
"""
