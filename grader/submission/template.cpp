#include "grader/submission/template.h"

#include <fmt/format.h>

namespace rays::grader {

std::string submission_template() {
    return R"({
    "version": 1,
    "pictures": [
        {"file": "pictures/still_life.png", "scene": "scenes/1_ray_casting/still_life.pov", "width": 320, "height": 240,
         "shows": ["spheres", "polygons", "shadows"]},
        {"file": "pictures/highlights.png", "scene": "scenes/2_phong/highlights.pov", "width": 320, "height": 240,
         "shows": ["phong", "specular"]},
        {"file": "pictures/depth_3.png", "scene": "scenes/3_recursion/depth_3.pov", "width": 320, "height": 240,
         "shows": ["reflection", "recursive_reflection"]}
    ]
}
)";
}

std::string report_template(const std::vector<SubmittedPicture>& pictures) {
    std::string text =
        "# Report\n\n## What I implemented\n\n(to be written: which shapes, which light, how deep the recursion goes, "
        "what was "
        "hard, and what does not work yet)\n\n## Pictures\n";
    for (const SubmittedPicture& p : pictures) {
        std::string features;
        for (const std::string& f : p.shows) features += (features.empty() ? "" : ", ") + f;
        const std::string name = std::filesystem::path(p.file).filename().string();
        const bool course = p.scene.starts_with("scenes/");
        text +=
            fmt::format("\n### {}\n\nShows {}. (to be written: where to look, and how you know that it is right)\n\n",
                        name, features.empty() ? "nothing yet" : features);
        text += fmt::format("```\n./rays render {}{} -o submission/{} --from student --width {} --height {}\n```\n",
                            course ? "" : "submission/", p.scene, p.file, p.raster.width, p.raster.height);
    }
    return text;
}

}  // namespace rays::grader
