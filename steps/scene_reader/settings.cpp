// global_settings and photons.
#include <fmt/format.h>

#include "scene_reader/statements.h"

namespace rays::sdl {

namespace {

void read_global_photons(Interpreter& in, GlobalSettings& settings) {
    const Place place = in.peek().place;
    in.expect('{', "photons");
    settings.photons = true;
    bool noted = false;
    for (;;) {
        const Token word = in.peek();
        if (in.accept(Word::spacing_)) {
            settings.photon_spacing = static_cast<Real>(in.number());
            if (!(settings.photon_spacing > 0)) in.fail(place, "the spacing of photons must be greater than 0");
        } else if (in.accept(Word::count_)) {
            settings.photon_count = in.integer("the number of photons", 1, 2'000'000'000);
        } else if (word.kind == Token::Kind::word && word.word != Word::spacing_ && !in.peek().is('}')) {
            in.take();
            if (!in.number_follows()) in.unexpected("spacing, count or '}' in photons");
            while (in.number_follows()) {
                in.number();
                in.comma();
            }
            if (!noted)
                in.note(word.place, fmt::format("'{}' belongs to POV-Ray's photon maps and has no effect", word.text));
            noted = true;
        } else {
            break;
        }
    }
    if (!in.accept('}')) in.unexpected("spacing, count or '}' in photons");
}

/// The first one counts.
void read_gamma(Context& context) {
    Interpreter& in = context.in;
    const Place place = in.peek().place;
    Gamma gamma;
    if (in.accept(Word::srgb_)) {
        gamma.srgb = true;
    } else {
        const double power = in.number();
        if (!(power > 0)) in.fail(place, fmt::format("assumed_gamma is {}; it must be greater than 0", power));
        if (std::abs(1 - 1 / power) > 0.01) gamma.power = static_cast<float>(power);  // POV-Ray takes the rest for 1
    }
    if (context.has_gamma) return in.note(place, "assumed_gamma was stated before; the first one counts");
    context.has_gamma = true;
    context.scene.settings.gamma = in.gamma = gamma;
}

bool read_setting(Context& context) {
    Interpreter& in = context.in;
    GlobalSettings& settings = context.scene.settings;
    if (in.peek().kind != Token::Kind::word) return false;
    const Token word = in.peek();
    switch (word.word) {
        case Word::ambient_light_:
            in.take();
            settings.ambient_light = in.rgb();
            return true;
        case Word::max_trace_level_:
            in.take();
            settings.max_trace_level = in.integer("max_trace_level", 1, 256);
            return true;
        case Word::adc_bailout_:
            in.take();
            settings.adc_bailout = static_cast<float>(in.number());
            return true;
        case Word::photons_:
            in.take();
            read_global_photons(in, settings);
            return true;
        case Word::assumed_gamma_:
            in.take();
            read_gamma(context);
            return true;
        case Word::max_intersections_:
        case Word::number_of_waves_:
        case Word::noise_generator_:
        case Word::mm_per_unit_:
            in.take();
            in.number();
            break;
        case Word::irid_wavelength_:
            in.take();
            in.rgb();
            break;
        case Word::charset_: in.take(), in.take(); break;
        default: return false;
    }
    in.note(word.place, fmt::format("'{}' is read and has no effect", word.text));
    return true;
}

}  // namespace

void read_global_settings(Context& context) {
    context.in.expect('{', "global_settings");
    while (read_setting(context)) {
    }
    if (!context.in.accept('}')) {
        context.in.unexpected(
            "assumed_gamma, max_trace_level, adc_bailout, ambient_light, photons or '}' in global_settings");
    }
}

ObjectPhotons read_object_photons(Interpreter& in, ObjectPhotons photons) {
    in.expect('{', "photons");
    for (;;) {
        if (in.accept(Word::target_)) {
            photons.spacing = static_cast<Real>(in.number_or(1));
            photons.target = photons.spacing > 0;
        } else if (in.accept(Word::reflection_)) {
            photons.reflection = in.number() != 0;
        } else if (in.accept(Word::refraction_)) {
            photons.refraction = in.number() != 0;
        } else if (in.accept(Word::collect_)) {
            photons.collect = in.flag();
        } else if (in.accept(Word::pass_through_)) {
            photons.pass_through = in.number_or(1) != 0;
        } else if (in.accept(Word::area_light_)) {
            continue;
        } else {
            break;
        }
    }
    if (!in.accept('}')) in.unexpected("target, reflection, refraction, collect, pass_through or '}' in photons");
    return photons;
}

}  // namespace rays::sdl
