#include "pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rays::report {
namespace {

using nlohmann::json;

/// Relative errors of 2^-9: a display shows steps of 2^-7 where it is finest.
constexpr int kLookMantissa = 8;
/// Bits beyond a half float's where the student's value is: an eighth of the reference's rounding.
constexpr int kFiner = 3;

/// IEC 61966-2-1, clamped: what the eye gets to see.
float displayed(float linear) {
    const float v = std::clamp(linear, 0.0f, 1.0f);
    return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
}

Bitmap bitmap_of(std::size_t pixels, const std::function<bool(std::size_t)>& is_set) {
    Bitmap bitmap(pixels);
    for (std::size_t i = 0; i < pixels; ++i) bitmap[i] = is_set(i);
    return bitmap;
}

/// Where the supersampled reference jumps within a pixel: outlines of objects, shadows and checks. A jump of less than
/// a tenth of the displayed range is a gradient to the eye.
Bitmap outlines(const Exr& reference) {
    constexpr float kJump = 0.1f;
    return bitmap_of(reference.frame.pixels(), [&](std::size_t i) {
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

json PictureStore::keep(const Picture& picture, BitWriter& writer, int mantissa, std::size_t room) {
    std::string text = base91(writer.finish());
    if (text.size() > room) throw std::runtime_error("left out to keep the page small");
    const std::string id = fmt::format("pixels-{}", blobs_.size());
    bytes_ += text.size();
    blobs_.push_back({id, std::move(text)});
    return {{"id", id}, {"width", picture.width}, {"height", picture.height}, {"mantissa", mantissa}};
}

const PictureStore::Kept& PictureStore::embed_reference(const std::filesystem::path& file, Need need,
                                                        std::size_t room) {
    const auto known = references_.find(file.string());
    if (known != references_.end()) return known->second;
    auto exr = std::make_shared<const Exr>(read_picture(file));
    const int exact = exact_with(exr->frame, kHalfMantissa) ? kHalfMantissa : kHalfMantissa + kFiner;
    const int mantissa = need == Need::compare ? exact : kLookMantissa;
    Planes planes = ordinals(exr->frame, mantissa);
    BitWriter writer;
    put_planes(writer, planes, exr->frame.width, nullptr);
    const bool has_outlines = !exr->low.rgb.empty();
    if (has_outlines) put_bitmap(writer, outlines(*exr), exr->frame.width);
    json blob = keep(exr->frame, writer, mantissa, room);
    blob["outlines"] = has_outlines;
    return references_[file.string()] = {std::move(exr), std::move(blob), std::move(planes)};
}

json PictureStore::embed_student(const Picture& student, const Kept* reference, const Allowance& allowance, Need need,
                                 std::size_t room) {
    const std::string base = reference ? reference->description["id"].get<std::string>() : "";
    const int mantissa = reference               ? reference->description["mantissa"].get<int>()
                         : need == Need::compare ? kHalfMantissa
                                                 : kLookMantissa;
    const std::string key =
        fmt::format("{} {} {} {} {}", fingerprint(student), base, mantissa, allowance.absolute, allowance.relative);
    const auto known = students_.find(key);
    if (known != students_.end()) return known->second;
    BitWriter writer;
    const Planes planes = ordinals(student, mantissa);
    put_planes(writer, planes, student.width, reference ? &reference->planes : nullptr);
    const int finer = reference && mantissa == kHalfMantissa ? kFiner : 0;
    if (reference) {
        const Exr& truth = *reference->exr;
        const Bitmap beyond =
            bitmap_of(student.pixels(), [&](std::size_t i) { return is_beyond(student, truth, allowance, i); });
        put_bitmap(writer, beyond, student.width);
        put_bitmap(writer,
                   bitmap_of(student.pixels(),
                             [&](std::size_t i) { return beyond[i] && is_explained(student, truth, allowance, i); }),
                   student.width);
        if (finer > 0) {
            const auto differs = [&](std::size_t i) {
                for (std::size_t c = 0; c < 3; ++c)
                    if (planes[c][i] != reference->planes[c][i]) return true;
                return bool{beyond[i]};
            };
            put_finer(writer, student, bitmap_of(student.pixels(), differs), mantissa, finer);
        }
    }
    json blob = keep(student, writer, mantissa, room);
    if (reference) blob["base"] = base, blob["finer"] = finer;
    return students_[key] = blob;
}

void PictureStore::embed(json& image, Need need, std::size_t room) {
    json& embedded = image["embedded"] = {{"reference", nullptr}, {"student", nullptr}, {"notes", json::array()}};
    const Kept* reference = nullptr;
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
        reference = &embed_reference(folder_ / text_of(image, "reference"), need, room_left());
        embedded["reference"] = reference->description;
    });
    attempt("The student's picture", [&] {
        const Picture student = read_picture(folder_ / text_of(image, "student")).frame;
        const Picture* truth = reference ? &reference->exr->frame : nullptr;
        const bool same_size = truth && student.width == truth->width && student.height == truth->height;
        embedded["student"] =
            embed_student(student, same_size ? reference : nullptr, allowance_of(image), need, room_left());
        if (truth && !same_size)
            embedded["notes"].push_back(fmt::format("The student's picture has {} x {} pixels, POV-Ray's {} x {}",
                                                    student.width, student.height, truth->width, truth->height));
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
            BitWriter writer;
            put_planes(writer, counts(costs), costs.width, nullptr);
            students_[key] = keep(costs, writer, 0, room);
            students_[key]["counts"] = true;
        }
        map["embedded"] = students_[key];
    } catch (const std::exception& e) {
        map["note"] = e.what();
    }
}

void PictureStore::embed_z(json& statistics, std::size_t room) {
    statistics["embedded"] = nullptr;
    statistics.erase("note");
    const std::string file = text_of(statistics, "z_picture");
    if (file.empty()) return;
    try {
        statistics["embedded"] = embed_student(read_picture(folder_ / file).frame, nullptr, {}, Need::look, room);
    } catch (const std::exception& e) {
        statistics["note"] = e.what();
    }
}

}  // namespace rays::report
