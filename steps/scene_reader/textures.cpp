// Textures and pigments.
#include <fmt/format.h>

#include "scene_reader/statements.h"

namespace rays::sdl {

namespace {

/// The two colours of a checker, or two plain pigments. POV-Ray's defaults are blue and green.
void read_checker(Interpreter& in, PigmentDraft& pigment) {
    Color colors[2] = {{Radiance(0, 0, 1)}, {Radiance(0, 1, 0)}};
    for (Color& color : colors) {
        if (in.peek().is(Word::pigment_)) {
            const Place place = in.take().place;
            in.expect('{', "a pigment");
            const PigmentDraft plain = read_pigment(in, {});
            if (plain.checker_other) in.fail(place, "a checker of checkers is not in the subset; use plain colors");
            color = plain.color;
            in.expect('}', "a pigment");
        } else if (in.color_follows()) {
            color = in.color();
        } else {
            break;
        }
        in.comma();
    }
    pigment.color = colors[0];
    pigment.checker_other = colors[1];
}

}  // namespace

PigmentDraft read_pigment(Interpreter& in, PigmentDraft pigment) {
    const Interpreter::Nesting nesting(in);
    if (const auto named = in.accept_named<PigmentDraft>()) pigment = *named;
    if (in.accept(Word::checker_)) {
        pigment.placement.reset();
        read_checker(in, pigment);
    } else if (in.color_follows()) {
        pigment.color = in.color();
        pigment.checker_other.reset();
    }
    for (;;) {
        if (const auto step = read_placement(in)) {
            place_further(pigment.placement, *step);
        } else if (in.peek().is(Word::quick_color_)) {
            in.note(in.take().place, "quick_color has no effect: pictures are made at full quality");
            in.color();
        } else {
            break;
        }
    }
    if (!in.peek().is('}')) in.unexpected("a color, checker, a transform or '}' in a pigment");
    return pigment;
}

Shared<SurfaceDraft> read_texture(Context& context) {
    Interpreter& in = context.in;
    const Interpreter::Nesting nesting(in);
    Shared<SurfaceDraft> start = in.accept_named<SurfaceDraft>();
    if (!start) start = context.default_surface;
    if (in.peek().is('}')) return start;  // shared, not copied: thousands of objects may wear it
    SurfaceDraft surface = *start;
    for (;;) {
        if (const auto pigment = in.accept_named<PigmentDraft>()) {
            surface.pigment = *pigment;
        } else if (const auto finish = in.accept_named<FinishDraft>()) {
            surface.finish = *finish;
        } else if (in.accept(Word::pigment_)) {
            in.expect('{', "a pigment");
            surface.pigment = read_pigment(in, surface.pigment);
            in.expect('}', "a pigment");
        } else if (in.accept(Word::finish_)) {
            surface.finish = read_finish(in, surface.finish);
        } else if (const auto step = read_placement(in)) {
            place_further(surface.pigment.placement, *step);
        } else {
            break;
        }
    }
    if (!in.peek().is('}')) in.unexpected("a pigment, finish, transform or '}' in a texture");
    return std::make_shared<const SurfaceDraft>(std::move(surface));
}

}  // namespace rays::sdl
