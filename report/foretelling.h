// What the pixels before it say about a pixel's number, and how sure they are.
//
// Several simple guesses compete; who was closest around the pixel is believed. The guesses:
// - of a channel by itself: the median edge detector (M. Weinberger, G. Seroussi, G. Sapiro: The LOCO-I lossless image
//   compression algorithm, 2000, equation 1), for green also every neighbour, and the plane through three of them;
// - of red and blue: what the known channels do here, as a difference; and the neighbour whose known channels are
//   closest, which finds the right side of an edge;
// - of a picture with a base: the base's pixel.
// Ordinals are nearly logarithms, so surfaces of one colour under any light differ by constants between the channels.
#pragma once

#include <cstddef>

#include "pixel_code.h"

namespace rays::report {

/// Indices of neighbours that come before pixel i. At the borders another neighbour stands in; the first pixel's are
/// all `none`.
struct Around {
    std::size_t w, n, nw, ne, ww, nn;
};
Around around(std::size_t i, std::size_t width, std::size_t none);

class Foretelling {
public:
    /// The planes must live as long. base: of the same size, or null.
    Foretelling(const Planes& planes, const Planes* base, int width);

    /// Pixels in their order, in each the channels in theirs.
    void put(BitWriter& writer, std::size_t channel, std::size_t pixel);

private:
    static constexpr std::size_t kMostGuesses = 7;
    using Guesses = std::array<std::int32_t, kMostGuesses>;
    struct Guessed {
        std::int32_t value;
        std::int32_t doubt;  ///< how far this kind of guess was off around here
        bool from_base;
    };

    std::size_t guesses_of(std::size_t channel, std::size_t pixel, const Around& at, Guesses& guesses) const;
    Guessed best(std::size_t channel, const Around& at, const Guesses& guesses, std::size_t count) const;
    void put_residual(BitWriter& writer, std::size_t channel, std::size_t pixel, const Around& at,
                      const Guessed& guessed);

    std::size_t width_, none_;
    Planes planes_;  ///< each with a zero after its end, the number of pixel none_
    const Planes* base_;
    std::array<std::vector<Guesses>, 3> off_;  ///< how far every guess was off
    Planes residuals_;
    std::vector<Chance> by_doubt_, by_residuals_, by_neighbours_, signs_, digits_;
    std::vector<Weights> weights_;
};

}  // namespace rays::report
