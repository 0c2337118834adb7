// The file charts.json (chart.h) as a whole.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rays::bench {

/// A new file with these charts (of to_json), on this machine. `povray`: its version, or empty.
nlohmann::json charts_file(std::vector<nlohmann::json> charts, const std::string& povray);

/// The charts of an earlier run, less those of these steps: what is not measured anew stays. Empty when the file is
/// missing, is no charts.json, or comes from another machine.
std::vector<nlohmann::json> kept_charts(const std::filesystem::path& file, const std::vector<int>& measured_steps);

}  // namespace rays::bench
