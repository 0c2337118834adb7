#include "schema_check.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace rays::grader {
namespace {

using nlohmann::json;

bool is_type(const json& v, const std::string& type) {
    if (type == "object") return v.is_object();
    if (type == "array") return v.is_array();
    if (type == "string") return v.is_string();
    if (type == "boolean") return v.is_boolean();
    if (type == "null") return v.is_null();
    if (type == "integer") return v.is_number_integer();
    if (type == "number") return v.is_number();
    throw std::runtime_error("unknown type " + type);
}

class Checker {
public:
    explicit Checker(const json& root) : root_(root) {}
    std::vector<std::string> problems;

    void check(const json& v, const json& schema, const std::string& at) {
        static const std::set<std::string> known{"$schema", "$id",         "$defs",      "$ref",
                                                 "title",   "description", "type",       "const",
                                                 "enum",    "required",    "properties", "additionalProperties",
                                                 "items",   "minItems",    "maxItems",   "minimum"};
        for (const auto& [key, rule] : schema.items())
            if (!known.count(key)) throw std::runtime_error("unknown keyword " + key);
        if (schema.contains("$ref"))
            return check(v, root_.at(json::json_pointer(schema["$ref"].get<std::string>().substr(1))), at);
        if (schema.contains("type") && !type_fits(v, schema["type"]))
            return fail(at, "has the wrong type: " + v.dump().substr(0, 60));
        if (schema.contains("const") && v != schema["const"]) fail(at, "is not " + schema["const"].dump());
        if (schema.contains("enum") &&
            std::find(schema["enum"].begin(), schema["enum"].end(), v) == schema["enum"].end())
            fail(at, "is none of the allowed values: " + v.dump());
        if (schema.contains("minimum") && v.is_number() && !(v.get<double>() >= schema["minimum"].get<double>()))
            fail(at, "is too small: " + v.dump());
        if (v.is_object()) check_object(v, schema, at);
        if (v.is_array()) check_array(v, schema, at);
    }

private:
    void fail(const std::string& at, const std::string& what) { problems.push_back(at + ": " + what); }

    static bool type_fits(const json& v, const json& type) {
        if (type.is_string()) return is_type(v, type);
        return std::any_of(type.begin(), type.end(), [&](const json& t) { return is_type(v, t); });
    }

    void check_object(const json& v, const json& schema, const std::string& at) {
        for (const json& name : schema.value("required", json::array()))
            if (!v.contains(name.get<std::string>())) fail(at, "has no " + name.get<std::string>());
        const json properties = schema.value("properties", json::object());
        for (const auto& [name, value] : v.items()) {
            if (properties.contains(name))
                check(value, properties[name], at + "/" + name);
            else if (schema.value("additionalProperties", true) == false)
                fail(at, "has the unknown field " + name);
        }
    }

    void check_array(const json& v, const json& schema, const std::string& at) {
        if (v.size() < schema.value("minItems", std::size_t{0}) || v.size() > schema.value("maxItems", v.size()))
            fail(at, "has the wrong length");
        if (!schema.contains("items")) return;
        for (std::size_t i = 0; i < v.size(); ++i) check(v[i], schema["items"], at + "/" + std::to_string(i));
    }

    const json& root_;
};

}  // namespace

std::vector<std::string> schema_problems(const json& value, const json& schema) {
    Checker checker(schema);
    checker.check(value, schema, "");
    return checker.problems;
}

}  // namespace rays::grader
