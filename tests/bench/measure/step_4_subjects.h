// What measure-4 measures.
#pragma once

#include <cstddef>

namespace rays::bench {

/// Registers with Google Benchmark, for every structure (contender.h) and random spheres, random triangles and the
/// flake:
///
///     nearest/RAYS/BODIES/STRUCTURE    e.g. nearest/bounced/spheres/1000/bvh
///     any/RAYS/BODIES/STRUCTURE        only for 500 000 bodies and more
///     build/BODIES/STRUCTURE           time of all threads together
///
/// RAYS is primary or bounced, BODIES spheres/N, triangles/N or flake. Counters: rays and bodies of an iteration; for
/// nearest also lost, found and elsewhere (Disagreement, against the bvh); for build bytes, and seconds on the clock.
/// There are up to `most` bodies in a set, ten times as many in each as in the one before.
void add_structures(std::size_t most);

}  // namespace rays::bench
