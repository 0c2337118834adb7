// Any bytes are a scene or an InputError: no crash, no hang, no undefined behaviour.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "scene_reader/tabulate.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // Little work for each input, so that endless loops end soon and many inputs are tried. No include file is found.
    rays::sdl::Budget budget;
    budget.work = 100'000;
    budget.can_grow = false;
    budget.memory_limit = 64 << 20;
    rays::sdl::Sources sources("/nonexistent", {});
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        rays::sdl::read_and_tabulate(sources, sources.add_text("fuzz.pov", text), {}, budget);
    } catch (const rays::InputError&) {
    }
    return 0;
}
