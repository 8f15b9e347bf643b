"""Writes datablocks into a .blend that is compressed as Blender compresses, but in larger frames and more patiently.

Pictures and node trees resemble each other, so the file is up to half as large.  Blender finds a frame by the table at
the end (Zstandard's seekable format) and unpacks no more than it reads.
"""

import struct
import tempfile
from pathlib import Path

__all__ = ["packed", "write"]

FRAME, LEVEL = 4 << 20, 19
"""Bytes of a frame before it is compressed, and how patiently it is."""
SKIPPED, SEEKABLE = 0x184D2A5E, 0x8F92EAB1
"""Numbers of Zstandard's format: of a frame that is no data, and of a table of frames."""


def write(file, datablocks, loosely=False):
    """Write datablocks and what they use, all with a user; loosely as Blender writes, which is read the soonest."""
    import bpy
    with tempfile.TemporaryDirectory() as scratch:
        loose = Path(scratch) / file.name
        bpy.data.libraries.write(str(loose), datablocks, fake_user=True)
        raw = loose.read_bytes()
        file.write_bytes(raw if loosely else packed(raw))


def packed(raw):
    """Bytes as frames with their table.

    >>> import zstandard
    >>> zstandard.ZstdDecompressor().stream_reader(packed(b"BLENDER"), read_across_frames=True).read()
    b'BLENDER'
    """
    import zstandard
    pieces = [raw[start:start + FRAME] for start in range(0, len(raw), FRAME)]
    frames = [zstandard.ZstdCompressor(level=LEVEL, write_content_size=True).compress(piece) for piece in pieces]
    table = b"".join(struct.pack("<II", len(frame), len(piece)) for frame, piece in zip(frames, pieces))
    table += struct.pack("<IBI", len(frames), 0, SEEKABLE)
    return b"".join((*frames, struct.pack("<II", SKIPPED, len(table)), table))
