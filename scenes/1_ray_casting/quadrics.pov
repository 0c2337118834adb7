// Surfaces of the second order, cut to size: ellipsoid, paraboloid, hyperboloids of one and of two sheets, cone, saddle.
// Catches 2B where B is meant, A near zero along the paraboloid's axis, and one sheet where there are two.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.94, 0.93, 0.90> }

camera { location <0, 2.6, -9> right x*4/3 up y look_at <0, 0.05, 0> angle 52 }
light_source { <-6, 9, -8>, rgb 0.95 shadowless }

#declare Plain = finish { ambient 0.15 diffuse 0.8 }
#declare Cut = box { -1.05, 1.05 }

quadric {  // x^2/1.2 + 3 y^2 + z^2 = 1
    <1/1.2, 3, 1>, <0, 0, 0>, <0, 0, 0>, -1
    rotate <-20, 0, 25> translate <-2.6, 1.45, 0> pigment { rgb <0.90, 0.45, 0.30> } finish { Plain }
}
quadric {  // 1.4 x^2 + z^2 = y. (POV-Ray bounds a paraboloid wrongly when its vertex is not in the origin: keep it there.)
    <1.4, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0
    clipped_by { Cut } rotate <-24, 0, 12> translate <0, 0.85, 0> pigment { rgb <0.95, 0.75, 0.30> } finish { Plain }
}
quadric {  // x^2 - y^2 + z^2 = 0.15
    <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, -0.15
    clipped_by { Cut } rotate <10, 0, -15> translate <2.6, 1.35, 0> pigment { rgb <0.45, 0.70, 0.45> } finish { Plain }
}
quadric {  // y^2 - x^2 - z^2 = 0.12, two sheets
    <-1, 1, -1>, <0, 0, 0>, <0, 0, 0>, -0.12
    inverse
    clipped_by { Cut } rotate <15, 0, 10> translate <-2.6, -1.35, 0> pigment { rgb <0.35, 0.60, 0.85> } finish { Plain }
}
quadric {  // y = x z, the saddle that is also a bilinear patch
    <0, 0, 0>, <0, 1, 0>, <0, -1, 0>, 0
    clipped_by { Cut } rotate <-25, 35, 0> translate <0, -1.3, 0> pigment { rgb <0.70, 0.50, 0.85> } finish { Plain }
}
quadric {  // x^2 + z^2 = (y/2)^2, the double cone
    <1, -0.25, 1>, <0, 0, 0>, <0, 0, 0>, 0
    clipped_by { Cut } rotate <-10, 0, 20> translate <2.6, -1.3, 0> pigment { rgb <0.85, 0.55, 0.65> } finish { Plain }
}
