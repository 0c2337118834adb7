#include "renderer/picture_file.h"

#include <dlfcn.h>

#include <filesystem>

#include "core/error.h"

namespace rays {
namespace {

using WriteFunction = const char* (*)(const char* path, int width, int height, const float* rgba);

WriteFunction load_formats() {
    // Beside the program itself, wherever it was started from.
    const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    const std::string library = folder / "librays-formats.so";
    void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle) throw InputError("only .exr can be written: " + std::string(dlerror()));
    return reinterpret_cast<WriteFunction>(dlsym(handle, "rays_write_picture"));
}

}  // namespace

void write_picture(const Film& film, const std::string& path) {
    if (std::filesystem::path(path).extension() == ".exr") return write_exr(film, path);
    static const WriteFunction write = load_formats();
    const auto [width, height] = film.raster();
    if (const char* problem = write(path.c_str(), width, height, film.at(0, 0).lane))
        throw InputError(path + ": cannot write the picture (" + problem + ")");
}

}  // namespace rays
