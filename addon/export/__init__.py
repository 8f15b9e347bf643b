"""What was baked, for other programs: JSON, CSV, MaterialX, stand-ins.  numpy only."""

from .csv_text import curve_csv, spectrum_csv
from .json_text import json_text
from .materialx import COLOUR_SPACES, materialx, materialx_of_standin, require_exact
from .standin import Standin, gltf, lost_in, openpbr, plain, preview_surface, principled
from .writing import write_bytes, write_text

__all__ = ["COLOUR_SPACES", "Standin", "curve_csv", "gltf", "json_text", "lost_in", "materialx", "materialx_of_standin",
           "openpbr", "plain", "preview_surface", "principled", "require_exact", "spectrum_csv", "write_bytes",
           "write_text"]
