// Highlights: in front POV-Ray's phong, behind its specular (Blinn's half vector), with exponents 5, 20, 80 and 320 from
// left to right. The same exponent makes a specular highlight about twice as wide.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.4, 4.3, -9.5> right x*image_width/image_height up y angle 46 look_at <0.1, 0.55, 0> }
background { rgb <0.03, 0.035, 0.05> }
light_source { <-5, 7, -8>, rgb 0.95 }

plane { y, 0
    pigment { rgb <0.25, 0.27, 0.3> }
    finish { ambient 0.1 diffuse 0.6 }
}

#declare Column = 0;
#while (Column < 4)
    #declare Exponent = 5 * pow(4, Column);
    sphere { <-2.9 + 1.9*Column, 0.75, -1.1>, 0.75
        pigment { rgb <0.7, 0.13, 0.1> }
        finish { ambient 0.08 diffuse 0.6 phong 0.8 phong_size Exponent }
    }
    sphere { <-2.6 + 1.9*Column, 0.85, 1.6>, 0.85
        pigment { rgb <0.1, 0.3, 0.65> }
        finish { ambient 0.08 diffuse 0.6 specular 0.8 roughness 1/Exponent }
    }
    #declare Column = Column + 1;
#end
