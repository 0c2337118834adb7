#include "scene_reader/scene_reader.h"

#include <cstdlib>

#include "scene_reader/number_paths.h"
#include "scene_reader/reading.h"
#include "scene_reader/statements.h"
#include "scene_reader/tabulate.h"

namespace rays {

namespace sdl {

Reading read_once(Sources& sources, const Source& text, const ReadOptions& options, FoldChoices& choices,
                  Budget& budget) {
    choices.next = 0;
    budget.objects = 0;
    budget.memory = budget.memory_limit;
    Reading reading;
    Interpreter in(sources, text, options, budget);
    Flattener out(reading.scene, in, choices);
    Context context(in, reading.scene, out);
    in.read_thing = [&context](Value& result) { return read_thing(context, result); };
    in.read_default = [&context] { read_default(context); };
    read_frame(context);
    out.finish();
    require_finite(reading.scene, text);
    reading.scene.name = text.name;
    reading.scene.notes = std::move(in.notes());
    reading.used_time = in.used_time();
    reading.used_wavelength = in.used_wavelength();
    return reading;
}

}  // namespace sdl

namespace {

std::vector<std::filesystem::path> include_folders(const ReadOptions& options) {
    if (!options.include_folders.empty()) return options.include_folders;
    const std::filesystem::path povray = povray_include_folder();
    if (povray.empty()) return {};
    return {povray};
}

}  // namespace

Scene read_scene(const std::filesystem::path& file, const ReadOptions& options) {
    sdl::Sources sources(file.parent_path(), include_folders(options));
    const sdl::Source& text = sources.add_file(file);
    return sdl::read_and_tabulate(sources, text, options);
}

Scene read_scene_text(std::string_view text, const std::string& name, const ReadOptions& options) {
    sdl::Sources sources(std::filesystem::path(name).parent_path(), include_folders(options));
    return sdl::read_and_tabulate(sources, sources.add_text(name, text), options);
}

std::filesystem::path povray_include_folder() {
    for (const char* folder : {"/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include",
                               "/usr/share/povray/include", "/opt/homebrew/share/povray-3.7/include"}) {
        std::error_code error;
        if (std::filesystem::is_regular_file(std::filesystem::path(folder) / "colors.inc", error)) return folder;
    }
    return {};
}

}  // namespace rays
