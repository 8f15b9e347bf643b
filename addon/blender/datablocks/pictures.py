"""The images that groups of ours look colours up in: packed into the file, one a Picture, found again by its key."""

import json

import bpy

__all__ = ["image_in", "image_of", "key_of", "put_image", "sockets_of_image", "values_of_image"]

KEY, VALUES, SOCKETS = "facet_film_picture", "facet_film_values", "facet_film_sockets"


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
    """The image of ours that a node group shows, or None."""
    nodes = tree.nodes if tree is not None else ()
    return next((node.image for node in nodes if node.bl_idname == "ShaderNodeTexImage" and key_of(node.image)), None)


def put_image(tree, image):
    """Have all Image Texture nodes of a group show an image."""
    for node in tree.nodes:
        if node.bl_idname == "ShaderNodeTexImage":
            node.image = image


def key_of(image):
    """The key of an image of ours, or ""."""
    return image.get(KEY, "") if image is not None else ""


def values_of_image(image):
    """{name: text} that an image says of the material; {} for none."""
    return json.loads(image.get(VALUES, "{}")) if image is not None else {}


def sockets_of_image(image):
    """{socket: value} that the look-up in an image needs."""
    return json.loads(image.get(SOCKETS, "{}")) if image is not None else {}
