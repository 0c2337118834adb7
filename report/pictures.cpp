#include "pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rays::report {
namespace {

using nlohmann::json;

/// Counts up to 2^18 stay whole; a pixel that costs more is told to five digits.
constexpr int kCountMantissa = 17;

/// IEC 61966-2-1, clamped: what the eye gets to see.
float displayed(float linear) {
    const float v = std::clamp(linear, 0.0f, 1.0f);
    return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
}

/// One bit a pixel, eight to a byte, lowest first.
Bytes bit_map(std::size_t pixels, const std::function<bool(std::size_t)>& is_set) {
    Bytes bytes((pixels + 7) / 8);
    for (std::size_t i = 0; i < pixels; ++i)
        if (is_set(i)) bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] | 1u << (i % 8));
    return bytes;
}

/// Where the supersampled reference jumps within a pixel: outlines of objects, shadows and checks. A jump of less than
/// a tenth of the displayed range is a gradient to the eye.
Bytes outlines(const Exr& reference) {
    constexpr float kJump = 0.1f;
    return bit_map(reference.frame.pixels(), [&](std::size_t i) {
        if (reference.low.rgb.empty() || reference.high.rgb.empty()) return false;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
            if (displayed(reference.high.rgb[c]) - displayed(reference.low.rgb[c]) > kJump) return true;
        return false;
    });
}

/// Pixels that differ by more than allowed. Marked from the full floats, for the page has them rounded.
bool is_beyond(const Picture& student, const Exr& reference, const Allowance& allowance, std::size_t pixel) {
    for (std::size_t c = 3 * pixel; c < 3 * pixel + 3; ++c) {
        const float truth = reference.frame.rgb[c];
        if (!(std::abs(double{student.rgb[c]} - truth) <= allowance.of(truth))) return true;
    }
    return false;
}

/// Do they still lie between the least and the greatest value of the reference there?
bool is_explained(const Picture& student, const Exr& reference, const Allowance& allowance, std::size_t pixel) {
    if (reference.low.rgb.empty() || reference.high.rgb.empty()) return false;
    for (std::size_t c = 3 * pixel; c < 3 * pixel + 3; ++c) {
        const float low = reference.low.rgb[c], high = reference.high.rgb[c];
        if (!(student.rgb[c] >= low - allowance.of(low) && student.rgb[c] <= high + allowance.of(high))) return false;
    }
    return true;
}

Bytes marks_of(const Picture& student, const Exr& reference, const Allowance& allowance) {
    const auto beyond = [&](std::size_t i) { return is_beyond(student, reference, allowance, i); };
    Bytes marks = bit_map(student.pixels(), beyond);
    const Bytes silhouettes = bit_map(
        student.pixels(), [&](std::size_t i) { return beyond(i) && is_explained(student, reference, allowance, i); });
    marks.insert(marks.end(), silhouettes.begin(), silhouettes.end());
    return marks;
}

double number_of(const json& object, const char* key, double otherwise) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? found->get<double>() : otherwise;
}

/// results.json says what is allowed for a value of 1, and how much of that for a value of 0.
Allowance allowance_of(const json& image) {
    const double whole = number_of(image, "tolerance", 0), absolute = number_of(image, "tolerance_absolute", whole);
    return {absolute, whole - absolute};
}

std::string fingerprint(const Picture& picture) {
    return base64(sha256({reinterpret_cast<const char*>(picture.rgb.data()), picture.rgb.size() * sizeof(float)})) +
           fmt::format(" {}x{}", picture.width, picture.height);
}

std::string text_of(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

double Allowance::of(float reference) const { return absolute + relative * std::abs(double{reference}); }

json PictureStore::keep(const Picture& picture, const PixelCode& code, const Bytes& marks, int mantissa,
                        std::size_t room) {
    Bytes all = code.bytes;
    all.insert(all.end(), marks.begin(), marks.end());
    std::string text = base64(deflate(all));
    if (text.size() > room) throw std::runtime_error("left out to keep the page small");
    const std::string id = fmt::format("pixels-{}", blobs_.size());
    bytes_ += text.size();
    blobs_.push_back({id, std::move(text)});
    return {{"id", id},
            {"width", picture.width},
            {"height", picture.height},
            {"mantissa", mantissa},
            {"color", code.color},
            {"gradient", code.gradient},
            {"base", nullptr}};
}

json PictureStore::embed_reference(const std::filesystem::path& file, std::size_t room) {
    const auto known = references_.find(file.string());
    if (known != references_.end()) return known->second.description;
    auto exr = std::make_shared<const Exr>(read_picture(file));
    const int mantissa = exact_with(exr->frame, kHalfMantissa) ? kHalfMantissa : mantissa_;
    json blob = keep(exr->frame, encode(exr->frame, mantissa, nullptr, 0), outlines(*exr), mantissa, room);
    blob["outlines"] = !exr->low.rgb.empty();
    references_[file.string()] = {exr, blob};
    return blob;
}

json PictureStore::embed_student(const Picture& student, const Exr* reference, const json& reference_blob,
                                 const Allowance& allowance, std::size_t room) {
    const std::string base_id = reference ? reference_blob["id"].get<std::string>() : "";
    const std::string key =
        fmt::format("{} {} {} {}", fingerprint(student), base_id, allowance.absolute, allowance.relative);
    const auto known = students_.find(key);
    if (known != students_.end()) return known->second;
    const int base_mantissa = reference ? reference_blob["mantissa"].get<int>() : 0;
    const PixelCode code = encode(student, mantissa_, reference ? &reference->frame : nullptr, base_mantissa);
    const Bytes marks = reference ? marks_of(student, *reference, allowance) : Bytes();
    json blob = keep(student, code, marks, mantissa_, room);
    if (code.base) blob["base"] = base_id, blob["base_mantissa"] = base_mantissa;
    students_[key] = blob;
    return blob;
}

void PictureStore::embed(json& image, std::size_t room) {
    json& embedded = image["embedded"] = {{"reference", nullptr}, {"student", nullptr}, {"notes", json::array()}};
    const Exr* reference = nullptr;
    std::size_t used = bytes_;
    const auto room_left = [&] { return room - std::min(room, bytes_ - used); };
    const auto attempt = [&](const char* whose, const std::function<void()>& work) {
        try {
            work();
        } catch (const std::exception& e) {
            embedded["notes"].push_back(fmt::format("{}: {}", whose, e.what()));
        }
    };
    attempt("POV-Ray's picture", [&] {
        const auto file = folder_ / text_of(image, "reference");
        embedded["reference"] = embed_reference(file, room_left());
        reference = references_.at(file.string()).exr.get();
    });
    attempt("The student's picture", [&] {
        const Exr student = read_picture(folder_ / text_of(image, "student"));
        const bool same_size = reference && student.frame.width == reference->frame.width &&
                               student.frame.height == reference->frame.height;
        embedded["student"] = embed_student(student.frame, same_size ? reference : nullptr, embedded["reference"],
                                            allowance_of(image), room_left());
        if (reference && !same_size)
            embedded["notes"].push_back(fmt::format("The student's picture has {} x {} pixels, POV-Ray's {} x {}",
                                                    student.frame.width, student.frame.height, reference->frame.width,
                                                    reference->frame.height));
    });
}

void PictureStore::embed_costs(json& map, std::size_t room) {
    map["embedded"] = nullptr;
    map.erase("note");
    const std::string file = text_of(map, "file");
    if (file.empty()) return;
    try {
        const Picture costs = read_cost_map(folder_ / file);
        const std::string key = fingerprint(costs) + " costs";
        if (!students_.contains(key)) {
            // As many bits as the largest count needs, if there is room for them.
            int mantissa = kHalfMantissa;
            while (mantissa_ > kHalfMantissa && mantissa < kCountMantissa && !exact_with(costs, mantissa)) ++mantissa;
            students_[key] = keep(costs, encode(costs, mantissa, nullptr, 0), {}, mantissa, room);
        }
        map["embedded"] = students_[key];
    } catch (const std::exception& e) {
        map["note"] = e.what();
    }
}

}  // namespace rays::report
