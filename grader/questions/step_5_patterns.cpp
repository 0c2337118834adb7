// Questions about patterns (5.1 to 5.4): which cells their points are in, and that nothing else can be told of them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "questions/step_5.h"

namespace rays::grader::step_5 {
namespace {

const std::string kScene = construct::scene_of("");

/// "points PATTERN SEED PIXEL DIMENSION SAMPLE SAMPLES ALONG COUNT ALONG COUNT" of a draw of dice.
/// `dimension`: below 0, any.
std::string points(Dice& dice, const std::string& pattern, int sample, int samples, const std::string& along, int count,
                   const std::string& then = "nothing", int then_count = 1, int dimension = -1) {
    const int seed = dice.whole(0, 1000000000), pixel = dice.whole(0, 1000000);
    if (dimension < 0) dimension = dice.whole(0, 60);
    return fmt::format("points {} {} {} {} {} {} {} {} {} {}", pattern, seed, pixel, dimension, sample, samples, along,
                       count, then, then_count);
}

std::string all_of(Dice& dice, const std::string& pattern, int samples) {
    return points(dice, pattern, 0, samples, "sample", samples);
}

constexpr int kSeries = 2048;

Judge points_hold(int count, std::string in_short, std::function<void(const std::vector<V2>&, Claims&)> claims) {
    return rows_hold(static_cast<std::size_t>(count), 2, std::move(in_short),
                     [=](const Table& table, Claims& c) { claims(points_in(table), c); });
}

void ask_repeated(Notebook& book, Dice& dice, const std::string& pattern, int samples) {
    book.ask(points(dice, pattern, dice.whole(0, samples - 1), samples, "nothing", 5),
             "the same draw is the same point",
             points_hold(5, "five times the same point", [](const std::vector<V2>& p, Claims& claims) {
                 claim_in_square(claims, p);
                 for (const V2& q : p)
                     claims.holds(q == p[0], "the same draw is the same point, whenever it is asked for");
             }));
}

/// One sample of many pixels, dimensions or seeds: unrelated, and evenly anywhere.
void ask_unrelated(Notebook& book, Dice& dice, const std::string& pattern, int samples) {
    for (const char* along : {"pixel", "dimension", "seed"})
        book.ask(points(dice, pattern, dice.whole(0, samples - 1), samples, along, kSeries),
                 fmt::format("one sample of {}, along every {}: as if thrown", samples, along),
                 points_hold(kSeries, "unrelated points, evenly anywhere",
                             [](const std::vector<V2>& p, Claims& claims) { claim_random(claims, p); }));
}

/// The n-th point of one pattern does not go with the n-th of another. Of 16 numbers in any order the square of the
/// correlation is 1/15 on the average; of nested ones about 1/8; in the same order 1.
void ask_order(Notebook& book, Dice& dice, const std::string& pattern) {
    constexpr int kSamples = 16, kPatterns = 128;
    for (const char* along : {"dimension", "pixel", "seed"})
        book.ask(
            points(dice, pattern, 0, kSamples, "sample", kSamples, along, kPatterns),
            fmt::format("the order of points in one {} says nothing of the next", along),
            points_hold(
                kSamples * kPatterns, "orders that do not go together", [](const std::vector<V2>& p, Claims& claims) {
                    claim_in_square(claims, p);
                    for (int a = 0; a < 2; ++a) {
                        L sum = 0;
                        for (std::size_t k = 0; k + 1 < kPatterns; ++k) {
                            const V2 *one = &p[k * kSamples], *other = one + kSamples;
                            const L m = mean_of(kSamples, [&](std::size_t i) { return one[i][a]; });
                            const L n = mean_of(kSamples, [&](std::size_t i) { return other[i][a]; });
                            const L both =
                                mean_of(kSamples, [&](std::size_t i) { return (one[i][a] - m) * (other[i][a] - n); });
                            const L mm =
                                mean_of(kSamples, [&](std::size_t i) { return (one[i][a] - m) * (one[i][a] - m); });
                            const L nn =
                                mean_of(kSamples, [&](std::size_t i) { return (other[i][a] - n) * (other[i][a] - n); });
                            sum += both * both / std::max(mm * nn, 1e-12L);
                        }
                        claims.holds(
                            sum / (kPatterns - 1) < 0.25L,
                            fmt::format("orders that do not go together (mean square of the correlation: {:.3g})",
                                        double(sum / (kPatterns - 1))));
                    }
                }));
}

// ---- 5.1 ---------------------------------------------------------------------------------------------------------------

Grid square_grid_of(int samples) {
    int columns = static_cast<int>(std::sqrt(samples + 0.5));
    while (samples % columns != 0) --columns;
    return {columns, samples / columns};
}

bool all_centers(const Grid& grid, const std::vector<V2>& points) {
    return most_in_a_cell(grid, points) == 1 && std::all_of(points.begin(), points.end(), [&](const V2& p) {
               const V2 at = grid.within(p);
               return std::abs(at.x - 0.5L) < 1e-4L && std::abs(at.y - 0.5L) < 1e-4L;
           });
}

void ask_centers(Notebook& book, Dice& dice, int samples) {
    const Grid grid = square_grid_of(samples);
    book.ask(all_of(dice, "regular", samples),
             fmt::format("{} x {} centres of cells, each once", grid.columns, grid.rows),
             points_hold(samples, "the centre of every cell once", [=](const std::vector<V2>& p, Claims& claims) {
                 claims.holds(all_centers(grid, p) || all_centers({grid.rows, grid.columns}, p),
                              fmt::format("the centres of {} x {} cells, each once", grid.columns, grid.rows));
             }));
}

/// Which cell a sample has is anyone's guess.
void ask_cells(Notebook& book, Dice& dice, const std::string& pattern, int samples, const Grid& grid) {
    for (const char* along : {"pixel", "dimension", "seed"})
        book.ask(
            points(dice, pattern, dice.whole(0, samples - 1), samples, along, kSeries),
            fmt::format("the cell of one sample of {}, along every {}: any", samples, along),
            points_hold(kSeries, "every cell equally often", [=](const std::vector<V2>& p, Claims& claims) {
                claim_in_square(claims, p);
                std::vector<int> counts(static_cast<std::size_t>(grid.count()));
                std::vector<int> cells;
                for (const V2& q : p) cells.push_back(grid.cell(q)), ++counts[static_cast<std::size_t>(cells.back())];
                claim_equal_shares(claims, counts, "points in a cell");
                const L middle = (grid.count() - 1) / 2.0L, variance = (grid.count() * grid.count() - 1) / 12.0L;
                claims.within(
                    mean_of(p.size() - 1, [&](std::size_t i) { return (cells[i] - middle) * (cells[i + 1] - middle); }),
                    0, kSigmas * variance / std::sqrt(L(kSeries)), "covariance of a cell's number with the next one's");
            }));
}

}  // namespace

std::vector<Question> regular_and_random(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.1");
    book.scene(kScene);
    for (const int samples : {1, 2, 3, 4, 6, 7, 12, 16, 35, 97, 100, 1024}) ask_centers(book, dice, samples);
    ask_centers(book, dice, dice.whole(2, 64));
    ask_cells(book, dice, "regular", 4, {2, 2});
    ask_cells(book, dice, "regular", 9, {3, 3});
    ask_order(book, dice, "regular");
    ask_repeated(book, dice, "regular", 16);
    ask_unrelated(book, dice, "random", 16);
    ask_unrelated(book, dice, "random", 1);
    ask_order(book, dice, "random");
    for (const int samples : {kSeries, 10 * kSeries})
        book.ask(points(dice, "random", dice.whole(0, samples - kSeries), samples, "sample", kSeries),
                 "the samples of one pixel: as if thrown",
                 points_hold(kSeries, "unrelated points, evenly anywhere",
                             [](const std::vector<V2>& p, Claims& claims) { claim_random(claims, p); }));
    ask_repeated(book, dice, "random", 16);
    return book.take();
}

// ---- 5.2 ---------------------------------------------------------------------------------------------------------------

namespace {

/// The place within a cell is as random as can be, whichever cell it is.
void ask_jitter(Notebook& book, Dice& dice, const std::string& pattern, int samples) {
    const Grid grid = grid_for(samples);
    for (const char* along : {"pixel", "sample"}) {
        const int patterns = along[0] == 's' ? kSeries / samples : 1;
        const int count = along[0] == 's' ? samples : kSeries;
        const int first = along[0] == 's' ? 0 : dice.whole(0, samples - 1);
        book.ask(points(dice, pattern, first, samples, along, count, along[0] == 's' ? "pixel" : "nothing", patterns),
                 fmt::format("where in its cell a point of {} lies, along every {}", samples, along),
                 points_hold(count * patterns, "anywhere in its cell", [=](const std::vector<V2>& p, Claims& claims) {
                     claim_in_square(claims, p);
                     const auto claim = [&](const Grid& cells) {
                         Claims mine;
                         std::vector<V2> jitter;
                         for (const V2& q : p) jitter.push_back(glm::clamp(cells.within(q), V2(0), V2(1 - 1e-9L)));
                         claim_random(mine, jitter);
                         for (int a = 0; a < 2; ++a)
                             for (int b = 0; b < 2; ++b)
                                 mine.within(
                                     mean_of(p.size(),
                                             [&](std::size_t i) { return (jitter[i][a] - 0.5L) * (p[i][b] - 0.5L); }),
                                     a == b ? 1 / (12.0L * (a == 0 ? cells.columns : cells.rows)) : 0,
                                     kSigmas / 12 / std::sqrt(L(p.size())),
                                     "covariance of the place in the cell with that of the cell");
                         return mine.judgement("");
                     };
                     // A grid on its side is as good.
                     const Judgement upright = claim(grid), turned = claim({grid.rows, grid.columns});
                     claims.holds(upright.ok || turned.ok, upright.expected);
                 }));
    }
}

/// Where in its strips a point lies: anywhere.
void ask_strips(Notebook& book, Dice& dice, int samples) {
    const int strips = grid_for(samples).count();
    book.ask(points(dice, "multi_jittered", dice.whole(0, samples - 1), samples, "pixel", kSeries),
             fmt::format("where in its strips a point of {} lies", samples),
             points_hold(kSeries, "anywhere in its strips", [=](const std::vector<V2>& p, Claims& claims) {
                 claim_in_square(claims, p);
                 std::vector<V2> within;
                 for (const V2& q : p) within.push_back(q * L(strips) - glm::floor(q * L(strips)));
                 claim_random(claims, within);
             }));
}

std::vector<Question> jittered_questions(const std::string& task, const std::string& pattern, std::uint64_t seed,
                                         bool strips) {
    Dice dice(seed);
    Notebook book(task);
    book.scene(kScene);
    // Full grids first; then numbers that leave cells empty.
    for (const int samples : {1, 2, 4, 6, 9, 12, 16, 100, 1024, 3, 5, 7, 13, 97, 1021})
        book.ask(all_of(dice, pattern, samples), fmt::format("{} points, one by one in cells", samples),
                 stratified(samples, strips));
    const int any = dice.whole(17, 500);
    book.ask(all_of(dice, pattern, any), fmt::format("{} points, one by one in cells", any), stratified(any, strips));
    ask_unrelated(book, dice, pattern, 7);
    ask_unrelated(book, dice, pattern, 16);
    ask_order(book, dice, pattern);
    ask_jitter(book, dice, pattern, 16);
    if (strips)
        for (const int samples : {9, 16}) ask_strips(book, dice, samples);
    ask_repeated(book, dice, pattern, 7);
    return book.take();
}

}  // namespace

std::vector<Question> jittered(std::uint64_t seed) { return jittered_questions("5.2", "jittered", seed, false); }
std::vector<Question> multi_jittered(std::uint64_t seed) {
    return jittered_questions("5.3", "multi_jittered", seed, true);
}

// ---- 5.4 ---------------------------------------------------------------------------------------------------------------

namespace {

/// Of 2^k points every box of 2^-a by 2^-(k - a) holds one, in an even dimension.
void ask_every_box(Notebook& book, Dice& dice, int k) {
    const int samples = 1 << k, dimension = 2 * dice.whole(0, 30);
    book.ask(points(dice, "sobol", 0, samples + dice.whole(0, 3), "sample", samples, "nothing", 1, dimension),
             fmt::format("the first {} points: one in every box of that area", samples),
             points_hold(samples, "one in every box", [=](const std::vector<V2>& p, Claims& claims) {
                 claim_in_square(claims, p);
                 for (int a = 0; a <= k; ++a)
                     claims.holds(most_in_a_cell({1 << a, 1 << (k - a)}, p) == 1,
                                  fmt::format("one point in each of {} x {} boxes", 1 << a, 1 << (k - a)));
             }));
}

/// In an odd one: one in every strip.
void ask_every_strip(Notebook& book, Dice& dice, int k) {
    const int samples = 1 << k, dimension = 2 * dice.whole(0, 30) + 1;
    book.ask(points(dice, "sobol", 0, samples, "sample", samples, "nothing", 1, dimension),
             fmt::format("the first {} points of an odd dimension: one in every strip", samples),
             points_hold(samples, "one in every strip", [=](const std::vector<V2>& p, Claims& claims) {
                 claim_in_square(claims, p);
                 for (const int axis : {0, 1})
                     claims.holds(most_in_a_strip(samples, p, axis) == 1,
                                  fmt::format("one point in each of {} strips", samples));
             }));
}

/// Two neighbouring dimensions are four of one sequence: of 2^7 first points each sixteenth of the four-dimensional
/// cube holds eight (Sobol's first four dimensions have t = 3).
void ask_four_dimensions(Notebook& book, Dice& dice) {
    constexpr int kSamples = 128;
    book.ask(
        points(dice, "sobol", 0, kSamples, "sample", kSamples, "dimension", 2, 2 * dice.whole(0, 30)),
        "dimensions 2k and 2k + 1 of the first 128 points: eight in each sixteenth of four dimensions",
        points_hold(2 * kSamples, "eight points in each sixteenth of four dimensions",
                    [](const std::vector<V2>& p, Claims& claims) {
                        claim_in_square(claims, p);
                        int counts[16] = {};
                        for (std::size_t i = 0; i < kSamples; ++i) {
                            const V2 &one = p[i], &other = p[kSamples + i];
                            ++counts[(one.x < 0.5L) + 2 * (one.y < 0.5L) + 4 * (other.x < 0.5L) + 8 * (other.y < 0.5L)];
                        }
                        for (const int count : counts)
                            claims.holds(count == 8, fmt::format("8 points in a sixteenth, not {}", count));
                    }));
}

void ask_progressive(Notebook& book, Dice& dice) {
    const int sample = dice.whole(0, 200);
    book.ask(points(dice, "sobol", sample, sample + 1, "samples", 40),
             "how many samples there will be changes no point",
             points_hold(40, "the same point for any number of samples", [](const std::vector<V2>& p, Claims& claims) {
                 claim_in_square(claims, p);
                 for (const V2& q : p) claims.holds(q == p[0], "the same point for any number of samples");
             }));
}

constexpr std::size_t kNet = 16, kNets = 128;

/// Halves of strips, strip by strip: -1 or 1 as the point of that strip lies in its lower or upper half.
std::vector<int> halves(const V2* points, int axis) {
    std::vector<int> result(kNet);
    for (std::size_t i = 0; i < kNet; ++i) {
        const L at = points[i][axis] * kNet;
        result[std::min(static_cast<std::size_t>(at), kNet - 1)] = at - std::floor(at) < 0.5L ? -1 : 1;
    }
    return result;
}

/// Owen's scrambling decides anew in every strip which half is taken, and for x otherwise than for y. A digit that is
/// turned alike everywhere, or not at all, or by one key for both, shows as a mean square of 1 where chance makes 1/16.
void ask_scrambling(Notebook& book, Dice& dice) {
    book.ask(points(dice, "sobol", 0, kNet, "sample", kNet, "pixel", kNets),
             "in each strip a half of its own, in x another than in y",
             points_hold(kNet * kNets, "scrambled after Owen", [](const std::vector<V2>& p, Claims& claims) {
                 claim_in_square(claims, p);
                 L of[3] = {0, 0, 0};
                 for (std::size_t k = 0; k < kNets; ++k) {
                     const auto x = halves(&p[k * kNet], 0), y = halves(&p[k * kNet], 1);
                     const L mean_x = mean_of(kNet, [&](std::size_t i) { return x[i]; }),
                             mean_y = mean_of(kNet, [&](std::size_t i) { return y[i]; });
                     const L both = mean_of(kNet, [&](std::size_t i) { return x[i] * y[i]; });
                     of[0] += mean_x * mean_x / kNets, of[1] += mean_y * mean_y / kNets, of[2] += both * both / kNets;
                 }
                 claims.holds(of[0] < 0.25L,
                              fmt::format("halves of the strips of x that have nothing in common (mean square: {:.3g})",
                                          double(of[0])));
                 claims.holds(of[1] < 0.25L,
                              fmt::format("halves of the strips of y that have nothing in common (mean square: {:.3g})",
                                          double(of[1])));
                 claims.holds(of[2] < 0.25L, fmt::format("x and y scrambled by keys of their own (mean square: {:.3g})",
                                                         double(of[2])));
             }));
}

}  // namespace

std::vector<Question> sobol(std::uint64_t seed) {
    Dice dice(seed);
    Notebook book("5.4");
    book.scene(kScene);
    for (int k = 0; k <= 11; ++k) ask_every_box(book, dice, k);
    for (int k = 1; k <= 11; k += 2) ask_every_strip(book, dice, k);
    for (int i = 0; i < 3; ++i) ask_four_dimensions(book, dice);
    for (int i = 0; i < 3; ++i) ask_progressive(book, dice);
    ask_unrelated(book, dice, "sobol", 1);
    ask_unrelated(book, dice, "sobol", 50);
    ask_order(book, dice, "sobol");
    for (int i = 0; i < 3; ++i) ask_scrambling(book, dice);
    ask_repeated(book, dice, "sobol", 50);
    return book.take();
}

}  // namespace rays::grader::step_5
