// In programs that have no packets, rays go one by one. The linker takes this file only where nothing else is given.
#include "renderer/packets.h"

namespace rays {

std::unique_ptr<Packets> make_packets(const Scene&) { return nullptr; }

}  // namespace rays
