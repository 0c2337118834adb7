// The pictures of the checks, as compact blobs of pixel values for the page.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pixel_code.h"

namespace rays::report {

/// A frame, and where the reference has them the least and the greatest value around each pixel.
struct Exr {
    Picture frame;
    Picture low, high;  ///< empty when the file has no channels min.* max.*
};

/// The grader's rule: a value may differ by absolute + relative * |reference|.
struct Allowance {
    double absolute = 0, relative = 0;
    double of(float reference) const;
};

/// Reads R G B (and min.* max.*) as floats. Throws std::runtime_error with a message for the page: missing file, not a
/// picture, channels missing, or more than 4 million pixels.
Exr read_picture(const std::filesystem::path& file);

/// What `--cost-map` wrote, as a picture: tests in the first value of a pixel, nodes in the second, 0 in the third.
/// Throws as read_picture does.
Picture read_cost_map(const std::filesystem::path& file);

/// What a picture in the page is for.
enum class Need {
    compare,  ///< every value counts: as many bits as POV-Ray's own pictures have, and more where the student's differ
    look,     ///< nothing to compare with: finer than a display's steps at any exposure
};

/// Collects the blobs of a page. The same picture is kept once, however many checks show it.
class PictureStore {
public:
    explicit PictureStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Reads the pictures of results.json's `image` and says in image["embedded"] where they are:
    /// {"reference": blob, "student": blob, "notes": [..]}; a blob is
    /// {"id","width","height","mantissa","finer","base"}. Never throws for a bad picture: that is a note. Who needs
    /// more bits of a reference has to come first. `room` bytes of text may be added; a picture that does not fit is
    /// left out with a note.
    void embed(nlohmann::json& image, Need need, std::size_t room);

    /// The same for a map of results.json's `cost_maps`: map["embedded"] is a blob, or null, and then map["note"] says
    /// why if there should be one.
    void embed_costs(nlohmann::json& map, std::size_t room);

    /// The same for results.json's `statistics`: its picture of z.
    void embed_z(nlohmann::json& statistics, std::size_t room);

    struct Blob {
        std::string id, text;
    };
    const std::vector<Blob>& blobs() const { return blobs_; }
    std::size_t bytes() const { return bytes_; }

private:
    struct Kept {
        std::shared_ptr<const Exr> exr;
        nlohmann::json description;
        Planes planes;
    };
    const Kept& embed_reference(const std::filesystem::path& file, Need need, std::size_t room);
    nlohmann::json embed_student(const Picture& student, const Kept* reference, const Allowance& allowance, Need need,
                                 std::size_t room);
    nlohmann::json keep(const Picture& picture, BitWriter& writer, int mantissa, std::size_t room);

    std::filesystem::path folder_;
    std::size_t bytes_ = 0;
    std::vector<Blob> blobs_;
    std::map<std::string, Kept> references_;          ///< by path
    std::map<std::string, nlohmann::json> students_;  ///< by hash of the values, reference and tolerance
};

}  // namespace rays::report
