"""What sorts of presets there are.  Read when Blender starts, so it loads nothing."""

__all__ = ["KINDS"]

KINDS = {
    "metal": "Metals", "alloy": "Alloys", "conductor": "Other Conductors", "semiconductor": "Semiconductors",
    "oxide": "Oxides", "sulphide": "Sulphides", "mineral": "Minerals and Ceramics", "crystal": "Crystals and Gems",
    "glass": "Glasses", "liquid": "Liquids", "polymer": "Polymers", "surface": "Measured Surfaces",
    "look": "Layered Films",
    "iridescent": "Iridescent", "figure": "The Papers' Figures",
}
"""What sorts of presets there are, in the order in which lists show them -> what people call them."""
