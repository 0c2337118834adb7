#include "page.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>

#include "core/error.h"
#include "encoding.h"

namespace rays::report {
namespace {

namespace fs = std::filesystem;

const char* const kStyles[] = {"base.css",  "layout.css", "checks.css", "pictures.css",
                               "costs.css", "charts.css", "print.css"};
// In this order: each builds on those before it.
const char* const kScripts[] = {
    "dom.js",     "words.js",   "data.js",           "colors.js",     "bits.js",         "foretelling.js", "pixels.js",
    "near.js",    "picture.js", "viewer.js",         "statistics.js", "axes.js",         "chart.js",       "marks.js",
    "scatter.js", "ratios.js",  "student_points.js", "speed.js",      "tree_picture.js", "trees.js",       "check.js",
    "costs.js",   "cells.js",   "overview.js",       "steps.js",      "theme.js",        "main.js"};

constexpr int kSteps = 8;

std::string read_text(const fs::path& file, const std::string& what_next) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError(file.string() + ": cannot be read; " + what_next);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A source map would be asked for from outside of the page.
std::string without_source_map(std::string script) {
    const std::size_t at = script.rfind("//# sourceMappingURL");
    if (at != std::string::npos) script.resize(at);
    return script;
}

/// Our own scripts and styles without indentation and without lines that are comments: a tenth of them. Texts within
/// them must not go over several lines.
std::string compact(const std::string& text) {
    std::string kept;
    bool in_comment = false;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line(text.data() + begin, end - begin);
        begin = end + 1;
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        in_comment = in_comment || (line.starts_with("/*") && line.find("*/") == std::string_view::npos);
        const bool comment = in_comment || line.starts_with("//") || (line.starts_with("/*") && line.ends_with("*/"));
        if (in_comment && line.ends_with("*/")) in_comment = false;
        if (!comment && !line.empty()) kept.append(line) += '\n';
    }
    return kept;
}

/// What stands in a script or style element must not end it.
void check_inlinable(const std::string& text, const fs::path& file) {
    std::string lower = text;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
    for (const char* end : {"</script", "</style", "<!--"})
        if (lower.find(end) != std::string::npos)
            throw InputError(fmt::format("{}: contains '{}' and cannot stand in a page", file.string(), end));
}

std::string hashes(const std::vector<std::string>& contents) {
    std::string list;
    for (const std::string& text : contents) list += fmt::format(" 'sha256-{}'", base64(sha256(text)));
    return list;
}

std::string elements(const std::string& name, const std::vector<std::string>& contents,
                     const std::string& attributes = "") {
    std::string html;
    for (const std::string& text : contents) html += fmt::format("<{0}{2}>{1}</{0}>\n", name, text, attributes);
    return html;
}

std::string escaped(const std::string& text) {
    std::string html;
    for (const char c : text) {
        if (c == '<')
            html += "&lt;";
        else if (c == '&')
            html += "&amp;";
        else
            html += c;
    }
    return html;
}

/// One pass: what is filled in is not searched again.
std::string filled(std::string_view page, const std::map<std::string, std::string, std::less<>>& values) {
    std::string out;
    while (!page.empty()) {
        const std::size_t open = page.find("{{");
        const std::size_t close = open == std::string_view::npos ? open : page.find("}}", open);
        out += page.substr(0, open);
        if (close == std::string_view::npos) break;
        out += values.at(std::string(page.substr(open + 2, close - open - 2)));
        page.remove_prefix(close + 2);
    }
    return out;
}

}  // namespace

PageParts read_parts(const fs::path& folder) {
    const fs::path packages = folder / "node_modules";
    const std::string install =
        "the report's JavaScript packages are not installed: run './rays demo', or 'npm ci' in " + folder.string();
    const std::string sources = "it belongs to the sources of the report";
    PageParts parts;
    const auto add = [&](std::vector<std::string>& list, const fs::path& file, const std::string& what_next) {
        list.push_back(without_source_map(read_text(file, what_next)));
        check_inlinable(list.back(), file);
    };
    add(parts.styles, packages / "img-comparison-slider/dist/styles.css", install);
    add(parts.styles, packages / "uplot/dist/uPlot.min.css", install);
    add(parts.scripts, packages / "img-comparison-slider/dist/index.js", install);
    add(parts.scripts, packages / "uplot/dist/uPlot.iife.min.js", install);
    std::string style, script;
    for (const char* name : kStyles) style += read_text(folder / "page" / name, sources);
    for (const char* name : kScripts) script += read_text(folder / "page" / name, sources);
    parts.styles.push_back(compact(style));
    parts.modules.push_back(compact(script));
    check_inlinable(style, folder / "page");
    check_inlinable(script, folder / "page");
    parts.html = read_text(folder / "page/template.html", sources);
    for (int step = 1; step <= kSteps; ++step) {
        const fs::path file = folder / fmt::format("gallery/small/step_{}.jpg", step);
        if (!fs::exists(file)) continue;
        const std::string bytes = read_text(file, sources);
        parts.heroes += fmt::format("<img data-step=\"{}\" alt=\"\" src=\"data:image/jpeg;base64,{}\">", step,
                                    base64(Bytes(bytes.begin(), bytes.end())));
    }
    parts.notices = "img-comparison-slider\n\n" + read_text(folder / "licenses/img-comparison-slider.txt", sources) +
                    "\n\nuPlot\n\n" + read_text(packages / "uplot/LICENSE", install);
    return parts;
}

std::string assemble(const PageParts& parts, const std::string& results, const std::vector<PictureStore::Blob>& blobs) {
    const std::string policy = fmt::format(
        "default-src 'none'; script-src{}{}; style-src{}; img-src data: blob:; base-uri 'none'; form-action 'none'",
        hashes(parts.scripts), hashes(parts.modules), hashes(parts.styles));
    std::string pixels;
    for (const auto& blob : blobs)
        pixels += fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", blob.id, blob.text);
    return filled(parts.html, {{"csp", policy},
                               {"styles", elements("style", parts.styles)},
                               {"notices", escaped(parts.notices)},
                               {"heroes", parts.heroes},
                               {"results", base91(deflate(results))},
                               {"pixels", pixels},
                               {"scripts", elements("script", parts.scripts) +
                                               elements("script", parts.modules, " type=\"module\"")}});
}

}  // namespace rays::report
