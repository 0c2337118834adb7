#!/usr/bin/env python3
"""Renders the gallery with the solutions: make.py BUILD_FOLDER [STEP ...]."""
import pathlib
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
render = pathlib.Path(sys.argv[1]).resolve() / "bin" / "render-solution"
scenes = here.parents[1] / "scenes" / "gallery"
# One ray a sample needs a grid; what is an integral over many things needs many samples.
SAMPLES = {1: 16, 2: 16, 3: 25, 4: 25, 5: 512}
SIZE = {4: (704, 396)}  # 82 430 spheres hardly fit into 400 kB as it is

for step in [int(word) for word in sys.argv[2:]] or SAMPLES:
    width, height = SIZE.get(step, (960, 540))
    words = [render, scenes / f"step_{step}.pov", "-o", here / f"step_{step}.png", "--width", width, "--height", height]
    subprocess.run([str(w) for w in [*words, "--samples", SAMPLES[step]]], check=True)
    # For the page of the solutions.
    subprocess.run(["oiiotool", str(here / f"step_{step}.png"), "--resize", "320x180", "--eraseattrib", ".*", "--nosoftwareattrib", "--compression", "jpeg:60", "-o", str(here / "small" / f"step_{step}.jpg")], check=True)
