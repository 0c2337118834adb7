// Pictures on disk, by extension.
#pragma once

#include <string>

#include "core/film.h"

namespace rays {

/// .exr: linear 32-bit floats. Anything else that OpenImageIO knows (.png, .jpg, ...): sRGB, 8 bits. The part that
/// knows OpenImageIO is loaded only then. Throws InputError when the format is unknown or the file cannot be written.
void write_picture(const Film& film, const std::string& path);

}  // namespace rays
