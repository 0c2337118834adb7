// Objects: which one, and what may be said of any of them.
#include <fmt/format.h>

#include "scene_reader/statements.h"

namespace rays::sdl {

void ObjectDraft::move(const Affine& map) {
    place_further(placement, map);
    if (surface) place_further(surface_placement, map);
    if (interior) place_further(interior_placement, map);
    for (ObjectDraft& clip : clips) clip.move(map);
    for (ObjectDraft& bound : bounds) bound.move(map);
}

namespace {

/// `union { ... }`: its children, before its modifiers.
void read_children(Context& context, ObjectDraft& object) {
    auto children = std::make_shared<std::vector<ObjectDraft>>();
    while (auto child = read_object(context)) {
        context.in.hold(sizeof(ObjectDraft) * (1 + child->clips.size()));
        children->push_back(std::move(*child));
    }
    object.shape = UnionDraft{std::move(children)};
}

/// Clips and bounds are copied with an object; its children are shared.
void pay_for_copy(Interpreter& in, const ObjectDraft& object) {
    in.spend(static_cast<std::int64_t>(8 * (object.clips.size() + object.bounds.size())));
}

/// After the brace of `sphere {` and its like, a name may stand for the whole object.
bool read_named(Context& context, ObjectDraft& object) {
    const auto named = context.in.accept_named<ObjectDraft>();
    if (!named) return false;
    pay_for_copy(context.in, *named);
    object = *named;
    return true;
}

void read_body(Context& context, const Token& word, ObjectDraft& object) {
    Interpreter& in = context.in;
    if (word.word == Word::object_) {
        if (read_named(context, object)) return;
        auto inner = read_object(context);
        if (!inner) in.unexpected("an object");
        object = std::move(*inner);
    } else if (read_named(context, object)) {
        return;
    } else if (word.word == Word::union_) {
        read_children(context, object);
    } else if (word.word == Word::light_source_) {
        object.shape = read_light(in);
    } else {
        read_shape(context, word.word, object);
    }
}

/// What an old scene's finish says of the interior counts more than the interior.
void fill_from_finish(ObjectDraft& object) {
    if (!object.surface) return;
    const FinishDraft& finish = object.surface->finish;
    if (!finish.ior && !finish.caustics) return;
    auto filled =
        object.interior ? std::make_shared<InteriorDraft>(*object.interior) : std::make_shared<InteriorDraft>();
    if (finish.ior) filled->interior.ior = *finish.ior;
    if (finish.caustics) filled->interior.caustics = *finish.caustics;
    object.interior = std::move(filled);
}

}  // namespace

std::optional<ObjectDraft> read_object(Context& context) {
    Interpreter& in = context.in;
    const Token word = in.peek();
    if (const auto named = in.accept_named<ObjectDraft>()) {
        in.object_made(word.place);
        pay_for_copy(in, *named);
        return *named;
    }
    const bool begins = word.kind == Token::Kind::word && (word.word == Word::object_ || word.word == Word::union_ ||
                                                           word.word == Word::light_source_ || is_shape(word.word));
    if (!begins) return std::nullopt;
    const Interpreter::Nesting nesting(in);
    in.take();
    in.expect('{', to_string(word.word));
    ObjectDraft object;
    object.place = word.place;
    // What follows is a light's name, or its location: a number, or the name of a vector.
    const bool named = in.peek().kind == Token::Kind::value && in.peek().value->shared<ObjectDraft>();
    const bool fresh_light = word.word == Word::light_source_ && !named;
    read_body(context, word, object);
    if (!fresh_light || !object.is_light()) read_object_modifiers(context, object);
    fill_from_finish(object);
    object.place = word.place;
    in.object_made(word.place);
    return object;
}

namespace {

void wear(Context& context, ObjectDraft& object, Shared<SurfaceDraft> surface, const Place& place) {
    if (object.surface && !is_opaque(*surface)) {
        context.in.fail(place, "layered textures are not in the subset; give the object one texture");
    }
    // A layer that lets nothing through hides what is below.
    object.surface = std::move(surface);
    object.surface_placement.reset();
}

/// pigment and finish given to the object itself change the texture it has, or the default one. The texture's own
/// placement is worked into its pigment first, since a new pigment starts from here.
void read_pigment_or_finish(Context& context, ObjectDraft& object, Word word) {
    SurfaceDraft surface = object.surface ? *object.surface : *context.default_surface;
    if (surface.pigment.checker_other) place_further(surface.pigment.placement, object.surface_placement);
    object.surface_placement.reset();
    if (word == Word::pigment_) {
        context.in.expect('{', "a pigment");
        surface.pigment = read_pigment(context.in, surface.pigment);
        context.in.expect('}', "a pigment");
    } else {
        surface.finish = read_finish(context.in, surface.finish);
    }
    object.surface = std::make_shared<const SurfaceDraft>(std::move(surface));
}

std::vector<ObjectDraft> read_clip_objects(Context& context) {
    std::vector<ObjectDraft> objects;
    while (auto object = read_object(context)) objects.push_back(std::move(*object));
    if (objects.empty()) context.in.unexpected("an object");
    while (const auto step = read_placement(context.in)) {
        for (ObjectDraft& object : objects) object.move(*step);
    }
    return objects;
}

void read_clips(Context& context, ObjectDraft& object) {
    const Place place = context.in.peek().place;
    context.in.expect('{', "clipped_by");
    if (context.in.accept(Word::bounded_by_)) {
        object.clips = object.bounds;
        for (const ObjectDraft& clip : object.clips) {
            if (clip.is_patch() || clip.is_union() || !clip.clips.empty()) {
                context.in.fail(place, "these bounds cannot clip; clip by a box, a sphere, a plane, ...");
            }
        }
    } else {
        for (ObjectDraft& clip : read_clip_objects(context)) {
            if (clip.is_patch() || clip.is_light())
                context.in.fail(place, "a clip needs an inside: a box, a sphere, a plane, ...");
            if (!clip.clips.empty()) context.in.fail(place, "a clipped object cannot clip; list both clips instead");
            if (clip.is_union()) context.in.fail(place, "a union cannot clip; clip by a box, a sphere, a plane, ...");
            clip.bounds.clear();
            object.clips.push_back(std::move(clip));
        }
    }
    context.in.expect('}', "clipped_by");
}

void read_bounds(Context& context, ObjectDraft& object) {
    context.in.note(context.in.peek().place, "bounded_by is read and has no effect: Raysteps finds bounds itself");
    context.in.expect('{', "bounded_by");
    if (!context.in.accept(Word::clipped_by_)) {
        object.bounds = read_clip_objects(context);
        for (ObjectDraft& bound : object.bounds) bound.bounds.clear();
    }
    context.in.expect('}', "bounded_by");
}

void set_hollow(ObjectDraft& object, bool hollow) {
    object.hollow = hollow;
    object.hollow_said = true;
}

bool read_surface_modifier(Context& context, ObjectDraft& object) {
    Interpreter& in = context.in;
    const Token word = in.peek();
    switch (word.word) {
        case Word::texture_:
            in.take();
            in.expect('{', "a texture");
            wear(context, object, read_texture(context), word.place);
            in.expect('}', "a texture");
            return true;
        case Word::pigment_:
        case Word::finish_:
            in.take();
            read_pigment_or_finish(context, object, word.word);
            return true;
        case Word::interior_: {
            in.take();
            object.interior = read_interior(in, object.interior);
            object.interior_placement.reset();
            return true;
        }
        case Word::material_: {
            in.take();
            MaterialDraft material = read_material(context, {nullptr, object.interior});
            if (material.surface) wear(context, object, material.surface, word.place);
            object.interior = material.interior;
            object.interior_placement.reset();
            return true;
        }
        default: return false;
    }
}

bool read_flag(Context& context, ObjectDraft& object) {
    Interpreter& in = context.in;
    const Token word = in.peek();
    switch (word.word) {
        case Word::inverse_:
            in.take();
            if (object.is_union()) in.fail(word, "a union cannot be inverted; invert its parts");
            if (object.is_patch()) in.note(word.place, "inverse has no effect on a thing without an inside");
            object.inverse = !object.inverse;
            return true;
        case Word::no_shadow_:
            in.take();
            object.no_shadow = true;
            return true;
        case Word::hollow_:
            in.take();
            set_hollow(object, in.flag());
            return true;
        case Word::photons_:
            in.take();
            object.photons = read_object_photons(in, object.photons.value_or(ObjectPhotons{}));
            return true;
        case Word::clipped_by_:
            in.take();
            read_clips(context, object);
            return true;
        case Word::bounded_by_:
            in.take();
            read_bounds(context, object);
            return true;
        case Word::sturm_:
        case Word::hierarchy_:
        case Word::split_union_:
            in.take();
            in.flag();
            in.note(word.place, fmt::format("'{}' is read and has no effect", word.text));
            return true;
        case Word::no_image_:
        case Word::no_reflection_:
        case Word::no_radiosity_:
        case Word::double_illuminate_:
            in.take();
            if (in.flag()) in.fail(word, fmt::format("'{}' is not in the subset; remove it", word.text));
            return true;
        default: return false;
    }
}

}  // namespace

void read_object_modifiers(Context& context, ObjectDraft& object) {
    Interpreter& in = context.in;
    while (in.peek().kind == Token::Kind::word) {
        if (const auto step = read_placement(in)) {
            object.move(*step);
        } else if (!read_surface_modifier(context, object) && !read_flag(context, object)) {
            break;
        }
    }
    if (!in.accept('}')) {
        in.unexpected(
            "a texture, pigment, finish, interior, material, transform, inverse, no_shadow, hollow, clipped_by, "
            "bounded_by, photons or '}' in an object");
    }
}

}  // namespace rays::sdl
