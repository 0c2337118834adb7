// Parallel rays: equal boxes look equally large at any distance, and the stair goes on without a vanishing point.
// Catches rays that still start in one point and directions that still fan out.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.93, 0.90, 0.84> }

camera { orthographic location <10, 8.5, -10> right x*8*4/3 up y*8 look_at <-0.2, -0.6, -0.6> }
light_source { <9, 16, -4>, rgb 0.95 shadowless }

#declare Plain = finish { ambient 0.2 diffuse 0.75 }

#for (I, 0, 6)
    box {
        <-0.5, -2.5, -0.5>, <0.5, -1.6 + 0.5*I, 0.5>
        translate <3 - I, 0, 0>
        pigment { rgb <0.90 - 0.06*I, 0.55 + 0.03*I, 0.35 + 0.08*I> } finish { Plain }
    }
#end
#for (I, 0, 4)
    sphere { <2.4 - 0.4*I, -2.05, -1.5 - 0.9*I>, 0.45 pigment { rgb <0.35, 0.50 + 0.08*I, 0.75> } finish { Plain } }
#end
cylinder { <-3.6, -2.5, -2.4>, <-3.6, -0.6, -2.4>, 0.7 pigment { rgb <0.75, 0.45, 0.40> } finish { Plain } }
plane { y, -2.5 pigment { rgb <0.80, 0.78, 0.74> } finish { Plain } }
