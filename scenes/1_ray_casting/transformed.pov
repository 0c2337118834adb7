// Scaled, sheared, rotated: the ray goes into the object's space unnormalised and the normal comes back by the inverse
// transpose. Catches normals multiplied by the matrix itself, t measured in the wrong space, and the wrong order.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.13, 0.10, 0.12> }

camera { location <0, 2.2, -8> right x*4/3 up y look_at <0.2, 0, 0> angle 54 }
light_source { <-6, 9, -7>, rgb 1 shadowless }

#declare Plain = finish { ambient 0.12 diffuse 0.85 }

// Pancake and egg.
sphere { 0, 1 scale <1.5, 0.35, 1.1> rotate <-20, 0, 25> translate <-2.1, 1.3, 0> pigment { rgb <0.95, 0.75, 0.35> } finish { Plain } }
sphere { 0, 1 scale <0.55, 1.2, 0.55> rotate <35, 0, -30> translate <0.2, 1.1, 0.5> pigment { rgb <0.90, 0.50, 0.45> } finish { Plain } }
// A box that leans: x grows with y.
box {
    -0.7, 0.7
    matrix <1, 0, 0,  0.6, 1, 0.2,  0, 0, 1,  0, 0, 0>
    rotate -35*y
    translate <2.4, 0.9, 0>
    pigment { rgb <0.45, 0.75, 0.55> } finish { Plain }
}
// A torus squeezed and sheared, a cylinder with an elliptic cut, a mirrored cone.
torus {
    0.8, 0.28
    scale <1.3, 1, 0.8>
    matrix <1, 0.3, 0,  0, 1, 0,  0, 0.4, 1,  0, 0, 0>
    rotate -50*x
    translate <-2.2, -1.1, 0>
    pigment { rgb <0.40, 0.60, 0.90> } finish { Plain }
}
cylinder { -0.9*y, 0.9*y, 0.6 scale <1.5, 0.8, 0.5> rotate <25, 40, 30> translate <0.3, -1.1, -0.5> pigment { rgb <0.75, 0.55, 0.90> } finish { Plain } }
cone { -0.9*y, 0.8, 0.9*y, 0.2 scale <1, -1, 1> matrix <1, 0, 0,  0.4, 1, 0,  0, 0, 1,  0, 0, 0> translate <2.3, -1.2, -0.3> pigment { rgb <0.90, 0.60, 0.25> } finish { Plain } }
