// Light sources.
#include <fmt/format.h>

#include "scene_reader/statements.h"

namespace rays::sdl {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

void read_area(Interpreter& in, LightDraft& draft) {
    draft.light.area = true;
    draft.axis_u = in.vector();
    in.comma();
    draft.axis_v = in.vector();
    in.comma();
    draft.light.size_u = in.integer("the size of an area light", 1, 100'000);
    in.comma();
    draft.light.size_v = in.integer("the size of an area light", 1, 100'000);
}

/// point_at, radius, falloff and tightness belong to lights with a direction.
void require_direction(Interpreter& in, const Token& word, const Light& light, bool or_parallel) {
    if (light.kind == Light::Kind::point && !(or_parallel && light.parallel)) {
        in.fail(word, fmt::format("'{}' needs spotlight or cylinder{} in front of it", word.text,
                                  or_parallel ? " or parallel" : ""));
    }
}

Real cone_size(Interpreter& in, const Light& light) {
    const double size = in.number();
    return static_cast<Real>(light.kind == Light::Kind::spot ? size * kDegree : size);
}

/// shadowless, spotlight and cylinder are three values of one setting in POV-Ray: the last one said is what counts. So
/// a shadowless light has no cone, and a spotlight after shadowless casts shadows. parallel, which cylinder implies,
/// is another setting and stays.
void set_kind(LightDraft& draft, Light::Kind kind, bool shadowless, double radius, double falloff) {
    Light& light = draft.light;
    light.kind = kind;
    light.shadowless = shadowless;
    light.radius_rad = static_cast<Real>(radius);
    light.falloff_rad = static_cast<Real>(falloff);
    light.tightness = 0;
}

bool read_shape_item(Interpreter& in, LightDraft& draft) {
    Light& light = draft.light;
    if (in.peek().kind != Token::Kind::word) return false;
    const Token word = in.peek();
    switch (word.word) {
        case Word::spotlight_:
            in.take();
            set_kind(draft, Light::Kind::spot, false, 30 * kDegree, 45 * kDegree);
            return true;
        case Word::cylinder_:
            in.take();
            set_kind(draft, Light::Kind::cylinder, false, 0.75, 1);
            light.parallel = true;
            return true;
        case Word::parallel_:
            in.take();
            light.parallel = true;
            return true;
        case Word::shadowless_:
            in.take();
            set_kind(draft, Light::Kind::point, true, 0, 0);
            return true;
        case Word::point_at_:
            require_direction(in, in.take(), light, true);
            draft.point_at = in.vector();
            return true;
        case Word::radius_:
            require_direction(in, in.take(), light, false);
            light.radius_rad = cone_size(in, light);
            return true;
        case Word::falloff_:
            require_direction(in, in.take(), light, false);
            light.falloff_rad = cone_size(in, light);
            return true;
        case Word::tightness_:
            require_direction(in, in.take(), light, false);
            light.tightness = static_cast<Real>(in.number());
            return true;
        case Word::fade_distance_:
            in.take();
            light.fade_distance = static_cast<Real>(in.number());
            return true;
        case Word::fade_power_:
            in.take();
            light.fade_power = static_cast<Real>(in.number());
            return true;
        default: return false;
    }
}

bool read_area_item(Interpreter& in, LightDraft& draft) {
    Light& light = draft.light;
    if (in.peek().kind != Token::Kind::word) return false;
    const Token word = in.peek();
    switch (word.word) {
        case Word::area_light_:
            in.take();
            read_area(in, draft);
            return true;
        case Word::adaptive_:
            in.take();
            light.adaptive = in.integer("adaptive", 0, 100);
            return true;
        case Word::jitter_:
            in.take();
            light.jitter = true;
            return true;
        case Word::circular_:
            in.take();
            light.circular = true;
            return true;
        case Word::orient_:
            in.take();
            light.orient = true;
            return true;
        case Word::area_illumination_:
            in.take();
            if (!in.flag())
                in.note(word.place,
                        "every point of an area light lights from where it is: area_illumination is always on");
            return true;
        case Word::media_attenuation_:
        case Word::media_interaction_:
            in.take();
            in.flag();
            in.note(word.place, fmt::format("'{}' is read and has no effect", word.text));
            return true;
        case Word::photons_:
            in.take();
            read_object_photons(in, {});
            in.note(word.place, "photons of a light are read and have no effect: every light sends them to targets");
            return true;
        default: return false;
    }
}

}  // namespace

Shared<LightDraft> read_light(Interpreter& in) {
    LightDraft draft;
    in.hold(sizeof(LightDraft) + 2 * sizeof(Light));
    const Place place = in.peek().place;
    draft.location = in.vector();
    in.comma();
    draft.light.color = in.rgb();
    for (;;) {
        if (read_shape_item(in, draft) || read_area_item(in, draft)) continue;
        const auto step = read_placement(in);
        if (!step) break;
        draft.location = step->point(draft.location);
        draft.point_at = step->point(draft.point_at);
        draft.axis_u = step->vector(draft.axis_u);
        draft.axis_v = step->vector(draft.axis_v);
    }
    Light& light = draft.light;
    if (light.orient && !light.circular) {
        in.note(place, "orient makes this area light circular, as POV-Ray does");
        light.circular = true;
    }
    if (light.circular && (light.size_u <= 1 || light.size_v <= 1)) {
        in.fail(place, "a circular area light needs more than one point along each axis");
    }
    if ((light.kind != Light::Kind::point || light.parallel) &&
        !(glm::length(draft.point_at - draft.location) > 1e-10)) {
        in.fail(place, "this light points at its own location; move point_at");
    }
    if (!in.accept('}')) {
        in.unexpected(
            "spotlight, cylinder, parallel, point_at, radius, falloff, tightness, area_light, adaptive, jitter, "
            "circular, "
            "orient, fade_distance, fade_power, shadowless, a transform or '}' in a light source");
    }
    return std::make_shared<const LightDraft>(draft);
}

}  // namespace rays::sdl
