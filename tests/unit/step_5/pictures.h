// Small scenes that move or blur, as text.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../films.h"
#include "renderer/render.h"
#include "scene_reader/scene_reader.h"

namespace rays::tests {

/// A scene's text after its first line.
inline Scene staged(const std::string& text, const ReadOptions& options = {}) {
    Scene scene = read_scene_text("#version 3.7; global_settings { assumed_gamma 1.0 }\n" + text, "test", options);
    prepare(scene);
    return scene;
}

/// The same at one time: `Time` is declared, nothing moves.
inline Scene staged_at(const std::string& text, double time) {
    ReadOptions options;
    options.declared = {{"Time", time}};
    return staged(text, options);
}

/// How many pixels differ by more than a rounding.
inline int different(const Film& a, const Film& b, float tolerance) {
    int count = 0;
    for (int y = 0; y < a.raster().height; ++y)
        for (int x = 0; x < a.raster().width; ++x)
            for (int c = 0; c < 3; ++c)
                if (!(std::abs(a.at(x, y)[c] - b.at(x, y)[c]) <= tolerance)) {
                    ++count;
                    break;
                }
    return count;
}

inline bool all_finite(const Film& film) {
    for (int y = 0; y < film.raster().height; ++y)
        for (int x = 0; x < film.raster().width; ++x)
            if (!film.at(x, y).is_finite()) return false;
    return true;
}

inline double mean_of(const Film& film) {
    double sum = 0;
    for (int y = 0; y < film.raster().height; ++y)
        for (int x = 0; x < film.raster().width; ++x) sum += double(film.at(x, y)[0]);
    return sum / film.raster().width / film.raster().height;
}

}  // namespace rays::tests
