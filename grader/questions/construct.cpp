#include "questions/construct.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace rays::grader::construct {

V Dice::unit() {
    for (;;) {
        const V v(between(-1, 1), between(-1, 1), between(-1, 1));
        const L l2 = glm::dot(v, v);
        if (l2 > 0.01L && l2 < 1) return v / std::sqrt(l2);
    }
}

V Dice::position(double reach) {
    const L x = round_between(-reach, reach), y = round_between(-reach, reach);
    return {x, y, round_between(-reach, reach)};
}

void frame(const V& n, V& x, V& y) {
    x = glm::normalize(glm::cross(n, std::abs(n.x) < 0.6L ? V(1, 0, 0) : V(0, 1, 0)));
    y = glm::cross(n, x);
}

std::string number(L v) { return fmt::format("{}", static_cast<double>(v)); }
std::string numbers(const V& v) { return fmt::format("{} {} {}", number(v.x), number(v.y), number(v.z)); }
std::string vector(const V& v) { return fmt::format("<{}, {}, {}>", number(v.x), number(v.y), number(v.z)); }

std::string scene_of(const std::string& objects) {
    return "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 0, -10> look_at <0, 0, 0> }\n"
           "#default { pigment { color rgb 1 } finish { ambient 0 diffuse 1 } }\n" +
           objects;
}

Shot aim(const V& target, const V& unit_direction, L distance, L speed) {
    Shot shot{rounded(target - distance * unit_direction), rounded(speed * unit_direction), 0};
    shot.t = glm::dot(target - shot.origin, shot.direction) / glm::dot(shot.direction, shot.direction);
    return shot;
}

std::string root_query(const Shot& shot, L t_min, L t_max, int object) {
    return fmt::format("root {} {} {} {}", object, shot.text(), number(t_min), number(t_max));
}
std::string nearest_query(const Shot& shot, L t_min, L t_max) {
    return fmt::format("nearest {} {} {}", shot.text(), number(t_min), number(t_max));
}

namespace {

constexpr double kWrong = std::numeric_limits<double>::infinity();

Judgement judged(double error, double tolerance, std::string expected) {
    const bool ok = error <= tolerance;  // NaN is not
    return {ok, std::isnan(error) ? kWrong : error, std::move(expected)};
}

/// Difference of two unit vectors; infinite unless the answer's is of unit length.
double off(const Answer& answer, std::size_t first, const V& truth, bool either_side) {
    const V n(answer.numbers[first], answer.numbers[first + 1], answer.numbers[first + 2]);
    if (!(std::abs(glm::length(n) - 1) <= kNormal)) return kWrong;
    const L straight = glm::length(n - truth), turned = glm::length(n + truth);
    return static_cast<double>(either_side ? std::min(straight, turned) : straight);
}

bool is_hit(const Answer& answer, std::size_t count) {
    return answer.kind == Answer::Kind::value && answer.numbers.size() == count;
}

constexpr std::size_t kRootNumbers = 1, kNearestNumbers = 8;

double off_in_length(const Answer& answer, L t, L speed) {
    return static_cast<double>(std::abs(answer.numbers[0] - t) * speed);
}

}  // namespace

Judge misses_it() {
    return [](const Answer& answer) { return judged(answer.kind == Answer::Kind::miss ? 0 : kWrong, 0, "miss"); };
}

Judge hits_at(L t, L speed, L tolerance) {
    return [=](const Answer& answer) {
        const bool hit = is_hit(answer, kRootNumbers) || is_hit(answer, kNearestNumbers);
        return judged(hit ? off_in_length(answer, t, speed) : kWrong, static_cast<double>(tolerance),
                      "hit " + number(t));
    };
}

Judge hits(const Shot& shot) { return hits_at(shot.t, shot.speed(), kLength * (1 + std::abs(shot.t) * shot.speed())); }

Judge hits_with_normal(const Shot& shot, const V& normal, bool either_side, int object) {
    return [=, where = hits(shot)](const Answer& answer) {
        const std::string expected = fmt::format("hit {} with {}normal {} of object {}", number(shot.t),
                                                 either_side ? "+- " : "", numbers(normal), object);
        if (!is_hit(answer, kNearestNumbers)) return Judgement{false, kWrong, expected};
        if (!where(answer).ok || answer.numbers[7] != object) return Judgement{false, kWrong, expected};
        return judged(off(answer, 1, normal, either_side), kNormal, expected);
    };
}

Judge hits_with_shading_normal(const Shot& shot, const V& shading_normal) {
    return [=, where = hits(shot)](const Answer& answer) {
        const std::string expected = "hit " + number(shot.t) + " with shading normal " + numbers(shading_normal);
        if (!is_hit(answer, kNearestNumbers) || !where(answer).ok) return Judgement{false, kWrong, expected};
        return judged(off(answer, 4, shading_normal, false), kNormal, expected);
    };
}

Judge says(bool truth) {
    return [=](const Answer& answer) {
        const bool right = is_hit(answer, 1) && answer.numbers[0] == (truth ? 1 : 0);
        return judged(right ? 0 : kWrong, 0, truth ? "1" : "0");
    };
}

Judge lands_on(const Shot& shot, std::function<L(const V&)> off_surface, L tolerance) {
    return [=](const Answer& answer) {
        const double error = is_hit(answer, kRootNumbers)
                                 ? static_cast<double>(std::abs(off_surface(shot.at(answer.numbers[0]))))
                                 : kWrong;
        return judged(error, static_cast<double>(tolerance), "hit near " + number(shot.t));
    };
}

}  // namespace rays::grader::construct
