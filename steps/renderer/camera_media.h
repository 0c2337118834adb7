// What camera rays start in.
#pragma once

#include <optional>

#include "3_recursion/recursion.h"

namespace rays {

/// A perspective camera stands in one place, an orthographic one everywhere on its film.
class CameraMedia {
public:
    explicit CameraMedia(const World& world);

    Inside at(const Vec3& origin) const;
    /// The media in which all rays start; nothing when that is not certain.
    std::optional<Inside> everywhere() const;

private:
    const Scene& scene_;
    bool asked_;  ///< nobody asks where nothing lets light through
    bool one_place_;
    Inside there_;  ///< in that place
};

}  // namespace rays
