// Robust roots beside the textbook's, near and far.
#include "charts.h"
#include "methods.h"

namespace rays::bench {

Chart sphere_near(Laboratory& laboratory) {
    return roots_chart("1.sphere.near", "A sphere from 10 radii away",
                       "b^2 - c loses about a digit here; the robust form loses none, and takes longer.", "sphere/near",
                       laboratory);
}

Chart sphere_far(Laboratory& laboratory) {
    return roots_chart(
        "1.sphere.far", "A sphere from 10 000 radii away",
        "The error of b^2 - c grows with the square of the distance: in float no digit is left and most rays are "
        "answered wrongly, in double half of the digits are gone. The robust form loses only what t itself cannot "
        "hold.",
        "sphere/far", laboratory);
}

Chart quadric_near(Laboratory& laboratory) {
    return roots_chart(
        "1.quadric.near", "An ellipsoid (quadric) from 10 sizes away",
        "The price of the robust form: moving to the nearest point, a fused discriminant, Vieta's roots.",
        "quadric/near", laboratory);
}

Chart quadric_far(Laboratory& laboratory) {
    return roots_chart("1.quadric.far", "An ellipsoid (quadric) from 10 000 sizes away",
                       "Set up at the ray's origin, the coefficients are those of the distance, not of the shape.",
                       "quadric/far", laboratory);
}

}  // namespace rays::bench
