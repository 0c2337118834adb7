// The top level of a scene, and what a name can be declared to be.
#include <fmt/format.h>

#include "scene_reader/flatten.h"
#include "scene_reader/statements.h"

namespace rays::sdl {

namespace {

template <class T>
void set(Value& result, T thing) {
    result.is = Shared<T>(std::make_shared<const T>(std::move(thing)));
}

void read_background(Context& context) {
    context.in.expect('{', "a background");
    const Color color = context.in.color();
    context.in.expect('}', "a background");
    // Without an alpha channel POV-Ray 3.7 shows what the background does not let through, earlier ones all of it.
    const float shown = context.in.is_legacy() ? 1 : 1 - color.transmit;
    for (int i = 0; i < 3; ++i) context.scene.background[i] = color.rgb[i] * shown;
    context.scene.background[3] = 0;
}

void read_scene_camera(Context& context, const Place& place) {
    if (context.has_camera) context.in.note(place, "more than one camera: the last one counts");
    context.has_camera = true;
    context.scene.camera = final_camera(read_camera(context), context.in, place);
}

bool read_statement(Context& context) {
    Interpreter& in = context.in;
    const Token word = in.peek();
    if (word.kind == Token::Kind::word) {
        switch (word.word) {
            case Word::camera_:
                in.take();
                read_scene_camera(context, word.place);
                return true;
            case Word::background_:
                in.take();
                read_background(context);
                return true;
            case Word::global_settings_:
                in.take();
                read_global_settings(context);
                return true;
            case Word::default_:
                in.take();
                read_default(context);
                return true;
            case Word::media_:
                in.take();
                context.out.add_atmosphere(read_media(in));
                return true;
            default: break;
        }
    }
    const auto object = read_object(context);
    if (object) context.out.add(*object, context.default_surface);
    return object.has_value();
}

/// What the version changes in a picture, and not in the reading. As in POV-Ray the last version counts.
void obey_version(Context& context) {
    GlobalSettings& settings = context.scene.settings;
    if (!context.in.is_legacy()) return;
    settings.filter_by_color = true;
    if (context.has_gamma) return;
    settings.gamma.srgb = true;
    if (!context.has_camera) return;  // a piece of a scene, no picture
    context.in.note(context.in.peek().place,
                    "neither #version 3.7 nor assumed_gamma is stated: as in POV-Ray, colours are numbers of sRGB");
}

}  // namespace

void read_frame(Context& context) {
    Interpreter& in = context.in;
    while (in.peek().kind != Token::Kind::end) {
        if (in.peek().is(';')) in.fail(in.peek(), "a ';' that ends nothing; remove it");
        if (!read_statement(context)) {
            in.unexpected(
                "a camera, a light_source, an object (sphere, plane, triangle, smooth_triangle, polygon, mesh, mesh2, "
                "box, "
                "disc, cylinder, cone, quadric, torus, bicubic_patch, union), background, global_settings, media or a "
                "directive");
        }
    }
    if (!context.has_camera) {
        context.scene.camera = final_camera(context.default_camera, in, in.peek().place);
    }
    obey_version(context);
}

bool read_thing(Context& context, Value& result) {
    Interpreter& in = context.in;
    const Token word = in.peek();
    switch (word.kind == Token::Kind::word ? word.word : Word::other_) {
        case Word::texture_: {
            in.take();
            in.expect('{', "a texture");
            result.is = read_texture(context);
            in.expect('}', "a texture");
            return true;
        }
        case Word::pigment_:
            in.take();
            in.expect('{', "a pigment");
            set(result, read_pigment(in, context.default_surface->pigment));
            in.expect('}', "a pigment");
            return true;
        case Word::finish_:
            in.take();
            set(result, read_finish(in, context.default_surface->finish));
            return true;
        case Word::interior_:
            in.take();
            result.is = read_interior(in, nullptr);
            return true;
        case Word::material_:
            in.take();
            set(result, read_material(context, {}));
            return true;
        case Word::media_:
            in.take();
            set(result, read_media(in));
            return true;
        case Word::density_:
            in.take();
            set(result, read_density(in));
            return true;
        case Word::transform_:
            in.take();
            set(result, read_transform(in));
            return true;
        case Word::camera_:
            in.take();
            set(result, read_camera(context));
            return true;
        default: break;
    }
    auto object = read_object(context);
    if (object) set(result, std::move(*object));
    return object.has_value();
}

void read_default(Context& context) {
    Interpreter& in = context.in;
    in.expect('{', "#default");
    for (;;) {
        SurfaceDraft surface = *context.default_surface;
        if (in.accept(Word::texture_)) {
            in.expect('{', "a texture");
            surface = *read_texture(context);
            in.expect('}', "a texture");
        } else if (in.accept(Word::pigment_)) {
            in.expect('{', "a pigment");
            surface.pigment = read_pigment(in, surface.pigment);
            in.expect('}', "a pigment");
        } else if (in.accept(Word::finish_)) {
            surface.finish = read_finish(in, surface.finish);
        } else if (in.accept(Word::camera_)) {
            context.default_camera = read_camera(context);
            continue;
        } else {
            break;
        }
        context.default_surface = std::make_shared<const SurfaceDraft>(std::move(surface));
    }
    if (!in.accept('}')) in.unexpected("a texture, pigment, finish, camera or '}' in #default");
}

}  // namespace rays::sdl
