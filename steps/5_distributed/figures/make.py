#!/usr/bin/env python3
"""Makes the figures of the handout with the render program: make.py BUILD_FOLDER [FIGURE ...] (needs oiiotool)."""
import math
import pathlib
import re
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
scenes = here.parents[2] / "scenes" / "5_distributed"
program = pathlib.Path(sys.argv[1]).resolve() / "bin" / "render-solution"
work = pathlib.Path(tempfile.mkdtemp())
PATTERNS = ["regular", "random", "jittered", "multi_jittered", "sobol"]


def run(*words, **more):
    return subprocess.run([str(w) for w in words], check=True, capture_output=True, text=True, **more).stdout


def render(scene, name, *words):
    run(program, scene, "-o", work / name, *words)
    return work / name


def mosaic(name, pictures, columns):
    rows = math.ceil(len(pictures) / columns)
    run("oiiotool", *pictures, "--mosaic:pad=4", f"{columns}x{rows}", "-d", "uint8", "-o", here / f"{name}.png")


def ball(x, y, radius, colour, z=0):
    return f"sphere {{ <{x:.5g}, {y:.5g}, {z}>, {radius} pigment {{ rgb {colour} }} finish {{ ambient 0 diffuse 0 emission 1 }} }}"


def rod(x0, y0, x1, y1, radius, colour, z=0):
    return (f"cylinder {{ <{x0:.5g}, {y0:.5g}, {z}>, <{x1:.5g}, {y1:.5g}, {z}>, {radius} pigment {{ rgb {colour} }} "
            "finish { ambient 0 diffuse 0 emission 1 } }")


def drawing(name, left, bottom, right, top, width, items):
    """A drawing is a scene that is seen from far in front."""
    wide, high = right - left, top - bottom
    pov = work / f"{name}.pov"
    pov.write_text("#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\nbackground { rgb 0.95 }\n"
                   f"camera {{ orthographic location <{left + wide / 2}, {bottom + high / 2}, -9> direction z right {wide}*x up {high}*y }}\n"
                   + "\n".join(items))
    return render(pov, f"{name}.png", "--width", width, "--height", round(width * high / wide), "--samples", 16)


def points():
    """The same 64 points of each pattern, and the elementary intervals that one of them each is in."""
    pictures = []
    for pattern in PATTERNS:
        question = f"scene 12\nsphere{{0,1 }}\npoints {pattern} 7 1 0 0 64 sample 64 nothing 1\n"
        numbers = [float(w) for w in re.findall(r"[-+0-9.e]+", run(program, "--answer", input=question).splitlines()[-1])]
        grid = [rod(i / 8, 0, i / 8, 1, 0.002, 0.6, 1) for i in range(9)] + [rod(0, i / 8, 1, i / 8, 0.002, 0.6, 1) for i in range(9)]
        dots = [ball(x, y, 0.014, "<0.02, 0.12, 0.4>") for x, y in zip(numbers[-128::2], numbers[-127::2])]
        pictures.append(drawing(pattern, -0.04, -0.04, 1.04, 1.04, 172, grid + dots))
    mosaic("points", pictures, 5)


def patterns():
    """A penumbra with 16 samples a pixel."""
    pictures = []
    for pattern in PATTERNS:
        whole = render(scenes / "soft_shadow.pov", f"{pattern}.exr", "--samples", 16, "--pattern", pattern, "--width", 320, "--height", 240)
        pictures.append(work / f"{pattern}.png")
        run("oiiotool", whole, "--cut", "86x86+150+120", "--colorconvert", "lin_srgb", "sRGB", "--resize:filter=box", "172x172", "-d", "uint8", "-o", pictures[-1])
    mosaic("patterns", pictures, 5)


def errors(scene, size, counts, most, seeds):
    """Root mean squares of the errors by pattern and number of samples."""
    size = ["--width", size, "--height", size]
    truth = render(scene, "truth.exr", "--samples", most, "--pattern", "sobol", "--seed", 99, *size)
    table = {}
    for pattern in PATTERNS:
        for n in counts:
            squares = 0
            for seed in range(seeds):
                picture = render(scene, "try.exr", "--samples", n, "--pattern", pattern, "--seed", seed, *size)
                told = subprocess.run(
                    ["idiff", "-fail", "9", str(picture), str(truth)], capture_output=True, text=True).stdout
                found = re.search(r"RMS error = (\S+)", told)
                squares += float(found[1]) ** 2 if found else 0
            table[pattern, n] = math.sqrt(squares / seeds)
    return table


def slopes():
    """Error against samples, both on scales of tens: an edge on the left, a smooth light on the right."""
    colours = {"regular": "<0.35, 0.35, 0.35>", "random": "<0.75, 0.08, 0.05>", "jittered": "<0.9, 0.45, 0.02>",
               "multi_jittered": "<0.1, 0.5, 0.15>", "sobol": "<0.04, 0.15, 0.6>"}
    counts = [4, 16, 64, 256, 1024, 4096]
    pictures = []
    for scene, most, low in (("edge", 1 << 18, -5.2), ("smooth", 1 << 18, -6.2)):
        table = errors(here / f"{scene}.pov", 24, counts, most, 4)
        items, high = [], -0.6
        for n in counts:
            items.append(rod(math.log10(n), low, math.log10(n), high, 0.006, 0.75, 2))
        for e in range(math.ceil(low), math.floor(high) + 1):
            items.append(rod(math.log10(4), e, math.log10(4096), e, 0.006, 0.75, 2))
        for pattern in PATTERNS:
            line = [(math.log10(n), math.log10(table[pattern, n])) for n in counts if table[pattern, n] > 10 ** low]
            print(scene, pattern, " ".join(f"{table[pattern, n]:.3g}" for n in counts),
                  "slope %.2f" % ((line[-1][1] - line[1][1]) / (line[-1][0] - line[1][0])))
            items += [rod(*a, *b, 0.02, colours[pattern]) for a, b in zip(line, line[1:])]
            items += [ball(x, y, 0.045, colours[pattern]) for x, y in line]
        picture = drawing(scene, 0.4, low, 3.8, high, 420, items)
        pictures.append(picture)
    mosaic("slopes", pictures, 2)


def filters():
    """Tiles at the horizon: one ray, and 64 samples through each filter; every pixel shown as 4 x 4."""
    pictures = []
    for name, words in (("one", ["--samples", 1]), *((f, ["--samples", 64, "--filter", f]) for f in ("box", "tent", "mitchell"))):
        whole = render(scenes / "edges.pov", f"{name}.exr", *words, "--width", 160, "--height", 120)
        pictures.append(work / f"{name}.f.png")
        run("oiiotool", whole, "--cut", "54x40+40+48", "--clamp:min=0:max=1", "--colorconvert", "lin_srgb", "sRGB", "--resize:filter=box", "216x160",
            "-d", "uint8", "-o", pictures[-1])
    mosaic("filters", pictures, 4)


def row(name, names, columns, width, samples=256):
    words = ["--samples", samples, "--width", width, "--height", width * 3 // 4]
    mosaic(name, [render(scenes / f"{scene}.pov", f"{scene}.{i}.png", *words, *more) for i, (scene, *more) in enumerate(names)], columns)


FIGURES = {
    "points": points,
    "patterns": patterns,
    "slopes": slopes,
    "filters": filters,
    "lens": lambda: row("lens", [("focus_near",), ("focus_far",), ("hexagon",)], 3, 288),
    "lights": lambda: row("lights", [("soft_shadow", "--without", "area_lights"), ("soft_shadow",), ("ball_light",)], 3, 288),
    "time": lambda: row("time", [("moving_sphere",), ("spinning_disc",)], 2, 360),
    "rough": lambda: row("rough", [("glossy_floor",), ("translucent_screen",)], 2, 360),
}
for figure in sys.argv[2:] or FIGURES:
    FIGURES[figure]()
