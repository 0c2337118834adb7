// A build without Embree: the structures are measured among themselves.
#include "contender.h"

namespace rays::bench {

std::vector<Contender> other_contenders() { return {}; }

}  // namespace rays::bench
