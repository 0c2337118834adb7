// The gallery's picture of step 1: every shape of the course in one garden, with the plainest of light.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.4, 3.3, -13> right x*image_width/image_height up y angle 56 look_at <0.1, 2.25, 0> }
background { rgb <0.72, 0.53, 0.45> }
light_source { <-140, 120, -100>, rgb <1.0, 0.84, 0.64> }
light_source { <100, 90, -120>, rgb <0.14, 0.18, 0.28> shadowless }
light_source { <0, -6, -10>, rgb <0.1, 0.06, 0.06> shadowless }

#declare Plain = finish { ambient rgb <0.12, 0.13, 0.17> diffuse 0.82 }
#declare Sand = pigment { rgb <0.8, 0.6, 0.42> }
#declare Chalk = pigment { rgb <0.93, 0.88, 0.8> }
#declare Coral = pigment { rgb <0.87, 0.28, 0.2> }
#declare Petrol = pigment { rgb <0.05, 0.27, 0.34> }
#declare Sea = pigment { rgb <0.24, 0.56, 0.56> }
#declare Mustard = pigment { rgb <0.93, 0.6, 0.12> }
#declare Plum = pigment { rgb <0.32, 0.15, 0.29> }

// Ground, the sun that has set behind it, and terraces.
plane { y, 0 pigment { Sand } finish { Plain } }
disc { <3.6, 2.6, 16>, z, 6.2 pigment { rgb <0.98, 0.42, 0.2> } finish { ambient 0.9 diffuse 0.1 } }
#for (I, 0, 3)
    cylinder { <-0.4, 0.14*I, 2.2>, <-0.4, 0.14*(I + 1), 2.2>, 4.6 - 0.75*I pigment { Chalk } finish { Plain } }
#end

// The large ring, and what it holds.
torus { 1.75, 0.3 rotate 90*x rotate 18*y translate <-0.4, 2.6, 2.2> pigment { Coral } finish { Plain } }
sphere { <-0.4, 2.6, 2.2>, 0.85 pigment { Mustard } finish { Plain } }

// Columns and their capitals.
#macro Column(X, Z, Height, Paint)
    union {
        box { <-0.45, 0, -0.45>, <0.45, 0.2, 0.45> }
        cylinder { <0, 0.2, 0>, <0, Height, 0>, 0.3 }
        cone { <0, Height, 0>, 0.3, <0, Height + 0.35, 0>, 0.52 }
        torus { 0.3, 0.08 translate 0.2*y }
        pigment { Paint } finish { Plain } translate <X, 0, Z>
    }
#end
Column(-4.9, 2.6, 4.1, pigment { Petrol })
Column(-3.9, 0.4, 2.3, pigment { Sea })
Column(4.3, 2.8, 2.9, pigment { Petrol })
sphere { <-4.9, 4.95, 2.6>, 0.5 pigment { Coral } finish { Plain } }
// A bowl (a paraboloid), clipped, on the second column.
quadric { <1, 0, 1>, <0, 0, 0>, <0, -0.55, 0>, 0 clipped_by { plane { y, 0.95 } } translate <-3.9, 2.65, 0.4> pigment { Mustard } finish { Plain } }

// A cooling tower: a hyperboloid between two planes.
quadric { <1, -0.28, 1>, <0, 0, 0>, <0, 0, 0>, -0.2
    clipped_by { box { <-3, -1.2, -3>, <3, 1.1, 3> } } translate <2.75, 1.2, 0.3> pigment { Chalk } finish { Plain } }
sphere { <2.75, 2.55, 0.3>, 0.45 pigment { Plum } finish { Plain } }

// A flying cloth of four patches' kind: one Bezier patch.
bicubic_patch { type 1 flatness 0.001 u_steps 5 v_steps 5
    <-2.2, 0.7, 0>, <-0.8, 2.2, 0.2>, <0.8, -0.7, -0.2>, <2.2, 0.7, 0>,
    <-2.0, 0.2, 0.8>, <-0.8, 1.5, 0.9>, <0.8, -0.9, 0.8>, <2.2, 0.5, 0.8>,
    <-2.1, 0.9, 1.6>, <-0.8, 2.4, 1.6>, <0.8, -0.3, 1.6>, <2.1, 1.0, 1.6>,
    <-1.9, 0.4, 2.4>, <-0.7, 1.8, 2.4>, <0.9, -0.6, 2.4>, <2.3, 0.7, 2.4>
    rotate <-22, -24, -10> translate <2.6, 4.2, 1.2> pigment { Sea } finish { Plain } }

// In front: a star (a polygon with a hole), a cone, a tetrahedron of triangles, a pebble (an ellipsoid), steps.
polygon { 16,
    #for (I, 0, 10) <(mod(I, 2) = 0 ? 0.85 : 0.42)*sin(pi*I/5), (mod(I, 2) = 0 ? 0.85 : 0.42)*cos(pi*I/5), 0>, #end
    <0.2, 0.2, 0>, <0.2, -0.2, 0>, <-0.2, -0.2, 0>, <-0.2, 0.2, 0>, <0.2, 0.2, 0>
    rotate <12, 24, 8> translate <4.75, 0.8, -1.2> pigment { Coral } finish { Plain } }
cone { <-2.1, 0, -2.3>, 0.62, <-2.1, 1.55, -2.3>, 0 pigment { Plum } finish { Plain } }
mesh {
    triangle { <0, 0, -0.7>, <0.6, 0, 0.35>, <0, 1, 0> } triangle { <0.6, 0, 0.35>, <-0.6, 0, 0.35>, <0, 1, 0> }
    triangle { <-0.6, 0, 0.35>, <0, 0, -0.7>, <0, 1, 0> }
    scale 1.1 rotate 40*y translate <1.5, 0, -3.1> pigment { Mustard } finish { Plain } }
sphere { 0, 1 scale <0.7, 0.3, 0.45> rotate 20*y translate <-0.5, 0.3, -3.6> pigment { Petrol } finish { Plain } }
torus { 0.38, 0.13 rotate <62, 0, -20> translate <-3.65, 0.44, -2.1> pigment { Chalk } finish { Plain } }
#for (I, 0, 3)
    box { <-0.35, 0, -0.35>, <0.35, 0.28*(I + 1), 0.35> rotate -14*y translate <3.0 + 0.63*I, 0, -3.1 + 0.22*I> pigment { rgb <0.24 + 0.17*I, 0.56 - 0.06*I, 0.56 - 0.1*I> } finish { Plain } }
#end
