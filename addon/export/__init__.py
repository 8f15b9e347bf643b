"""What was baked, for other programs: JSON, CSV, MaterialX, settings of a Principled BSDF.  numpy only."""

from .csv_text import curve_csv, spectrum_csv
from .json_text import json_text
from .materialx import materialx
from .principled import principled_settings
from .writing import write_bytes, write_text

__all__ = ["curve_csv", "json_text", "materialx", "principled_settings", "spectrum_csv", "write_bytes",
           "write_text"]
