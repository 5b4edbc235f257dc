#!/usr/bin/env python3
"""Writes the letters that fumon sets texts on frames with, as outlines: outlines_of_font.py FONT.ttf > NAME.txt

Needs fontTools (python3-fonttools). A line a thing, numbers in units of the font:
    em UNITS ascent UNITS descent UNITS
    glyph CODE ADVANCE [M x y | L x y | Q x y x y | Z]...    contours; Q is a quadratic curve: its control point, its end
    kern CODE CODE UNITS                                     what is added between two letters
"""
import sys

from fontTools.pens.basePen import decomposeQuadraticSegment
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.ttLib import TTFont

RANGES = [
    (0x20, 0x7E), (0xA0, 0x17F), (0x2C6, 0x2DD), (0x391, 0x3C9), (0x3D5, 0x3D6), (0x410, 0x44F),
    (0x2009, 0x200A), (0x2010, 0x2027), (0x202F, 0x203A), (0x2070, 0x208E), (0x20AC, 0x20AC), (0x2103, 0x2103),
    (0x2113, 0x2113), (0x2122, 0x2122), (0x2126, 0x2126), (0x2190, 0x2199), (0x2202, 0x221E), (0x2223, 0x222B),
    (0x2245, 0x2248), (0x2260, 0x2265), (0x226A, 0x226B), (0x22C5, 0x22C5), (0x25A0, 0x25CF),
]

font = TTFont(sys.argv[1])
glyphs, names = font.getGlyphSet(), font.getBestCmap()
codes = [code for first, last in RANGES for code in range(first, last + 1) if code in names]
print(f"# {font['name'].getDebugName(4)} {font['name'].getDebugName(5)}, some of its letters: see README.md beside this file.")
print(f"em {font['head'].unitsPerEm} ascent {font['hhea'].ascent} descent {-font['hhea'].descent}")


def number(value):
    return f"{value:g}" if value == round(value, 3) else f"{value:.3f}"


for code in codes:
    pen = DecomposingRecordingPen(glyphs)
    glyphs[names[code]].draw(pen)
    words = []
    for operator, points in pen.value:
        if operator == "moveTo":
            words += ["M", *points[0]]
        elif operator == "lineTo":
            words += ["L", *points[0]]
        elif operator == "qCurveTo":
            if points[-1] is None:  # a contour without a point on it begins between two of its control points
                start = tuple((a + b) / 2 for a, b in zip(points[-2], points[0]))
                words += ["M", *start]
                points = (*points[:-1], start)
            for control, end in decomposeQuadraticSegment(points):
                words += ["Q", *control, *end]
        elif operator == "closePath":
            words += ["Z"]
        elif operator != "endPath":
            raise SystemExit(f"{names[code]}: {operator} in an outline")
    text = " ".join(word if isinstance(word, str) else number(word) for word in words)
    print(f"glyph {code:X} {glyphs[names[code]].width} {text}".rstrip())

# Pairs as the font's kerning has them, for letters of Latin alphabets alone.
latin = {names[code]: code for code in codes if code < 0x180}
for (left, right), value in sorted(font["kern"].kernTables[0].kernTable.items()):
    if left in latin and right in latin and value:
        print(f"kern {latin[left]:X} {latin[right]:X} {value}")
