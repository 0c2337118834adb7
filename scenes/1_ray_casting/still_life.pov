// The picture of step 1: every shape of the course on one table, shadows and all.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.16, 0.20, 0.28> }

camera { location <0.6, 3.4, -9.5> right x*4/3 up y look_at <0.1, 0.55, 0> angle 42 }
light_source { <-7, 10, -7>, rgb 0.85 }
light_source { <6, 5, -9>, rgb 0.25 shadowless }

#declare Plain = finish { ambient 0.14 diffuse 0.8 }

// The table and a wall.
plane { y, -1 pigment { checker rgb <0.80, 0.74, 0.64>, rgb <0.42, 0.34, 0.30> scale 1.1 translate <0.4, 0.5, 0.3> } finish { Plain } }
plane { -z, -5 pigment { rgb <0.45, 0.52, 0.62> } finish { Plain } }

// A column: box, cylinder, torus, sphere.
box { <-3.5, -1, 0.6>, <-2.1, -0.7, 2> pigment { rgb <0.75, 0.72, 0.68> } finish { Plain } }
cylinder { <-2.8, -0.7, 1.3>, <-2.8, 1.5, 1.3>, 0.42 pigment { rgb <0.85, 0.82, 0.78> } finish { Plain } }
torus { 0.45, 0.14 translate <-2.8, 1.52, 1.3> pigment { rgb <0.75, 0.72, 0.68> } finish { Plain } }
sphere { <-2.8, 2.15, 1.3>, 0.58 pigment { rgb <0.90, 0.45, 0.25> } finish { Plain } }

// A party hat, a bowl, a ring that leans on the bowl.
cone { <-1.1, -1, -0.9>, 0.6, <-0.95, 0.55, -0.9>, 0 pigment { rgb <0.85, 0.30, 0.35> } finish { Plain } }
quadric {
    <1, 0, 1>, <0, 0, 0>, <0, -1.2, 0>, 0
    clipped_by { plane { y, 0.85 } }
    rotate <-5, 0, 4>
    translate <0.35, -1, 0.9>
    pigment { rgb <0.35, 0.60, 0.75> } finish { Plain }
}
torus { 0.62, 0.1 rotate <70, 0, 28> translate <1.55, -0.35, -0.9> pigment { rgb <0.95, 0.78, 0.30> } finish { Plain } }

// A window: a polygon with holes, and a smooth pebble before it.
polygon {
    15,
    <0, 0>, <2.2, 0>, <2.2, 2.2>, <1.1, 3.1>, <0, 2.2>, <0, 0>,
    <0.25, 0.25>, <1.95, 0.25>, <1.95, 1.1>, <0.25, 0.25>,
    <0.3, 1.3>, <1.9, 1.3>, <1.1, 2.7>, <0.3, 2.0>, <0.3, 1.3>
    rotate 18*y
    translate <1.3, -1, 2.4>
    pigment { rgb <0.55, 0.42, 0.30> } finish { Plain }
}
sphere { 0, 1 scale <0.75, 0.3, 0.5> rotate 20*y translate <2.6, -0.7, -0.2> pigment { rgb <0.55, 0.65, 0.45> } finish { Plain } }

// A crystal of triangles and a saucer with a hole.
mesh {
    #for (I, 0, 4)
        #declare A = <0.45*cos(radians(72*I)), 0, 0.45*sin(radians(72*I))>;
        #declare B = <0.45*cos(radians(72*I + 72)), 0, 0.45*sin(radians(72*I + 72))>;
        triangle { A, B, <0.05, 0.9, 0> }
        triangle { A, B, <0, -0.4, 0> }
    #end
    translate <0.35, 0.45, 0.9>
    pigment { rgb <0.75, 0.60, 0.90> } finish { Plain }
}
disc { <0.35, -0.2, -2.2>, <0.25, 1, -0.3>, 0.55, 0.2 pigment { rgb <0.50, 0.80, 0.70> } finish { Plain } }
