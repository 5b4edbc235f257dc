#!/usr/bin/env python3
"""Numbers by which pictures of sand are held beside photographs, as a table: saturation and hue of shadow and light, the span of
L*, pixels at the ends of the range, and the exponent of the ground's luminance.

    tests/bench/peers/looks.py PICTURE.png …

Saturation and hue (HSV) are those of the mean of the darkest 15 % and of the brightest 25 % of the lowest 60 %; L* spans from its
5th to its 95th percentile; the exponent is fitted, log on log from 8/n to .35 cycles a pixel, to the radial power of linear
luminance under a Hann window, of a square at the middle of the lower edge whose side n is 40 % of the picture's height. Needs
NumPy; reads PNG of 8 bits a channel.
"""

import argparse
import pathlib
import struct
import zlib

import numpy as np


def unfiltered(kind, row, above, channels):
    if kind == 0:
        return row
    if kind == 1:
        return np.cumsum(row.reshape(-1, channels), axis=0, dtype=np.int64).reshape(-1) & 255
    if kind == 2:
        return (row + above) & 255
    result = np.zeros_like(row)
    for i in range(len(row)):
        left = int(result[i - channels]) if i >= channels else 0
        up = int(above[i])
        corner = int(above[i - channels]) if i >= channels else 0
        if kind == 3:
            foreseen = (left + up) // 2
        else:
            away = [abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)]
            foreseen = (left, up, corner)[away.index(min(away))]
        result[i] = (row[i] + foreseen) & 255
    return result


def read_png(file):
    data = file.read_bytes()
    at, packed, header = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        content = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", content)
        if kind == b"IDAT":
            packed += content
        at += 12 + length
    width, height, bits, colour = header[:4]
    if bits != 8 or colour not in (2, 6):
        raise SystemExit(f"{file}: not an RGB picture of 8 bits")
    channels = 3 if colour == 2 else 4
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + width * channels).astype(np.int64)
    pixels = np.zeros((height, width * channels), np.int64)
    for y in range(height):
        pixels[y] = unfiltered(rows[y, 0], rows[y, 1:], pixels[y - 1] if y else np.zeros_like(rows[0, 1:]), channels)
    return pixels.reshape(height, width, channels)[:, :, :3]


def luminance(rgb):
    v = rgb / 255.0
    linear = np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)
    return linear @ [0.2126, 0.7152, 0.0722]


def hue_and_saturation(c):
    span = max(c) - min(c)
    if span == 0:
        return 0.0, 0.0
    sixth = ((c[1] - c[2]) / span, 2 + (c[2] - c[0]) / span, 4 + (c[0] - c[1]) / span)[int(np.argmax(c))]
    return 60 * (sixth % 6), span / max(c)


def exponent(light):
    height, width = light.shape
    n = int(0.2 * height) * 2
    left = (width - n) // 2
    square = light[height - n:, left:left + n]
    window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(n) / n)
    power = np.abs(np.fft.fft2((square - square.mean()) * window * window[:, None])) ** 2
    k = np.fft.fftfreq(n) * n
    ring = (np.hypot(k[:, None], k) + 0.5).astype(int)
    mean = np.bincount(ring.ravel(), power.ravel()) / np.bincount(ring.ravel())
    fitted = np.arange(8, int(0.35 * n) + 1)
    return np.polyfit(np.log(fitted), np.log(mean[fitted]), 1)[0]


def numbers(picture):
    light = luminance(picture)
    height = light.shape[0]
    ground = picture[int(0.4 * height):].reshape(-1, 3)
    order = np.argsort(light[int(0.4 * height):].ravel(), kind="stable")
    shadow = hue_and_saturation(ground[order[:int(0.15 * len(order))]].mean(0))
    lit = hue_and_saturation(ground[order[int(0.75 * len(order)):]].mean(0))
    star = np.where(light > 216 / 24389, 116 * np.cbrt(light) - 16, light * 24389 / 27)
    low, high = np.percentile(star, [5, 95])
    ends = ((picture.min(2) == 0) | (picture.max(2) == 255)).mean()
    return (f"{shadow[1]:.2f}, {lit[1]:.2f} | {shadow[0]:.0f}°, {lit[0]:.0f}° | {high - low:.1f} | {100 * ends:.3f} % | "
            f"{exponent(light):.2f}".replace("-", "−"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pictures", nargs="+", type=pathlib.Path)
    print("| picture | saturation of shadow, light | hue | L* | at 0 or 255 | exponent |\n|---|---|---|---|---|---|")
    for file in parser.parse_args().pictures:
        print(f"| {file.name} | {numbers(read_png(file))} |", flush=True)


if __name__ == "__main__":
    main()
