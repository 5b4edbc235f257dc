#!/usr/bin/env python3
"""Twenty frames of a changing bed by VTK, the peer of fumon's picture benchmark.

Draws N x N heights that change with every frame at 1920 x 1080, supersampled, as PNG of level 1, the way that costs VTK
least: one mesh whose points and normals are updated in place. One colour, no occlusion, and a shadow only if asked for.
Supersampled by VTK's own pass (vtkSSAAPass) or, cheaper than it, by a window of twice the size whose pixels NumPy averages.
Needs python3-vtk9 and python3-numpy, and a display, be it one by Xvfb (Debian's VTK has no other off-screen window).

    xvfb-run -a python3 vtk_frames.py 512 /tmp/frames

`--write-bed` writes the first bed as a PNG of 16 bits and draws nothing.
"""

import argparse
import pathlib

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

WIDTH, HEIGHT = 1920, 1080
RELIEF = 0.05  # black to white of a bed that is written, in sides of the bed


def dune_field(cells, shift):
    """Transverse dunes that carry ripples, moved downwind by `shift` wavelengths: as tests/support/dune_field.h."""
    x = np.arange(cells, dtype=np.float64)[None, :]
    u, v = x / cells, np.arange(cells, dtype=np.float64)[:, None] / cells
    bend = 0.5 * np.sin(5.0 * v + 2.0 * u) + 0.2 * np.sin(13.0 * v - 3.0 * u)
    share = np.mod(x / (cells / 7.0) + bend - shift, 1.0)
    stoss = np.abs(np.sin(1.5708 * np.minimum(share, 0.72) / 0.72)) ** 1.5
    dune = np.where(share < 0.72, stoss, 0.5 + 0.5 * np.cos(3.14159 * (share - 0.72) / 0.28))
    small = np.sin(6.28319 * (x / (cells / 85.0) + 0.8 * np.sin(9.0 * v + 4.0 * u)))
    return cells * (0.025 * dune * (1.0 + 0.4 * np.sin(7.0 * v)) + 0.0006 * small)


class Mesh:
    """Two triangles a cell; heights and normals are written into the arrays that VTK draws from."""

    def __init__(self, cells):
        self.points = np.zeros((cells, cells, 3), dtype=np.float32)
        self.points[..., 0] = np.arange(cells)[None, :]
        self.points[..., 1] = np.arange(cells)[:, None]
        self.normals = np.zeros((cells, cells, 3), dtype=np.float32)
        corner = (np.arange(cells - 1)[:, None] * cells + np.arange(cells - 1)[None, :]).ravel()
        triangles = np.empty((2 * corner.size, 3), dtype=np.int64)
        triangles[0::2] = np.stack([corner, corner + 1, corner + cells + 1], axis=1)
        triangles[1::2] = np.stack([corner, corner + cells + 1, corner + cells], axis=1)
        self.connectivity = triangles.ravel()
        offsets = np.arange(0, self.connectivity.size + 1, 3)
        faces = vtk.vtkCellArray()
        faces.SetData(numpy_to_vtkIdTypeArray(offsets, deep=1), numpy_to_vtkIdTypeArray(self.connectivity, deep=1))
        self.vtk_points = vtk.vtkPoints()
        self.vtk_points.SetData(numpy_to_vtk(self.points.reshape(-1, 3)))
        self.vtk_normals = numpy_to_vtk(self.normals.reshape(-1, 3))
        self.data = vtk.vtkPolyData()
        self.data.SetPoints(self.vtk_points)
        self.data.GetPointData().SetNormals(self.vtk_normals)
        self.data.SetPolys(faces)

    def set_heights(self, bed):
        bed = bed.astype(np.float32)
        self.points[..., 2] = bed
        slope_north, slope_east = np.gradient(bed)
        length = np.sqrt(1.0 + slope_east * slope_east + slope_north * slope_north)
        self.normals[..., 0] = -slope_east / length
        self.normals[..., 1] = -slope_north / length
        self.normals[..., 2] = 1.0 / length
        self.vtk_points.Modified()
        self.vtk_normals.Modified()
        self.data.Modified()


def make_window(mesh, cells, factor):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh.data)
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.80, 0.62, 0.38)
    actor.GetProperty().SetSpecular(0.0)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.93, 0.93, 0.95)
    renderer.AddActor(actor)
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    sun = vtk.vtkLight()
    middle = 0.5 * cells
    elevation, azimuth = np.radians(24.0), np.radians(300.0)
    towards = np.array([np.sin(azimuth) * np.cos(elevation), np.cos(azimuth) * np.cos(elevation), np.sin(elevation)])
    sun.SetFocalPoint(middle, middle, 0.0)
    sun.SetPosition(*(np.array([middle, middle, 0.0]) + 2.0 * cells * towards))
    renderer.AddLight(sun)
    camera = renderer.GetActiveCamera()  # as fumon's own: from 215 degrees, 32 above the horizon
    elevation, azimuth = np.radians(32.0), np.radians(215.0)
    towards = np.array([np.sin(azimuth) * np.cos(elevation), np.cos(azimuth) * np.cos(elevation), np.sin(elevation)])
    camera.SetFocalPoint(middle, middle, 0.0)
    camera.SetPosition(*(np.array([middle, middle, 0.0]) + 1.62 * cells * towards))
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(28.0)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(factor * WIDTH, factor * HEIGHT)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange(0, cells, 0, cells, -0.02 * cells, 0.08 * cells)
    return window, renderer, sun


def shadow_passes(sun):
    sun.PositionalOn()
    sun.SetConeAngle(25.0)
    baker = vtk.vtkShadowMapBakerPass()
    baker.SetResolution(2048)
    shadows = vtk.vtkShadowMapPass()
    shadows.SetShadowMapBakerPass(baker)
    passes = vtk.vtkRenderPassCollection()
    passes.AddItem(baker)
    passes.AddItem(shadows)
    sequence = vtk.vtkSequencePass()
    sequence.SetPasses(passes)
    return sequence


def set_passes(renderer, sun, samples, shadows):
    if not shadows and samples != "pass":
        return
    last = vtk.vtkRenderStepsPass()
    if shadows:
        last = vtk.vtkCameraPass()
        last.SetDelegatePass(shadow_passes(sun))
    if samples == "pass":
        supersampled = vtk.vtkSSAAPass()
        supersampled.SetDelegatePass(last)
        last = supersampled
    renderer.SetPass(last)


def averaged(pixels, factor):
    """The mean of each factor x factor pixels."""
    if factor == 1:
        return pixels
    height, width, channels = pixels.shape
    sums = pixels[0::2].astype(np.uint16)
    sums += pixels[1::2]
    sums = sums[:, 0::2] + sums[:, 1::2]
    return ((sums + 2) >> 2).astype(np.uint8)


def write_bed(cells, file):
    heights = dune_field(cells, 0.0) / (RELIEF * cells)
    levels = np.clip(np.rint(65535.0 * np.clip(heights + 0.1, 0.0, 1.0)), 0, 65535).astype(np.uint16)
    image = vtk.vtkImageData()
    image.SetDimensions(cells, cells, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(levels.ravel(), deep=1))
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(image)
    writer.Write()


def draw(arguments):
    factor = 2 if arguments.samples == "window" else 1
    folder = pathlib.Path(arguments.output)
    folder.mkdir(parents=True, exist_ok=True)
    mesh = Mesh(arguments.cells)
    mesh.set_heights(dune_field(arguments.cells, 0.0))
    window, renderer, sun = make_window(mesh, arguments.cells, factor)
    set_passes(renderer, sun, arguments.samples, arguments.shadows)
    raw = vtk.vtkUnsignedCharArray()
    picture = vtk.vtkImageData()
    picture.SetDimensions(WIDTH, HEIGHT, 1)
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(1)
    writer.SetInputData(picture)
    for frame in range(arguments.frames):
        mesh.set_heights(dune_field(arguments.cells, 0.02 * frame))
        window.Render()
        window.GetPixelData(0, 0, factor * WIDTH - 1, factor * HEIGHT - 1, 0, raw, 0)
        pixels = np.frombuffer(raw, dtype=np.uint8).reshape(factor * HEIGHT, factor * WIDTH, 3)
        small = np.ascontiguousarray(averaged(pixels, factor))
        picture.GetPointData().SetScalars(numpy_to_vtk(small.reshape(-1, 3)))
        picture.Modified()
        writer.SetFileName(str(folder / f"frame_{frame:04d}.png"))
        writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cells", type=int, help="N, cells along each side of the bed")
    parser.add_argument("output", help="folder of the frames, or file of the bed")
    parser.add_argument("--frames", type=int, default=20)
    parser.add_argument("--shadows", action="store_true", help="cast the sun's shadow, by a map of 2048 x 2048")
    parser.add_argument("--samples", choices=["pass", "window", "one"], default="pass", help="how it is supersampled")
    parser.add_argument("--write-bed", action="store_true", help="write the first bed instead")
    arguments = parser.parse_args()
    if arguments.write_bed:
        write_bed(arguments.cells, arguments.output)
    else:
        draw(arguments)


if __name__ == "__main__":
    main()
