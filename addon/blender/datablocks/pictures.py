"""The images that groups of ours look colours up in: packed into the file, one a Picture, found again by its key."""

import json

import bpy

from .fingerprints import PART_KEY
from .locked import is_editable

__all__ = ["SHOWS", "image_in", "image_of", "key_of", "note_pictures", "put_image", "sockets_of_image",
           "values_of_image"]

KEY, VALUES, SOCKETS = "facet_film_picture", "facet_film_values", "facet_film_sockets"
SHOWS = "facet_film_shows"
"""What is kept in parts that show an image."""


def image_of(picture):
    """The image of a Picture, made where the file has none."""
    for image in bpy.data.images:
        if key_of(image) == picture.key and image.library is None:
            return image
    pixels, values, sockets = picture.make()
    return _new_image(picture, pixels, values, sockets)


def _new_image(picture, pixels, values, sockets):
    """Packed as a file in half precision, so that what is rendered now is what a file opened again renders."""
    from ...nodes.exr import exr_bytes  # which loads numpy, and enabling the extension does not wait for that
    data = exr_bytes(pixels)
    rows, columns = pixels.shape[:2]
    image = bpy.data.images.new(picture.name, columns, rows, alpha=False, float_buffer=True, is_data=True)
    image.colorspace_settings.is_data, image.alpha_mode = True, "NONE"  # whatever the configuration calls such data
    image.pack(data=data, data_len=len(data))
    image.source = "FILE"
    image[KEY], image[VALUES], image[SOCKETS] = picture.key, json.dumps(values), json.dumps(sockets)
    return image


def image_in(tree):
    """The image of ours that a node group shows, itself or in a part of it, or None."""
    return next((image for image in _images_in(tree) if key_of(image)), None)


def put_image(tree, image):
    """Have all Image Texture nodes of a group show an image.

    A part that shows an image is there once for each: where it has another one, the image's own takes its place.
    """
    for node in tree.nodes:
        if node.bl_idname == "ShaderNodeTexImage":
            node.image = image
        elif _shows_picture(node):
            part = node.node_tree
            shown = next(_images_in(part), None)
            if shown is None:
                put_image(part, image)
            elif shown != image:
                node.node_tree = _with_image(part, image)


def _images_in(tree):
    """Every image that a group's nodes show, and those of its parts."""
    for node in tree.nodes if tree is not None else ():
        if node.bl_idname == "ShaderNodeTexImage":
            if node.image is not None:
                yield node.image
        elif _shows_picture(node):
            yield from _images_in(node.node_tree)


def note_pictures(parts):
    """Note in the parts that show an image that they do, so that it is not looked for in others."""
    parts = list(parts)
    while True:
        found = [part for part in parts if SHOWS not in part and any(
            node.bl_idname == "ShaderNodeTexImage" or _shows_picture(node) for node in part.nodes)]
        if not found:
            return
        for part in found:
            part[SHOWS] = True


def _shows_picture(node):
    return node.bl_idname == "ShaderNodeGroup" and node.node_tree is not None and SHOWS in node.node_tree


def _with_image(part, image):
    """The part with another image: one that the file has, or a copy."""
    for tree in bpy.data.node_groups:
        if SHOWS in tree and tree.get(PART_KEY) == part[PART_KEY] and is_editable(tree) and image_in(tree) == image:
            return tree
    copy = part.copy()
    put_image(copy, image)
    return copy


def key_of(image):
    """The key of an image of ours, or ""."""
    return image.get(KEY, "") if image is not None else ""


def values_of_image(image):
    """{name: text} that an image says of the material; {} for none."""
    return json.loads(image.get(VALUES, "{}")) if image is not None else {}


def sockets_of_image(image):
    """{socket: value} that the look-up in an image needs."""
    return json.loads(image.get(SOCKETS, "{}")) if image is not None else {}
