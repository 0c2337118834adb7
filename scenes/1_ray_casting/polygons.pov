// Plane polygons with everything: a concave notch, a hole, an island in the hole, a self-crossing star; one facing
// each axis. Catches the half-plane test, dropping z always, and holes that are filled.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.07, 0.08, 0.11> }

camera { location <6.4, 5.0, -6.6> right x*4/3 up y look_at <0.55, 0.45, -0.7> angle 40 }
light_source { <7, 9, -4>, rgb 1 shadowless }

#declare Plain = finish { ambient 0.15 diffuse 0.8 }

// In the plane z = 1: an arrow with a notch, a hole, and an island in the hole.
polygon {
    16,
    <-1, -0.9, 1>, <0.9, -0.9, 1>, <0.5, 0.5, 1>, <2.6, 0.3, 1>, <1.4, 2.6, 1>, <-1, 1.7, 1>, <-0.2, 0.5, 1>, <-1, -0.9, 1>,
    <0.3, 0.9, 1>, <1.5, 0.8, 1>, <1.0, 2.0, 1>, <0.3, 0.9, 1>,
    <0.75, 1.05, 1>, <1.15, 1.0, 1>, <1.0, 1.5, 1>, <0.75, 1.05, 1>
    pigment { rgb <0.95, 0.65, 0.20> } finish { Plain }
}
// In the plane x = -1.2: a frame of two squares, one standing on its corner.
polygon {
    10,
    <-1.2, -0.9, -3>, <-1.2, -0.9, 0.6>, <-1.2, 2.4, 0.6>, <-1.2, 2.4, -3>, <-1.2, -0.9, -3>,
    <-1.2, -0.4, -1.2>, <-1.2, 0.75, 0.2>, <-1.2, 1.9, -1.2>, <-1.2, 0.75, -2.6>, <-1.2, -0.4, -1.2>
    pigment { rgb <0.35, 0.65, 0.90> } finish { Plain }
}
// In the plane y = -1: a five-pointed star drawn in one stroke. By the even-odd rule its middle is empty.
polygon {
    6,
    <1.00 + 1.9*sin(0), -1, -1.2 + 1.9*cos(0)>,
    <1.00 + 1.9*sin(radians(144)), -1, -1.2 + 1.9*cos(radians(144))>,
    <1.00 + 1.9*sin(radians(288)), -1, -1.2 + 1.9*cos(radians(288))>,
    <1.00 + 1.9*sin(radians(72)), -1, -1.2 + 1.9*cos(radians(72))>,
    <1.00 + 1.9*sin(radians(216)), -1, -1.2 + 1.9*cos(radians(216))>,
    <1.00 + 1.9*sin(0), -1, -1.2 + 1.9*cos(0)>
    pigment { rgb <0.45, 0.80, 0.45> } finish { Plain }
}
