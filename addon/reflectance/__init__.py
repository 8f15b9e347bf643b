"""The physics: Fresnel, slope distributions, masking and the two reflectance models, as formulas."""
