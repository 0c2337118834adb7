#include "renderer/distribute.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "core/unfinished.h"
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
    return std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) { return m.finish.glossy > 0; });
}

}  // namespace

bool needs_distribution(const Scene& scene) {
    return has_area_lights(scene) || scene.camera.aperture > 0 || varies_with_time(scene) || is_rough(scene);
}

Distribution::Distribution(const Scene& scene, const RenderOptions& options)
    : scene_(scene), options_(options), pattern_(options.pattern.value_or(Pattern::sobol)), moves_(varies_with_time(scene)) {
    if (!moves_) still_ = make_intersector(scene, options.partition);
}

Draw Distribution::draw(int x, int y, std::uint32_t sample, std::uint32_t samples) const {
    const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(options_.raster.width) + static_cast<std::uint32_t>(x);
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
    if (is_rough(*scene)) world_->roughness = this;
    has_area_lights_ = has_area_lights(*scene);
    lights_ = scene->lights;
    if (has_area_lights_) world_->lights = lights_;
}

Draw SampleTracer::draw_for(Purpose purpose, std::uint32_t number) const {
    Draw draw = draw_;
    draw.dimension = dimension_of(purpose, number, static_cast<std::uint32_t>(lights_.size()));
    return draw;
}

Vec2 SampleTracer::point(Purpose purpose, std::uint32_t number) const {
    return point_of(distribution_.pattern(), draw_for(purpose, number));
}

Real SampleTracer::one_number(Purpose purpose, std::uint32_t number) const {
    return number_of(distribution_.pattern(), draw_for(purpose, number));
}

void SampleTracer::tilt(Surface& surface) {
    if (!(surface.finish->glossy > 0)) return;
    surface.normal = tilted_normal(surface, point(Purpose::rough_surface, rough_surfaces_++));
}

Radiance SampleTracer::sample(int x, int y, const Draw& draw) {
    const Scene& scene = world_->scene;
    draw_ = draw;
    rough_surfaces_ = 0;
    if (motion_) motion_->set_time(shutter_time(scene.camera, one_number(Purpose::time)));
    if (has_area_lights_) {
        for (std::uint32_t i = 0; i < lights_.size(); ++i) {
            const Light& light = scene.lights[i];
            const Real third = light.area && light.orient ? one_number(Purpose::ball_light, i) : 0;
            lights_[i] = light.area ? light_at(light, point(Purpose::light, i), third) : light;
        }
    }
    const FilterPoint at = filter_point(distribution_.options().filter, point(Purpose::pixel));
    const Vec2 lens = scene.camera.aperture > 0 ? point(Purpose::lens) : Vec2(0);
    const Ray ray = lens_ray(scene.camera, distribution_.options().raster, x, y, at.offset, lens);
    const Inside inside = media_ ? media_->at(ray.origin)
                                 : world_->sees_through ? media_around(scene, ray.origin) : Inside();
    return at.weight * radiance(*world_, ray, inside);
}

namespace {

/// Which of the four groups a sample of the round belongs to that makes `before` samples `after`: each group gets a run
/// of neighbours, which are stratified among themselves.
std::uint32_t group_of(std::uint32_t sample, std::uint32_t before, std::uint32_t after) {
    return (sample - before) * Estimate::kGroups / (after - before);
}

/// A picture that is sampled until every pixel is good enough.
class AdaptivePicture {
public:
    AdaptivePicture(const Distribution& distribution, Residuals& residuals)
        : distribution_(distribution), raster_(distribution.options().raster), residuals_(residuals),
          pixels_(std::size_t(raster_.width) * std::size_t(raster_.height)), active_(pixels_.size(), 1),
          unfinished_(pixels_.size(), 0), pruned_(pixels_.size(), 0) {}

    /// One more round for row y: active pixels get samples up to `after` in all.
    void sample_row(SampleTracer& tracer, int y, std::uint32_t before, std::uint32_t after) {
        for (int x = 0; x < raster_.width; ++x) {
            if (!active_[index(x, y)]) continue;
            Estimate& estimate = pixels_[index(x, y)];
            tracer.pruned() = 0;
            for (std::uint32_t s = before; s < after; ++s)
                estimate.sum[group_of(s, before, after)] += tracer.sample(x, y, distribution_.draw(x, y, s, after));
            estimate.samples = after;
            pruned_[index(x, y)] += tracer.pruned();
            if (take_unfinished_task()) unfinished_[index(x, y)] = 1;
        }
    }
    /// Who has to go on? Returns how many.
    std::size_t choose(float wanted) {
        std::vector<float> errors(pixels_.size());
        for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = standard_error(pixels_[i]);
        std::size_t left = 0;
        for (int y = 0; y < raster_.height; ++y)
            for (int x = 0; x < raster_.width; ++x) {
                float around[8];
                std::size_t count = 0;
                for (int v = std::max(0, y - 1); v <= std::min(raster_.height - 1, y + 1); ++v)
                    for (int u = std::max(0, x - 1); u <= std::min(raster_.width - 1, x + 1); ++u)
                        if (u != x || v != y) around[count++] = errors[index(u, v)];
                auto& active = active_[index(x, y)];
                active = active && !is_enough(errors[index(x, y)], {around, count}, wanted);
                left += active;
            }
        take_unfinished_task();
        return left;
    }
    void finish(Film& film) {
        for (int y = 0; y < raster_.height; ++y)
            for (int x = 0; x < raster_.width; ++x) {
                const Radiance mean = pixels_[index(x, y)].mean();
                film.at(x, y) = unfinished_[index(x, y)] ? striped(mean, x, y) : mean;
                residuals_.add(x, y, pruned_[index(x, y)] / pixels_[index(x, y)].samples);
            }
    }
    double mean_samples() const {
        double all = 0;
        for (const Estimate& pixel : pixels_) all += pixel.samples;
        return all / double(pixels_.size());
    }

private:
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(raster_.width) + std::size_t(x); }

    const Distribution& distribution_;
    Raster raster_;
    Residuals& residuals_;
    std::vector<Estimate> pixels_;
    std::vector<char> active_, unfinished_;
    std::vector<double> pruned_;
};

/// Calls work(tracer, y, reports) for every row, on all threads; each keeps its tracer.
class Crew {
public:
    explicit Crew(const Distribution& distribution) : distribution_(distribution) {
        const RenderOptions& options = distribution.options();
        const int wanted = options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
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
    crew.each_row([&](SampleTracer& tracer, int y, bool reports) {
        for (int x = 0; x < options.raster.width; ++x) {
            tracer.pruned() = 0;
            Radiance sum;
            for (std::uint32_t s = 0; s < samples; ++s) sum += tracer.sample(x, y, distribution.draw(x, y, s, samples));
            const Radiance mean = (1.0f / static_cast<float>(samples)) * sum;
            film.at(x, y) = take_unfinished_task() ? striped(mean, x, y) : mean;
            residuals.add(x, y, tracer.pruned() / samples);
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
