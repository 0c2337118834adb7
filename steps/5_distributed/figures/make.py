#!/usr/bin/env python3
"""Makes the figures of the handout with the render program: make.py BUILD_FOLDER (needs oiiotool)."""
import pathlib
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
scenes = here.parents[2] / "scenes" / "5_distributed"
render = pathlib.Path(sys.argv[1]).resolve() / "bin" / "render-solution"
work = pathlib.Path(tempfile.mkdtemp())


def run(*words, **more):
    return subprocess.run([str(w) for w in words], check=True, capture_output=True, text=True, **more).stdout


def picture(scene, name, *options, width=240, height=180):
    file = work / f"{name}.png"
    run(render, scenes / scene, "-o", file, "--width", width, "--height", height, "--seed", 1, *options)
    return file


def side_by_side(name, *files):
    run("oiiotool", *files, "--mosaic:pad=4", f"{len(files)}x1", "-o", here / f"{name}.png")


def points_of(pattern, samples):
    """The points of one pixel, as the program answers them."""
    scene = "sphere { 0, 1 }\n"
    query = f"scene {len(scene)}\n{scene}points {pattern} 1 7 0 0 {samples} sample {samples} nothing 1\n"
    numbers = [float(w) for w in run(render, "--answer", input=query).split()]
    return list(zip(numbers[0::2], numbers[1::2]))


def dots(name, points, side=240):
    """Dark dots on a light square, as a picture in the simplest of formats."""
    pixels = [[235] * side for _ in range(side)]
    for x, y in points:
        for v in range(int(y * side) - 2, int(y * side) + 3):
            for u in range(int(x * side) - 2, int(x * side) + 3):
                if 0 <= u < side and 0 <= v < side and (u - x * side) ** 2 + (v - y * side) ** 2 < 7:
                    pixels[v][u] = 40
    file = work / f"{name}.pgm"
    file.write_text(f"P2 {side} {side} 255\n" + "\n".join(" ".join(map(str, row)) for row in pixels) + "\n")
    return file


PATTERNS = ["regular", "random", "jittered", "multi_jittered", "sobol"]
side_by_side("patterns", *[dots(p, points_of(p, 256)) for p in PATTERNS])
side_by_side("shadows", picture("soft_shadow.pov", "random", "--samples", 4, "--pattern", "random"),
             picture("soft_shadow.pov", "sobol", "--samples", 4), picture("soft_shadow.pov", "many", "--samples", 256))
side_by_side("focus", *[picture(f"focus_{f}.pov", f, "--samples", 256) for f in ("near", "middle", "far")])
side_by_side("motion", *[picture(f"{f}.pov", f, "--samples", 256) for f in ("moving_sphere", "spinning_disc", "shutter")])
side_by_side("rough", *[picture(f"{f}.pov", f, "--samples", 512) for f in ("glossy_floor", "translucent_screen", "hexagon")])
