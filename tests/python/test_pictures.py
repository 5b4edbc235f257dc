"""Pictures and movies: shown, saved, compared."""

import hashlib
import shutil
import struct
import subprocess

import numpy as np
import pytest
import xarray

import fumon
from test_terrain import HILLS, LOOK, array_with, X, Y

PICTURE = np.arange(40 * 64 * 3, dtype=np.uint8).reshape(40, 64, 3)


def test_a_picture_is_an_array_that_shows_itself(tmp_path):
    image = fumon.Image(PICTURE)
    assert np.array_equal(image, PICTURE) and image.dtype == np.uint8
    shown = image._repr_png_()
    assert shown.startswith(b"\x89PNG")
    image.save(tmp_path / "a.png")
    assert np.array_equal(fumon.Image.open(tmp_path / "a.png"), PICTURE)
    image[:10, ::2].save(tmp_path / "part.png")
    assert np.array_equal(fumon.Image.open(tmp_path / "part.png"), PICTURE[:10, ::2])
    assert image.mean(axis=2)._repr_png_() is None and float(image.mean()) == PICTURE.mean()
    with pytest.raises(ValueError, match="png"):
        image.save(tmp_path / "a.bmp")
    with pytest.raises(fumon.Error, match="nowhere"):
        image.save(tmp_path / "nowhere" / "a.png")
    with pytest.raises(fumon.InputError):
        fumon.Image.open(tmp_path / "missing.png")


def test_fingerprints_and_comparisons():
    found = fumon.fingerprint(PICTURE)
    assert (found["width"], found["height"]) == (64, 40) and found["thumbnail"].shape == (18, 32, 3)
    expected = hashlib.sha256(struct.pack("<II", 64, 40) + PICTURE.tobytes()).hexdigest()
    assert found["pixels_sha256"] == expected
    other = PICTURE.copy()
    other[5, 6, 0] ^= 1
    assert fumon.compare(PICTURE, PICTURE).likeness == "identical"
    comparison = fumon.compare(PICTURE, other)
    assert (comparison.largest, comparison.changed) == (1, 1) and comparison.likeness == "same to the eye"
    assert comparison.difference.shape == PICTURE.shape
    with pytest.raises(ValueError):
        fumon.compare(PICTURE, PICTURE[1:])
    with pytest.raises(TypeError):
        fumon.compare(PICTURE, PICTURE / 255)
    with pytest.raises(ValueError):
        fumon.fingerprint(PICTURE[:, :, 0])


def frames_of(file):
    found = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames", "-of",
                            "csv=p=0", file], capture_output=True, text=True, check=True)
    return int(found.stdout.strip().strip(","))


BEDS = np.stack([HILLS, HILLS * 1.2, HILLS * 1.4])


@pytest.mark.parametrize("ending, start", [("mp4", b"ftyp"), ("webp", b"WEBP"), ("gif", b"GIF8"), ("apng", b"\x89PNG")])
def test_movies_of_beds(tmp_path, ending, start):
    file = tmp_path / f"m.{ending}"
    movie = fumon.movie(BEDS, file, cell_size=2.0, rate=10, **LOOK)
    assert start in file.read_bytes()[:16] and movie.frames == 3
    assert "base64" in movie._repr_html_()
    if ending == "mp4" and shutil.which("ffprobe"):
        assert frames_of(file) == 3


def test_the_kinds_of_frames(tmp_path, barchans):
    def bytes_of(frames, **options):
        fumon.movie(frames, tmp_path / "m.mp4", **options)
        return (tmp_path / "m.mp4").read_bytes()

    of_beds = bytes_of(BEDS, cell_size=(2.0, 3.0), **LOOK)
    times = xarray.concat([array_with(X, Y, bed) for bed in BEDS], "time")
    assert bytes_of(list(BEDS), cell_size=(2.0, 3.0), **LOOK) == of_beds
    assert bytes_of(times, **LOOK) == of_beds
    assert bytes_of(times.transpose("x", "time", "y").to_dataset(name="bed"), **LOOK) == of_beds
    times.fumon.movie(tmp_path / "n.mp4", **LOOK)
    assert (tmp_path / "n.mp4").read_bytes() == of_beds
    images = [step.image() for step in barchans.run(every=20)]
    of_run = bytes_of(barchans.run(every=20))
    assert bytes_of(images) == of_run == bytes_of(np.stack(images))
    assert bytes_of(barchans.run(every=20)) != bytes_of(barchans.run(every=40))


def test_movies_keep_alpha_where_they_can(tmp_path):
    block = fumon.render(HILLS, 2.0, look_background="transparent", **LOOK)
    alpha = block[:, :, 3:].astype(int)
    on_white = ((alpha * block[:, :, :3] + (255 - alpha) * 255 + 127) // 255).astype(np.uint8)
    for ending in ("gif", "mp4"):
        fumon.movie([block, block], tmp_path / f"open.{ending}")
        fumon.movie([on_white, on_white], tmp_path / f"white.{ending}")
        assert (tmp_path / f"open.{ending}").read_bytes() == (tmp_path / f"white.{ending}").read_bytes()
    fumon.movie([block, on_white], tmp_path / "m.apng")
    rgba = 6
    assert (tmp_path / "m.apng").read_bytes()[25] == rgba  # the colour type in IHDR


def test_wrong_movies(tmp_path, barchans):
    with pytest.raises(ValueError, match="needs a frame"):
        fumon.movie([], tmp_path / "m.mp4")
    with pytest.raises(fumon.InputError, match=".mp4"):
        fumon.movie(BEDS, tmp_path / "m.avi", **LOOK)
    with pytest.raises(ValueError, match="rate"):
        fumon.movie(BEDS, tmp_path / "m.mp4", rate=0)
    with pytest.raises(ValueError, match="64 x 39"):
        fumon.movie([PICTURE, PICTURE[1:]], tmp_path / "m.mp4")
    with pytest.raises(ValueError, match="shape"):
        fumon.movie([HILLS, HILLS[1:]], tmp_path / "m.mp4", **LOOK)
    with pytest.raises(TypeError, match="camera_azimuth"):
        fumon.movie([PICTURE], tmp_path / "m.mp4", camera_azimuth=3)
    assert not list(tmp_path.iterdir())  # not even a part of one


def test_the_fields_of_a_run_are_a_dataset_to_film(tmp_path, barchans):
    import os
    (tmp_path / "s.toml").write_text(barchans.to_toml())
    subprocess.run([os.environ["FUMON_PROGRAM"], "run", tmp_path / "s.toml", "-o", tmp_path / "out", "--quiet", "--set",
                    "output.frames=false", "--set", "output.movie=false", "--set", "output.fields_every=20"], check=True)
    with xarray.open_dataset(tmp_path / "out/fields.nc") as fields:
        assert fumon.movie(fields, tmp_path / "m.mp4", **LOOK).frames == 3
        one = fields["bed_height"].isel(date=0)
        assert np.array_equal(one.fumon.render(**LOOK), fumon.render(next(barchans.run(every=20)).bed, **LOOK))
