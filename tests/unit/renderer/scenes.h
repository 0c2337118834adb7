// Small scenes as text, for tests.
#pragma once

#include <string>

#include "../films.h"
#include "renderer/render.h"
#include "scene_reader/scene_reader.h"

namespace rays::tests {

inline const std::string kHead =
    "#version 3.7; global_settings { assumed_gamma 1.0 }\n"
    "camera { location <0,1,-5> direction z right x*4/3 up y }\n"
    "background { rgb <0.1,0.2,0.3> }\n";

inline const std::string kBallOnFloor =
    kHead +
    "light_source { <3,5,-4> rgb 1 }\n"
    "sphere { <0,1,0>, 1 pigment { rgb <1,0.5,0.2> } finish { ambient 0.1 diffuse 0.6 phong 0.5 specular 0.2 } }\n"
    "plane { y, 0 pigment { checker rgb 1 rgb 0.2 } finish { ambient 0.1 diffuse 0.7 } }\n";

inline Scene staged(const std::string& text) {
    Scene scene = read_scene_text(text, "test");
    prepare(scene);
    return scene;
}

}  // namespace rays::tests
