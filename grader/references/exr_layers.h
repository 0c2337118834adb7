// Pictures as layers of one OpenEXR file: what all kinds of references share.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "references/reference.h"

namespace rays {

/// A layer's name with its dot ("" is the picture itself, with the channels R G B) -> the image that receives it.
using LayersRead = std::vector<std::pair<std::string, RgbImage*>>;
using LayersWritten = std::vector<std::pair<std::string, const RgbImage*>>;

enum class Digits { half, single };

/// All images get the file's size. Throws InputError when the file is missing, lacks a channel, is not readable or is
/// larger than 4096 pixels in one direction.
void load_layers(const std::filesystem::path& file, const LayersRead& layers);

/// All images must have the size of the first. Compressed without loss; appears whole or not at all.
void save_layers(const std::filesystem::path& file, const LayersWritten& layers, Digits digits);

}  // namespace rays
