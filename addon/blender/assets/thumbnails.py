"""The small pictures of the presets, as icons of Blender's: shipped ones, or drawn where there is none."""

__all__ = ["clear", "colour_icon", "drawn_icon", "preset_icon", "strip_icon"]

_held = []


def preset_icon(name):
    """Icon number of a preset or dataset; 0, no picture, for an unknown name and where Blender has no window.

    A preset without a rendered thumbnail gets a ball drawn by addon.blender.assets.pictures.
    """
    from ...catalogue.entries import thumbnail
    file = thumbnail(name)
    if "/" not in name and file.exists():
        return _icon(f"preset {name}", None, file)
    from .pictures import ball
    return _icon(f"preset {name}", lambda: ball(name))


def colour_icon(rgb, space):
    """Icon number of one linear colour."""
    from .pictures import plain
    return _icon(f"colour {tuple(rgb)} {space}", lambda: plain(rgb, space))


def strip_icon(cos_theta, rgb, space):
    """Icon number of colours over the angle."""
    from .pictures import strip
    return _icon(f"strip {hash((tuple(cos_theta), tuple(map(tuple, rgb)), space))}",
                 lambda: strip(cos_theta, rgb, space))


def drawn_icon(key, draw):
    """Icon number of what draw() gives, ``(rows, columns, 4)`` as addon.blender.assets.pictures draws; drawn once."""
    return _icon(key, draw)


def clear():
    """Give all pictures back."""
    while _held:
        import bpy.utils.previews
        bpy.utils.previews.remove(_held.pop())


def _icon(key, draw, file=None):
    from ...errors import FacetFilmError
    if not _held:
        import bpy.utils.previews
        _held.append(bpy.utils.previews.new())
    if key in _held[0]:
        return _held[0][key].icon_id
    if file:
        return _held[0].load(key, str(file), "IMAGE").icon_id
    try:
        pixels = draw()
    except FacetFilmError:
        return 0
    image = _held[0].new(key)
    image.image_size = pixels.shape[:2]
    image.image_pixels_float.foreach_set(pixels.ravel())
    small = (pixels[::2, ::2] + pixels[1::2, ::2] + pixels[::2, 1::2] + pixels[1::2, 1::2]) / 4.0
    image.icon_size = small.shape[:2]
    image.icon_pixels_float.foreach_set(small.ravel())
    return image.icon_id
