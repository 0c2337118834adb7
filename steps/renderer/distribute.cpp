#include "renderer/distribute.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "core/unfinished.h"
#include "renderer/adaptive_picture.h"
#include "renderer/radiance.h"
#include "renderer/rows.h"

namespace rays {
namespace {

/// Adaptive sampling begins with so many, and doubles.
constexpr std::uint32_t kFirstSamples = 16;

bool varies_with_time(const Scene& scene) {
    return std::any_of(scene.varying.begin(), scene.varying.end(),
                       [](const Varying& v) { return v.variable == Varying::Variable::time; });
}
bool has_area_lights(const Scene& scene) {
    return std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) { return light.area; });
}
bool is_rough(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const Material& m) { return m.finish.glossy > 0; });
}

bool has_smooth_faces(const Mesh& mesh) {
    return std::any_of(mesh.faces.begin(), mesh.faces.end(), [](const Mesh::Face& face) { return face.smooth; });
}

/// Not where things move, where something else than a point stands for an area light, nor where interpolated normals
/// tilt.
bool fits_packets(const Scene& scene, const RenderOptions& options) {
    if (!options.packets || options.partition != Partition::automatic || varies_with_time(scene)) return false;
    const bool only_points = std::all_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
        return !light.area || (light.kind == Light::Kind::point && !light.parallel);
    });
    const bool smoothed =
        !scene.smooth_triangles.empty() || std::any_of(scene.meshes.begin(), scene.meshes.end(), has_smooth_faces);
    return only_points && !(smoothed && is_rough(scene));
}

}  // namespace

bool needs_distribution(const Scene& scene) {
    return has_area_lights(scene) || scene.camera.aperture > 0 || varies_with_time(scene) || is_rough(scene);
}

Distribution::Distribution(const Scene& scene, const RenderOptions& options)
    : scene_(scene),
      options_(options),
      pattern_(options.pattern.value_or(Pattern::sobol)),
      moves_(varies_with_time(scene)) {
    if (fits_packets(scene, options)) packets_ = make_packets(scene);
    if (!moves_ && !packets_) still_ = make_intersector(scene, options.partition);
}

Draw Distribution::draw(int x, int y, std::uint32_t sample, std::uint32_t samples) const {
    const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(options_.raster.width) +
                       static_cast<std::uint32_t>(x);
    return {options_.seed, pixel, 0, sample, samples};
}

SampleTracer::SampleTracer(const Distribution& distribution) : distribution_(distribution) {
    const Scene* scene = &distribution.scene();
    const Intersector* intersector = distribution.intersector();
    if (distribution.moves()) {
        moving_scene_ = std::make_unique<Scene>(*scene);
        motion_ = std::make_unique<Motion>(*moving_scene_);
        moving_intersector_ = make_moving_intersector(*moving_scene_, *motion_, distribution.options().partition);
        scene = moving_scene_.get();
        intersector = moving_intersector_.get();
    }
    world_ = std::make_unique<World>(make_world(*scene, *intersector));
    if (motion_) {  // what lets light through at any time does so for all of them
        for (const Real time : motion_->knots(scene->camera.shutter_open, scene->camera.shutter_close)) {
            motion_->set_time(time);
            const World then = make_world(*scene, *intersector);
            world_->sees_through = world_->sees_through || then.sees_through;
            world_->filtered_shadows = world_->filtered_shadows || then.filtered_shadows;
        }
    } else {
        media_ = std::make_unique<CameraMedia>(*world_);
    }
    purposes_ = {scene->camera.aperture > 0,
                 has_area_lights(*scene) ? static_cast<std::uint32_t>(scene->lights.size()) : 0};
    if (is_rough(*scene)) world_->roughness = this;
    has_area_lights_ = has_area_lights(*scene);
    lights_ = scene->lights;
    if (has_area_lights_) world_->lights = lights_;
    if (const Packets* packets = distribution.packets()) {
        if (const auto everywhere = media_->everywhere()) {
            everywhere_ = *everywhere;
            tracer_ = packets->tracer(*world_);
            if (distribution.pattern() == Pattern::sobol && distribution.options().filter == Filter::box)
                chooser_ = packets->chooser(distribution.options().raster, purposes_);
            if (has_area_lights_) rays_.light.resize(3 * lights_.size());
            if (is_rough(*scene)) rays_.roughness = this;
        }
    }
}

Draw SampleTracer::draw_for(const Draw& sample, Purpose purpose, std::uint32_t number) const {
    Draw draw = sample;
    draw.dimension = dimension_of(purpose, number, purposes_);
    return draw;
}

Vec2 SampleTracer::point(const Draw& sample, Purpose purpose, std::uint32_t number) const {
    return point_of(distribution_.pattern(), draw_for(sample, purpose, number));
}

Real SampleTracer::one_number(const Draw& sample, Purpose purpose, std::uint32_t number) const {
    return number_of(distribution_.pattern(), draw_for(sample, purpose, number));
}

// The number of a rough surface is how many surfaces lie above it: branches of one tree that part share their numbers,
// which no mean notices, and no order of tracing them matters.
void SampleTracer::tilt(Surface& surface, int above) {
    if (surface.finish->glossy > 0)
        surface.normal =
            tilted_normal(surface, point(draw_, Purpose::rough_surface, static_cast<std::uint32_t>(above)));
}

void SampleTracer::tilt(int ray, Surface& surface, int above) {
    draw_ = draws_[ray];
    tilt(surface, above);
}

Chosen SampleTracer::choose(int x, int y, const Draw& draw) {
    const Scene& scene = world_->scene;
    if (motion_) motion_->set_time(shutter_time(scene.camera, one_number(draw, Purpose::time)));
    if (has_area_lights_) {
        for (std::uint32_t i = 0; i < lights_.size(); ++i) {
            const Light& light = scene.lights[i];
            const Real third = light.area && light.orient ? one_number(draw, Purpose::ball_light, i) : 0;
            lights_[i] = light.area ? light_at(light, point(draw, Purpose::light, i), third) : light;
        }
    }
    const FilterPoint at = filter_point(distribution_.options().filter, point(draw, Purpose::pixel));
    const Vec2 lens = scene.camera.aperture > 0 ? point(draw, Purpose::lens) : Vec2(0);
    return {lens_ray(scene.camera, distribution_.options().raster, x, y, at.offset, lens), at.weight};
}

Radiance SampleTracer::sample(int x, int y, const Draw& draw) {
    draw_ = draw;
    const Chosen chosen = choose(x, y, draw);
    if (has_area_lights_) world_->lights = lights_;
    const Inside inside = media_                 ? media_->at(chosen.ray.origin)
                          : world_->sees_through ? media_around(world_->scene, chosen.ray.origin)
                                                 : Inside();
    return chosen.weight * radiance(*world_, chosen.ray, inside);
}

void SampleTracer::put(int x, int y, Draw draw, std::uint32_t count) {
    const int at = rays_.count;
    if (chooser_) chooser_->add(x, y, draw, static_cast<int>(count), rays_);
    for (int i = at; i < at + static_cast<int>(count); ++i, ++draw.sample) {
        if (rays_.roughness) draws_[i] = draw;
        weights_[i] = 1;
        pruned_[i] = 0;
        if (!chooser_) put_one(x, y, draw);
    }
}

void SampleTracer::put_one(int x, int y, const Draw& draw) {
    const Chosen chosen = choose(x, y, draw);
    const auto i = static_cast<std::size_t>(rays_.count++);
    const Vec3 direction = glm::normalize(chosen.ray.direction);
    for (int a = 0; a < 3; ++a) {
        rays_.origin[a][i] = chosen.ray.origin[a];
        rays_.direction[a][i] = direction[a];
    }
    for (std::size_t column = 0; column < rays_.light.size(); ++column)
        rays_.light[column][i] = lights_[column / 3].location[static_cast<int>(column % 3)];
    weights_[i] = chosen.weight;
}

void SampleTracer::trace_together() { tracer_->trace(rays_, everywhere_, brought_, pruned_); }

namespace {

/// Calls work(tracer, y, reports) for every row, on all threads; each keeps its tracer.
class Crew {
public:
    explicit Crew(const Distribution& distribution) : distribution_(distribution) {
        const RenderOptions& options = distribution.options();
        const int wanted =
            options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
        tracers_.resize(static_cast<std::size_t>(std::clamp(wanted, 1, options.raster.height)));
    }

    template <class Work>
    void each_row(Work work) {
        std::atomic<int> next_row{0};
        const auto run = [&](std::size_t thread) {
            if (!tracers_[thread]) tracers_[thread] = std::make_unique<SampleTracer>(distribution_);
            const int rows = distribution_.options().raster.height;
            for (int y = next_row++; y < rows; y = next_row++) work(*tracers_[thread], y, thread == 0);
        };
        std::vector<std::jthread> helpers;
        for (std::size_t i = 1; i < tracers_.size(); ++i) helpers.emplace_back(run, i);
        run(0);
    }

private:
    const Distribution& distribution_;
    std::vector<std::unique_ptr<SampleTracer>> tracers_;
};

void sample_evenly(const Distribution& distribution, Crew& crew, Film& film, Residuals& residuals) {
    const RenderOptions& options = distribution.options();
    const auto samples = static_cast<std::uint32_t>(options.samples);
    const float weight = 1.0f / static_cast<float>(samples);
    crew.each_row([&](SampleTracer& tracer, int y, bool reports) {
        std::vector<double> pruned(static_cast<std::size_t>(options.raster.width), 0);
        const auto add = [&](std::uint32_t x, const Radiance& brought, double left_out) {
            film.at(static_cast<int>(x), y) += brought;
            pruned[x] += left_out;
        };
        std::vector<char> unfinished(pruned.size(), 0);
        for (int x = 0; x < options.raster.width; ++x) {
            const auto number = [x](std::uint32_t) { return static_cast<std::uint32_t>(x); };
            tracer.add(x, y, distribution.draw(x, y, 0, samples), samples, number, add);
            if (take_unfinished_task()) unfinished[static_cast<std::size_t>(x)] = 1;
        }
        tracer.flush(add);
        for (int x = 0; x < options.raster.width; ++x) {
            const Radiance mean = weight * film.at(x, y);
            film.at(x, y) = unfinished[static_cast<std::size_t>(x)] ? striped(mean, x, y) : mean;
            residuals.add(x, y, pruned[static_cast<std::size_t>(x)] / samples);
        }
        if (reports && options.progress) options.progress(double(y + 1) / options.raster.height);
    });
}

double sample_adaptively(const Distribution& distribution, Crew& crew, Film& film, Residuals& residuals) {
    const RenderOptions& options = distribution.options();
    AdaptivePicture picture(distribution, residuals);
    const auto most = static_cast<std::uint32_t>(options.samples);
    std::uint32_t before = 0, after = std::min(kFirstSamples, most);
    for (;;) {
        crew.each_row([&](SampleTracer& tracer, int y, bool) { picture.sample_row(tracer, y, before, after); });
        if (options.progress) options.progress(std::min(1.0, double(after) / most));
        if (2 * after > most || picture.choose(options.error) == 0) break;
        before = std::exchange(after, 2 * after);
    }
    if (options.progress) options.progress(1);
    picture.finish(film);
    return picture.mean_samples();
}

}  // namespace

Film render_distributed(const Scene& scene, const RenderOptions& options, Residual* residual) {
    Film film(options.raster);
    Residuals residuals(options.raster.height);
    const Distribution distribution(scene, options);
    Crew crew(distribution);
    double samples = options.samples;
    if (options.error > 0)
        samples = sample_adaptively(distribution, crew, film, residuals);
    else
        sample_evenly(distribution, crew, film, residuals);
    if (residual) *residual = residuals.over(options.raster), residual->samples = samples;
    return film;
}

}  // namespace rays
