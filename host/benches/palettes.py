#!/usr/bin/env python3
"""Compares the colours of each device with those that ImageMagick finds, on the scenes of the repository.

    cargo build --release
    python3 host/benches/palettes.py target/release/rta
    python3 host/benches/palettes.py target/release/rta other.dat another.nff

For each scene and device it prints FLIP, at the device's own pixels a degree, of the default colour table and dithering, of `uniform`, of
`tolerant` and of ImageMagick, which gets the whole picture, chooses as many colours as the device has and dithers with Floyd and
Steinberg's error diffusion. Its colours are rounded to the levels of the device's guns, in two ways of which the better one counts:
after dithering, and before it. All are compared with the picture that has 8 bits a gun. The status is 1 if a default is above 40 % of `uniform`, above 70 % of `tolerant`, or above ImageMagick.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
SHIPPED = ["juggler.dat", "hall-22.dat", "glass-2.dat", "balls2.nff"]

# Name, raster, shape of the screen, entries of the colour table, highest level of a gun, pixels a degree.
DEVICES = [
    ("vga", "320x200", "4:3", 256, 63, 13),
    ("graphigs", "1024x1024", "1:1", 128, 15, 38),
    ("pixrect", "1152x900", "32:25", 256, 255, 35),
]

# The options of each picture that rta draws.
TABLES = {"default": [], "uniform": ["--table", "uniform"], "tolerant": ["--table", "tolerant"]}

# What the default may have of the others' FLIP.
LIMITS = {"uniform": 0.4, "tolerant": 0.7, "ImageMagick": 1.0}


def run(*command, **options):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, **options).stdout


def rounded(ppm, most):
    """A binary PPM whose codes are the nearest that a gun with levels 0 to `most` has."""
    level = bytes((2 * 255 * ((2 * code * most + 255) // 510) + most) // (2 * most) for code in range(256))
    start = 0
    for _ in range(3):
        start = ppm.index(b"\n", start) + 1
    return ppm[:start] + ppm[start:].translate(level)


def imagemagick(convert, reference, test, colors, most):
    """Writes the picture by ImageMagick, rounded to the guns first after dithering, then before; yields after each."""
    choose = ["-dither", "FloydSteinberg", "-colors", str(colors)]
    ppm = run(convert, reference, *choose, "-depth", "8", "ppm:-")
    run(convert, "ppm:-", f"PNG24:{test}", input=rounded(ppm, most))
    yield
    ppm = run(convert, reference, *choose, "-unique-colors", "-depth", "8", "ppm:-")
    table = test.with_name("table.png")
    run(convert, "ppm:-", f"PNG24:{table}", input=rounded(ppm, most))
    run(convert, reference, "-dither", "FloydSteinberg", "-remap", table, f"PNG24:{test}")
    yield


def flips(rta, convert, scene, device, folder):
    """FLIP of each of TABLES and of ImageMagick."""
    name, size, aspect, colors, most, pixels = device
    reference, test = folder / "reference.png", folder / "test.png"
    run(rta, "render", scene, "-q", "-o", reference, "--device", "none", "--size", size, "--aspect", aspect)

    def flip():
        told = run(rta, "difference", reference, test, "--pixels-per-degree", str(pixels)).decode()
        return float(told.split("FLIP", 1)[1].split()[0])

    found = {}
    for table, options in TABLES.items():
        run(rta, "render", scene, "-q", "-o", test, "--device", name, *options)
        found[table] = flip()
    ways = imagemagick(convert, reference, test, colors, most)
    found["ImageMagick"] = min(flip() for _ in ways)
    return found


def main():
    rta = shutil.which(sys.argv[1]) if len(sys.argv) > 1 else None
    convert = shutil.which("magick") or shutil.which("convert")
    if rta is None or convert is None:
        sys.exit(f"{__doc__}\nIt needs a path to rta, and ImageMagick.")
    scenes = sys.argv[2:] or [SCENES / name for name in SHIPPED]
    failed = 0
    print("| device   | scene    | default | uniform | tolerant | ImageMagick | of uniform | of tolerant | of ImageMagick |      |")
    print("| -------- | -------- | ------: | ------: | -------: | ----------: | ---------: | ----------: | -------------: | ---- |")
    with tempfile.TemporaryDirectory() as folder:
        for device in DEVICES:
            for scene in scenes:
                found = flips(rta, convert, scene, device, pathlib.Path(folder))
                default = found["default"]
                within = [default <= part * found[other] for other, part in LIMITS.items()]
                failed += not all(within)
                parts = [f"{100 * default / max(found[other], 1e-9):.0f} %" for other in LIMITS]
                print(
                    f"| {device[0]:8} | {pathlib.Path(scene).stem:8} | {default:7.4f} | {found['uniform']:7.4f} "
                    f"| {found['tolerant']:8.4f} | {found['ImageMagick']:11.4f} "
                    f"| {parts[0]:>10} | {parts[1]:>11} | {parts[2]:>14} | {'ok' if all(within) else 'FAIL':4} |",
                    flush=True,
                )
    if failed:
        sys.exit(1)


if __name__ == "__main__":
    main()
