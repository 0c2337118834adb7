#include "tools.h"

#include <algorithm>
#include <fstream>

#include "core/exr_file.h"

namespace rays::grader {

namespace fs = std::filesystem;

RgbImage test_picture(int width, int height) {
    RgbImage picture{{width, height}, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float u = float(x) / float(width), v = float(y) / float(height);
            const bool right = x >= width / 3;
            picture.pixels.push_back(
                {0.1f + 0.5f * u * v, right ? 0.9f - 0.3f * v : 0.2f + 0.1f * v, 0.3f + 0.2f * u * u});
        }
    }
    return picture;
}

Reference test_reference(const RgbImage& picture, int edge) {
    Reference reference{picture, picture, picture};
    for (int y = 0; y < picture.raster.height; ++y) {
        for (const int x : {edge - 1, edge}) {
            for (std::size_t c = 0; c < 3; ++c) {
                const float a = picture.at(edge - 1, y)[c], b = picture.at(edge, y)[c];
                reference.min.at(x, y)[c] = std::min(a, b);
                reference.max.at(x, y)[c] = std::max(a, b);
            }
        }
    }
    return reference;
}

std::string exr_bytes(const RgbImage& picture) {
    Film film(picture.raster);
    for (int y = 0; y < picture.raster.height; ++y)
        for (int x = 0; x < picture.raster.width; ++x)
            film.at(x, y) = Radiance(picture.at(x, y)[0], picture.at(x, y)[1], picture.at(x, y)[2]);
    const TemporaryFolder folder;
    write_exr(film, (folder.path() / "x.exr").string());
    return read_file(folder.path() / "x.exr");
}

fs::path script(const TemporaryFolder& folder, const std::string& text) {
    const fs::path file = folder.path() / "script.sh";
    std::ofstream(file) << "#!/bin/sh\n" << text << '\n';
    fs::permissions(file, fs::perms::owner_all);
    return file;
}

}  // namespace rays::grader
