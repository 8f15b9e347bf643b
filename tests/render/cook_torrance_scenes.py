"""The Cook-Torrance scenes of addon.verify, as the tests use them."""

from addon.verify.cook_torrance_scenes import *  # noqa: F403
