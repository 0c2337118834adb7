// The eye stands inside a checkered sphere: the nearer root lies behind it and the farther one is seen. A small sphere
// floats in front. Catches taking only the smaller root, roots behind the eye, and normals not turned to the viewer.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <1, 0, 1> }  // must not be seen

camera { location <0.8, 0.3, -2.6> right x*4/3 up y direction z*0.8 }
light_source { <-1.2, 1.9, -0.8>, rgb 1 shadowless }

sphere {
    <0, 0, 0>, 4
    pigment { checker rgb <0.90, 0.86, 0.75>, rgb <0.30, 0.42, 0.55> scale 0.8 translate <0.13, 0.07, 0.11> }
    finish { ambient 0.15 diffuse 0.8 }
}
sphere { <-0.5, -0.4, 1.1>, 0.8 pigment { rgb <0.95, 0.45, 0.20> } finish { ambient 0.12 diffuse 0.85 } }
