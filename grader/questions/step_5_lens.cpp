// Questions about the lens (5.7): where its rays begin, and where they meet.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "questions/step_5.h"

namespace rays::grader::step_5 {

using construct::number;
using construct::numbers;
using construct::vector;

std::string LensCamera::scene() const {
    std::string text = fmt::format(
        "#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\ncamera {{ {} location {} direction {} right {} up {}\n",
        orthographic ? "orthographic" : "perspective", vector(location), vector(direction), vector(right), vector(up));
    if (aperture > 0)
        text += fmt::format("aperture {} focal_point {} blur_samples 16\n", number(aperture),
                            vector(construct::rounded(location + focus * direction)));
    if (blades > 0) text += fmt::format("#ifdef (Raysteps) aperture_blades {} #end\n", blades);
    return text + "}\n";
}

std::string FilmPoint::text() const {
    return fmt::format("{} {} {} {} {} {}", width, height, column, row, number(dx), number(dy));
}

V FilmPoint::on_film(const LensCamera& camera) const {
    // From the film's middle, in widths and heights of the film.
    const L x = (2 * (column + dx) + 1 - width) / (2.0L * width), y = (height - 2 * (row + dy) - 1) / (2.0L * height);
    return x * camera.right + y * camera.up;
}
V FilmPoint::pinhole_origin(const LensCamera& camera) const {
    return camera.orthographic ? camera.location + on_film(camera) : camera.location;
}
V FilmPoint::in_focus(const LensCamera& camera) const {
    // Parallel planes: what lies in the sharp one is the film's picture, enlarged; in an orthographic camera as it is.
    return camera.location + camera.focus * camera.direction +
           (camera.orthographic ? 1 : camera.focus) * on_film(camera);
}

LensCamera upright_camera(Dice& dice) {
    LensCamera camera;
    camera.location = dice.position(5);
    camera.direction = V(0, 0, dice.round_between(0.5, 2));
    camera.right = V(dice.round_between(0.8, 2), 0, 0);
    camera.up = V(0, dice.round_between(0.8, 2), 0);
    camera.aperture = dice.round_between(0.1, 2);
    camera.focus = dice.round_between(2, 8);
    return camera;
}

FilmPoint film_point(Dice& dice) {
    const int width = dice.whole(20, 400), height = dice.whole(20, 400), column = dice.whole(0, width - 1),
              row = dice.whole(0, height - 1);
    const L dx = dice.round_between(-0.5, 0.499);
    return {width, height, column, row, dx, dice.round_between(-0.5, 0.499)};
}

namespace {

/// Not a right angle among them.
LensCamera sheared(LensCamera camera, Dice& dice) {
    for (;;) {
        camera.direction = dice.position(2), camera.right = dice.position(2), camera.up = dice.position(2);
        const V axis = camera.axis();
        if (std::abs(glm::dot(axis, glm::normalize(camera.direction))) > 0.4L && glm::length(camera.direction) > 0.5L &&
            glm::length(camera.right) > 0.5L && glm::length(camera.up) > 0.5L &&
            std::abs(glm::dot(glm::normalize(camera.right), glm::normalize(camera.up))) < 0.8L)
            return camera;
    }
}

LensCamera turned(LensCamera camera, Dice& dice) {
    const V axis = dice.unit();
    V x, y;
    construct::frame(axis, x, y);
    camera.direction = construct::rounded(glm::length(camera.direction) * axis);
    camera.right = construct::rounded(glm::length(camera.right) * x);
    camera.up = construct::rounded(glm::length(camera.up) * y);
    return camera;
}

/// The pinhole's ray, from whatever point of the "lens".
Judge is_pinhole(const LensCamera& camera, const FilmPoint& film, std::size_t rays) {
    const V origin = film.pinhole_origin(camera), direction = glm::normalize(film.in_focus(camera) - origin);
    return rows_hold(rays, 6, "the pinhole's ray " + numbers(origin) + " " + numbers(direction),
                     [=](const Table& t, Claims& claims) {
                         for (std::size_t i = 0; i < t.rows(); ++i) {
                             claims.within(glm::length(t.triple(i) - origin), 0, 1e-6L,
                                           "distance of the ray's origin from the pinhole's");
                             claims.within(glm::length(glm::normalize(t.triple(i, 3)) - direction), 0, 1e-6L,
                                           "the ray's direction off the pinhole's");
                         }
                     });
}

}  // namespace

Judge meets_in_focus(const LensCamera& camera, const FilmPoint& film, const Centers& centers) {
    const V target = film.in_focus(camera), origin = film.pinhole_origin(camera);
    const L distance = glm::length(target - origin), radius = camera.aperture / 4;
    return rows_hold(
        centers.count(), 6, "rays from the lens through " + numbers(target), [=](const Table& t, Claims& claims) {
            std::vector<V2> on_lens;
            const V x = glm::normalize(camera.right), y = glm::normalize(camera.up);
            const L rounding = 1e-13L * (1 + glm::length(origin) + distance);
            for (std::size_t i = 0; i < t.rows(); ++i) {
                const V o = t.triple(i), d = glm::normalize(t.triple(i, 3));
                const V to = target - o;
                const L off = glm::length(glm::cross(to, d));
                claims.error(off / distance);
                claims.within(off, 0, 1e-7L * distance, "distance between a ray and the point in focus");
                claims.holds(glm::dot(to, d) > 0, "rays towards the plane in focus");
                const InPlane at = in_plane(o - origin, x, y);
                claims.within(at.off, 0, 1e-7L * radius + rounding, "distance of an origin from the lens's plane");
                claims.holds(glm::length(at.at) <= radius * (1 + 1e-6L) + 2 * rounding,
                             fmt::format("origins within {} (a quarter of the aperture)", number(radius)));
                on_lens.push_back(at.at / radius);
            }
            if (radius < 1e-6L) return;
            if (camera.blades > 0)
                claim_polygon(claims, centers, on_lens, camera.blades);
            else
                claim_disc(claims, centers, on_lens);
        });
}

std::vector<Question> lenses(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.7");
    const auto ask = [&](const LensCamera& camera, const std::string& about) {
        const FilmPoint film = film_point(dice);
        const Centers centers = camera.blades > 0 ? Centers{48, 48} : random_centers(dice);
        book.scene(camera.scene());
        book.ask("lens_ray " + film.text() + " " + centers.text(), about, meets_in_focus(camera, film, centers));
    };
    for (int i = 0; i < 3; ++i) ask(upright_camera(dice), "rays of one point of the film meet in the plane in focus");
    for (int i = 0; i < 3; ++i) ask(turned(upright_camera(dice), dice), "a camera that looks anywhere");
    for (int i = 0; i < 3; ++i)
        ask(sheared(upright_camera(dice), dice), "a sheared camera: the plane in focus is parallel to the film");
    for (int i = 0; i < 3; ++i) {
        LensCamera camera = i == 0 ? upright_camera(dice) : sheared(upright_camera(dice), dice);
        camera.orthographic = true;
        ask(camera, "an orthographic camera: the lens is around where its ray starts");
    }
    for (int i = 0; i < 3; ++i) {
        LensCamera camera = turned(upright_camera(dice), dice);
        camera.blades = i == 0 ? 3 : dice.whole(4, 8);
        ask(camera, fmt::format("an aperture of {} blades", camera.blades));
    }
    for (int i = 0; i < 3; ++i) {
        LensCamera camera = upright_camera(dice);
        camera.focus = dice.round_between(0.2, 0.9);
        ask(camera, "in focus nearer than the film");
    }
    for (int i = 0; i < 6; ++i) {
        LensCamera camera = i % 2 ? sheared(upright_camera(dice), dice) : turned(upright_camera(dice), dice);
        camera.aperture = 0;
        camera.orthographic = i >= 3;
        const FilmPoint film = film_point(dice);
        book.scene(camera.scene());
        book.ask("lens_ray " + film.text() + " " + (i < 2 ? "grid 5 5 0" : chance(dice)),
                 "a closed aperture: a pinhole", is_pinhole(camera, film, i < 2 ? 25 : 1));
    }
    return book.take();
}

}  // namespace rays::grader::step_5
