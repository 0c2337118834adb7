// Pictures compared bit by bit.
#pragma once

#include "core/film.h"

namespace rays::tests {

inline bool same_bytes(const Film& a, const Film& b) {
    for (int y = 0; y < a.raster().height; ++y)
        for (int x = 0; x < a.raster().width; ++x)
            for (int c = 0; c < 3; ++c)
                if (!(a.at(x, y)[c] == b.at(x, y)[c])) return false;  // so that a NaN is no equal
    return true;
}

}  // namespace rays::tests
