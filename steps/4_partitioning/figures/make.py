#!/usr/bin/env python3
"""Makes the figures of the handout with the render program: make.py BUILD_FOLDER (needs oiiotool)."""
import json
import pathlib
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
scenes = here.parents[2] / "scenes" / "4_partitioning"
render = pathlib.Path(sys.argv[1]).resolve() / "bin" / "render-solution"
work = pathlib.Path(tempfile.mkdtemp())
SIZE = ["--width", "240", "--height", "180"]


def run(*words):
    return subprocess.run([str(w) for w in words], check=True, capture_output=True, text=True).stdout


def costs(name, scene, partitions, most, power):
    """(Tests a pixel / most)^power, one structure beside the other."""
    maps = []
    for partition in partitions:
        exr = work / f"{name}.{partition}.exr"
        run(render, scenes / scene, "--cost-map", exr, "--partition", partition, *SIZE)
        maps += [exr, "--ch", "tests", "--mulc", 1 / most, "--powc", power, "--clamp:min=0:max=1", "--colormap", "inferno"]
    run("oiiotool", *maps, "--mosaic:pad=4", f"{len(partitions)}x1", "-d", "uint8", "-o", here / f"{name}.png")


def edges(boxes):
    """The edges of boxes as thin cylinders."""
    out = []
    for x0, y0, z0, x1, y1, z1 in boxes:
        corners = [(x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
        for i in range(8):
            for bit in (1, 2, 4):
                if not i & bit and corners[i] != corners[i | bit]:
                    a, b = corners[i], corners[i | bit]
                    out.append("cylinder { <%.6g, %.6g, %.6g>, <%.6g, %.6g, %.6g>, 0.008 texture { Wire } }" % (*a, *b))
    return "\n".join(out)


def walk(name, scene, pixel):
    """The cells of a grid and the leaves of an octree that one camera ray visits, seen from the side."""
    pictures = []
    for partition in ("grid", "octree"):
        visit = json.loads(run(render, scenes / scene, "--explain", pixel, "--visited", "--partition", partition, *SIZE))
        text = (scenes / scene).read_text().splitlines()
        text = [line for line in text if not line.startswith(("camera", "plane"))]
        wire = "#declare Wire = texture { pigment { rgb <1, 0.85, 0.2> } finish { ambient 0.8 diffuse 0.2 } }\n"
        camera = "camera { location <7, 2.5, -2> right x*image_width/image_height up y angle 30 look_at <0, 0, -0.4> }\n"
        pov = work / f"{partition}_{scene}"
        pov.write_text("\n".join(text) + "\n" + camera + wire + edges(visit["visited"]))
        (work / "flake.inc").write_text((scenes / "flake.inc").read_text())
        pictures.append(work / f"{name}.{partition}.png")
        run(render, pov, "-o", pictures[-1], "--samples", "9", "--width", "360", "--height", "270")
    run("oiiotool", *pictures, "--mosaic:pad=4", "2x1", "-d", "uint8", "-o", here / f"{name}.png")


costs("costs", "sphereflake_4.pov", ["grid", "octree"], 100, 1)
costs("stadium", "teapot_in_a_stadium.pov", ["grid", "octree"], 8000, 0.25)
walk("walk", "sphereflake_4.pov", "60,60")
