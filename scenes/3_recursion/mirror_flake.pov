// A sphereflake of mirrors, three generations: rays bounce between small spheres, where an error of one bounce grows
// with the next. A tracer in float is off at one pixel in a hundred here.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 7 adc_bailout 0 }
camera { location <2.2, 1.8, -4.6> right x*image_width/image_height up y angle 36 look_at <0, 0.05, 0> }
background { rgb <0.2, 0.3, 0.5> }
light_source { <-4, 7, -6>, rgb 0.8 }
light_source { <6, 4, -3>, rgb 0.4 }
plane { y, -1.6 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.4, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.6 } }
#declare Shiny = texture { pigment { rgb <0.8, 0.75, 0.6> } finish { ambient 0.02 diffuse 0.15 phong 0.7 phong_size 80 reflection { 0.75 } } }
#macro Flake(Radius, Generation)
    sphere { 0, Radius texture { Shiny } }
    #if (Generation > 0)
        #local I = 0;
        #while (I < 9)
            #local Around = (I < 6 ? 60*I : 120*(I - 6) + 30);
            #local Down = (I < 6 ? 90 : 35);
            #if (Generation = 1) sphere { 0, Radius/3 texture { Shiny } #else union { Flake(Radius/3, Generation - 1) #end
                translate 4/3*Radius*y rotate Down*x rotate Around*y }
            #local I = I + 1;
        #end
    #end
#end
union { Flake(1, 3) rotate <10, 15, 0> }
