// Pictures on disk, by extension.
#pragma once

#include <memory>
#include <string>

#include "core/film.h"

namespace rays {

/// .exr: linear 32-bit floats, written as they come. Anything else that OpenImageIO knows (.png, .jpg, ...): sRGB, 8
/// bits. The part that knows OpenImageIO is loaded only then. Throws InputError when the file cannot be made; whether
/// the format is known is seen in the end.
std::unique_ptr<PictureFile> make_picture_file(const std::string& path, const Raster& raster);

}  // namespace rays
