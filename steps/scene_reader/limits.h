// What a scene may cost to read. Everything that a hostile file could make endless has its number here.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rays::sdl {

/// POV-Ray's tolerance for truth and equality.
inline constexpr double kEpsilon = 1e-10;

/// Text of one file. A 100 MB scene must pass.
inline constexpr std::uintmax_t kMostBytesOfText = 400u << 20;
/// Nested braces, parentheses, unions, macro arguments: each level costs some hundred bytes of stack.
inline constexpr int kDeepestNesting = 200;
/// Nested #if, #while and macro calls; POV-Ray's own limit.
inline constexpr std::size_t kMostOpenBlocks = 200;
/// Include files inside of one another; POV-Ray's own limit is 32.
inline constexpr std::size_t kDeepestInclude = 32;
/// Objects after unions are taken apart: 10^7 spheres and their lights must pass.
inline constexpr std::size_t kMostObjects = 10'100'000;
/// Bytes of what the scene makes (objects, materials, arrays, ...), counted roughly; the process stays under 1 GiB.
inline constexpr std::int64_t kMostMemory = 800'000'000;
/// Elements of one array, corners or faces of one mesh.
inline constexpr std::size_t kMostElements = 50'000'000;
inline constexpr std::size_t kMostArrayElements = 5'000'000;
/// Characters of one string value.
inline constexpr std::size_t kLongestString = 1 << 20;
/// Notes kept; a loop could make millions.
inline constexpr std::size_t kMostNotes = 100;
/// Of meshes that several objects share, in all (Flattener::fold_meshes): 25 MB at most.
inline constexpr std::size_t kMostCopiedFaces = 1 << 17;

/// Expressions of one scene that are worked out (formula.h), and how often one is made anew for names that stand for
/// something else.
inline constexpr std::size_t kMostFormulas = 4096;
inline constexpr int kMostFormulasOfOne = 8;

/// Work is counted in units of a token, some 15 to 25 ns. A loop that makes nothing ends after `kIdleWork` (one
/// second); text read once buys more without limit, objects made by it up to `kMostWorkForObjects`: a mesh of a million
/// triangles that loops compute is read in three seconds, and nothing small takes five. Beyond, an object still buys
/// what a sphere in a loop costs: a scene of ten million objects is large, not hostile, and `kMostObjects` ends it.
inline constexpr std::int64_t kIdleWork = 40'000'000;
inline constexpr std::int64_t kMostWorkForObjects = 150'000'000;
/// Work of all readings after the first (see tabulate.h).
inline constexpr std::int64_t kWorkAgain = 60'000'000;
inline constexpr std::int64_t kWorkPerByte = 4;
inline constexpr std::int64_t kWorkPerObject = 400;
inline constexpr std::int64_t kWorkOfPlainSphere = 30;
/// What is no token and costs as much as several, by measurement: a call with its scope, a directive, bytes walked over
/// or copied, an expression worked out, the first touch of memory that the scene keeps, a face whose corners are looked up in large tables, a
/// material or a clip made, a question to the file system, a number printed.
inline constexpr std::int64_t kWorkOfCall = 10;
inline constexpr std::int64_t kWorkOfDirective = 2;
inline constexpr std::int64_t kWorkOfFormula = 50;
inline constexpr std::int64_t kWorkOfFormulaToken = 8;
inline constexpr std::int64_t kWorkOfFace = 75;
inline constexpr std::int64_t kWorkOfMaterial = 40;
inline constexpr std::int64_t kWorkOfClip = 20;
inline constexpr std::int64_t kWorkOfFileSearch = 1000;
inline constexpr std::int64_t kWorkOfPrintedDigit = 1;
inline constexpr std::int64_t kBytesPerWork = 16;
inline constexpr std::int64_t kHeldBytesPerWork = 32;

}  // namespace rays::sdl
