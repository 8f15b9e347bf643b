"""The layered RGB scenes of addon.verify, as the tests use them."""

from addon.verify.layered_rgb_scenes import *  # noqa: F403
