#include "grader/picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace rays::grader {

DecodedPicture decode_exr(const std::string& bytes, int width, int height) {
    DecodedPicture result;
    result.problem = exr_header_problem(bytes, width, height);
    if (!result.problem.empty()) return result;
    try {
        OIIO::Filesystem::IOMemReader memory(static_cast<const void*>(bytes.data()), bytes.size());
        auto input = OIIO::ImageInput::open("student.exr", nullptr, &memory);
        RgbImage picture{{width, height},
                         std::vector<Rgb>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
        const bool good = input && input->spec().width == width && input->spec().height == height &&
                          input->spec().nchannels >= 3 &&
                          input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, picture.pixels.data());
        if (good)
            result.picture = std::move(picture);
        else
            result.problem = "is damaged: its pixels cannot be read";
        OIIO::geterror();  // forget what was said: the problem is known
    } catch (const std::exception&) {
        result.problem = "is damaged: its pixels cannot be read";
    }
    return result;
}

}  // namespace rays::grader
