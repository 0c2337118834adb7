// Questions of tasks 1.1 and 1.2: from a pixel to a ray.
#include <fmt/format.h>

#include "questions/step_1.h"

namespace rays::grader::step_1 {

namespace {

struct View {
    V location, direction, right, up;

    std::string text(const char* kind) const {
        return fmt::format(
            "#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\ncamera {{ {} location {} direction {} right {} up "
            "{} }}\n",
            kind, vector(location), vector(direction), vector(right), vector(up));
    }
};

struct Pixel {
    int width, height, column, row;
    L dx = 0, dy = 0;

    std::string query() const {
        return fmt::format("camera {} {} {} {} {} {}", width, height, column, row, number(dx), number(dy));
    }
    /// From the film's middle, in widths and heights of the film: how many half pixels lie between, exactly.
    L right() const { return (2 * (column + dx) + 1 - width) / (2.0L * width); }
    L up() const { return (height - 2 * (row + dy) - 1) / (2.0L * height); }
};

Judge ray_is(const V& origin, const V& direction) {
    return [=, unit = glm::normalize(direction)](const Answer& answer) {
        const std::string expected = numbers(origin) + " " + numbers(unit);
        if (answer.kind != Answer::Kind::value || answer.numbers.size() != 6)
            return Judgement{false, std::numeric_limits<double>::infinity(), expected};
        const auto& n = answer.numbers;
        const V o(n[0], n[1], n[2]), d(n[3], n[4], n[5]);
        const L error = std::max(glm::length(o - origin) / (1 + glm::length(origin)), glm::length(d - unit));
        return Judgement{error <= kLength, static_cast<double>(error), expected};
    };
}

View upright(Dice& dice, double width, double height) {
    return {dice.position(5), V(0, 0, dice.round_between(0.5, 2)), V(rounded(width / height), 0, 0), V(0, 1, 0)};
}

/// No two vectors at right angles.
View sheared(Dice& dice) {
    for (;;) {
        const View view{dice.position(5), dice.position(2), dice.position(2), dice.position(2)};
        const L volume = glm::dot(glm::cross(view.right, view.up), view.direction);
        if (std::abs(volume) > 0.3L && glm::length(view.direction) > 0.3L) return view;
    }
}

template <class Ray>
std::vector<Question> ask(const char* task, const char* kind, std::uint64_t seed, Ray ray) {
    Dice dice(seed);
    Notebook book(task);
    const auto about = [&](const View& view, const Pixel& pixel, const std::string& what) {
        book.scene(view.text(kind));
        const auto [origin, direction] = ray(view, pixel.right(), pixel.up());
        book.ask(pixel.query(), what, ray_is(origin, direction));
    };
    const auto any_pixel = [&](int width, int height) {
        return Pixel{width, height, dice.whole(0, width - 1), dice.whole(0, height - 1)};
    };
    for (int i = 0; i < 4; ++i) {
        about(upright(dice, 4, 3), any_pixel(320, 240), "a pixel of an upright camera");
        about(upright(dice, 1, 1), {9, 9, 4, 4},
              "the middle pixel of an odd picture: the ray runs along the direction");
        about(upright(dice, 1, 1), any_pixel(12, 8), "a right vector that does not fit the picture's shape");
        about(upright(dice, 7, 2), any_pixel(7, 2), "width and height that do not divide each other");
        about(sheared(dice), any_pixel(160, 120), "direction, right and up at odd angles");
        Pixel between = any_pixel(64, 48);
        between.dx = dice.between(-0.5, 0.5), between.dy = dice.between(-0.5, 0.5);
        about(sheared(dice), between, "off the pixel's centre");
    }
    about(upright(dice, 4, 3), {320, 240, 0, 0}, "the upper left corner");
    about(upright(dice, 4, 3), {320, 240, 319, 239}, "the lower right corner");
    about(upright(dice, 4, 3), {320, 240, 319, 0},
          "the upper right corner: neither left and right nor up and down exchanged");
    about(upright(dice, 1, 1), {1, 1, 0, 0}, "a picture of one pixel");
    return book.take();
}

}  // namespace

std::vector<Question> perspective_cameras(std::uint64_t seed) {
    return ask("1.1", "perspective", seed, [](const View& view, L right, L up) {
        return std::pair(view.location, view.direction + right * view.right + up * view.up);
    });
}

std::vector<Question> orthographic_cameras(std::uint64_t seed) {
    return ask("1.2", "orthographic", seed, [](const View& view, L right, L up) {
        return std::pair(view.location + right * view.right + up * view.up, view.direction);
    });
}

}  // namespace rays::grader::step_1
