// Metal: the highlight takes the surface's colour, less so where light grazes. Four materials with plastic's white
// highlight (left), half metallic (middle) and metallic (right); a low light from the left shows the whitening rim.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.6, 2.2, -9> right x*image_width/image_height up y angle 42 look_at <0.1, 1.55, 0> }
background { rgb <0.02, 0.02, 0.025> }
light_source { <6, 7, -7>, rgb 0.7 }
light_source { <-9, 2, 3>, rgb <0.75, 0.8, 0.9> }

#macro Row(Y, Paint)
    #local Column = 0;
    #while (Column < 3)
        sphere { <-1.9 + 1.9*Column, Y, 0.4*Y>, 0.82
            pigment { rgb Paint }
            finish { ambient 0.06 diffuse 0.35 phong 0.5 phong_size 25 specular 0.4 roughness 0.02 metallic Column/2 }
        }
        #local Column = Column + 1;
    #end
#end

Row(0.75, <0.9, 0.55, 0.12>)
Row(2.45, <0.75, 0.28, 0.16>)
plane { y, -0.07
    pigment { rgb <0.16, 0.17, 0.2> }
    finish { ambient 0.1 diffuse 0.7 }
}
