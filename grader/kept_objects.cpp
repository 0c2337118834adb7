#include "grader/kept_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <vector>

#include "support/files.h"
#include "support/sha256.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptimisation = "-O2";

// The size first: what was submitted may be of any size.
std::optional<std::string> common_text(const fs::path& source, const fs::path& known) {
    std::error_code error;
    const auto size = fs::file_size(source, error);
    if (error || !fs::is_regular_file(known) || size != fs::file_size(known)) return {};
    const std::string text = read_file(known);
    if (read_file(source) != text) return {};
    return text;
}

std::string digest_of_headers(const fs::path& steps) {
    std::vector<fs::path> headers;
    for (const auto& entry : fs::recursive_directory_iterator(steps))
        if (entry.path().extension() == ".h" && entry.is_regular_file()) headers.push_back(entry.path());
    std::sort(headers.begin(), headers.end());
    std::string all;
    for (const fs::path& header : headers) all += header.string() + " " + sha256_of_file(header) + "\n";
    return sha256(all);
}

// Libraries' headers apart, which the build's own state stands for.
bool includes_headers_of_steps_only(const std::string& text, const fs::path& steps) {
    static const std::regex directive(R"((?:^|\n)[ \t]*#[ \t]*include\b[ \t]*([^\n]*))");
    static const std::regex name(R"(<.*|"([a-z0-9_]+/[a-z0-9_]+\.h)\".*)");
    for (auto i = std::sregex_iterator(text.begin(), text.end(), directive); i != std::sregex_iterator(); ++i) {
        const std::string included = (*i)[1];
        std::smatch found;
        if (!std::regex_match(included, found, name)) return false;
        if (found[1].matched && !fs::is_regular_file(steps / found[1].str())) return false;
    }
    return true;
}

void remove_older(const fs::path& folder, const std::string& prefix, const fs::path& kept) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path() != kept && entry.path().filename().string().starts_with(prefix) &&
            entry.path().extension() == ".o")
            fs::remove(entry.path(), ignored);
}

bool copied(const fs::path& from, const fs::path& to) {
    std::error_code error;
    return fs::copy_file(from, to, fs::copy_options::overwrite_existing, error) && !error;
}

}  // namespace

KeptObjects::KeptObjects(const Builder& builder, const Project& project)
    : builder_(builder),
      project_(project),
      folder_(project.build / "kept-objects"),
      headers_(digest_of_headers(project.steps())) {}

Built KeptObjects::compile(const std::string& file, const fs::path& source, const fs::path& object) const {
    try {
        if (common_text(source, project_.root / "solutions" / file))
            return {true, false, builder_.solution_object(file), {}};
        const auto text = common_text(source, project_.steps() / file);
        if (text && includes_headers_of_steps_only(*text, project_.steps()))
            return compile_starter(file, *text, object);
    } catch (const std::exception&) {
        // A file that cannot be read, or a full disk: the compiler has the words for it.
    }
    return builder_.compile(file, source, object, kOptimisation);
}

Built KeptObjects::compile_starter(const std::string& file, const std::string& text, const fs::path& object) const {
    std::string prefix = file + "-";
    std::replace(prefix.begin(), prefix.end(), '/', '.');
    const fs::path kept = folder_ / (prefix + sha256(builder_.state(file) + headers_ + kOptimisation + text) + ".o");
    // A copy, since another grading may put a newer one in its place.
    if (copied(kept, object)) return {true, false, object, {}};
    Built built = builder_.compile(file, project_.steps() / file, object, kOptimisation);
    if (!built.good) return built;
    write_atomically(kept, read_file(object));
    remove_older(folder_, prefix, kept);
    return built;
}

}  // namespace rays::grader
