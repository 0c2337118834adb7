// Which scenes there are, and of which files each is made.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rays {

/// The scenes under `root`, as "1_ray_casting/one_sphere.pov", sorted: every *.pov in a folder that begins with a
/// digit.
std::vector<std::string> find_scenes(const std::filesystem::path& root);

/// Those of `scenes` that the name means: "1_ray_casting/one_sphere.pov", the same without folder or extension,
/// or a whole folder ("1_ray_casting" or "1"). Throws InputError when it means none.
std::vector<std::string> scenes_named(const std::vector<std::string>& scenes, const std::string& name);

/// The names of the files that SDL text asks for, in order: `#include "x"` and `df3 "x"`, not in comments or strings.
/// Throws InputError for an #include whose name is computed: its fingerprint cannot be taken.
std::vector<std::string> included_names(std::string_view sdl, const std::string& where);

/// Does SDL text use this word, not in comments or strings?
bool mentions(std::string_view sdl, std::string_view word);

/// Every file that the scene includes, directly or not: the name as written -> where it was found (the scene's folder
/// first, then each of `folders`). Throws InputError when one is nowhere, or outside of the folder it was looked for
/// in: POV-Ray 3.7 on Unix reads any file whatever its povray.conf permits.
std::map<std::string, std::filesystem::path> included_files(const std::filesystem::path& scene,
                                                            const std::vector<std::filesystem::path>& folders);

/// Is the scene to be referenced by the mean of many frames? It is when its own text, or a file of its own folder that
/// it includes, uses the word `Frame`. Throws as included_files().
bool has_frames(const std::filesystem::path& scene, const std::vector<std::filesystem::path>& folders);

}  // namespace rays
