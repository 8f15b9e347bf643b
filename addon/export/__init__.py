"""What was baked, for other programs: JSON, CSV, MaterialX, stand-ins.  numpy only."""

from .csv_text import curve_csv, spectrum_csv
from .json_text import json_text
from .materialx import materialx
from .standin import Standin, gltf, openpbr, preview_surface, principled
from .writing import write_bytes, write_text

__all__ = ["Standin", "curve_csv", "gltf", "json_text", "materialx", "openpbr", "preview_surface", "principled",
           "spectrum_csv", "write_bytes", "write_text"]
