// Shadows, and where there is none: the gold ball stands between lamp and floor, the blue ball beyond the lamp, the green
// one has no_shadow, and the ring touches the floor, in its own shadow. Only gold and ring shade.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <-1.4, 4.6, -9.5> right x*image_width/image_height up y angle 44 look_at <0, 1.75, 0> }
background { rgb <0.04, 0.05, 0.08> }
light_source { <0, 3.2, 0>, rgb 0.9 fade_distance 4 fade_power 1 }

box { <-4, -0.2, -4>, <4, 0, 4>
    pigment { checker rgb <0.9, 0.87, 0.8> rgb <0.7, 0.68, 0.65> }
    finish { ambient 0.12 diffuse 0.75 }
}
sphere { <-1.15, 1.7, -0.6>, 0.42
    pigment { rgb <0.95, 0.7, 0.2> }
    finish { ambient 0.12 diffuse 0.65 phong 0.6 phong_size 50 }
}
sphere { <0.5, 4.2, 0.3>, 0.5
    pigment { rgb <0.25, 0.4, 0.9> }
    finish { ambient 0.12 diffuse 0.65 phong 0.6 phong_size 50 }
}
sphere { <1.5, 1.5, -0.8>, 0.45
    pigment { rgb <0.3, 0.8, 0.35> }
    finish { ambient 0.12 diffuse 0.65 phong 0.6 phong_size 50 }
    no_shadow
}
torus { 0.85, 0.3
    rotate -70*x
    translate <0.7, 1.08, 2.2>
    pigment { rgb <0.85, 0.35, 0.3> }
    finish { ambient 0.12 diffuse 0.65 phong 0.5 phong_size 40 }
}
