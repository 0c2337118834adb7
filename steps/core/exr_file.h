// Pictures as EXR files.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/film.h"

namespace rays {

/// 32-bit floats.
class ExrFile final : public PictureFile {
public:
    /// Of the lanes that have a name, R, G and B as a rule. Throws InputError when it cannot be made, or when there is
    /// no room for it.
    ExrFile(std::string path, Raster raster, const std::vector<std::string>& lanes = {"R", "G", "B"});
    ~ExrFile() override;
    ExrFile(const ExrFile&) = delete;
    ExrFile& operator=(const ExrFile&) = delete;

    void take(const Film& lines, int first) noexcept override;
    void finish() override;

private:
    struct Channel {
        std::string name;
        int lane;
    };
    void begin(Raster raster);
    std::string header(Raster raster) const;
    void write(std::string_view bytes, std::uint64_t place) noexcept;
    [[noreturn]] void fail(int problem);

    std::string path_, partial_;
    std::vector<Channel> channels_;  ///< in the order of their names, as the format wants them
    std::uint64_t first_line_ = 0, line_bytes_ = 0;
    int file_ = -1;
    std::atomic<int> problem_{0};  ///< errno of the first failure
};

/// A whole film at once. Throws InputError when it cannot be written.
void write_exr(const Film& film, const std::string& path, const std::vector<std::string>& lanes = {"R", "G", "B"});

}  // namespace rays
