// The stability sweeps of step 1.
#pragma once

#include <functional>

#include "questions/construct.h"

namespace rays::grader::step_1 {

using namespace construct;

/// Fills in one point of a sweep at x.
using AskAt = std::function<void(Notebook& book, Dice& dice, L x)>;

/// A sweep over 10^k, k from `first` to `last` by steps of `step`.
struct Decades {
    double first, last, step = 1;
};

struct Plan {
    const char *id, *task, *title, *x_label, *y_label;
    Decades decades;
    double pass_from, pass_to;
    AskAt ask;
};
Sweep carry_out(const Plan& plan, std::uint64_t seed);

std::vector<Plan> sweeps_of_round_shapes();   // spheres, cones, quadrics
std::vector<Plan> sweeps_of_flat_shapes();    // planes, triangles, polygons, boxes, meshes
std::vector<Plan> sweeps_of_curved_shapes();  // torus, patch; transforms and bounds

}  // namespace rays::grader::step_1
