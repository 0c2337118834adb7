#include "knobs.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rays::bench {

std::vector<Knob> read_knobs(const std::filesystem::path& bin, int step) {
    std::ifstream in(bin / "knobs.txt");
    std::vector<Knob> knobs;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        Knob knob;
        std::string program;
        if (!(words >> knob.step >> knob.name >> knob.value >> program))
            throw std::runtime_error("knobs.txt: not \"step knob value program\": " + line);
        knob.program = bin / program;
        if (knob.step == step) knobs.push_back(knob);
    }
    return knobs;
}

}  // namespace rays::bench
