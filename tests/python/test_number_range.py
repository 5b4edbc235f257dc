"""Numbers at the ends of the range for which pictures are made, and beyond it, through every door of the package."""

import numpy as np
import pytest

import fumon

SMALL = {"image_width": 16, "image_height": 16, "image_supersampling": 1}
BEYOND = [np.nextafter(1e6, np.inf), 1e300, -1.797e308]
GROUNDS = [{"look_ground": "endless"}, {"look_ground": "table"}, {"camera_projection": "orthographic"}, {"camera_projection": "map"}]


def bed(height=0.0):
    heights = np.zeros((6, 8))
    heights[2, 3] = height
    return heights


@pytest.mark.parametrize("look", GROUNDS, ids=lambda look: next(iter(look.values())))
def test_arrays_are_drawn_up_to_the_range_and_no_further(look):
    assert fumon.render(bed(1e6), 10, **look, **SMALL).shape == (16, 16, 3)
    for height in BEYOND:
        with pytest.raises(fumon.InputError, match=r"the height of cell \(3, 2\) is"):
            fumon.render(bed(height), 10, **look, **SMALL)
    with pytest.raises(ValueError, match="infinite"):
        fumon.render(bed(np.inf), 10, **look, **SMALL)
    with pytest.raises(fumon.InputError, match="a cell has 1e-06 to 1e"):
        fumon.render(bed(1.0), 1e-300, **look, **SMALL)


@pytest.mark.parametrize("height", BEYOND)
def test_measures_refuse_what_no_ground_has(height):
    with pytest.raises(fumon.InputError, match=r"the height of cell \(3, 2\) is"):
        fumon.measure(bed(height), 10)


def test_a_component_keeps_its_bed(tmp_path):
    file = tmp_path / "bed.toml"
    file.write_text('[model]\nname = "static"\n[grid]\nnx = 8\nny = 6\n')
    model = fumon.Bmi()
    model.initialize(file)
    name = "land_surface__elevation"
    before = model.get_value(name, np.empty(48))
    for height in [*BEYOND, np.inf, np.nan]:
        with pytest.raises(fumon.InputError):
            model.set_value(name, bed(height).ravel())
        assert np.array_equal(model.get_value(name, np.empty(48)), before)
