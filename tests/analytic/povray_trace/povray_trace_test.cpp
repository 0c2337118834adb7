// trace() in POV-Ray's own language as a numeric oracle: 10^4 rays of each primitive, to 1e-9 of its size.
//
// Why 1e-9: doubles carry 16 digits, and both sides compute a root from a handful of products of numbers up to 300
// sizes, squared, so 1e-16 x 300^2 = 1e-11 is lost at least. 1e-9 leaves two digits for the order of operations.
//
// Not asked: bicubic patches, which POV-Ray cuts into triangles before it meets them; their truths are analytic
// (patch = polygon, patch = quadric) and stand with step 1.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <numeric>
#include <ostream>

#include "verdict.h"

namespace rays::povray_trace {

void PrintTo(const Primitive& primitive, std::ostream* out) { *out << primitive.name; }

namespace {

constexpr std::size_t kRays = 10000;
constexpr std::uint64_t kSeed = 20240607;

/// POV-Ray solves the torus's quartic without polishing the roots, so now and then one is wrong in the seventh digit.
constexpr std::size_t kImpreciseAllowed = 20;

std::size_t total(const Counts& counts) { return std::accumulate(counts.begin(), counts.end(), std::size_t{0}); }
std::size_t of_kind(const Counts& counts, Kind kind) { return counts[static_cast<std::size_t>(kind)]; }

std::string by_kind(const Counts& counts) {
    std::string text;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts[k] > 0) text += fmt::format(" {} {}", counts[k], kKindNames[k]);
    }
    return text.empty() ? " none" : text;
}

class Trace : public testing::TestWithParam<Primitive> {};

TEST_P(Trace, AgreesWithPovray) {
    if (sizeof(Real) < sizeof(double)) GTEST_SKIP() << "the tolerance is for geometry in double";
    const Primitive& primitive = GetParam();
    const std::vector<TestRay> rays = make_rays(primitive, kRays, kSeed);
    const Meetings povray = ask_povray(Povray(), primitive, rays);
    const Verdict verdict = compare(primitive, rays, povray, [&](const std::vector<TestRay>& asked) {
        return ask_solution(RENDER_SOLUTION, primitive, asked);
    });

    fmt::print("{:36} {:5} hits, off the surface {:.1e}, normal {:.1e}; ties:{}; leaks:{}; imprecise:{}\n",
               primitive.name, verdict.hits, verdict.worst.off_surface, verdict.worst.turned, by_kind(verdict.ties),
               by_kind(verdict.leaks), by_kind(verdict.imprecise));
    RecordProperty("hits", static_cast<int>(verdict.hits));
    RecordProperty("off_surface", fmt::format("{:.3e}", verdict.worst.off_surface));
    RecordProperty("turned", fmt::format("{:.3e}", verdict.worst.turned));
    RecordProperty("ties", by_kind(verdict.ties));
    RecordProperty("leaks", by_kind(verdict.leaks));

    EXPECT_GT(verdict.hits, kRays / 10);
    EXPECT_LE(total(verdict.imprecise), kImpreciseAllowed);
    for (const Kind plain : {Kind::random, Kind::inside, Kind::far}) {  // nothing but chance could make them a tie
        EXPECT_EQ(of_kind(verdict.ties, plain) + of_kind(verdict.leaks, plain), 0u);
    }
    // Half of the tangent and edge rays are off by more than kTie, so a tie is never their common lot.
    EXPECT_LE(total(verdict.ties) + total(verdict.leaks), kRays / 10);
    std::string examples;
    for (std::size_t i = 0; i < std::min<std::size_t>(5, verdict.wrong.size()); ++i)
        examples += verdict.wrong[i] + "\n";
    EXPECT_TRUE(verdict.wrong.empty()) << verdict.wrong.size() << " rays differ:\n" << examples;
}

std::string test_name(const testing::TestParamInfo<Primitive>& info) {
    std::string name;
    for (const char c : info.param.name) {
        if (std::isalnum(static_cast<unsigned char>(c))) {
            name += c;
        } else if (!name.empty() && name.back() != '_') {
            name += '_';
        }
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(Primitives, Trace, testing::ValuesIn(all_primitives()), test_name);

}  // namespace
}  // namespace rays::povray_trace
