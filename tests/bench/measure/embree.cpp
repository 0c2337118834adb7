// Embree 3 (Wald et al., "Embree: A Kernel Framework for Efficient CPU Ray Tracing", 2014) on the same bodies and rays,
// one ray a call.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <array>
#include <atomic>
#include <limits>
#include <stdexcept>

#include "contender.h"

namespace rays::bench {
namespace {

std::atomic<std::ptrdiff_t> allocated{0};

bool count_bytes(void*, ssize_t bytes, bool) {
    allocated += bytes;
    return true;
}

RTCDevice device() {
    static const RTCDevice the_device = [] {
        const RTCDevice made = rtcNewDevice(nullptr);
        if (!made) throw std::runtime_error("Embree does not start");
        rtcSetDeviceMemoryMonitorFunction(made, count_bytes, nullptr);
        return made;
    }();
    return the_device;
}

class Embree final : public Structure {
public:
    explicit Embree(const Bodies& bodies) : scene_(rtcNewScene(device())) {
        RTCGeometry geometry = bodies.are_spheres() ? spheres(bodies.scene) : mesh(bodies.scene.meshes.at(0));
        const std::ptrdiff_t before = allocated;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
        bytes_ = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, allocated - before));
        if (rtcGetDeviceError(device()) != RTC_ERROR_NONE) throw std::runtime_error("Embree could not build");
    }
    ~Embree() override { rtcReleaseScene(scene_); }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    Real nearest(const Batch& batch) const override {
        Real sum = 0;
        for (const Ray& ray : batch.rays)
            if (const float t = nearest(ray); t < kNever) sum += t;
        return sum;
    }
    std::size_t occluded(const Batch& batch) const override {
        std::size_t hits = 0;
        for (const Ray& ray : batch.rays) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRay asked = of(ray);
            rtcOccluded1(scene_, &context, &asked);
            hits += asked.tfar < 0;  // how Embree says yes
        }
        return hits;
    }
    std::vector<Real> distances(const Batch& batch) const override {
        std::vector<Real> result;
        for (const Ray& ray : batch.rays) result.push_back(nearest(ray));
        return result;
    }
    std::size_t bytes() const override { return bytes_; }

private:
    static constexpr float kNever = std::numeric_limits<float>::infinity();

    static RTCRay of(const Ray& ray) {
        RTCRay result;
        result.org_x = static_cast<float>(ray.origin.x);
        result.org_y = static_cast<float>(ray.origin.y);
        result.org_z = static_cast<float>(ray.origin.z);
        result.tnear = static_cast<float>(kNearest);
        result.dir_x = static_cast<float>(ray.direction.x);
        result.dir_y = static_cast<float>(ray.direction.y);
        result.dir_z = static_cast<float>(ray.direction.z);
        result.time = 0;
        result.tfar = kNever;
        result.mask = ~0u;
        result.id = 0;
        result.flags = 0;
        return result;
    }

    float nearest(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit asked;
        asked.ray = of(ray);
        asked.hit.geomID = asked.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &asked);
        return asked.ray.tfar;
    }

    template <class Row>
    static Row* new_rows(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
        return static_cast<Row*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Row), count));
    }

    static RTCGeometry mesh(const Mesh& from) {
        RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* points =
            new_rows<std::array<float, 3>>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, from.positions.size());
        for (const Vec3& p : from.positions)
            *points++ = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
        auto* faces = new_rows<std::array<std::uint32_t, 3>>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3,
                                                             from.faces.size());
        for (const Mesh::Face& face : from.faces) *faces++ = face.position;
        return geometry;
    }

    static RTCGeometry spheres(const Scene& from) {
        RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* rows =
            new_rows<std::array<float, 4>>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, from.spheres.size());
        for (const Sphere& s : from.spheres)
            *rows++ = {static_cast<float>(s.center.x), static_cast<float>(s.center.y), static_cast<float>(s.center.z),
                       static_cast<float>(s.radius)};
        return geometry;
    }

    RTCScene scene_;
    std::size_t bytes_ = 0;
};

}  // namespace

std::vector<Contender> other_contenders() {
    return {{"embree", "Embree " RTC_VERSION_STRING ", single rays in float", 0,
             [](const Bodies& bodies) -> std::unique_ptr<Structure> { return std::make_unique<Embree>(bodies); }}};
}

}  // namespace rays::bench
