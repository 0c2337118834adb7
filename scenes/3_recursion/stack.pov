// A stack of thin sheets, filter above, transmit below: light behind is tinted by filter and not by transmit, the
// sheet's own light fades with both. Straight rays are no levels: eight sheets show what is behind at level 2.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 adc_bailout 0 }
camera { location <-2.5, 1.8, -7> right x*image_width/image_height up y angle 40 look_at <0.2, 1, 0> }
background { rgb <0.8, 0.85, 0.9> }
light_source { <-6, 7, -7>, rgb 1 }
plane { y, 0 pigment { checker rgb 0.9, rgb 0.35 } finish { ambient 0.2 diffuse 0.7 } }
sphere { <0.6, 1, 3>, 0.9 pigment { rgb <0.9, 0.4, 0.1> } finish { ambient 0.2 diffuse 0.7 phong 0.5 } }
#declare I = 0;
#while (I < 4)
    box { <-0.9, 1.05, 0>, <1.3 - 0.3*I, 2, 0.02> pigment { rgbf <0.9 - 0.1*I, 0.5 + 0.1*I, 0.3, 0.85> } finish { ambient 0.1 diffuse 0.5 } translate <0, 0, 0.4*I> }
    polygon { 5, <-0.9, 0.05>, <1.3 - 0.3*I, 0.05>, <1.3 - 0.3*I, 0.95>, <-0.9, 0.95>, <-0.9, 0.05>
        pigment { rgbt <0.2, 0.4 + 0.1*I, 0.9, 0.6> } finish { ambient 0.1 diffuse 0.5 } translate <0, 0, 0.4*I> }
    #declare I = I + 1;
#end
