#include "references/scene_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/error.h"
#include "support/files.h"

namespace rays {
namespace fs = std::filesystem;

namespace {

/// The words and strings of SDL text, comments left out; everything else is a word of one character.
class Scanner {
public:
    struct Token {
        std::string text;
        bool string = false;
    };
    explicit Scanner(std::string_view text) : rest_(text) {}

    std::optional<Token> next() {
        skip_space_and_comments();
        if (rest_.empty()) return std::nullopt;
        if (rest_[0] == '"') return string();
        std::size_t length = rest_[0] == '#' ? 1 : 0;
        if (length == 1) take_while(length, [](char c) { return c == ' ' || c == '\t'; });  // "# include" is legal
        const std::size_t begin = length;
        take_while(length, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; });
        std::string text = begin > 0 ? "#" : "";
        if (begin == 0 && length == 0) length = 1;
        text += rest_.substr(begin, length - begin);
        rest_.remove_prefix(length);
        return Token{text, false};
    }

private:
    template <class Predicate>
    void take_while(std::size_t& length, Predicate wanted) const {
        while (length < rest_.size() && wanted(rest_[length])) ++length;
    }

    Token string() {
        std::size_t length = 1;
        while (length < rest_.size() && rest_[length] != '"') length += rest_[length] == '\\' ? 2 : 1;
        length = std::min(length, rest_.size());
        Token token{std::string(rest_.substr(1, length - 1)), true};
        rest_.remove_prefix(std::min(length + 1, rest_.size()));
        return token;
    }

    void skip_space_and_comments() {
        for (;;) {
            if (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_[0]))) {
                rest_.remove_prefix(1);
            } else if (rest_.starts_with("//")) {
                rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
            } else if (rest_.starts_with("/*")) {
                skip_block_comment();
            } else {
                return;
            }
        }
    }

    void skip_block_comment() {  // they nest in POV-Ray
        int depth = 0;
        do {
            const bool opens = rest_.starts_with("/*");
            const bool closes = rest_.starts_with("*/");
            depth += opens ? 1 : closes ? -1 : 0;
            rest_.remove_prefix(opens || closes ? 2 : 1);
        } while (depth > 0 && !rest_.empty());
    }

    std::string_view rest_;
};

/// Where a file really lies, through links and "..".
bool lies_in(const fs::path& file, const fs::path& folder) {
    const fs::path inside = fs::weakly_canonical(file).lexically_relative(fs::canonical(folder.empty() ? "." : folder));
    return !inside.empty() && *inside.begin() != "..";
}

fs::path locate(const std::string& name, const fs::path& scene, const std::vector<fs::path>& folders,
                const std::string& asked_by) {
    std::vector<fs::path> tried{scene.parent_path()};
    tried.insert(tried.end(), folders.begin(), folders.end());
    for (const fs::path& folder : tried) {
        const fs::path file = folder / name;
        if (!fs::is_regular_file(file)) continue;
        if (lies_in(file, folder)) return file;
        throw InputError(fmt::format("{}: includes \"{}\", which lies outside of {}", asked_by, name,
                                     folder.empty() ? "." : folder.string()));
    }
    std::string where;
    for (const fs::path& folder : tried)
        where += (where.empty() ? "" : ", ") + (folder.empty() ? "." : folder.string());
    throw InputError(fmt::format("{}: includes \"{}\", which is in none of: {}", asked_by, name, where));
}

}  // namespace

std::vector<std::string> find_scenes(const fs::path& root) {
    if (!fs::is_directory(root)) throw InputError(fmt::format("{}: no such folder of scenes", root.string()));
    std::vector<std::string> result;
    for (const auto& folder : fs::directory_iterator(root)) {
        const std::string name = folder.path().filename().string();
        if (!folder.is_directory() || !std::isdigit(static_cast<unsigned char>(name[0]))) continue;
        for (const auto& file : fs::directory_iterator(folder)) {
            if (file.path().extension() == ".pov") result.push_back(name + "/" + file.path().filename().string());
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<std::string> scenes_named(const std::vector<std::string>& scenes, const std::string& name) {
    std::vector<std::string> result;
    for (const std::string& scene : scenes) {
        const fs::path path(scene);
        const std::string folder = path.parent_path().string();
        const std::string number = folder.substr(0, folder.find('_'));
        const fs::path plain = fs::path(path).replace_extension();
        for (const std::string& meaning :
             {scene, path.filename().string(), plain.string(), plain.filename().string(), folder, number}) {
            if (meaning == name) {
                result.push_back(scene);
                break;
            }
        }
    }
    if (result.empty()) throw InputError(fmt::format("no scene is named '{}'", name));
    return result;
}

std::vector<std::string> included_names(std::string_view sdl, const std::string& where) {
    std::vector<std::string> result;
    Scanner scanner(sdl);
    std::string before;
    while (const auto token = scanner.next()) {
        const bool wanted = before == "#include" || before == "df3";
        if (wanted && token->string) result.push_back(token->text);
        if (before == "#include" && !token->string) {
            throw InputError(fmt::format("{}: '#include {}...': write the file's name in quotes", where, token->text));
        }
        before = token->string ? "" : token->text;
    }
    return result;
}

bool mentions(std::string_view sdl, std::string_view word) {
    Scanner scanner(sdl);
    while (const auto token = scanner.next()) {
        if (!token->string && token->text == word) return true;
    }
    return false;
}

std::map<std::string, fs::path> included_files(const fs::path& scene, const std::vector<fs::path>& folders) {
    std::map<std::string, fs::path> result;
    std::vector<fs::path> unread{scene};
    while (!unread.empty()) {
        const fs::path file = unread.back();
        unread.pop_back();
        if (file.extension() == ".df3") continue;  // data, not SDL
        for (const std::string& name : included_names(read_file(file), file.string())) {
            if (result.contains(name)) continue;
            result[name] = locate(name, scene, folders, file.string());
            unread.push_back(result[name]);
        }
    }
    return result;
}

bool has_frames(const fs::path& scene, const std::vector<fs::path>& folders) {
    constexpr std::string_view kWord = "Frame";
    if (mentions(read_file(scene), kWord)) return true;
    for (const auto& [name, file] : included_files(scene, folders)) {
        const bool own = file == scene.parent_path() / name;
        if (own && file.extension() != ".df3" && mentions(read_file(file), kWord)) return true;
    }
    return false;
}

}  // namespace rays
