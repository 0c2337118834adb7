// Finishes.
#include <fmt/format.h>

#include "scene_reader/statements.h"

namespace rays::sdl {

namespace {

/// `albedo` makes a number mean reflected energy; it is worked into the number when the finish ends.
struct Albedo {
    bool diffuse = false;
    bool phong = false;
    bool specular = false;
};

float single(Interpreter& in) { return static_cast<float>(in.number()); }

void read_reflection(Interpreter& in, Reflection& reflection) {
    reflection.falloff = 1;
    reflection.fresnel = false;
    if (!in.accept('{')) {
        reflection.min = reflection.max = in.rgb();
        return;
    }
    reflection.min = in.rgb();
    in.comma();
    const bool has_max = in.color_follows();
    reflection.max = has_max ? in.rgb() : reflection.min;
    for (;;) {
        const Place place = in.peek().place;
        if (in.accept(Word::fresnel_)) {
            reflection.fresnel = in.flag();
            if (reflection.fresnel && !has_max) reflection.min = Radiance(0.0f);
        } else if (in.accept(Word::falloff_)) {
            reflection.falloff = single(in);
        } else if (in.accept(Word::exponent_)) {
            const double exponent = in.number();
            if (!(exponent > 0)) in.fail(place, "the exponent of a reflection must be greater than 0");
            reflection.exponent = static_cast<float>(1 / exponent);
        } else if (in.accept(Word::metallic_)) {
            reflection.metallic = static_cast<float>(in.number_or(1));
        } else {
            break;
        }
    }
    if (!in.accept('}')) in.unexpected("fresnel, falloff, exponent, metallic or '}' in a reflection");
}

/// Words that must have the value that does nothing.
void only(Interpreter& in, double allowed) {
    const Token word = in.take();
    const double value = in.number();
    if (value != allowed) {
        in.fail(word, fmt::format("'{} {}' is not in the subset; only {} {} is", word.text, value, word.text, allowed));
    }
}

void read_diffuse(Interpreter& in, Finish& finish, Albedo& albedo) {
    albedo.diffuse = in.accept(Word::albedo_) || albedo.diffuse;
    finish.diffuse = single(in);
    in.comma();
    if (in.number_follows() && in.number() != 0) {
        in.fail(in.peek(), "diffuse light through to the back is not in the subset; give diffuse one number");
    }
}

/// Words of the interior that stand in a finish, as in scenes from before POV-Ray 3.1.
bool read_old_item(Interpreter& in, FinishDraft& draft) {
    const Token word = in.peek();
    if (in.accept(Word::ior_)) {
        draft.ior = single(in);
        if (!(*draft.ior > 0)) in.fail(word, "ior must be greater than 0");
    } else if (in.accept(Word::caustics_)) {
        draft.caustics = single(in);
    } else if (word.is(Word::refraction_)) {
        only(in, 1);
        in.note(word.place, "'refraction' in a finish has no effect; ior decides");
    } else {
        return false;
    }
    return true;
}

bool read_item(Interpreter& in, Finish& finish, Albedo& albedo) {
    const Place own = in.peek().place;
    if (in.accept_own("glossy")) {  // POV-Ray does not know it: it stands between #ifdef (Raysteps) and #end
        finish.glossy = single(in);
        if (!(finish.glossy >= 0 && finish.glossy <= 1)) in.fail(own, "glossy lies between 0, a mirror, and 1");
        return true;
    }
    if (in.peek().kind != Token::Kind::word) return false;
    const Place place = in.peek().place;
    switch (in.peek().word) {
        case Word::ambient_:
            in.take();
            finish.ambient = in.rgb();
            return true;
        case Word::emission_:
            in.take();
            finish.emission = in.rgb();
            return true;
        case Word::diffuse_:
            in.take();
            read_diffuse(in, finish, albedo);
            return true;
        case Word::phong_:
            in.take();
            albedo.phong = in.accept(Word::albedo_) || albedo.phong;
            finish.phong = single(in);
            return true;
        case Word::phong_size_:
            in.take();
            finish.phong_size = single(in);
            return true;
        case Word::specular_:
            in.take();
            albedo.specular = in.accept(Word::albedo_) || albedo.specular;
            finish.specular = single(in);
            return true;
        case Word::roughness_:
            in.take();
            finish.roughness = single(in);
            if (!(finish.roughness > 0)) in.fail(place, "roughness must be greater than 0");
            return true;
        case Word::metallic_:
            in.take();
            finish.metallic = static_cast<float>(in.number_or(1));
            return true;
        case Word::reflection_:
            in.take();
            read_reflection(in, finish.reflection);
            return true;
        case Word::reflection_exponent_: {
            in.take();
            const double exponent = in.number();
            if (!(exponent > 0)) in.fail(place, "reflection_exponent must be greater than 0");
            finish.reflection.exponent = static_cast<float>(1 / exponent);
            return true;
        }
        case Word::conserve_energy_:
            in.take();
            finish.conserve_energy = true;
            return true;
        case Word::brilliance_:
            in.take();
            finish.brilliance = single(in);
            if (!(finish.brilliance >= 0)) in.fail(place, "brilliance must not be negative");
            return true;
        case Word::crand_: only(in, 0); return true;
        default: return false;
    }
}

}  // namespace

FinishDraft read_finish(Interpreter& in, FinishDraft draft) {
    in.expect('{', "a finish");
    if (const auto named = in.accept_named<FinishDraft>()) draft = *named;
    Finish& finish = draft.finish;
    Albedo albedo;
    while (read_item(in, finish, albedo) || read_old_item(in, draft)) {
    }
    if (!in.accept('}')) {
        in.unexpected(
            "ambient, diffuse, emission, phong, phong_size, specular, roughness, metallic, brilliance, reflection, "
            "conserve_energy, glossy or '}' in a finish");
    }
    // POV-Ray's normalisations of `albedo` (methods: Lewis; Blinn-Phong over the hemisphere).
    if (albedo.diffuse) finish.diffuse *= (finish.brilliance + 1) / 2;
    if (albedo.phong) finish.phong *= (finish.phong_size + 1) / 2;
    if (albedo.specular) {
        const float exponent = 1 / finish.roughness;
        finish.specular *= (exponent + 2) / (4 * (2 - std::pow(2.0f, -exponent / 2)));
    }
    return draft;
}

}  // namespace rays::sdl
