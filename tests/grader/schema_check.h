// The part of JSON Schema (2020-12) that results.schema.json uses.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rays::grader {

/// What of `value` is not as `schema` says: "/steps/0/verdict: ...". Throws std::runtime_error for a keyword it does
/// not know, so that no rule is passed over.
std::vector<std::string> schema_problems(const nlohmann::json& value, const nlohmann::json& schema);

}  // namespace rays::grader
