// Colours: red, green, blue, filter, transmit, in POV-Ray's several spellings and in single precision.
#include <fmt/format.h>

#include "scene_reader/interpreter.h"

namespace rays::sdl {

namespace {

bool is_whole_color(Word word) {
    switch (word) {
        // clang-format off
        case Word::rgb_: case Word::rgbf_: case Word::rgbt_: case Word::rgbft_: case Word::srgb_: case Word::srgbf_:
        case Word::srgbt_: case Word::srgbft_: return true;
        // clang-format on
        default: return false;
    }
}

bool is_component(Word word) {
    switch (word) {
        // clang-format off
        case Word::alpha_: case Word::blue_: case Word::filter_: case Word::green_: case Word::red_:
        case Word::transmit_: return true;
        // clang-format on
        default: return is_whole_color(word);
    }
}

}  // namespace

bool Interpreter::color_follows() {
    const bool keyword = peek().kind == Token::Kind::word && (peek().word == Word::color_ || is_component(peek().word));
    return keyword || vector_follows();
}

void Interpreter::color_keyword(Word word, Color& color) {
    const Place place = peek().place;
    if (!is_whole_color(word)) {
        const auto value = static_cast<float>(number());
        switch (word) {
            case Word::red_: color.rgb[0] = value; break;
            case Word::green_: color.rgb[1] = value; break;
            case Word::blue_: color.rgb[2] = value; break;
            case Word::transmit_: color.transmit = value; break;
            default: color.filter = value;
        }
        return;
    }
    const bool has_filter =
        word == Word::rgbf_ || word == Word::rgbft_ || word == Word::srgbf_ || word == Word::srgbft_;
    const bool has_transmit =
        word == Word::rgbt_ || word == Word::rgbft_ || word == Word::srgbt_ || word == Word::srgbft_;
    const bool is_srgb = word == Word::srgb_ || word == Word::srgbf_ || word == Word::srgbt_ || word == Word::srgbft_;
    const int components = 3 + has_filter + has_transmit;
    Numbers value;
    if (!worked_out(Expression::Rule::whole, components, value)) value = expression(components);
    for (int i = 0; i < value.count; ++i) checked(value.at[i], place);
    for (int i = 0; i < 3; ++i) {
        const auto channel = static_cast<float>(value.at[i]);
        color.rgb[i] = is_srgb ? from_srgb(channel, gamma) : channel;
    }
    color.filter = static_cast<float>(value.at[3]);
    color.transmit = static_cast<float>(value.at[4]);
    if (has_transmit && !has_filter) {
        color.transmit = static_cast<float>(value.at[3]);
        color.filter = 0;
    }
}

Color Interpreter::color_components(int wanted) {
    Color color{Radiance(0, 0, 0)};
    accept(Word::color_);
    const Place place = peek().place;
    if (peek().kind != Token::Kind::word || !is_component(peek().word)) {
        Numbers value;
        if (!worked_out(Expression::Rule::whole, wanted, value)) value = expression(wanted);
        for (int i = 0; i < value.count; ++i) checked(value.at[i], place);
        for (int i = 0; i < 3; ++i) color.rgb[i] = static_cast<float>(value.at[i]);
        color.filter = static_cast<float>(value.at[3]);
        color.transmit = static_cast<float>(value.at[4]);
    }
    // red, green, ... may follow one another, and a whole colour; a second whole colour, or `color`, begins something
    // else.
    for (bool first = true; peek().kind == Token::Kind::word && is_component(peek().word); first = false) {
        if (is_whole_color(peek().word) && !first) break;
        color_keyword(take().word, color);
    }
    return color;
}

Color Interpreter::color() { return color_components(5); }

Radiance Interpreter::rgb() { return color_components(3).rgb; }

}  // namespace rays::sdl
