"""Models as components of the Basic Model Interface: every function for every model, values set between steps, and a
model coupled with a diffusion in NumPy."""

import re
import shutil
import subprocess

import numpy as np
import pytest

import fumon

BED = "land_surface__elevation"
UPLIFT = "bedrock__uplift_rate"

SCENES = {
    "sand": '[model]\nname = "sand"\n[grid]\nnx = 24\nny = 16\n[run]\nsteps = 6\n',
    "sandpile": '[model]\nname = "sandpile"\n[grid]\nnx = 21\nny = 21\n[run]\nsteps = 6\n',
    "dunes": '[model]\nname = "dunes"\n[grid]\nnx = 24\nny = 16\ncell_size = 2\n[bed]\nkind = "noise"\nhigh = 4\n[run]\nsteps = 6\n',
    "gully": '[model]\nname = "gully"\n[grid]\nnx = 24\nny = 16\n[run]\nsteps = 6\n',
    "water": '[model]\nname = "water"\nrain = 30\n[grid]\nnx = 24\nny = 16\n[run]\nsteps = 6\n',
    "airflow": '[model]\nname = "airflow"\n[grid]\nnx = 32\nny = 1\n[run]\nsteps = 6\n',
    "static": '[model]\nname = "static"\n[grid]\nnx = 24\nny = 16\ncell_size = 2\n[bed]\nkind = "noise"\nhigh = 1\n[run]\nsteps = 6\n',
}
CHANGING = ["sand", "dunes", "gully", "water", "sandpile", "static"]  # whose bed can be set

# "1", or symbols that UDUNITS has, with whole powers.
_SYMBOL = "(m|mm|km|kg|s|min|h|d|yr|Pa|degree)(-?[0-9])?"
UNITS = re.compile(f"1|{_SYMBOL}( {_SYMBOL})*")

# Of the specification, in its order.
FUNCTIONS = """initialize update update_until finalize get_component_name get_input_item_count get_output_item_count
get_input_var_names get_output_var_names get_var_grid get_var_type get_var_units get_var_itemsize get_var_nbytes
get_var_location get_current_time get_start_time get_end_time get_time_units get_time_step get_value get_value_ptr
get_value_at_indices set_value set_value_at_indices get_grid_rank get_grid_size get_grid_type get_grid_shape
get_grid_spacing get_grid_origin get_grid_x get_grid_y get_grid_z get_grid_node_count get_grid_edge_count
get_grid_face_count get_grid_edge_nodes get_grid_face_edges get_grid_face_nodes get_grid_nodes_per_face""".split()


@pytest.fixture
def component(tmp_path):
    def make(model):
        file = tmp_path / f"{model}.toml"
        file.write_text(SCENES[model])
        one = fumon.Bmi()
        one.initialize(file)
        return one

    return make


def value(model, name=BED):
    return model.get_value(name, np.empty(model.get_var_nbytes(name) // 8))


def test_it_has_every_function_of_the_specification():
    assert [name for name in FUNCTIONS if not callable(getattr(fumon.Bmi, name, None))] == []
    bmipy = pytest.importorskip("bmipy")
    assert set(bmipy.Bmi.__abstractmethods__) <= set(FUNCTIONS)


@pytest.mark.parametrize("name", SCENES)
def test_every_model_answers(component, name):
    model = component(name)
    assert model.get_component_name() == f"fumon {name}"
    inputs, outputs = model.get_input_var_names(), model.get_output_var_names()
    assert len(inputs) == model.get_input_item_count() and len(outputs) == model.get_output_item_count()
    assert BED in outputs and (BED in inputs) == (name in CHANGING)
    for variable in {*inputs, *outputs}:
        grid = model.get_var_grid(variable)
        size = model.get_grid_size(grid)
        assert model.get_var_nbytes(variable) == 8 * size == model.get_var_itemsize(variable) * size
        assert model.get_var_units(variable) and model.get_var_type(variable) == "float64"
        assert model.get_var_location(variable) == "node"
        assert np.array_equal(model.get_value_ptr(variable), value(model, variable))
        assert model.get_value_at_indices(variable, np.empty(1), [size - 1])[0] == value(model, variable)[-1]
    rows, columns = model.get_grid_shape(0, np.empty(2, int))
    assert rows * columns == model.get_grid_size(0) == model.get_grid_node_count(0)
    assert (model.get_grid_rank(0), model.get_grid_type(0)) == (2, "uniform_rectilinear")
    assert (model.get_grid_rank(1), model.get_grid_type(1), model.get_grid_size(1)) == (0, "scalar", 1)
    dy, dx = model.get_grid_spacing(0, np.empty(2))
    y, x = model.get_grid_origin(0, np.empty(2))
    assert np.allclose(model.get_grid_x(0, np.empty(columns)), x + dx * np.arange(columns))
    assert np.allclose(model.get_grid_y(0, np.empty(rows)), y + dy * np.arange(rows))
    faces, edges = model.get_grid_face_count(0), model.get_grid_edge_count(0)
    assert faces == (rows - 1) * (columns - 1)
    ends = model.get_grid_edge_nodes(0, np.empty(2 * edges, int)).reshape(-1, 2)
    assert set(np.diff(ends)[:, 0]) <= {1, columns}
    corners = model.get_grid_face_nodes(0, np.empty(4 * faces, int)).reshape(-1, 4)
    around = model.get_grid_face_edges(0, np.empty(4 * faces, int)).reshape(-1, 4)
    for nodes, sides in zip(corners, around):  # each side joins two corners that follow each other
        for k in range(4):
            assert set(ends[sides[k]]) == {nodes[k], nodes[(k + 1) % 4]}
    assert np.all(model.get_grid_nodes_per_face(0, np.empty(faces, int)) == 4)
    assert model.get_start_time() == model.get_current_time() == 0
    step = model.get_time_step()
    model.update()
    assert model.get_current_time() == step > 0 and model.get_time_units() in ("1", "s", "yr")
    model.update_until(3 * step)
    assert model.get_current_time() == pytest.approx(3 * step)
    assert model.get_end_time() == pytest.approx(6 * step)
    model.finalize()
    with pytest.raises(fumon.InputError, match="not initialised"):
        model.update()


@pytest.mark.parametrize("name", SCENES)
def test_it_keeps_the_rules_of_bmi_tester(component, name):
    """What the tester of CSDMS asks of a component, in its words; each variable and grid."""
    model = component(name)
    start, end, now, step = model.get_start_time(), model.get_end_time(), model.get_current_time(), model.get_time_step()
    assert all(type(value) is float for value in (start, end, now, step))
    assert start == 0.0 and step > 0 and start <= now <= end
    assert model.get_time_units() in ("1", "s", "yr")
    inputs, outputs = model.get_input_var_names(), model.get_output_var_names()
    assert isinstance(inputs, tuple) and isinstance(outputs, tuple)
    for variable in {*inputs, *outputs}:
        size = model.get_grid_size(model.get_var_grid(variable))
        dtype = np.dtype(model.get_var_type(variable))
        assert model.get_var_itemsize(variable) == dtype.itemsize
        assert model.get_var_nbytes(variable) == dtype.itemsize * size
        assert model.get_var_location(variable) in ("node", "edge", "face", "none")
        assert UNITS.fullmatch(model.get_var_units(variable)), (variable, model.get_var_units(variable))
        dest = np.full(size, np.nan)
        assert model.get_value(variable, dest) is dest and np.all(np.isfinite(dest))
        assert np.array_equal(model.get_value_ptr(variable), dest)
        if variable in inputs:  # what it is may be set
            model.set_value(variable, dest)
            assert np.array_equal(model.get_value_ptr(variable), dest)
            model.set_value_at_indices(variable, [0], dest[:1])
    for grid in (0, 1):
        rank = model.get_grid_rank(grid)
        assert type(rank) is int and type(model.get_grid_size(grid)) is int and model.get_grid_size(grid) > 0
        assert model.get_grid_type(grid) == {0: "scalar", 2: "uniform_rectilinear"}[rank]
        if rank:
            shape, spacing, origin = np.empty(rank, np.int32), np.empty(rank), np.full(rank, np.nan)
            assert model.get_grid_shape(grid, shape) is shape and np.all(shape > 0)
            assert model.get_grid_spacing(grid, spacing) is spacing and np.all(spacing > 0)
            assert model.get_grid_origin(grid, origin) is origin and np.all(np.isfinite(origin))
    model.update()
    assert model.get_current_time() == pytest.approx(step)
    model.finalize()


@pytest.mark.parametrize("name", SCENES)
def test_udunits_reads_every_unit(component, name):
    if not shutil.which("udunits2"):
        pytest.skip("udunits2 is not installed (udunits-bin)")
    model = component(name)
    units = {model.get_var_units(one) for one in {*model.get_input_var_names(), *model.get_output_var_names()}}
    for unit in {*units, model.get_time_units()}:
        told = subprocess.run(["udunits2", "-A", "-H", unit, "-W", unit], capture_output=True, text=True)
        assert "= 1" in told.stdout and not told.stderr, (unit, told.stderr)


@pytest.mark.parametrize("name", CHANGING)
def test_it_steps_as_a_run_does_and_a_bed_set_to_itself_changes_nothing(component, name):
    model = component(name)
    shown = model.get_value_ptr(BED)
    for _ in range(3):
        model.update()
        model.set_value(BED, value(model))
    run = fumon.Scene.from_toml(SCENES[name]).at(3)
    assert model.get_current_time() == run.time
    assert np.array_equal(shown, run.bed.ravel() * (run.height_unit or 1.0))
    for field, array in run.fields.items():
        own = next((one for one in model.get_output_var_names() if one.endswith(f"__{field}") or one == field), None)
        if own:
            assert np.array_equal(value(model, own), array.ravel()), field


def test_what_is_set_is_what_the_model_goes_on_with(component):
    model = component("water")
    rain = "atmosphere_water__rainfall_volume_flux"
    assert value(model, rain) == 30 and model.get_var_units(rain) == "mm h-1"
    model.update()
    depth = value(model, "land_surface_water__depth").sum()
    model.set_value(rain, [0.0])
    model.update()
    dry = value(model, "land_surface_water__depth").sum()
    model.set_value(rain, [3000.0])
    model.update()
    assert dry <= depth * 1.000001 and value(model, "land_surface_water__depth").sum() > 10 * dry
    with pytest.raises(fumon.InputError, match="model.rain"):
        model.set_value(rain, [-1.0])
    assert value(model, rain) == 3000.0

    dunes = component("dunes")
    flux = [name for name in dunes.get_input_var_names() if name in ("model.flux", "wind.0.strength")]
    assert "model.flux" in flux
    dunes.set_value("model.flux", value(dunes, "model.flux") * 2)
    dunes.update()


def test_uplift_raises_the_ground(component):
    model = component("static")
    before = value(model)
    rate = np.linspace(0.0, 2.0, before.size)
    model.set_value(UPLIFT, rate)
    for _ in range(4):
        model.update()
    assert np.allclose(value(model), before + 4 * rate, atol=1e-12)
    model.set_value(UPLIFT, 0 * rate)
    model.update()
    assert np.allclose(value(model), before + 4 * rate, atol=1e-12)


def test_a_single_cell_can_be_set(component):
    model = component("sand")
    before = value(model)
    model.set_value_at_indices(BED, [5, 7], [9.0, 8.0])
    after = value(model)
    assert after[5] == 9.0 and after[7] == 8.0
    assert np.array_equal(np.delete(after, [5, 7]), np.delete(before, [5, 7]))


def diffused(heights, rate):
    """One explicit step of dz/dt = D ∇²z on a periodic grid; rate = D Δt / Δx²."""
    around = sum(np.roll(heights, way, axis) for way in (1, -1) for axis in (0, 1))
    return heights + rate * (around - 4 * heights)


def test_coupled_with_a_diffusion_in_numpy(component):
    # Alone, the diffusion of a wave decays as its eigenvalue says; over dunes sand stays as much as it was.
    bed = component("static")
    shape = bed.get_grid_shape(0, np.empty(2, int))
    wave = np.tile(np.cos(2 * np.pi * np.arange(shape[1]) / shape[1]), (shape[0], 1))
    bed.set_value(BED, wave)
    for _ in range(10):
        bed.update()
        bed.set_value(BED, diffused(value(bed).reshape(shape), 0.2))
    decay = 1 - 0.2 * (2 - 2 * np.cos(2 * np.pi / shape[1]))
    assert np.allclose(value(bed).reshape(shape), wave * decay**10, atol=1e-12)

    coupled, alone = component("sand"), component("sand")
    for _ in range(6):
        coupled.update()
        alone.update()
        coupled.set_value(BED, diffused(value(coupled).reshape(shape), 0.1))
    assert value(coupled).sum() == pytest.approx(value(alone).sum(), rel=1e-12)
    assert value(coupled).std() < 0.9 * value(alone).std()


def test_wrong_use_is_one_clear_exception(component):
    model = component("sand")
    with pytest.raises(fumon.InputError, match="did you mean|is one of|it has"):
        model.get_var_units("land_surface__elevatoin")
    with pytest.raises(fumon.InputError, match="has 384 values, not 3"):
        model.set_value(BED, [1.0, 2.0, 3.0])
    with pytest.raises(fumon.InputError, match="not finite"):
        model.set_value(BED, np.full(384, np.nan))
    with pytest.raises(fumon.InputError, match="has 384 values; index 384 is out of range"):
        model.set_value_at_indices(BED, [384], [1.0])
    with pytest.raises(fumon.InputError, match="there is no grid 7"):
        model.get_grid_size(7)
    with pytest.raises(fumon.InputError, match="scalar and has no shape"):
        model.get_grid_shape(1, np.empty(2, int))
    with pytest.raises(fumon.InputError, match="no z"):
        model.get_grid_z(0, np.empty(1))
    with pytest.raises(ValueError, match="cannot go back"):
        model.update()
        model.update_until(0.0)
    with pytest.raises(ValueError, match="read-only"):
        model.get_value_ptr(BED)[0] = 1.0
    air = component("airflow")
    with pytest.raises(fumon.InputError, match="cannot be set"):
        air.set_value(BED, value(air))
    with pytest.raises(fumon.InputError):
        fumon.Bmi().initialize("no-such-scene.toml")
