// Where eight rays meet surfaces.
#pragma once

#include "core/hit.h"
#include "packets/rays.h"

namespace rays::packets {

/// As eight of `Hit`, as far as shading asks. In memory, since lanes are written group by group and sometimes one by
/// one.
struct Hits {
    unsigned are = 0;  ///< which rays have met something
    Spread t;
    struct Vectors {
        Spread x, y, z;
        Vec3s load() const { return {Reals::load(x.lane), Reals::load(y.lane), Reals::load(z.lane)}; }
        Vec3 operator[](int i) const { return {x[i], y[i], z[i]}; }
        void set(int i, const Vec3& v) { x.lane[i] = v.x, y.lane[i] = v.y, z.lane[i] = v.z; }
        void set(Mask where, const Vec3s& v) {
            const Vec3s mixed = select(where, v, load());
            mixed.x.store(x.lane), mixed.y.store(y.lane), mixed.z.store(z.lane);
        }
    };
    Vectors point, normal;  ///< the normal is the shading normal
    std::uint32_t object[kLanes], material[kLanes];

    void set(int i, const Hit& hit) {
        are |= 1u << i;
        t.lane[i] = hit.t;
        point.set(i, hit.point);
        normal.set(i, hit.shading_normal);
        object[i] = hit.object;
        material[i] = hit.material;
    }
};

}  // namespace rays::packets
