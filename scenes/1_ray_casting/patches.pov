// Bicubic Bezier patches: a vase of twelve, and a cloth that folds over itself. POV-Ray cuts a patch into 2^8 x 2^8 x 2
// triangles whose distance from the true surface is far below a pixel. Catches patches without their limits u, v in
// [0, 1], a single Newton start that loses the far side, and twisted control points.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.90, 0.88, 0.84> }

camera { location <0, 2.2, -7.5> right x*4/3 up y look_at <0.1, 0, 0> angle 42 }
light_source { <-6, 9, -8>, rgb 0.95 shadowless }

#declare Plain = finish { ambient 0.3 diffuse 0.65 }
#declare K = 4/3*(sqrt(2) - 1);  // a quarter of a circle as a cubic

// A quarter of a ring of the vase between two heights: R and Y are the radius and height of the four control rows.
#macro Row(R, Y) <R, Y, 0>, <R, Y, R*K>, <R*K, Y, R>, <0, Y, R> #end
#macro Quarter(R0, Y0, R1, Y1, R2, Y2, R3, Y3, Turn)
    bicubic_patch {
        type 1 flatness 0 u_steps 8 v_steps 8
        Row(R0, Y0), Row(R1, Y1), Row(R2, Y2), Row(R3, Y3)
        rotate Turn*y
    }
#end
union {
    #for (I, 0, 3)
        Quarter(0.55, -1.6, 1.15, -1.4, 1.35, -0.7, 1.20, -0.1, 90*I)
        Quarter(1.20, -0.1, 1.05, 0.5, 0.40, 0.5, 0.42, 1.0, 90*I)
        Quarter(0.42, 1.0, 0.44, 1.3, 0.60, 1.5, 0.85, 1.6, 90*I)
    #end
    rotate <0, 20, 6>
    translate <-1.5, -0.1, 0>
    pigment { rgb <0.35, 0.55, 0.80> } finish { Plain }
}
bicubic_patch {
    type 1 flatness 0 u_steps 8 v_steps 8
    <-1.2, 0.6, -1.2>, <-0.4, 1.6, -1.4>, <0.4, -0.6, -1.4>, <1.2, 0.4, -1.2>,
    <-1.4, -0.4, -0.4>, <-0.4, 2.6, -0.4>, <0.4, 0.2, -0.4>, <1.6, -0.8, -0.4>,
    <-1.0, 0.2, 0.4>, <-0.4, -1.8, 0.4>, <0.6, 2.2, 0.4>, <1.2, 0.6, 0.4>,
    <-1.2, 0.8, 1.2>, <-0.4, 0.0, 1.4>, <0.4, 1.2, 1.2>, <1.3, -0.2, 1.3>
    rotate <-10, 25, 0>
    translate <1.6, -0.3, 0>
    pigment { rgb <0.85, 0.40, 0.30> } finish { Plain }
}
