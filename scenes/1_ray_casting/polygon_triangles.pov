// A fan of triangles about one point and a concave polygon behind it: edges are shared, nothing shines through. The
// background is glaring, so that a leak is seen. Catches t or weights compared with the wrong sign, and lost edges.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <3, 0, 3> }

camera { location <0.4, 1.2, -5> right x*4/3 up y look_at <0, 0, 0> angle 50 }
light_source { <-4, 6, -6>, rgb 1 shadowless }

#declare Plain = finish { ambient 0.15 diffuse 0.8 }

// A paper fan: 12 folds, every other one pulled forward.
#for (I, 0, 11)
    #declare A = radians(30*I);
    #declare B = radians(30*(I + 1));
    #declare Near = mod(I, 2)*0.5 - 0.5;
    triangle {
        <0, 0, -0.6>, <1.8*cos(A), 1.8*sin(A), Near>, <1.8*cos(B), 1.8*sin(B), -0.5 - Near>
        pigment { rgb <0.55 + 0.4*cos(A), 0.6 + 0.3*sin(A), 0.75 - 0.2*cos(A)> } finish { Plain }
    }
#end

// A curtain of triangles that covers the rest.
#for (I, -4, 4)
    triangle { <I, -4, 1>, <I + 1, -4, 1.4>, <I, 4, 1> pigment { rgb <0.25, 0.27, 0.35> } finish { Plain } }
    triangle { <I + 1, -4, 1.4>, <I + 1, 4, 1.4>, <I, 4, 1> pigment { rgb <0.30, 0.32, 0.40> } finish { Plain } }
    triangle { <I + 1, -4, 1.4>, <I + 1, 4, 1.4>, <I + 1, 4, 1> pigment { rgb <0.22, 0.24, 0.30> } finish { Plain } }
    triangle { <I + 1, -4, 1.4>, <I + 1, -4, 1>, <I + 1, 4, 1> pigment { rgb <0.22, 0.24, 0.30> } finish { Plain } }
#end
triangle { <-4, -4, 1>, <-9, -4, 1>, <-4, 9, 1> pigment { rgb <0.30, 0.32, 0.40> } finish { Plain } }
