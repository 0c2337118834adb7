// Scenes that are hard on structures, as text.
#pragma once

#include <string>
#include <vector>

#include "renderer/render.h"
#include "scene_reader/scene_reader.h"

namespace rays::tests {

inline Scene staged(const std::string& text) {
    Scene scene = read_scene_text(
        "#version 3.7; global_settings { assumed_gamma 1.0 }\n"
        "camera { location <0, 0, -10> look_at 0 }\n"
        "#declare R = seed(7);\n" +
            text,
        "test");
    prepare(scene);
    return scene;
}

struct HardScene {
    std::string name, text;
};

inline const std::vector<HardScene>& hard_scenes() {
    static const std::vector<HardScene> scenes{
        {"empty", ""},
        {"only_a_plane", "plane { y, 0 }\n"},
        {"one_sphere", "sphere { <1, 2, 3>, 0.5 }\n"},
        {"spheres",
         "#for (I, 1, 400) sphere { <rand(R), rand(R), rand(R)> * 10, 0.05 + 0.4 * rand(R) } #end plane { y, -1 }\n"},
        {"triangles",
         "mesh { #for (I, 1, 300) #local P = <rand(R), rand(R), rand(R)> * 10;\n"
         "triangle { P, P + <rand(R), rand(R), rand(R)>, P + <rand(R), rand(R), -rand(R)> } #end }\n"
         "#for (I, 1, 40) #local P = <rand(R), rand(R), rand(R)> * 10;\n"
         "triangle { P, P + <rand(R), 0, rand(R)>, P + <rand(R), rand(R), -rand(R)> translate x } #end\n"},
        {"mixed",
         "#for (I, 1, 12) #local P = <rand(R), rand(R), rand(R)> * 8;\n"
         "union { box { 0, <1, 0.5, 0.3> rotate <20, 30 * I, 10> } torus { 0.6, 0.2 rotate 40 * x * I scale <1, 2, "
         "0.5> }\n"
         "cone { 0, 0.4, <1, 1, 0>, 0.1 open } cylinder { 0, y, 0.2 } disc { <0, 2, 0>, <1, 1, 0.2>, 0.7, 0.2 }\n"
         "sphere { 0, 1 clipped_by { box { -0.4, 2 } } } sphere { 0, 0.8 scale <1, 0.1, 2> rotate 33 * z }\n"
         "polygon { 4, <0, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0, 0, 0> rotate 70 * y }\n"
         "quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -0.3 clipped_by { box { -0.5, 0.5 } } }\n"
         "bicubic_patch { type 1 flatness 0 u_steps 3 v_steps 3 "
         "<0,0,0>,<1,0,1>,<2,0,0>,<3,0,0>,<0,1,0>,<1,1,1>,<2,1,0>,<3,1,1>,\n"
         "<0,2,0>,<1,2,1>,<2,2,2>,<3,2,0>,<0,3,0>,<1,3,0>,<2,3,0>,<3,3,1> scale 0.3 }\n"
         "translate P } #end quadric { <1, 0, 1>, <0, 0, 0>, <0, 0, 0>, -0.05 } plane { <1, 2, 0.5>, -2 }\n"},
        {"cut_open",
         "#for (I, 1, 40) #local P = <rand(R), rand(R), rand(R)> * 6;\n"
         "#local C = <rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>;\n"
         "sphere { P, 1 clipped_by { plane { C, vdot(P, vnormalize(C)) + rand(R) - 0.5 } } }\n"
         "cone { P, 0.8, P + <0, 1.5, 0.3>, 0.2 clipped_by { plane { C, vdot(P, vnormalize(C)) inverse } } }\n"
         "torus { 0.8, 0.2 clipped_by { plane { C, 0.1 } plane { <C.z, 1, C.x>, 0.2 } } rotate 60 * I * C translate P "
         "}\n"
         "box { P, P + 1 clipped_by { plane { x, 0 rotate 90 * C translate P + 0.5 } plane { y, P.y + 0.7 } } }\n"
         "sphere { P + 3, 0.3 clipped_by { plane { C, -20 } } } #end\n"},
        {"teapot_in_a_stadium",
         "plane { y, 0 } #for (I, 0, 35) cylinder { <3000, 0, 0>, <3000, 400, 0>, 50 rotate 10 * I * y } #end\n"
         "polygon { 5, <-5000, -1, -5000>, <5000, -1, -5000>, <5000, -1, 5000>, <-5000, -1, 5000>, <-5000, -1, -5000> "
         "}\n"
         "mesh { #for (I, 0, 15) #for (J, 0, 15) #local P = <I / 16, 0.2 + 0.1 * sin(I) * cos(J), J / 16>;\n"
         "triangle { P, P + <0.07, 0, 0>, P + <0, 0.02, 0.07> } #end #end }\n"},
        {"coincident_spheres", "#for (I, 1, 300) sphere { <1, 2, 3>, 0.5 } #end\n"},
        {"coincident_triangles", "mesh { #for (I, 1, 100) triangle { 0, x, y } #end }\n"},
        {"tiles",
         "#for (I, 0, 15) #for (J, 0, 15) polygon { 5, <I, 0, J>, <I + 1, 0, J>, <I + 1, 0, J + 1>, <I, 0, J + 1>, <I, "
         "0, J> } #end #end\n"},
        {"boxes_face_to_face", "#for (I, 0, 7) #for (J, 0, 7) box { <I, 0, J>, <I + 1, 1, J + 1> } #end #end\n"},
        {"nested_spheres", "#for (I, 1, 1000) sphere { 0, I / 100 } #end\n"},
        {"nested_off_centre", "#for (I, 1, 600) sphere { <I / 700, I / 900, 0>, I / 300 } #end\n"},
        {"on_a_line", "#for (I, 1, 300) sphere { <I, I, I>, 0.7 } #end\n"},
        {"far_away", "#for (I, 1, 200) sphere { <1e7, -1e7, 1e7> + <rand(R), rand(R), rand(R)> * 10, 0.4 } #end\n"},
        {"large", "#for (I, 1, 200) sphere { <rand(R), rand(R), rand(R)> * 1e7, 4e5 * rand(R) + 1 } #end\n"},
        {"tiny", "#for (I, 1, 200) sphere { <rand(R), rand(R), rand(R)> * 1e-4, 1e-5 * rand(R) + 1e-7 } #end\n"},
        {"large_and_tiny",
         "sphere { <1e6, 0, 0>, 1e5 } #for (I, 1, 200) sphere { <rand(R), rand(R), rand(R)>, 0.1 * rand(R) } #end\n"},
        {"shadowless_half",
         "#for (I, 1, 200) sphere { <rand(R), rand(R), rand(R)> * 5, 0.3 #if (mod(I, 2)) no_shadow #end } #end\n"},
        {"torn_meshes",  // a face that is certainly there, were it not for its clip or for its back
         "#for (I, 1, 30) #local P = <rand(R), rand(R), rand(R)> * 6;\n"
         "#local C = <rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>;\n"
         "mesh { #for (J, 0, 9) #local A = <rand(R), rand(R), rand(R)> * 2;\n"
         "triangle { P + A, P + A + <rand(R), 0.2, 0>, P + A + <0, rand(R), rand(R)> } #end\n"
         "clipped_by { plane { C, vdot(P + 1, vnormalize(C)) } } }\n"
         "triangle { P, P + <2, 0, 0.3>, P + <0, 2, rand(R)> clipped_by { plane { C, vdot(P, vnormalize(C)) + 0.3 } } "
         "}\n"
         "mesh { triangle { P, P + x, P + y } triangle { P, P + y, P + z } triangle { P, P + z, P + x }\n"
         "triangle { P + x, P + z, P + y } } #end\n"},
    };
    return scenes;
}

}  // namespace rays::tests
