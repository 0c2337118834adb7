#!/usr/bin/env python3
"""Makes the figures of the handout with the render program: make.py BUILD_FOLDER (needs oiiotool)."""
import math
import pathlib
import re
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


def ball(x, y, radius, colour, z=0):
    return f"sphere {{ <{x:.5g}, {y:.5g}, {z}>, {radius} pigment {{ rgb {colour} }} finish {{ ambient 0 diffuse 0 emission 1 }} }}"


def rod(x0, y0, x1, y1, radius, colour, z=0):
    return (f"cylinder {{ <{x0:.5g}, {y0:.5g}, {z}>, <{x1:.5g}, {y1:.5g}, {z}>, {radius} pigment {{ rgb {colour} }} "
            "finish { ambient 0 diffuse 0 emission 1 } }")


def drawing(name, left, bottom, right, top, items, width=288):
    """A scene of balls and rods, seen from far in front."""
    wide, high = right - left, top - bottom
    pov = work / f"{name}.pov"
    pov.write_text("#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\nbackground { rgb 0.95 }\n"
                   f"camera {{ orthographic location <{left + wide / 2}, {bottom + high / 2}, -9> direction z right {wide}*x up {high}*y }}\n"
                   + "\n".join(items))
    return picture(pov, f"{name}.drawn", "--samples", 16, width=width, height=round(width * high / wide))


COUNTS = [4, 16, 64, 256, 1024, 4096]


def errors(scene, seeds=4):
    """Root mean squares of the errors by pattern and number of samples."""
    def rendered(name, samples, pattern, seed):
        run(render, scene, "-o", work / name, "--width", 16, "--height", 16, "--samples", samples, "--pattern", pattern, "--seed", seed)
        return work / name
    truth = rendered("truth.exr", 1 << 18, "sobol", 99)
    table = {}
    for pattern in PATTERNS:
        for n in COUNTS:
            squares = 0
            for seed in range(seeds):
                told = subprocess.run(["idiff", "-fail", "1e-30", "-warn", "1e-30", str(rendered("try.exr", n, pattern, seed)), str(truth)],
                                      capture_output=True, text=True).stdout
                found = re.search(r"RMS error = (\S+)", told)
                squares += float(found[1]) ** 2 if found else 0
            table[pattern, n] = math.sqrt(squares / seeds)
    return table


def slopes(scene, low=-6, high=-0.8):
    """Error against samples, both on scales of tens."""
    colours = {"regular": "<0.35, 0.35, 0.35>", "random": "<0.75, 0.08, 0.05>", "jittered": "<0.9, 0.45, 0.02>",
               "multi_jittered": "<0.1, 0.5, 0.15>", "sobol": "<0.04, 0.15, 0.6>"}
    table = errors(here / f"{scene}.pov")
    items = [rod(math.log10(n), low, math.log10(n), high, 0.006, 0.75, 2) for n in COUNTS]
    items += [rod(math.log10(4), e, math.log10(4096), e, 0.006, 0.75, 2) for e in range(math.ceil(low), math.floor(high) + 1)]
    for pattern in PATTERNS:
        line = [(math.log10(n), math.log10(table[pattern, n])) for n in COUNTS if table[pattern, n] > 10 ** low]
        print(scene, pattern, " ".join(f"{table[pattern, n]:.3g}" for n in COUNTS),
              "slope %.2f" % ((line[-1][1] - line[1][1]) / (line[-1][0] - line[1][0])))
        items += [rod(*a, *b, 0.02, colours[pattern]) for a, b in zip(line, line[1:])] + [ball(x, y, 0.045, colours[pattern]) for x, y in line]
    return drawing(scene, 0.4, low, 3.8, high, items)


def enlarged(file):
    """54 x 40 pixels at the horizon, each as 4 x 4."""
    part = file.with_suffix(".part.png")
    run("oiiotool", file, "--cut", "54x40+40+48", "--resize:filter=box", "216x160", "-d", "uint8", "-o", part)
    return part


PATTERNS = ["regular", "random", "jittered", "multi_jittered", "sobol"]
side_by_side("patterns", *[dots(p, points_of(p, 256)) for p in PATTERNS])
side_by_side("shadows", picture("soft_shadow.pov", "random", "--samples", 4, "--pattern", "random"),
             picture("soft_shadow.pov", "sobol", "--samples", 4), picture("soft_shadow.pov", "many", "--samples", 256))
side_by_side("focus", *[picture(f"focus_{f}.pov", f, "--samples", 256) for f in ("near", "middle", "far")])
side_by_side("motion", *[picture(f"{f}.pov", f, "--samples", 256) for f in ("moving_sphere", "spinning_disc", "shutter")])
side_by_side("rough", *[picture(f"{f}.pov", f, "--samples", 512) for f in ("glossy_floor", "translucent_screen", "hexagon")])
side_by_side("filters", *[enlarged(picture("edges.pov", f, *options, width=160, height=120)) for f, options in (
    ("one", ["--samples", 1]), *((f, ["--samples", 64, "--filter", f]) for f in ("box", "tent", "mitchell")))])
side_by_side("slopes", slopes("edge"), slopes("smooth"), slopes("two"))
