"""What was baked, for other programs: JSON, CSV, MaterialX, settings of a Principled BSDF.  numpy only."""

from .csv_text import curve_csv, spectrum_csv
from .json_text import bake_json
from .materialx import materialx
from .principled import principled_settings
from .writing import write_text

__all__ = ["bake_json", "curve_csv", "materialx", "principled_settings", "spectrum_csv", "write_text"]
