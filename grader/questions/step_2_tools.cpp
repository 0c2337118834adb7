#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "questions/step_2.h"

namespace rays::grader::step_2 {

V Dice::unit() {
    const double z = between(-1, 1), turn = between(0, 2 * kPi), r = std::sqrt(1 - z * z);
    return glm::normalize(V(r * std::cos(turn), r * std::sin(turn), z));
}
V Dice::color() {
    const double r = round_between(0.05, 1), g = round_between(0.05, 1);
    return {r, g, round_between(0.05, 1)};
}
V Dice::position(double reach) {
    const double x = round_between(-reach, reach), y = round_between(-reach, reach);
    return {x, y, round_between(-reach, reach)};
}

V across(const V& n) { return glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? V(1, 0, 0) : V(0, 1, 0))); }

V tilted(const V& n, double angle, double turn) {
    const V a = across(n), b = glm::cross(n, a);
    return glm::normalize(std::cos(angle) * n + std::sin(angle) * (std::cos(turn) * a + std::sin(turn) * b));
}

std::string number(double v) { return fmt::format("{}", v); }
std::string numbers(const V& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
std::string vector(const V& v) { return fmt::format("<{}, {}, {}>", v.x, v.y, v.z); }
std::string rgb(const V& color) { return "rgb " + vector(color); }

std::string header(const V& ambient_light) {
    return "#version 3.7;\nglobal_settings { assumed_gamma 1.0 ambient_light " + rgb(ambient_light) +
           " }\ncamera { location <0, 0, -10> look_at 0 }\n";
}

std::string sphere(const V& center, double radius, const std::string& pigment, const std::string& finish,
                   const std::string& modifiers) {
    return fmt::format("sphere {{ {}, {} pigment {{ {} }} finish {{ {} }} {} }}\n", vector(center), radius, pigment,
                       finish, modifiers);
}

namespace {

std::string shown(const std::vector<double>& v) {
    std::string text;
    for (const double x : v) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", x);
    return text;
}

Judge all_close(std::vector<double> truth, Tolerance tolerance) {
    return [truth = std::move(truth), tolerance](const Answer& answer) {
        Judgement judgement{false, std::numeric_limits<double>::infinity(), shown(truth)};
        if (answer.kind != Answer::Kind::value || answer.numbers.size() != truth.size()) return judgement;
        double largest = 0, worst = 0;
        bool all_numbers = true;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            largest = std::max(largest, std::abs(truth[i]));
            worst = std::max(worst, std::abs(answer.numbers[i] - truth[i]));
            all_numbers = all_numbers && std::isfinite(answer.numbers[i]);
        }
        if (!all_numbers) return judgement;
        judgement.error = largest > 0 ? worst / largest : worst;
        judgement.ok = worst <= tolerance.absolute + tolerance.relative * largest;
        return judgement;
    };
}

}  // namespace

Judge close_to(const V& truth, Tolerance tolerance) { return all_close({truth.x, truth.y, truth.z}, tolerance); }
Judge close_to(double truth, Tolerance tolerance) { return all_close({truth}, tolerance); }

Judge says(bool truth) {
    return [truth](const Answer& answer) {
        Judgement judgement{false, 1, truth ? "1" : "0"};
        if (answer.kind != Answer::Kind::value || answer.numbers.size() != 1) return judgement;
        judgement.ok = answer.numbers[0] == (truth ? 1 : 0);
        judgement.error = judgement.ok ? 0 : 1;
        return judgement;
    };
}

// ---- Truth ----------------------------------------------------------------------------------------------------------

std::string Finish::text() const {
    return fmt::format("ambient {} emission {} diffuse {} phong {} phong_size {} specular {} roughness {}{}{}",
                       rgb(ambient), rgb(emission), diffuse, phong, phong_size, specular, roughness,
                       metallic > 0 ? fmt::format(" metallic {}", metallic) : "",
                       brilliance != 1 ? fmt::format(" brilliance {}", brilliance) : "");
}

double r_dot_l(const V& n, const V& l, const V& v) { return 2 * glm::dot(n, v) * glm::dot(n, l) - glm::dot(v, l); }

double n_dot_h(const V& n, const V& l, const V& v) {
    return (glm::dot(n, l) + glm::dot(n, v)) / std::sqrt(2 + 2 * glm::dot(l, v));
}

double fresnel(double n_dot_l) {
    const double x = std::acos(std::min(1.0, n_dot_l)) * 2 / kPi - 1.12;
    return std::min(1.0, std::max(0.0, 0.014567225 / (x * x) - 0.011612903));
}

V highlight_tint(const Finish& finish, const V& color, const V& n, const V& l) {
    const double own = finish.metallic * (1 - fresnel(glm::dot(n, l)));
    return (1 - own) * V(1) + own * color;
}

V shaded(const Finish& finish, const V& color, const V& n, const V& l, const V& v, bool matt) {
    const double cosine = glm::dot(n, l);
    if (cosine <= 0) return V(0);
    V sum = finish.diffuse * std::pow(cosine, finish.brilliance) * color;
    if (matt) return sum;
    const double mirrored = r_dot_l(n, l, v), half = n_dot_h(n, l, v);
    double highlight = 0;
    if (finish.phong > 0 && mirrored > 0) highlight += finish.phong * std::pow(mirrored, finish.phong_size);
    if (finish.specular > 0 && half > 0) highlight += finish.specular * std::pow(half, 1 / finish.roughness);
    return sum + highlight * highlight_tint(finish, color, n, l);
}

std::string Lamp::text() const {
    std::string words = "light_source { " + vector(location) + ", " + rgb(color);
    if (fade_power > 0) words += fmt::format(" fade_distance {} fade_power {}", fade_distance, fade_power);
    return words + (shadowless ? " shadowless }\n" : " }\n");
}

double Lamp::fading(double distance) const {
    if (fade_power <= 0) return 1;
    return 2 / (1 + std::pow(distance / fade_distance, fade_power));
}

}  // namespace rays::grader::step_2
