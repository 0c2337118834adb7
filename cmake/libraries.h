// What nearly every file includes, compiled once for all of them: cmake/precompile.cmake. Only headers of libraries, so
// that no change to the project's own makes everything compile again, and nothing of it is seen without being included.
#pragma once

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/glm.hpp>
#include <immintrin.h>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <regex>
#include <string>
#include <string_view>
#include <thread>
#include <variant>
#include <vector>
