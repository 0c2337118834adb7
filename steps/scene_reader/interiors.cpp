// Interiors, media, densities, materials.
#include <fmt/format.h>

#include "core/error.h"
#include "scene_reader/statements.h"

namespace rays::sdl {

namespace {

float single(Interpreter& in) { return static_cast<float>(in.number()); }

Media::Scattering read_scattering(Interpreter& in) {
    in.expect('{', "scattering");
    Media::Scattering scattering;
    scattering.type = in.integer("the type of scattering", 1, 5);
    in.comma();
    scattering.color = in.rgb();
    for (;;) {
        const Place place = in.peek().place;
        if (in.accept(Word::eccentricity_)) {
            scattering.eccentricity = single(in);
            if (scattering.type != 5) in.fail(place, "eccentricity belongs to scattering type 5");
            if (!(std::abs(scattering.eccentricity) < 1)) in.fail(place, "eccentricity lies between -1 and 1");
        } else if (in.accept(Word::extinction_)) {
            scattering.extinction = single(in);
        } else {
            break;
        }
    }
    if (!in.accept('}')) in.unexpected("eccentricity, extinction or '}' in scattering");
    return scattering;
}

/// POV-Ray's df3: three sizes of two bytes, big endian, then one, two or four bytes a cell, x fastest.
Shared<Media::GridDensity> read_df3(Interpreter& in) {
    const Token name = in.peek();
    const std::string file = in.string();
    std::string bytes;
    try {
        const auto path = in.sources().find_file(file);
        if (path.empty()) in.fail(name, fmt::format("density file '{}' is not in the scene's folder", file));
        bytes = read_bytes(path, kMostBytesOfText);
    } catch (const InputError& error) {
        in.fail(name, error.what());
    }
    const auto byte = [&bytes](std::size_t i) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i]));
    };
    if (bytes.size() < 6) in.fail(name, "this density file is too short for its header");
    auto grid = std::make_shared<Media::GridDensity>();
    std::size_t cells = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        grid->size[i] = byte(2 * i) << 8 | byte(2 * i + 1);
        cells *= grid->size[i];
    }
    const std::size_t width = cells ? (bytes.size() - 6) / cells : 0;
    if ((width != 1 && width != 2 && width != 4) || width * cells != bytes.size() - 6) {
        in.fail(name, fmt::format("this density file has {} bytes for {} cells; 1, 2 or 4 a cell are known",
                                  bytes.size() - 6, cells));
    }
    in.spend(static_cast<std::int64_t>(cells));
    in.hold(cells * sizeof(float));
    grid->values.reserve(cells);
    const double largest = width == 1 ? 255.0 : width == 2 ? 65535.0 : 4294967295.0;
    for (std::size_t i = 6; i < bytes.size(); i += width) {
        std::uint32_t value = 0;
        for (std::size_t k = 0; k < width; ++k) value = value << 8 | byte(i + k);
        grid->values.push_back(static_cast<float>(value / largest));
    }
    return grid;
}

/// Between black at 0 and one colour at 1, which then multiplies the density. Anything else is not in the subset.
Radiance read_density_map(Interpreter& in) {
    const Place place = in.peek().place;
    in.expect('{', "color_map");
    Radiance ends[2];
    for (int i = 0; i < 2; ++i) {
        in.expect('[', "a map of two entries");
        const double at = in.number();
        in.comma();
        ends[i] = in.rgb();
        in.expect(']', "a map entry");
        if (at != i) in.fail(place, "only a map [0 rgb 0] [1 rgb C] is in the subset");
    }
    if (!ends[0].is_black()) in.fail(place, "only a map [0 rgb 0] [1 rgb C] is in the subset");
    in.expect('}', "a map of two entries");
    return ends[1];
}

void read_pattern(Interpreter& in, DensityDraft& density) {
    const Place place = in.peek().place;
    if (in.accept(Word::spherical_)) {
        density.form = Media::SphericalDensity{};
    } else if (in.accept(Word::gradient_)) {
        density.form = Media::LinearDensity{0, Vec3(in.vector())};
        in.note(place,
                "gradient is clamped to 0 and 1 where POV-Ray repeats it: keep the medium within its first period");
    } else if (in.accept(Word::density_file_)) {
        if (!in.accept(Word::df3_)) in.unexpected("df3");
        density.form = read_df3(in);
    } else if (in.color_follows()) {
        density.color = in.rgb();
    }
}

bool read_limits_item(Interpreter& in, Media& media) {
    const Token word = in.peek();
    switch (word.word) {
        case Word::intervals_:
            in.take();
            media.intervals = in.integer("intervals", 1, 1'000'000);
            return true;
        case Word::samples_:
            in.take();
            media.samples_min = media.samples_max = in.integer("samples", 1, 1'000'000);
            in.comma();
            if (in.number_follows()) media.samples_max = in.integer("samples", media.samples_min, 1'000'000);
            return true;
        case Word::method_:
            in.take();
            media.method = in.integer("method", 1, 3);
            return true;
        case Word::jitter_:
        case Word::aa_threshold_:
        case Word::aa_level_:
        case Word::confidence_:
        case Word::variance_:
        case Word::ratio_:
        case Word::collect_:
            in.take();
            in.number_or(1);
            in.note(word.place,
                    fmt::format("'{}' belongs to POV-Ray's way of sampling media and has no effect", word.text));
            return true;
        default: return false;
    }
}

}  // namespace

DensityDraft read_density(Interpreter& in) {
    in.expect('{', "a density");
    DensityDraft density;
    if (const auto named = in.accept_named<DensityDraft>()) density = *named;
    read_pattern(in, density);
    for (;;) {
        const Token word = in.peek();
        if (const auto step = read_placement(in)) {
            place_further(density.placement, *step);
        } else if (word.is(Word::color_map_) || word.is(Word::density_map_)) {
            in.take();
            density.color = read_density_map(in);
        } else if (word.is(Word::interpolate_)) {
            in.take();
            const int interpolation = in.integer("interpolate", 0, 2);
            if (const auto* grid = std::get_if<Shared<Media::GridDensity>>(&density.form)) {
                auto copy = std::make_shared<Media::GridDensity>(**grid);
                copy->interpolation = interpolation;
                density.form = Shared<Media::GridDensity>(copy);
            }
        } else {
            break;
        }
    }
    if (!in.accept('}')) {
        in.unexpected(
            "a color, spherical, gradient, density_file df3, interpolate, color_map, a transform or '}' in a density");
    }
    return density;
}

MediaDraft read_media(Interpreter& in) {
    in.expect('{', "media");
    MediaDraft draft;
    draft.media.samples_min = draft.media.samples_max = 10;  // POV-Ray 3.5 and later, method 3
    if (const auto named = in.accept_named<MediaDraft>()) draft = *named;
    in.spend(static_cast<std::int64_t>(10 * draft.densities.size()));
    in.hold(draft.densities.size() * sizeof(DensityDraft));
    while (in.peek().kind == Token::Kind::word) {
        if (in.accept(Word::absorption_)) {
            draft.media.absorption = in.rgb();
        } else if (in.accept(Word::emission_)) {
            draft.media.emission = in.rgb();
        } else if (in.accept(Word::scattering_)) {
            draft.media.scattering = read_scattering(in);
        } else if (in.accept(Word::density_)) {
            draft.densities.push_back(read_density(in));
        } else if (const auto step = read_placement(in)) {
            for (DensityDraft& density : draft.densities) place_further(density.placement, *step);
        } else if (!read_limits_item(in, draft.media)) {
            break;
        }
    }
    if (!in.accept('}')) {
        in.unexpected(
            "absorption, emission, scattering, density, method, intervals, samples, a transform or '}' in media");
    }
    return draft;
}

Shared<InteriorDraft> read_interior(Interpreter& in, Shared<InteriorDraft> start) {
    in.expect('{', "an interior");
    if (const auto named = in.accept_named<InteriorDraft>()) {
        if (in.accept('}')) return named;
        start = named;
    }
    auto draft = start ? std::make_shared<InteriorDraft>(*start) : std::make_shared<InteriorDraft>();
    Interior& interior = draft->interior;
    while (in.peek().kind == Token::Kind::word) {
        const Token word = in.peek();
        if (in.accept(Word::ior_)) {
            interior.ior = single(in);
            if (!(interior.ior > 0)) in.fail(word, "ior must be greater than 0");
        } else if (in.accept(Word::dispersion_)) {
            interior.dispersion = single(in);
        } else if (in.accept(Word::dispersion_samples_)) {
            interior.dispersion_samples = in.integer("dispersion_samples", 2, 100'000);
        } else if (in.accept(Word::caustics_)) {
            interior.caustics = single(in);
        } else if (in.accept(Word::fade_distance_)) {
            interior.fade_distance = single(in);
        } else if (in.accept(Word::fade_power_)) {
            interior.fade_power = single(in);
        } else if (in.accept(Word::fade_color_)) {
            interior.fade_color = in.rgb();
        } else if (in.accept(Word::media_)) {
            draft->media.push_back(read_media(in));
        } else if (in.accept(Word::refraction_)) {
            in.number();
            in.note(word.place, "'refraction' in an interior has no effect; ior decides");
        } else {
            break;
        }
    }
    if (!in.accept('}')) {
        in.unexpected(
            "ior, dispersion, dispersion_samples, caustics, fade_distance, fade_power, fade_color, media or '}' in an "
            "interior");
    }
    return draft;
}

MaterialDraft read_material(Context& context, MaterialDraft start) {
    Interpreter& in = context.in;
    in.expect('{', "a material");
    MaterialDraft material = std::move(start);
    if (const auto named = in.accept_named<MaterialDraft>()) material = *named;
    for (;;) {
        const Place place = in.peek().place;
        if (in.accept(Word::texture_)) {
            in.expect('{', "a texture");
            if (material.surface)
                in.fail(place, "layered textures are not in the subset; give the material one texture");
            material.surface = read_texture(context);
            in.expect('}', "a texture");
        } else if (in.accept(Word::interior_)) {
            material.interior = read_interior(in, material.interior);
        } else if (const auto step = read_placement(in)) {
            if (material.surface) {
                auto surface = std::make_shared<SurfaceDraft>(*material.surface);
                place_further(surface->pigment.placement, *step);
                material.surface = surface;
            }
            if (material.interior) {
                auto interior = std::make_shared<InteriorDraft>(*material.interior);
                for (MediaDraft& media : interior->media) {
                    for (DensityDraft& density : media.densities) place_further(density.placement, *step);
                }
                material.interior = interior;
            }
        } else {
            break;
        }
    }
    if (!in.accept('}')) in.unexpected("a texture, interior, transform or '}' in a material");
    return material;
}

}  // namespace rays::sdl
