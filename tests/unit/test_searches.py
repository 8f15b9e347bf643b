"""What a person types, and what has to come first: the first ones as users tried them, the others chosen beforehand."""

import contextlib

import pytest

from addon.catalogue.entries import entries
from addon.catalogue.popup import labels
from addon.catalogue.presets import find
from addon.catalogue.search import look_up
from addon.errors import FacetFilmError

FIRST = {
    "gold": "gold", "silver": "silver", "steel": "stainless_steel", "stainless 304": "stainless_304",
    "aluminum": "aluminium", "chrome": "chromium", "Ti": "titanium", "copper": "copper", "brass": "brass",
    "mirror": "mirror", "glass": "window_glass", "window": "window_glass", "water": "water", "ice": "ice",
    "diamond": "diamond", "sapphire": "sapphire", "oil": "vegetable_oil", "plastic": "plastic_white",
    "rubber": "rubber", "tire": "rubber", "rust": "rust", "patina": "patina", "verdigris": "verdigris",
    "anodised titanium": "anodised_titanium", "anodized": "anodised_titanium", "heat tinted": "heat_tinted_steel",
    "blued steel": "heat_blued_steel", "brushed steel": "brushed_stainless", "rose gold": "rose_gold",
    "18k gold": "yellow_gold_18_carat", "white gold": "white_gold", "car paint": "car_paint_red",
    "pearl": "mother_of_pearl", "nacre": "nacre", "beetle": "beetle", "soap bubble": "soap_bubble",
    "oil slick": "petrol_on_water", "iridescent": "anodised_titanium", "carbon": "carbon", "obsidian": "obsidian",
    "金": "gold", "铜": "copper", "玻璃": "window_glass", "Kupfer": "copper", "Glas": "window_glass",
}
OF_OUR_OWN = {
    "sterling": "sterling_silver", "Edelstahl": "stainless_steel", "carbon fiber": "carbon_fibre",
    "gunmetal": "gunmetal", "honey": "honey", "red wine": "red_wine", "emerald": "emerald", "pewter": "pewter",
    "galvanized steel": "zinc", "gasoline": "petrol_on_water", "pvc": "vinyl", "brown bottle": "bottle_brown",
    "TiN": "titanium_nitride", "tin": "tin", "blue car paint": "car_paint_blue", "plexiglass": "acrylic",
    "rose qartz": "rose_quartz", "银": "silver", "Messing": "brass", "copper patina": "patina", "mercury": "mercury",
}


@pytest.mark.parametrize("typed, first", [*FIRST.items(), *OF_OUR_OWN.items()])
def test_what_a_person_means_comes_first(typed, first):
    found = look_up(typed)
    assert [one.id for one in found.materials][:1] == [first]
    assert bool(found.missing) == (typed == "rose qartz")


def test_the_name_that_is_searched_is_the_name_that_is_made():
    """Where a text is a material's name for scripts too, it is the same material's."""
    known = {}
    for typed, first in {**FIRST, **OF_OUR_OWN}.items():
        with contextlib.suppress(FacetFilmError):
            known[typed] = find(typed).name, first
    assert len(known) > 50 and all(made == first for made, first in known.values())


@pytest.mark.parametrize("typed, near", [
    ("adamantium", ()), ("gold leaf", ("gold",)), ("unobtainium steel", ("steel",))])
def test_what_is_not_there_is_said_with_the_nearest(typed, near):
    found = look_up(typed)
    assert found.missing == typed
    assert bool(found.materials) == bool(near)
    assert all(any(word in one.words for word in near) for one in found.materials)


BY_BLENDER_OTHERWISE = {"sapphire": "blue_sapphire", "TiN": "tin", "rose qartz": None}
"""Where Blender's ranking takes the shorter title, knows no capitals, and the stand-in below no misspelling."""


def words(text):
    """(word, part) of a text as Blender splits it; a new part begins behind each ▸."""
    return [(word, part) for part, words_of in enumerate(text.lower().split("▸"))
            for word in words_of.replace("-", " ").replace("_", " ").replace("/", " ").split()]


def as_blender_ranks(listed, typed):
    """The name of the first, as Blender's search is documented to rank; without its tolerance of misspelling."""
    found = []
    for name, text in listed:
        of_text = words(text)
        last, score, used = of_text[-1][1], 0, []
        for begun, _ in words(typed):
            fit = [(part != last, place) for place, (word, part) in enumerate(of_text)
                   if word.startswith(begun) and place not in used]
            if not fit:
                break
            score += 9 if min(fit)[0] else 10
            used.append(min(fit)[1])
        else:
            score -= sum(one > other for one, other in zip(used, used[1:]))
            letters = sum(len(word.encode()) for word, part in of_text if part == last)
            found.append((-score, letters, len(text.encode()), name))
    return min(found)[-1] if found else None


def test_what_a_person_means_comes_first_in_blenders_own_popup():
    listed = labels(entries().values())
    wanted = {**FIRST, **OF_OUR_OWN, **BY_BLENDER_OTHERWISE}
    assert {typed: as_blender_ranks(listed, typed) for typed in wanted} == wanted
    assert len(listed) < 1.3 * len(entries())  # few are listed twice
