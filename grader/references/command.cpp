#include "references/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <numeric>
#include <random>

#include "core/error.h"
#include "references/in_parallel.h"
#include "references/library.h"
#include "references/scene_files.h"

namespace rays {
namespace {

struct Order {
    ReferenceFolders folders;
    std::vector<std::string> names;
    bool check = false;
    int sample = 0;  ///< how many to render for --check; 0: all
    bool hashes = false;
    bool force = false;
    Raster raster{160, 120};
    int frames = 0;  ///< of a mean; 0: as many as it has, or kFrames
    int jobs = static_cast<int>(std::thread::hardware_concurrency()) + 1;  // each process waits some wall time
    double seconds = 120;
    unsigned seed = 1;
};

constexpr int kFrames = 512;

/// POV-Ray sleeps for most of a small frame's half second, so several of them share a processor.
constexpr int kFramesPerJob = 4;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::string> wanted_scenes(const Order& order) {
    const std::vector<std::string> all = find_scenes(order.folders.scenes);
    if (order.names.empty()) return all;
    std::vector<std::string> wanted;
    for (const std::string& name : order.names) {
        for (const std::string& scene : scenes_named(all, name)) wanted.push_back(scene);
    }
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    return wanted;
}

/// One line a scene, from any thread, and how many were bad.
class Account {
public:
    void good(const std::string& line) { say(stdout, line); }
    void bad(const std::string& scene, const std::string& problem) {
        say(stderr, fmt::format("FAILED  {}: {}", scene, problem));
        const std::lock_guard lock(mutex_);
        ++failures_;
    }
    /// Runs `work`; a problem it throws is this scene's failure.
    template <class Work>
    void attempt(const std::string& scene, const Work& work) {
        try {
            work();
        } catch (const std::exception& problem) {
            bad(scene, problem.what());
        }
    }
    int failures() const { return failures_; }
    int status() const { return failures_ == 0 ? kSuccess : kCheckFailed; }

private:
    void say(std::FILE* to, const std::string& line) {
        const std::lock_guard lock(mutex_);
        fmt::print(to, "{}\n", line);
        std::fflush(to);
    }
    std::mutex mutex_;
    int failures_ = 0;
};

/// Takes out what no scene has any more: entries, and with them their pictures.
void drop_orphans(Manifest& manifest, const Order& order) {
    std::erase_if(manifest.entries, [&](const ManifestEntry& entry) {
        if (std::filesystem::exists(order.folders.scenes / entry.scene)) return false;
        std::filesystem::remove(order.folders.references() / entry.reference);
        fmt::print("dropped {}: the scene is gone\n", entry.scene);
        return true;
    });
}

bool up_to_date(const Order& order, const Manifest& manifest, const std::string& scene, const Povray& povray) {
    const ManifestEntry* entry = manifest.find(scene);
    if (entry == nullptr || (entry->averaged() && order.frames > 0 && entry->frames != order.frames)) return false;
    return stale_fingerprints(order.folders, *entry, povray.include_folder()).empty();
}

Averaging averaging_of(const Order& order, const Povray& povray, const ManifestEntry* known) {
    Averaging how{&povray, order.raster, order.frames, kFramesPerJob * order.jobs, order.seconds};
    if (known != nullptr) how.raster = known->raster;
    if (how.frames == 0) how.frames = known != nullptr && known->averaged() ? known->frames : kFrames;
    return how;
}

/// Scenes of one frame are rendered several at once; of the others one after another, but several frames at once.
/// Calls work(scene, averaged) for all; a problem is its scene's failure.
template <class Work>
void for_each_scene(const std::vector<std::string>& scenes, const Order& order, const Povray& povray, Account& account,
                    const Work& work) {
    std::vector<std::string> single, averaged;
    for (const std::string& scene : scenes) {
        account.attempt(scene,
                        [&] { (is_averaged(order.folders, scene, povray) ? averaged : single).push_back(scene); });
    }
    in_parallel(single.size(), order.jobs,
                [&](std::size_t i) { account.attempt(single[i], [&] { work(single[i], false); }); });
    for (const std::string& scene : averaged) account.attempt(scene, [&] { work(scene, true); });
}

int make(const Order& order) {
    const Povray povray;
    const std::vector<std::string> scenes = wanted_scenes(order);
    Manifest manifest;
    if (std::filesystem::exists(order.folders.manifest())) manifest = load_manifest(order.folders.manifest());
    const bool same_povray = manifest.povray == povray.version();
    manifest.povray = povray.version();
    drop_orphans(manifest, order);

    Account account;
    std::mutex manifest_mutex;
    int made = 0;
    for_each_scene(scenes, order, povray, account, [&](const std::string& scene, bool averaged) {
        Averaging how{&povray, order.raster};
        {
            const std::lock_guard lock(manifest_mutex);
            if (!order.force && same_povray && up_to_date(order, manifest, scene, povray)) return;
            how = averaging_of(order, povray, manifest.find(scene));
        }
        const auto start = std::chrono::steady_clock::now();
        const ManifestEntry entry = averaged
                                        ? make_averaged_reference_of(order.folders, scene, how)
                                        : make_reference_of(order.folders, scene, how.raster, povray, order.seconds);
        account.good(fmt::format(
            "made    {}  {} x {}  {:.1f} s{}", scene, entry.raster.width, entry.raster.height, seconds_since(start),
            averaged ? fmt::format("  {}, standard error {:.2g}", entry.method, entry.standard_error) : std::string()));
        const std::lock_guard lock(manifest_mutex);
        manifest.put(entry);
        ++made;
        if (averaged) save_manifest(manifest, order.folders.manifest());  // a minute's work: not to be lost
    });
    save_manifest(manifest, order.folders.manifest());
    fmt::print("{} made, {} up to date, {} failed (POV-Ray {})\n", made,
               static_cast<int>(scenes.size()) - made - account.failures(), account.failures(), povray.version());
    return account.status();
}

/// Fingerprints of everything wanted. POV-Ray need not be installed unless a scene includes one of its files.
void check_fingerprints(const Order& order, const Manifest& manifest, const std::vector<std::string>& scenes,
                        const std::filesystem::path& povray_includes, Account& account) {
    for (const std::string& scene : scenes) {
        account.attempt(scene, [&] {
            const ManifestEntry* entry = manifest.find(scene);
            if (entry == nullptr) return account.bad(scene, "has no reference; make it: rays references");
            for (const std::string& problem : stale_fingerprints(order.folders, *entry, povray_includes)) {
                account.bad(scene, problem + "; make it anew: rays references");
            }
        });
    }
    for (const ManifestEntry& entry : manifest.entries) {
        if (!std::filesystem::exists(order.folders.scenes / entry.scene)) account.bad(entry.scene, "the scene is gone");
    }
}

std::vector<std::string> sample_of(std::vector<std::string> scenes, const Order& order) {
    if (order.sample <= 0 || static_cast<std::size_t>(order.sample) >= scenes.size()) return scenes;
    std::shuffle(scenes.begin(), scenes.end(), std::mt19937(order.seed));
    scenes.resize(static_cast<std::size_t>(order.sample));
    return scenes;
}

int check(const Order& order) {
    const Manifest manifest = load_manifest(order.folders.manifest());
    const std::vector<std::string> scenes = wanted_scenes(order);
    Account account;
    if (!order.check) {
        check_fingerprints(order, manifest, scenes, find_povray_includes(), account);
        fmt::print("{} references verified by fingerprint, {} problems\n", scenes.size(), account.failures());
        return account.status();
    }
    const Povray povray;
    check_fingerprints(order, manifest, scenes, povray.include_folder(), account);
    if (povray.version() != manifest.povray) {
        fmt::print("note: the references are by POV-Ray {}, here is {}\n", manifest.povray, povray.version());
    }
    std::vector<std::string> known = scenes;
    std::erase_if(known, [&](const std::string& scene) { return manifest.find(scene) == nullptr; });  // told already
    const std::vector<std::string> sample = sample_of(known, order);
    for_each_scene(sample, order, povray, account, [&](const std::string& scene, bool averaged) {
        const ManifestEntry* entry = manifest.find(scene);
        if (averaged != entry->averaged())
            return account.bad(scene, fmt::format("the reference is {}, but the scene {} Frame", entry->method,
                                                  averaged ? "uses" : "does not use"));
        const int replicate = static_cast<int>(order.seed % kReplicates);
        const std::string difference =
            averaged ? averaged_difference_today(order.folders, *entry, averaging_of(order, povray, entry), replicate)
                     : difference_today(order.folders, *entry, povray, order.seconds);
        if (!difference.empty()) return account.bad(scene, difference);
        account.good(fmt::format("same    {}{}", scene,
                                 averaged ? fmt::format("  (replicate {} of {})", replicate, kReplicates) : ""));
    });
    fmt::print("{} of {} references rendered anew, {} problems\n", sample.size(), scenes.size(), account.failures());
    return account.status();
}

/// "--check 5" is a sample of five, "--check one_sphere" is the check of a scene.
void sort_out_check(const std::vector<std::string>& words, Order& order) {
    for (const std::string& word : words) {
        int number = 0;
        const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), number);
        const bool is_number = failure == std::errc() && end == word.data() + word.size();
        if (is_number && number > 0) {
            order.sample = number;
        } else if (!word.empty()) {
            order.names.push_back(word);
        }
    }
}

}  // namespace

int references_command(int argc, const char* const* argv) {
    Order order;
    std::vector<std::string> check_words;
    CLI::App app("Pictures by POV-Ray, to hold our own against", "references");
    app.add_option("name", order.names, "scenes, or folders of scenes; default: all");
    CLI::Option* check_option =
        app.add_option("--check", check_words,
                       "render N scenes (default: all) anew and compare: a frame bit by bit, of a mean an eighth "
                       "of its frames")
            ->expected(0, 1)
            ->type_name("[N]");
    app.add_flag("--hashes", order.hashes, "only verify fingerprints; nothing is rendered");
    app.add_flag("--force", order.force, "make also what is up to date");
    app.add_option("--width", order.raster.width, "pixels of new references")->check(CLI::Range(1, 1024));
    app.add_option("--height", order.raster.height, "pixels of new references")->check(CLI::Range(1, 1024));
    app.add_option("--frames", order.frames, "frames of a mean: a multiple of 8; default: as many as it has, or 512")
        ->check([](const std::string& text) {
            const int frames = std::atoi(text.c_str());
            return frames >= kReplicates && frames <= 1 << 16 && frames % kReplicates == 0
                       ? std::string()
                       : fmt::format("must be a multiple of {}, up to 65536", kReplicates);
        });
    app.add_option("--jobs", order.jobs, fmt::format("scenes at once, and {} frames of a mean for each", kFramesPerJob))
        ->check(CLI::Range(1, 256));
    app.add_option("--time-limit", order.seconds, "seconds a frame")->check(CLI::PositiveNumber);
    app.add_option("--seed", order.seed, "which sample --check N takes, and which replicate of a mean");
    app.add_option("--scenes", order.folders.scenes, "the folder of scenes");
    try {
        app.parse(argc, argv);
        order.check = check_option->count() > 0;
        sort_out_check(check_words, order);
        return order.check || order.hashes ? check(order) : make(order);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? kSuccess : kBadInput;
    } catch (const PovrayError& problem) {
        fmt::print(stderr, "{}\n", problem.what());
        return kCheckFailed;
    } catch (const std::exception& problem) {
        fmt::print(stderr, "references: {}\n", problem.what());
        return kBadInput;
    }
}

}  // namespace rays
