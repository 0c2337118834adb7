// What measure-3 measures.
#pragma once

namespace rays::bench {

/// Registers fresnel/outside/exact, fresnel/outside/schlick and the same from inside of glass, index 1.5. The counters
/// are those of measure/subject.h; errors are of the reflected share, against the formula in long double.
void add_fresnel();

}  // namespace rays::bench
