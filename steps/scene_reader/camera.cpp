// The camera. POV-Ray 3.5 and later read all items first and apply them in one order: angle, look_at, transforms. In
// scenes of earlier versions the order is the text's.
#include <fmt/format.h>

#include "scene_reader/statements.h"

namespace rays::sdl {

namespace {

/// What a camera statement said; what it did not say stays as it was.
struct Said {
    std::optional<V3> look_at, focal_point;
    std::optional<double> angle;
    bool up = false, right = false, orthographic = false;
    Placement placement;
};

/// Words that POV-Ray does not know: they stand between #ifdef (Raysteps) and #end.
bool read_own_item(Interpreter& in, CameraDraft& camera) {
    const Place place = in.peek().place;
    if (in.accept_own("aperture_blades")) {
        camera.aperture_blades = in.integer("aperture_blades", 3, 64);
        return true;
    }
    if (!in.accept_own("shutter")) return false;
    camera.shutter_open = in.number();
    in.comma();
    camera.shutter_close = in.number();
    if (!(0 <= camera.shutter_open && camera.shutter_open <= camera.shutter_close && camera.shutter_close <= 1))
        in.fail(place, "a shutter opens and closes between the times 0 and 1, in this order");
    return true;
}

bool read_item(Interpreter& in, CameraDraft& camera, Said& said) {
    if (read_own_item(in, camera)) return true;
    if (in.peek().kind != Token::Kind::word) return false;
    const Place place = in.peek().place;
    switch (in.peek().word) {
        case Word::perspective_:
            in.take();
            camera.kind = Camera::Kind::perspective;
            return true;
        case Word::orthographic_:
            in.take();
            camera.kind = Camera::Kind::orthographic;
            said.orthographic = true;
            return true;
        case Word::location_:
            in.take();
            camera.location = in.vector();
            return true;
        case Word::direction_:
            in.take();
            camera.direction = in.vector();
            return true;
        case Word::sky_:
            in.take();
            camera.sky = in.vector();
            return true;
        case Word::right_:
            in.take();
            camera.right = in.vector();
            said.right = true;
            return true;
        case Word::up_:
            in.take();
            camera.up = in.vector();
            said.up = true;
            return true;
        case Word::look_at_:
            in.take();
            said.look_at = in.vector();
            return true;
        case Word::focal_point_:
            in.take();
            said.focal_point = in.vector();
            return true;
        case Word::aperture_:
            in.take();
            camera.aperture = in.number();
            return true;
        case Word::angle_:
            in.take();
            said.angle = camera.kind == Camera::Kind::orthographic ? in.number_or(0) : in.number();
            if (!(*said.angle >= 0 && *said.angle < 180))
                in.fail(place, "an angle of view lies between 0 and 180 degrees");
            return true;
        case Word::blur_samples_:
            in.take();
            camera.blur_samples = in.integer("blur_samples", 1, 1'000'000);
            in.comma();
            if (in.number_follows()) camera.blur_samples = in.integer("blur_samples", 1, 1'000'000);
            return true;
        case Word::confidence_:
        case Word::variance_: {
            const Token word = in.take();
            in.number();
            in.note(word.place, fmt::format("'{}' belongs to POV-Ray's focal blur and has no effect", word.text));
            return true;
        }
        default: break;
    }
    const auto step = read_placement(in);
    if (step) place_further(said.placement, *step);
    return step.has_value();
}

void aim(CameraDraft& camera, const V3& at, Interpreter& in, const Place& place) {
    const double direction_length = glm::length(camera.direction);
    const double up_length = glm::length(camera.up);
    const double right_length = glm::length(camera.right);
    const bool right_handed = glm::dot(glm::cross(camera.up, camera.direction), camera.right) <= 0;
    V3 direction = at - camera.location;
    if (!(glm::dot(direction, direction) >= kEpsilon))
        in.fail(place, "location and look_at are the same point; move one");
    direction = glm::normalize(direction);
    V3 right = glm::cross(camera.sky, direction);
    if (std::abs(right.x) < kEpsilon && std::abs(right.y) < kEpsilon && std::abs(right.z) < kEpsilon) {
        in.note(place, "the camera looks along its sky vector; its right vector decides what is up");
        right = camera.right;
    }
    if (!(glm::length(right) > 0)) in.fail(place, "the camera's right vector has no length");
    right = glm::normalize(right);
    camera.up = glm::cross(direction, right) * up_length;
    camera.direction = direction * direction_length;
    camera.right = right * (right_handed ? -right_length : right_length);
}

void set_angle(CameraDraft& camera, double angle, Interpreter& in, const Place& place) {
    if (!(glm::length(camera.direction) > 0)) in.fail(place, "the camera's direction has no length");
    const double length = glm::length(camera.right) / std::tan(angle * std::numbers::pi / 360) / 2;
    camera.direction = glm::normalize(camera.direction) * length;
}

/// An orthographic camera shows what a perspective one would show at look_at.
void widen_to_look_at(CameraDraft& camera) {
    const double distance = glm::length(camera.look_at - camera.location);
    const double length = glm::length(camera.direction);
    if (!(distance > kEpsilon && length > kEpsilon)) return;
    camera.right *= distance / length;
    camera.up *= distance / length;
}

void apply(CameraDraft& camera, const Said& said, Interpreter& in, const Place& place) {
    if (said.angle && *said.angle > 0) set_angle(camera, *said.angle, in, place);
    if (said.angle) camera.angle = *said.angle;
    if (said.look_at) {
        aim(camera, *said.look_at, in, place);
        camera.look_at = *said.look_at;
    }
    if (camera.kind == Camera::Kind::orthographic && ((!said.up && !said.right) || said.angle))
        widen_to_look_at(camera);
    if (said.focal_point) camera.focal_distance = glm::length(*said.focal_point - camera.location);
}

void place_camera(CameraDraft& camera, const Placement& placement) {
    if (!placement) return;
    camera.location = placement->point(camera.location);
    camera.direction = placement->vector(camera.direction);
    camera.up = placement->vector(camera.up);
    camera.right = placement->vector(camera.right);
}

/// Before version 3.5 each item changes the camera at once: their order matters.
bool read_and_apply_item(Interpreter& in, CameraDraft& camera, const Place& place) {
    Said said;
    if (!read_item(in, camera, said)) return false;
    if (said.orthographic) widen_to_look_at(camera);
    if (said.angle) camera.angle = *said.angle;
    if (said.angle && *said.angle > 0 && camera.kind == Camera::Kind::perspective)
        set_angle(camera, *said.angle, in, place);
    if (said.look_at) {
        aim(camera, *said.look_at, in, place);
        camera.look_at = *said.look_at;
    }
    if (said.focal_point) camera.focal_distance = glm::length(*said.focal_point - camera.location);
    place_camera(camera, said.placement);
    return true;
}

}  // namespace

CameraDraft read_camera(Context& context) {
    Interpreter& in = context.in;
    const Place place = in.peek().place;
    in.expect('{', "a camera");
    CameraDraft camera = context.default_camera;
    Said said;
    const auto named = in.accept_named<CameraDraft>();
    if (named) camera = *named;
    if (std::lround(100 * in.version()) < 350) {
        while (read_and_apply_item(in, camera, place)) {
        }
    } else if (named) {  // only transforms may follow
        while (const auto step = read_placement(in)) place_further(said.placement, *step);
    } else {
        while (read_item(in, camera, said)) {
        }
        apply(camera, said, in, place);
    }
    place_camera(camera, said.placement);
    if (!in.accept('}')) {
        in.unexpected(
            "perspective, orthographic, location, direction, right, up, sky, angle, look_at, aperture, focal_point, "
            "blur_samples, aperture_blades, shutter, a transform or '}' in a camera");
    }
    return camera;
}

Camera final_camera(const CameraDraft& draft, Interpreter& in, const Place& place) {
    for (const auto& [vector, name] :
         {std::pair{draft.direction, "direction"}, {draft.right, "right"}, {draft.up, "up"}}) {
        const double length = glm::length(vector);
        if (!(length > 0 && std::isfinite(length))) {
            in.fail(place, fmt::format("the camera's {} vector has length {}; give it a direction", name, length));
        }
    }
    const double volume =
        glm::dot(glm::cross(glm::normalize(draft.right), glm::normalize(draft.up)), glm::normalize(draft.direction));
    if (!(std::abs(volume) > 1e-12))
        in.fail(place, "the camera's direction, right and up lie in one plane; nothing is seen");
    Camera camera;
    camera.kind = draft.kind;
    camera.location = Vec3(draft.location);
    camera.direction = Vec3(draft.direction);
    camera.right = Vec3(draft.right);
    camera.up = Vec3(draft.up);
    camera.aperture = static_cast<Real>(draft.aperture);
    camera.blur_samples = draft.blur_samples;
    camera.aperture_blades = draft.aperture_blades;
    camera.shutter_open = static_cast<Real>(draft.shutter_open);
    camera.shutter_close = static_cast<Real>(draft.shutter_close);
    // POV-Ray keeps the distance only: what is in focus is the plane across the axis at that distance.
    double distance = draft.focal_distance < 0 ? glm::length(draft.direction) : draft.focal_distance;
    if (distance == 0) distance = 1;
    camera.focal_point = Vec3(draft.location + glm::normalize(draft.direction) * distance);
    return camera;
}

}  // namespace rays::sdl
