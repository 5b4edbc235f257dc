#!/usr/bin/env python3
"""One picture of a terrain by fumon and by F3D, from process start: CPU seconds (user and system), memory, and their ratio.

    tests/bench/peers/stills.py build/release/fumon
    tests/bench/peers/stills.py build/release/fumon --cells 1024 --f3d=--fxaa --f3d=--ssao

Both read the bed of vtk_frames.py and write 1920 x 1080 pixels: fumon a PNG of 16 bits, with shadow, sky and block,
supersampled; F3D a file of triangles with normals (VTK's own format, uncompressed, which it reads fastest), in one
colour, with no more than it is asked for. Programs take turns, and the least of their times counts. Needs F3D (Debian
package f3d) and what frames.py needs.
"""

import argparse
import pathlib
import tempfile

import vtk
from frames import in_turns, virtual_display
from vtk_frames import HEIGHT, WIDTH, Mesh, dune_field, write_bed


def write_triangles(cells, file):
    mesh = Mesh(cells)
    mesh.set_heights(dune_field(cells, 0.0))
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(mesh.data)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.SetCompressorTypeToNone()
    writer.Write()


def compare(fumon, cells, turns, f3d_options, work):
    write_bed(cells, work / "bed.png")
    write_triangles(cells, work / "bed.vtp")
    heights = f"{-0.005 * cells}:{0.045 * cells}"  # black and white of the bed's picture
    middle = 0.5 * cells
    eye = [-0.52 * cells, -0.96 * cells, 1.11 * cells]  # from 215 degrees, 32 above the horizon, as fumon's own
    commands = {
        "fumon": [fumon, "still", work / "bed.png", "--heights", heights, "-o", work / "fumon.png", "--force"],
        "F3D": ["f3d", work / "bed.vtp", "--dry-run", "--quiet", "--output", work / "f3d.png",
                f"--resolution={WIDTH},{HEIGHT}", "--up=+Z", "--color=0.80,0.62,0.38",
                "--camera-position=" + ",".join(map(str, eye)), f"--camera-focal-point={middle},{middle},0",
                "--camera-view-up=0,0,1", "--camera-view-angle=28", *f3d_options],
    }
    least = in_turns(commands, turns)
    for name, (seconds, megabytes) in least.items():
        ratio = "" if name == "F3D" else f"  {seconds / least['F3D'][0]:.2f} of F3D's"
        print(f"{cells:5}²  {name:8}  {seconds:6.2f} s  {megabytes:5.0f} MB{ratio}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fumon", type=pathlib.Path)
    parser.add_argument("--cells", type=int, action="append", help="along each side of the bed (512 and 1024)")
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--f3d", action="append", default=[], help="an option of F3D")
    parser.add_argument("--keep", type=pathlib.Path, help="folder where the pictures stay")
    arguments = parser.parse_args()
    with virtual_display(), tempfile.TemporaryDirectory() as work:
        folder = arguments.keep or pathlib.Path(work)
        folder.mkdir(parents=True, exist_ok=True)
        for cells in arguments.cells or [512, 1024]:
            compare(arguments.fumon.resolve(), cells, arguments.turns, arguments.f3d, folder)


if __name__ == "__main__":
    main()
