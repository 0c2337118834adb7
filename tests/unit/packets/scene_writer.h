// Scenes by chance, as text.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>

#include <fmt/format.h>

namespace rays::packets::tests {

/// Writes scenes in which everything that shading and recursion know occurs, in all combinations sooner or later.
class SceneWriter {
public:
    explicit SceneWriter(std::uint64_t seed) : bits_(seed) {}

    std::string scene() {
        std::string text = fmt::format(
            "#version 3.7; global_settings {{ assumed_gamma 1.0 max_trace_level {} adc_bailout {} ambient_light rgb {} "
            "}}\n",
            pick({"1", "2", "5", "12"}), pick({"0", "1/255", "0.05", "0.4"}), number(0.5, 1.5));
        text += camera() + fmt::format("background {{ rgb {} }}\n", vector(0, 1));
        for (int i = 1 + below(3); i-- > 0;) text += light();
        text +=
            "#declare M1 = interior { ior 1.5 } #declare M2 = interior { ior 1.2 fade_distance 0.7 fade_power 1000 "
            "fade_color rgb <0.2, 0.7, 0.4> }\n";
        text += "#declare T = texture { " + pigment() + " }\n";
        if (chance(3)) text += fmt::format("plane {{ y, -2 {} }}\n", texture());
        for (int i = 3 + below(12); i-- > 0;) text += object();
        return text;
    }

private:
    double unit() { return double(bits_() >> 11) * 0x1p-53; }
    int below(int n) { return int(bits_() % std::uint64_t(n)); }
    bool chance(int one_in) { return below(one_in) == 0; }
    std::string pick(std::initializer_list<const char*> words) { return words.begin()[below(int(words.size()))]; }
    std::string number(double low, double high) { return fmt::format("{:.4f}", low + (high - low) * unit()); }
    std::string vector(double low, double high) {
        const std::string x = number(low, high), y = number(low, high);
        return "<" + x + ", " + y + ", " + number(low, high) + ">";
    }
    std::string maybe(int one_in, const std::string& text) { return chance(one_in) ? " " + text : ""; }

    std::string camera() {
        if (chance(6)) return "camera { orthographic location <0, 1, -6> right x * 5 up y * 4 look_at 0 }\n";
        if (chance(6))  // perhaps inside of something
            return "camera { location <0.1, 0.2, -0.3> right x * 4/3 look_at <1, 0.3, 2> angle 90 }\n";
        return "camera { location <0, 1, -6> right x * 4/3 look_at 0 angle 50 }\n";
    }
    std::string light() {
        const std::string kind = pick({"", "", "spotlight point_at 0 radius 10 falloff 35 tightness 3",
                                       "cylinder point_at 0 radius 2 falloff 4 tightness 2", "parallel point_at 0",
                                       "spotlight parallel point_at <0, -1, 0> radius 20 falloff 40"});
        return fmt::format(
            "light_source {{ {}, rgb {} {}{}{} }}\n", vector(-6, 6), vector(chance(6) ? -0.6 : 0, 1.2), kind,
            maybe(6, "shadowless"),
            maybe(3, fmt::format("fade_distance {} fade_power {}", number(1, 8), pick({"1", "2", "3", "1.7"}))));
    }
    std::string color() {
        if (chance(3))
            return pick({"rgbf <1, 0.8, 0.6, 0.7>", "rgbt <0.2, 0.5, 1, 0.6>", "rgbft <0.9, 1, 0.9, 0.4, 0.5>",
                         "rgbf 1", "rgbft <1, 1, 1, 0.8, 0.6>", "rgbf <0, 0, 0, 1>"});
        return "rgb " + vector(chance(8) ? -0.5 : 0, 1);
    }
    std::string pigment() {
        if (chance(4))
            return fmt::format("pigment {{ checker {} {} scale {} rotate {} }}", color(), color(), number(0.2, 1),
                               vector(0, 90));
        return "pigment { " + color() + " }";
    }
    std::string mirror() {
        const std::string range = pick({"0.4", "1", "rgb <0.9, 0.5, 0.1>", "0.1, rgb <0.8, 0.9, 1>", "0, 1", "1.2"});
        return fmt::format("reflection {{ {}{}{}{}{} }}", range, maybe(3, "fresnel on"),
                           maybe(4, "falloff " + number(0.5, 5)), maybe(5, "exponent " + pick({"0.5", "2", "1.3"})),
                           maybe(5, "metallic"));
    }
    std::string texture() {
        return fmt::format(
            "{} finish {{ ambient {} diffuse {}{}{}{}{}{}{}{} }}{}{}", pigment(),
            pick({"0", "0.1", "rgb <0.1, 0.2, 0.3>"}), pick({"0", "0.6", "0.9"}),
            maybe(4, "brilliance " + pick({"2", "0.5", "0"})), maybe(6, "emission rgb " + vector(0, 0.3)),
            maybe(3, fmt::format("phong {} phong_size {}", number(0.1, 1), number(1, 120))),
            maybe(3, fmt::format("specular {} roughness {}", number(0.1, 1), number(0.005, 0.5))), maybe(5, "metallic"),
            maybe(2, mirror()), maybe(4, "conserve_energy"),
            maybe(2, "interior { " + pick({"M1", "M2", "ior 1.33", "ior 0.8", "ior 1"}) + " }"), maybe(8, "no_shadow"));
    }
    std::string shape() {
        switch (below(11)) {
            case 0:
            case 1:
            case 2: return fmt::format("sphere {{ {}, {}", vector(-2, 2), number(0.3, 1.4));
            case 3: return fmt::format("box {{ {}, {}", vector(-2, -0.2), vector(0.2, 1));
            case 4:
                return fmt::format("cone {{ {}, {}, {}, {}{}", vector(-2, 0), number(0.2, 1), vector(0.2, 2),
                                   number(0, 0.5), maybe(2, "open"));
            case 5: return fmt::format("cylinder {{ {}, {}, {}", vector(-2, 0), vector(0.2, 2), number(0.1, 0.8));
            case 6: return fmt::format("torus {{ {}, {} rotate {}", number(0.7, 1.6), number(0.1, 0.4), vector(0, 360));
            case 7: return fmt::format("disc {{ {}, {}, 1.5, 0.4", vector(-1, 1), vector(0.1, 1));
            case 8:
                return fmt::format("smooth_triangle {{ {}, <0.2, 0.3, -1>, {}, <1, 0.3, -1>, {}, <-1, 0.2, -0.5>",
                                   vector(-2, 0), vector(0, 2), vector(-1, 2));
            case 9:
                return fmt::format(
                    "quadric {{ <1, 1, 0.5>, <0.2, 0, 0>, <0, 0, 0>, -1 clipped_by {{ box {{ -1.2, 1.2 }} }} translate "
                    "{}",
                    vector(-1, 1));
            default: break;
        }
        const std::string a = vector(-2, 0), b = vector(0, 2), c = vector(-1, 2), d = vector(-2, 2);
        return fmt::format(
            "mesh {{ triangle {{ {}, {}, {} texture {{ T }} }} triangle {{ {}, {}, {} }} triangle {{ {}, {}, {} }}", a,
            b, c, b, c, d, a, b, d);
    }
    std::string object() {
        return shape() + maybe(4, fmt::format("scale <1, {}, 1> rotate {}", number(0.5, 2), vector(0, 90))) +
               maybe(6, fmt::format("clipped_by {{ sphere {{ {}, 1.2{} }} }}", vector(-1, 1), maybe(2, "inverse"))) +
               maybe(6, fmt::format("clipped_by {{ plane {{ {}, {}{} }} }}", vector(-1, 1), number(-0.5, 1),
                                    maybe(3, "inverse"))) +
               " " + texture() + " }\n";
    }

    std::mt19937_64 bits_;
};

}  // namespace rays::packets::tests
