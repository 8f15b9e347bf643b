"""Which devices the verification switches on, and that the preferences are as they were afterwards."""

from types import SimpleNamespace

import pytest

from addon.errors import FacetFilmError
from addon.verify.devices import switched_on


def device(name, kind, use=False):
    return SimpleNamespace(name=name, type=kind, use=use)


class Preferences:
    """As Cycles has them: two cards by either way, and the processor."""

    def __init__(self):
        self.compute_device_type = "NONE"
        self.devices = [device("Card A", "CUDA"), device("Card B", "CUDA"), device("Card A", "OPTIX"),
                        device("Processor", "CPU", True)]

    def get_devices_for_type(self, kind):
        return [one for one in self.devices if one.type in (kind, "CPU")]


def test_a_way_to_the_gpu_is_switched_on_by_itself_and_off_again():
    preferences = Preferences()
    with switched_on("CUDA", preferences) as (cycles_device, name):
        assert (cycles_device, name) == ("GPU", "CUDA: Card A, Card B")
        assert [one.use for one in preferences.devices] == [True, True, False, False]
    assert preferences.compute_device_type == "NONE"
    assert [one.use for one in preferences.devices] == [False, False, False, True]


def test_gpu_takes_what_is_switched_on():
    preferences = Preferences()
    with pytest.raises(FacetFilmError, match="needs one switched on"), switched_on("GPU", preferences):
        pass
    preferences.compute_device_type, preferences.devices[2].use = "OPTIX", True
    with switched_on("GPU", preferences) as found:
        assert found == ("GPU", "OPTIX: Card A")


def test_what_is_not_there_is_said_and_changes_nothing():
    preferences = Preferences()
    with pytest.raises(FacetFilmError, match="device HIP: Blender finds none"), switched_on("HIP", preferences):
        pass
    assert preferences.compute_device_type == "NONE" and preferences.devices[3].use
