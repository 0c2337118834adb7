// Mirror balls on a lattice: every ray that enters is shuffled from ball to ball.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 adc_bailout 0 }
camera { location <3.1, 2.4, -7.2> right x*image_width/image_height up y angle 40 look_at <0, 0, 0> }
background { rgb <0.7, 0.8, 0.95> }
light_source { <-5, 9, -7>, rgb 0.7 }
#declare X = -2;
#while (X <= 2)
    #declare Y = -2;
    #while (Y <= 2)
        #declare Z = -2;
        #while (Z <= 2)
            sphere { <X, Y, Z>, 0.33 pigment { rgb <0.5 + 0.2*X, 0.5 + 0.2*Y, 0.5 + 0.2*Z> } finish { ambient 0.05 diffuse 0.3 reflection { 0.65 } } }
            #declare Z = Z + 1;
        #end
        #declare Y = Y + 1;
    #end
    #declare X = X + 1;
#end
