// Cones of light: a soft spotlight, a hard one, a tight one, and a cylinder of parallel rays, each on its own spot. Behind
// each spotlight there is no light at all.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 6.5, -9> right x*image_width/image_height up y angle 48 look_at <0.2, 0.6, 0.6> }
light_source { <-4.5, 5, -3>, rgb <1, 0.75, 0.4> spotlight radius 6 falloff 24 point_at <-3, 0, 0> }
light_source { <-0.5, 5, 3.5>, rgb <0.5, 0.95, 0.6> spotlight radius 15 falloff 16 point_at <-0.6, 0, 1.2> }
light_source { <2, 5, -4>, rgb <0.5, 0.7, 1> spotlight radius 0 falloff 40 tightness 25 point_at <1.2, 0, -1.1> }
light_source { <5, 6, 3>, rgb <1, 0.5, 0.75> cylinder radius 0.6 falloff 1.3 tightness 0.5 point_at <3, 0, 0.6> }

plane { y, 0
    pigment { checker rgb <0.95, 0.92, 0.85> rgb <0.6, 0.62, 0.7> scale 0.8 }
    finish { ambient 0.04 diffuse 0.9 }
}
plane { z, 4.2
    pigment { rgb <0.8, 0.8, 0.85> }
    finish { ambient 0.04 diffuse 0.9 }
}
#macro Peg(X, Z, R)
    cylinder { <X, 0, Z>, <X, 2.2*R, Z>, R
        pigment { rgb 0.9 }
        finish { ambient 0.04 diffuse 0.8 phong 0.3 }
    }
#end
Peg(-3.2, 0.2, 0.35)
Peg(-0.9, 1.5, 0.3)
Peg(1.3, -1.2, 0.25)
Peg(2.8, 0.9, 0.4)
