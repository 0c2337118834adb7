// librays-formats.so: pictures in every format of OpenImageIO. Loading it costs 0.2 s, so render programs load it only
// when a picture is not an EXR.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <cstdio>
#include <filesystem>
#include <string>

/// `rgba`: linear, four floats a pixel of which the fourth is ignored. Null on success, else why not.
extern "C" const char* rays_write_picture(const char* path, int width, int height, const float* rgba) {
    static std::string problem;
    // Written under another name first: a full disk leaves no half picture.
    const std::filesystem::path target(path);
    const auto partial = target.parent_path() / (target.stem().string() + ".partial" + target.extension().string());
    OIIO::ImageBuf linear(OIIO::ImageSpec(width, height, 4, OIIO::TypeDesc::FLOAT), const_cast<float*>(rgba));
    const OIIO::ImageBuf rgb = OIIO::ImageBufAlgo::channels(linear, 3, {});
    OIIO::ImageBuf srgb = OIIO::ImageBufAlgo::colorconvert(rgb, "linear", "sRGB");
    srgb.set_write_format(OIIO::TypeDesc::UINT8);
    std::error_code failed;
    if (!srgb.has_error() && srgb.write(partial.string())) {
        std::filesystem::rename(partial, target, failed);
        if (!failed) return nullptr;
    }
    problem = failed ? failed.message() : srgb.geterror();
    std::filesystem::remove(partial, failed);
    return problem.c_str();
}
