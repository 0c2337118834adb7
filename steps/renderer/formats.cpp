// rays-formats PATH WIDTH HEIGHT: writes a picture in any format of OpenImageIO. The pixels come from standard input:
// linear, four floats each, of which the fourth is ignored. What went wrong goes to standard output; nothing when all
// is well.
//
// A program of its own, since OpenImageIO takes 0.2 s to load, and since a render program that loads nothing starts in
// a third of the time.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace {

/// Not every writer of OpenImageIO notices that the disk is full.
std::string problem_of(const std::filesystem::path& written) {
    if (!std::filesystem::is_regular_file(written)) return "there is something else at " + written.string();
    OIIO::ImageBuf picture(written.string());
    return picture.read(0, 0, true) ? std::string()
                                    : "what was written cannot be read: is the disk full? " + picture.geterror();
}

std::string write_picture(const std::filesystem::path& target, int width, int height, std::vector<float>& rgba) {
    // Written under another name first: a full disk leaves no half picture.
    const auto partial = target.parent_path() / (target.stem().string() + ".partial" + target.extension().string());
    OIIO::ImageBuf linear(OIIO::ImageSpec(width, height, 4, OIIO::TypeDesc::FLOAT), rgba.data());
    const OIIO::ImageBuf rgb = OIIO::ImageBufAlgo::channels(linear, 3, {});
    OIIO::ImageBuf srgb = OIIO::ImageBufAlgo::colorconvert(rgb, "linear", "sRGB");
    srgb.set_write_format(OIIO::TypeDesc::UINT8);
    std::string problem;
    if (srgb.has_error() || !srgb.write(partial.string())) {
        problem = srgb.geterror();
        if (problem.empty()) problem = OIIO::geterror();
    } else {
        problem = problem_of(partial);
    }
    std::error_code failed;
    if (problem.empty()) {
        std::filesystem::rename(partial, target, failed);
        if (!failed) return {};
        problem = failed.message();
    }
    std::filesystem::remove(partial, failed);
    return problem;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4)
        return std::fputs("rays-formats is for render programs: rays-formats PATH WIDTH HEIGHT < PIXELS\n", stderr), 2;
    const int width = std::atoi(argv[2]), height = std::atoi(argv[3]);
    if (width < 1 || height < 1) return std::fputs("rays-formats: no such size\n", stderr), 2;
    std::vector<float> rgba(4 * std::size_t(width) * std::size_t(height));
    const bool whole = std::fread(rgba.data(), sizeof(float), rgba.size(), stdin) == rgba.size();
    const std::string problem = whole ? write_picture(argv[1], width, height, rgba) : "its pixels did not come";
    std::fputs(problem.c_str(), stdout);
    return problem.empty() ? 0 : 1;
}
