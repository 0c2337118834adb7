#include "questions/step_1_sweeps.h"

#include <cmath>

namespace rays::grader {

namespace step_1 {

Sweep carry_out(const Plan& plan, std::uint64_t seed) {
    Sweep sweep;
    sweep.id = plan.id;
    sweep.task = plan.task;
    sweep.title = plan.title;
    sweep.x_label = plan.x_label;
    sweep.y_label = plan.y_label;
    sweep.pass_from = plan.pass_from;
    sweep.pass_to = plan.pass_to;
    const auto [first, last, step] = plan.decades;
    const int count = static_cast<int>(std::lround(std::abs(last - first) / step));
    for (int i = 0; i <= count; ++i) {
        // The same dice at every x: only x changes along the chart.
        Dice dice(seed);
        Notebook book(plan.task);
        const double x = std::pow(10, first + (last > first ? i : -i) * step);
        plan.ask(book, dice, x);
        sweep.points.push_back({x, book.take()});
    }
    return sweep;
}

}  // namespace step_1

std::vector<Sweep> sweeps_1_ray_casting(std::uint64_t seed) {
    using namespace step_1;
    std::vector<Sweep> sweeps;
    for (const auto& plans : {sweeps_of_round_shapes(), sweeps_of_flat_shapes(), sweeps_of_curved_shapes()})
        for (const Plan& plan : plans) sweeps.push_back(carry_out(plan, seed + sweeps.size()));
    return sweeps;
}

}  // namespace rays::grader
