#!/usr/bin/env python3
"""Makes FLIP's reference values of the pairs of pictures in this folder; README.md tells of the files.

    python3 -m venv venv
    venv/bin/pip install flip-evaluator==1.7 numpy==2.4.6 pillow==13.0.0
    venv/bin/python reference.py            # NAME-flip.png and means.csv
    venv/bin/python reference.py --draw     # draws the pairs that rta does not, too
"""

import pathlib
import sys

import flip_evaluator
import numpy as np
from PIL import Image

FOLDER = pathlib.Path(__file__).parent
PIXELS_PER_DEGREE = [13, 35, 38, 67]


def read(name):
    return np.asarray(Image.open(FOLDER / name).convert("RGB"))


def write(name, pixels):
    Image.fromarray(np.asarray(pixels, dtype=np.uint8), "RGB").save(FOLDER / name, optimize=True)


def write_pair(name, reference, test):
    write(f"{name}-reference.png", reference)
    write(f"{name}-test.png", test)


def strokes(width, height, scale):
    """Returns black stems, bars and a slope on white, `scale` times as large."""
    y, x = np.mgrid[0 : height * scale, 0 : width * scale] / scale
    stems = (x % 7 < 1.5) & (y % 8 > 1) & (x < 24)
    bars = (y % 4 < 0.75) & (x < 24)
    slope = (abs(x - 26 - y * 0.7) < 0.8) & (x >= 24)
    return np.where(stems | bars | slope, 0.0, 255.0)


def draw():
    """Draws noise, text, plain, shifted and tiny. Text: one sample a pixel beside the mean of 8 x 8, on darker paper."""
    random = np.random.default_rng(2020)
    write_pair("noise", *random.integers(0, 256, (2, 24, 32, 3)))
    sharp = strokes(44, 16, 1)
    smooth = strokes(44, 16, 8).reshape(16, 8, 44, 8).mean(axis=(1, 3)).clip(0, 240).round()
    write_pair("text", *[np.repeat(gray[..., None], 3, axis=2) for gray in (sharp, smooth)])
    write_pair("plain", np.full((9, 14, 3), (200, 120, 40)), np.full((9, 14, 3), (190, 128, 70)))
    balls = read("shifted-reference.png")
    write("shifted-test.png", np.concatenate([balls[:, :1], balls[:, :-1]], axis=1))
    write_pair("tiny", *random.integers(0, 256, (2, 2, 3, 3)))


def measure():
    means = ["pair,pixels_per_degree,mean"]
    for reference in sorted(FOLDER.glob("*-reference.png")):
        name = reference.name.removesuffix("-reference.png")
        pictures = [read(f"{name}-{which}.png").astype(np.float32) / 255 for which in ("reference", "test")]
        maps = []
        for pixels in PIXELS_PER_DEGREE:
            parameters = {"ppd": float(pixels)}
            errors, mean, _ = flip_evaluator.evaluate(*pictures, "LDR", applyMagma=False, parameters=parameters)
            maps.append(errors.reshape(errors.shape[:2]))
            means.append(f"{name},{pixels},{mean:.6f}")
        stacked = np.round(np.concatenate(maps) * 65535).astype(np.uint16)
        Image.fromarray(stacked).save(FOLDER / f"{name}-flip.png", optimize=True)
    (FOLDER / "means.csv").write_text("\n".join(means) + "\n")


if sys.argv[1:] == ["--draw"]:
    draw()
measure()
