"""Any model of fumon as a component of the Basic Model Interface, version 2.0."""

from __future__ import annotations

import os
from typing import Literal, NoReturn, SupportsIndex, TypeVar

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Array, Numbers
from .images import PathLike

Dest = TypeVar("Dest", bound=Array)  #: the caller's own array, of any type that holds the values


class Bmi:
    """A model that another program starts, steps, asks and changes, by the functions of the Basic Model Interface 2.0
    (Hutton, Piper & Tucker 2020). It has what bmipy's abstract class asks for, and needs no bmipy.

        model = fumon.Bmi()
        model.initialize("dunes.toml")
        bed = model.get_value_ptr("land_surface__elevation")        # flat, row 0 southernmost
        while model.get_current_time() < model.get_end_time():
            model.update()

    Values are float64. ``get_…`` functions fill the array that they are given and return it. What a model computes
    and takes: ``get_output_var_names()``, ``get_input_var_names()``. A change builds the model anew around its state,
    which costs about what starting it costs; a value that the model cannot take raises InputError and changes nothing.
    """

    def __init__(self) -> None:
        self._core = _core.Component()

    def __reduce_ex__(self, protocol: SupportsIndex) -> NoReturn:
        raise TypeError("a model under way belongs to its process; initialize another where it is needed")

    def initialize(self, config_file: PathLike) -> None:
        """Reads a scene's file, or one that fumon ships by its name, and makes its model ready."""
        self._core.initialize(os.fspath(config_file))

    def update(self) -> None:
        """One step of the model."""
        self._core.update()

    def update_until(self, time: float) -> None:
        """Steps to the step whose end is nearest to a time: models take whole steps. Ctrl-C stops between two."""
        now = self._core.current_time()
        if time < now:
            raise ValueError(f"the model is already at {now} and cannot go back to {time}")
        step = self._core.time_step()
        if not step > 0.0:
            raise ValueError("the model's time stands still; use update")
        while self._core.current_time() + 0.5 * step <= time:
            before = self._core.current_time()
            self._core.update()
            step = self._core.current_time() - before

    def finalize(self) -> None:
        """Lets the model go. Arrays of get_value_ptr keep what they show until then only."""
        self._core.finalize()

    def get_component_name(self) -> str:
        """"fumon" and the model's name."""
        return self._core.component_name()

    def get_input_item_count(self) -> int:
        """How many variables can be set."""
        return len(self._core.input_names())

    def get_output_item_count(self) -> int:
        """How many variables the model computes."""
        return len(self._core.output_names())

    def get_input_var_names(self) -> tuple[str, ...]:
        """What can be set: the bed and its uplift, and the numbers of the scene's [model] and [wind]."""
        return tuple(self._core.input_names())

    def get_output_var_names(self) -> tuple[str, ...]:
        """What the model computes: the bed, and its fields."""
        return tuple(self._core.output_names())

    def get_var_grid(self, name: str) -> int:
        """0: one value a cell; 1: one value. InputError, as from all that take a name, for one that there is not."""
        return self._core.var_grid(name)

    def get_var_type(self, name: str) -> Literal["float64"]:
        """NumPy's name of the type of its values."""
        self._core.var_grid(name)
        return "float64"

    def get_var_units(self, name: str) -> str:
        """As UDUNITS has them; "1" for a pure number, for sites, model heights and shares of them, and for what has
        no whole power (Manning's n). The guide's page on coupling tells what "1" means where."""
        return self._core.var_units(name)

    def get_var_itemsize(self, name: str) -> int:
        """Bytes of a value."""
        self._core.var_grid(name)
        return 8

    def get_var_nbytes(self, name: str) -> int:
        """Bytes of all its values."""
        return 8 * self._core.grid_size(self._core.var_grid(name))

    def get_var_location(self, name: str) -> Literal["node"]:
        """Values lie at nodes, which are the cells' centres."""
        self._core.var_grid(name)
        return "node"

    def get_current_time(self) -> float:
        """When the last step ended, in ``get_time_units()``."""
        return self._core.current_time()

    def get_start_time(self) -> float:
        """Zero."""
        return 0.0

    def get_end_time(self) -> float:
        """After the scene's run.steps; steps beyond it may be taken."""
        return self._core.end_time()

    def get_time_units(self) -> str:
        """"s", "yr", or "1" for a model that counts steps."""
        return self._core.time_units()

    def get_time_step(self) -> float:
        """What the next step takes, found by taking it on a copy of the model."""
        return self._core.time_step()

    def get_value(self, name: str, dest: Dest) -> Dest:
        """Copies a variable's values into ``dest``: flat, row 0 southernmost."""
        dest[:] = self._core.value(name)
        return dest

    def get_value_ptr(self, name: str) -> Numbers:
        """The component's own array, which follows the model and cannot be written to; set_value() does that."""
        return self._core.value_pointer(name)

    def get_value_at_indices(self, name: str, dest: Dest, inds: npt.ArrayLike) -> Dest:
        """Copies those at some places of the flat array into ``dest``."""
        dest[:] = self._core.value(name)[np.asarray(inds)]
        return dest

    def set_value(self, name: str, src: npt.ArrayLike) -> None:
        """Sets all values of a variable. InputError, and nothing changes, where one is not finite or the model cannot
        take it, or where there are too many or too few."""
        self._core.set(name, np.asarray(src, dtype=float).ravel())

    def set_value_at_indices(self, name: str, inds: npt.ArrayLike, src: npt.ArrayLike) -> None:
        """Sets those at some places of the flat array; errors as of set_value()."""
        self._core.set_at(name, np.asarray(inds, dtype=np.intc), np.asarray(src, dtype=float))

    def get_grid_rank(self, grid: int) -> int:
        """2, or 0 for the grid of one value. InputError, as from all that take a grid, for one that there is not."""
        return self._core.grid_rank(grid)

    def get_grid_size(self, grid: int) -> int:
        """How many values it has."""
        return self._core.grid_size(grid)

    def get_grid_type(self, grid: int) -> Literal["uniform_rectilinear", "scalar"]:
        """"uniform_rectilinear", or "scalar" for the grid of one value."""
        return self._core.grid_type(grid)

    def get_grid_shape(self, grid: int, shape: Dest) -> Dest:
        """(rows, columns)."""
        shape[:] = self._core.grid_shape(grid)
        return shape

    def get_grid_spacing(self, grid: int, spacing: Dest) -> Dest:
        """(northward, eastward), metres or sites."""
        spacing[:] = self._core.grid_spacing(grid)
        return spacing

    def get_grid_origin(self, grid: int, origin: Dest) -> Dest:
        """(northward, eastward) of the south-western cell's centre, from the bed's corner."""
        origin[:] = self._core.grid_origin(grid)
        return origin

    def get_grid_x(self, grid: int, x: Dest) -> Dest:
        """Of the columns' centres."""
        x[:] = self._core.grid_x(grid)
        return x

    def get_grid_y(self, grid: int, y: Dest) -> Dest:
        """Of the rows' centres."""
        y[:] = self._core.grid_y(grid)
        return y

    def get_grid_z(self, grid: int, z: Dest) -> Dest:
        """Raises InputError: the grid lies in the plane."""
        z[:] = self._core.grid_z(grid)
        return z

    def get_grid_node_count(self, grid: int) -> int:
        """How many cells' centres it has."""
        return self._core.grid_size(grid)

    def get_grid_edge_count(self, grid: int) -> int:
        """How many lines join neighbouring centres."""
        return self._core.grid_edge_count(grid)

    def get_grid_face_count(self, grid: int) -> int:
        """How many squares lie between four centres."""
        return self._core.grid_face_count(grid)

    def get_grid_edge_nodes(self, grid: int, edge_nodes: Dest) -> Dest:
        """Both ends of each edge: those along x row by row, then those along y."""
        edge_nodes[:] = self._core.grid_edge_nodes(grid)
        return edge_nodes

    def get_grid_face_edges(self, grid: int, face_edges: Dest) -> Dest:
        """The edges of each square between four centres, counterclockwise from the south."""
        face_edges[:] = self._core.grid_face_edges(grid)
        return face_edges

    def get_grid_face_nodes(self, grid: int, face_nodes: Dest) -> Dest:
        """Their corners, counterclockwise from the south-west."""
        face_nodes[:] = self._core.grid_face_nodes(grid)
        return face_nodes

    def get_grid_nodes_per_face(self, grid: int, nodes_per_face: Dest) -> Dest:
        """Four for each."""
        nodes_per_face[:] = self._core.grid_nodes_per_face(grid)
        return nodes_per_face
