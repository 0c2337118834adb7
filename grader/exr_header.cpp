// The header of an OpenEXR file, read strictly ("OpenEXR File Layout", openexr.com).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>

#include "grader/picture.h"

namespace rays::grader {
namespace {

constexpr std::uint32_t kMagic = 20000630;
constexpr std::uint32_t kVersionMask = 0xff, kLongNames = 0x400;
constexpr std::size_t kNameLimit = 255;
constexpr int kMostAttributes = 256;

/// Little-endian bytes, taken in order; empty once they run out.
class Bytes {
public:
    explicit Bytes(std::string_view bytes) : rest_(bytes) {}
    std::optional<std::uint32_t> u32() {
        if (rest_.size() < 4) return {};
        std::uint32_t v = 0;
        for (int i = 3; i >= 0; --i) v = v << 8 | static_cast<unsigned char>(rest_[static_cast<std::size_t>(i)]);
        rest_.remove_prefix(4);
        return v;
    }
    std::optional<std::string_view> name() {
        const auto end = rest_.substr(0, kNameLimit + 1).find('\0');
        if (end == std::string_view::npos) return {};
        const auto text = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return text;
    }
    std::optional<std::string_view> take(std::size_t count) {
        if (rest_.size() < count) return {};
        const auto bytes = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return bytes;
    }

private:
    std::string_view rest_;
};

struct Window {
    std::int64_t width = 0, height = 0;
};

std::optional<Window> window(std::string_view value) {
    Bytes in(value);
    std::int64_t corner[4];
    for (auto& c : corner) {
        const auto v = in.u32();
        if (!v) return {};
        c = static_cast<std::int32_t>(*v);
    }
    return Window{corner[2] - corner[0] + 1, corner[3] - corner[1] + 1};
}

// name\0 type(4) linear(1) reserved(3) xSampling(4) ySampling(4), ended by an empty name
std::string channel_problem(std::string_view value, const ChannelNames& wanted) {
    Bytes in(value);
    std::set<std::string, std::less<>> names;
    for (;;) {
        const auto name = in.name();
        if (!name) return "its channel list is cut off";
        if (name->empty()) break;
        const auto type = in.u32(), flags = in.u32(), x = in.u32(), y = in.u32();
        if (!type || !flags || !x || !y) return "its channel list is cut off";
        if (*type != 1 && *type != 2) return "its channels are not floating point numbers";
        if (*x != 1 || *y != 1) return "its channels are subsampled";
        names.emplace(*name);
    }
    const bool all =
        std::all_of(wanted.begin(), wanted.end(), [&](const auto& name) { return names.count(name) == 1; });
    if (all && names.size() <= wanted.size() + 1) return {};
    return fmt::format("its channels are not {}", fmt::join(wanted, ", "));
}

}  // namespace

std::string exr_header_problem(std::string_view bytes, int width, int height, const ChannelNames& channel_names) {
    Bytes in(bytes);
    const auto magic = in.u32(), version = in.u32();
    if (!magic || *magic != kMagic) return "is not an OpenEXR file";
    if (!version || (*version & kVersionMask) != 2 || (*version & ~(kVersionMask | kLongNames)) != 0)
        return "is not a plain OpenEXR file (one part of scan lines)";
    std::optional<Window> data, display;
    bool channels = false;
    for (int i = 0; i < kMostAttributes; ++i) {
        const auto name = in.name();
        if (!name) break;
        if (name->empty()) {
            if (!data || !display || !channels) return "has an OpenEXR header without size or channels";
            if (data->width != width || data->height != height || display->width != width || display->height != height)
                return fmt::format("is {} x {} pixels, not {} x {}", data->width, data->height, width, height);
            return {};
        }
        const auto type = in.name();
        const auto size = in.u32();
        const auto value = type && size ? in.take(*size) : std::nullopt;
        if (!value) break;
        if (*name == "dataWindow") data = window(*value);
        if (*name == "displayWindow") display = window(*value);
        if (*name == "channels") {
            channels = true;
            if (const std::string problem = channel_problem(*value, channel_names); !problem.empty())
                return "is no picture of ours: " + problem;
        }
    }
    return "has a broken OpenEXR header";
}

}  // namespace rays::grader
