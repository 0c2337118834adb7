// translate, rotate, scale, matrix, transform.
#include <fmt/format.h>

#include "scene_reader/statements.h"

namespace rays::sdl {

namespace {

Affine checked(Interpreter& in, const Place& place, const Affine& map) {
    if (!is_finite(map)) in.fail(place, "this transform is too large or too small to be computed with");
    return map;
}

Affine read_scale(Interpreter& in, const Place& place) {
    V3 by = in.vector();
    for (int i = 0; i < 3; ++i) {
        if (by[i] != 0) continue;
        in.note(place, "a scale by 0 is taken for 1, as POV-Ray does");
        by[i] = 1;
    }
    return checked(in, place, Affine::scaling(by));
}

Affine read_matrix(Interpreter& in, const Place& place) {
    in.expect('<', "a matrix of twelve numbers");
    double m[12];
    for (double& x : m) {
        if (&x != m) in.comma();
        x = in.number();
    }
    in.expect('>', "a matrix of twelve numbers");
    // Three numbers each: where x, y and z go, and the offset.
    M3 linear(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]);
    for (int row = 0; row < 3; ++row) {
        if (std::abs(linear[0][row]) + std::abs(linear[1][row]) + std::abs(linear[2][row]) < 1e-10) {
            in.note(place, "a matrix column of zeros gets a 1, as POV-Ray does");
            linear[row][row] = 1;
        }
    }
    if (!Affine::is_regular(linear)) {
        in.fail(place, "this matrix is singular: it flattens everything; use one with a determinant");
    }
    return checked(in, place, Affine::matrix(linear, {m[9], m[10], m[11]}));
}

}  // namespace

std::optional<Affine> read_placement(Interpreter& in) {
    const Token& next = in.peek();
    if (next.kind != Token::Kind::word) return std::nullopt;
    const Place place = next.place;
    switch (next.word) {
        case Word::translate_: in.take(); return Affine::translation(in.vector());
        case Word::rotate_: in.take(); return Affine::rotation(in.vector());
        case Word::scale_: in.take(); return read_scale(in, place);
        case Word::matrix_: in.take(); return read_matrix(in, place);
        case Word::transform_: in.take(); return checked(in, place, read_transform(in));
        default: return std::nullopt;
    }
}

Affine read_transform(Interpreter& in) {
    const Interpreter::Nesting nesting(in);
    if (const auto named = in.accept_named<Affine>()) return *named;
    in.expect('{', "a transform");
    Affine map;
    bool inverted = false;
    for (;;) {
        if (in.accept(Word::inverse_)) {
            inverted = true;
        } else if (const auto named = in.accept_named<Affine>()) {
            map = then(map, *named);
        } else if (const auto step = read_placement(in)) {
            map = then(map, *step);
        } else {
            break;
        }
    }
    if (!in.accept('}')) in.unexpected("translate, rotate, scale, matrix, transform, inverse or '}' in a transform");
    return inverted ? inverse(map) : map;
}

}  // namespace rays::sdl
