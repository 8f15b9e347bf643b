"""What was baked, for other programs: JSON, CSV, MaterialX, stand-ins.  numpy only."""

from importlib import import_module

__all__ = ["COLOUR_SPACES", "Standin", "curve_csv", "gltf", "json_text", "lost_in", "materialx", "materialx_of_standin",
           "openpbr", "plain", "preview_surface", "principled", "require_exact", "spectrum_csv", "write_bytes",
           "write_text"]

HOLDS = {
    "as_json": ("json_text",),
    "as_materialx": ("COLOUR_SPACES", "materialx", "materialx_of_standin", "require_exact"),
    "csv_text": ("curve_csv", "spectrum_csv"),
    "standin": ("Standin", "gltf", "lost_in", "openpbr", "plain", "preview_surface", "principled"),
    "writing": ("write_bytes", "write_text"),
}
"""Module -> what it holds, loaded with its first use: who writes a text waits for nothing else."""


def __getattr__(name):
    for place, held in HOLDS.items():
        if name in held:
            return getattr(import_module(f".{place}", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
