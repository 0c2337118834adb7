// Short ways to read a scene in a test.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "scene_reader/scene_reader.h"

namespace rays {

/// Geometry is read in double and stored in Real; a chain of a few transforms loses a few of its last digits.
inline constexpr double kClose = std::is_same_v<Real, double> ? 1e-12 : 2e-6;

inline Scene scene_of(const std::string& text, const ReadOptions& options = {}) {
    return read_scene_text(text, "test.pov", options);
}

/// The message of the error that reading must end with; empty when it does not.
inline std::string error_of(const std::string& text, const ReadOptions& options = {}) {
    try {
        scene_of(text, options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// False for a NaN.
inline ::testing::AssertionResult near(const Vec3& found, const Vec3& expected, double tolerance = kClose) {
    const double scale = 1 + std::abs(expected.x) + std::abs(expected.y) + std::abs(expected.z);
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(double(found[i]) - double(expected[i])) <= tolerance * scale)) {
            return ::testing::AssertionFailure()
                   << "found <" << found.x << ", " << found.y << ", " << found.z << ">, expected <" << expected.x
                   << ", " << expected.y << ", " << expected.z << ">";
        }
    }
    return ::testing::AssertionSuccess();
}

}  // namespace rays
