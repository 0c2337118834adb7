// Boxes in three positions, one seen from inside, and discs with holes like a planet's ring. Catches a slab test that
// divides zero by zero, the wrong face's normal, and a hole that is filled.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <1, 0, 1> }  // must not be seen: the room is closed

camera { location <0.3, 1.4, -6.2> right x*4/3 up y look_at <0, 0.4, 0> angle 56 }
light_source { <-2.5, 3.6, -4>, rgb 1 shadowless }

#declare Plain = finish { ambient 0.15 diffuse 0.8 }

// The room.
box {
    <-4, -1.5, -7>, <4, 4, 4>
    pigment { checker rgb <0.62, 0.60, 0.58>, rgb <0.50, 0.50, 0.54> scale 1.1 translate <0.35, 0.27, 0.41> }
    finish { Plain }
}
box { <-0.8, -0.8, -0.8>, <0.8, 0.8, 0.8> rotate <0, 35, 0> translate <-1.9, -0.7, 0.4> pigment { rgb <0.85, 0.35, 0.25> } finish { Plain } }
box { <-0.55, -0.55, -0.55>, <0.55, 0.55, 0.55> rotate <45, 0, 35.26> translate <-1.9, 1.05, 0.4> pigment { rgb <0.95, 0.75, 0.30> } finish { Plain } }
box { <2.3, -1.5, -0.6>, <3.1, 0.9, 0.2> pigment { rgb <0.35, 0.55, 0.80> } finish { Plain } }
// A planet with two rings, and a plain disc that closes nothing.
sphere { <0.7, 0.6, 0.6>, 0.6 pigment { rgb <0.90, 0.80, 0.60> } finish { Plain } }
disc { <0.7, 0.6, 0.6>, <0.25, 1, -0.35>, 1.30, 0.85 pigment { rgb <0.80, 0.65, 0.45> } finish { Plain } }
disc { <0.7, 0.6, 0.6>, <0.25, 1, -0.35>, 1.65, 1.40 pigment { rgb <0.65, 0.55, 0.50> } finish { Plain } }
disc { <2.7, 1.9, -0.2>, <-0.3, 0.2, -1>, 0.6 pigment { rgb <0.45, 0.75, 0.50> } finish { Plain } }
