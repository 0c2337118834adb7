#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "questions/step_3.h"

namespace rays::grader::step_3 {

Meeting meeting(Dice& dice, double angle) {
    Meeting m;
    m.normal = dice.unit();
    // From the sine and cosine of the angle at once: both are exact to the last digit, however grazing.
    const V a = across(m.normal), b = glm::normalize(glm::cross(m.normal, a));
    const double turn = dice.between(0, 2 * kPi);
    m.sideways = glm::normalize(std::cos(turn) * a + std::sin(turn) * b);
    m.direction = std::sin(angle) * m.sideways - std::cos(angle) * m.normal;
    return m;
}

V behind(const Meeting& m, double angle) { return std::sin(angle) * m.sideways - std::cos(angle) * m.normal; }
V mirrored(const Meeting& m, double angle) { return std::sin(angle) * m.sideways + std::cos(angle) * m.normal; }

double critical_angle(double relative_ior) { return std::asin(relative_ior); }

double angle_behind(double angle, double relative_ior) {
    return static_cast<double>(std::asin(std::sin(L(angle)) / L(relative_ior)));
}

double reflectance(double angle, double relative_ior) {
    const L n = relative_ior, sine = std::sin(L(angle)) / n, ci = std::cos(L(angle));
    if (sine > 1) return 1;
    const L ct = std::sqrt((1 - sine) * (1 + sine));
    const L s = (ci - n * ct) / (ci + n * ct), p = (n * ci - ct) / (n * ci + ct);
    return static_cast<double>((s * s + p * p) / 2);
}

Judge nothing() {
    return [](const Answer& answer) {
        const bool ok = answer.kind == Answer::Kind::miss;
        return Judgement{ok, ok ? 0 : std::numeric_limits<double>::infinity(), "miss"};
    };
}

Judge starts_with(std::vector<double> truth, std::size_t count, Tolerance tolerance) {
    return [truth = std::move(truth), count, tolerance](const Answer& answer) {
        Judgement judgement{false, std::numeric_limits<double>::infinity(), {}};
        for (const double v : truth) judgement.expected += fmt::format("{:.6g} ", v);
        if (answer.kind != Answer::Kind::value || answer.numbers.size() != count) return judgement;
        double largest = 0, worst = 0;
        bool finite = true;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            finite = finite && std::isfinite(answer.numbers[i]);
            largest = std::max(largest, std::abs(truth[i]));
            worst = std::max(worst, std::abs(answer.numbers[i] - truth[i]));
        }
        if (!finite) return judgement;
        judgement.error = largest > 0 ? worst / largest : worst;
        judgement.ok = worst <= tolerance.absolute + tolerance.relative * largest;
        return judgement;
    };
}

Judge grey(double value) { return close_to(V(value)); }

std::string world(int max_trace_level, double adc_bailout, const std::string& background) {
    return fmt::format(
        "#version 3.7;\nglobal_settings {{ assumed_gamma 1.0 max_trace_level {} adc_bailout {} }}\n"
        "camera {{ location <0, 0, -50> look_at 0 }}\nbackground {{ {} }}\n",
        max_trace_level, adc_bailout, background);
}

std::string plane(const std::string& normal, double distance, const std::string& more) {
    return fmt::format("plane {{ {}, {} {} }}\n", normal, distance, more);
}

std::string lossless(double ior) {
    return fmt::format(
        "pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 reflection {{ 0, 1 fresnel on }} conserve_energy }} "
        "interior {{ ior {} }}",
        ior);
}

std::string shining(const V& color) {
    return "pigment { rgb 1 } finish { ambient 0 diffuse 0 emission " + rgb(color) + " }";
}

}  // namespace rays::grader::step_3
