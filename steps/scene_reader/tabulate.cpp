#include "scene_reader/tabulate.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <new>

#include "core/error.h"
#include "scene_reader/number_paths.h"
#include "scene_reader/number_table.h"
#include "scene_reader/scene_numbers.h"

namespace rays::sdl {

namespace {

/// Intervals of a table.
constexpr int kFinest = 8192;
/// Text read again and again, in all, and numbers held at a time.
constexpr double kMostBytesReadAgain = 1e9;
constexpr double kMostSamples = 3e7;

/// All numbers of a scene in visiting order, and a fingerprint of everything else.
struct Numbers {
    std::vector<double> values;
    std::uint64_t structure = 14695981039346656037ull;

    explicit Numbers(const Scene& scene) { visit_numbers(scene, *this); }

    void number(const char*, double x) { values.push_back(x); }
    void fixed(std::int64_t n) { structure = (structure ^ static_cast<std::uint64_t>(n)) * 1099511628211ull; }
    void enter(const char*) {}
    void enter(const char*, std::size_t) {}
    void leave() {}
};

class Tabulator {
public:
    Tabulator(Sources& sources, const Source& text, const ReadOptions& options, const Budget& budget)
        : sources_(sources), text_(text), options_(options), budget_(budget) {}

    Scene run() {
        Reading reading = read({});
        const bool again = options_.tabulate && (reading.used_time || reading.used_wavelength);
        if (!again) return std::move(reading.scene);
        std::vector<Variable> variables;
        if (reading.used_time) variables.push_back(kTime);
        if (reading.used_wavelength) variables.push_back(kWavelength);
        choices_.varying = true;
        if (budget_.can_grow) budget_.work = kWorkAgain;
        budget_.can_grow = false;
        do {  // until all readings can agree on what is folded
            choices_.changed = false;
            base_scene_ = read({}).scene;
            base_.emplace(base_scene_);
            tables_.clear();
            for (const Variable& variable : variables) tabulate(variable);
            if (variables.size() == 2) require_separate();
        } while (choices_.changed);
        write_tables();
        return std::move(base_scene_);
    }

private:
    Reading read(const std::vector<std::pair<std::string, double>>& values) {
        ReadOptions options = options_;
        // What the scene's #debug says is said once.
        if (readings_ > 0) options.debug = nullptr;
        bytes_read_ += static_cast<double>(text_.text.size()) * (readings_++ > 0);
        if (bytes_read_ > kMostBytesReadAgain)
            fail("this scene is too large to be read at enough values of Time or Wavelength");
        options.declared.insert(options.declared.end(), values.begin(), values.end());
        return read_once(sources_, text_, options, choices_, budget_);
    }

    std::vector<double> read_at(const Variable& variable, double value) {
        const Scene scene = read({{variable.name, value}}).scene;
        Numbers numbers(scene);
        budget_.work -= static_cast<std::int64_t>(numbers.values.size());  // comparing costs as reading does
        if (numbers.structure != base_->structure || numbers.values.size() != base_->values.size()) {
            if (choices_.changed) return base_->values;  // another round follows
            fail(fmt::format("the scene has other parts at {} = {} than at {}; only numbers may change with it",
                             variable.name, value, variable.first));
        }
        return std::move(numbers.values);
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(fmt::format("{}:1:1: {}", text_.name, what));
    }

    void tabulate(const Variable& variable) {
        NumberTable table(variable, base_->values);
        for (int i = 0; i <= 4; ++i) table.add(read_at(variable, variable.at(i / 4.0)));
        while (!choices_.changed) {
            const std::size_t intervals = table.intervals();
            for (std::size_t i = 0; i < intervals; ++i) {
                const double middle = (static_cast<double>(i) + 0.5) / static_cast<double>(intervals);
                table.add_middle(read_at(variable, variable.at(middle)));
            }
            const bool fine = table.middles_agree() && probes_agree(table);
            table.merge_middles();
            if (fine) break;
            if (2 * intervals > kFinest || table.held() > kMostSamples)
                fail(fmt::format("some number changes too abruptly with {}, or too many do; let it change smoothly",
                                 variable.name));
        }
        tables_.push_back(std::move(table));
    }

    /// Values that no regular grid meets: a wave that is 0 at all grid points is found out here.
    bool probes_agree(NumberTable& table) {
        for (const double part : {0.1180339887, 0.3819660113, 0.5278640450, 0.7360679775, 0.9442719100})
            if (!table.agrees(part, read_at(table.variable(), table.variable().at(part)))) return false;
        return true;
    }

    /// A number may depend on Time or on Wavelength, not on both.
    void require_separate() {
        const auto moved = read_at(kTime, 0.7);
        const auto tinted = read_at(kWavelength, 611);
        const Scene scene = read({{kTime.name, 0.7}, {kWavelength.name, 611}}).scene;
        const Numbers both_changed(scene);
        if (both_changed.structure != base_->structure)
            fail("the scene's parts change with Time and Wavelength together");
        for (std::size_t i = 0; i < base_->values.size(); ++i) {
            const bool depends_on_both = moved[i] != base_->values[i] && tinted[i] != base_->values[i];
            const double expected = moved[i] != base_->values[i] ? moved[i] : tinted[i];
            const bool as_expected =
                std::abs(both_changed.values[i] - expected) <= kNumberRounding * std::abs(expected);
            if (depends_on_both || !as_expected) fail_for_both(i);
        }
    }

    [[noreturn]] void fail_for_both(std::size_t i) const {
        fail(
            fmt::format("{} depends on Time and on Wavelength; let it depend on one of them", path_of(base_scene_, i)));
    }

    void write_tables() {
        std::map<std::size_t, std::string> paths;
        for (const NumberTable& table : tables_)
            for (const std::size_t i : table.which()) paths[i];
        find_paths(base_scene_, paths);
        for (const NumberTable& table : tables_) {
            for (std::size_t k = 0; k < table.which().size(); ++k) {
                if (table.is_constant(k)) continue;
                Varying varying = table.thinned(k);
                varying.what = paths[table.which()[k]];
                base_scene_.varying.push_back(std::move(varying));
            }
        }
    }

    Sources& sources_;
    const Source& text_;
    const ReadOptions& options_;
    FoldChoices choices_;
    Budget budget_;
    Scene base_scene_;
    std::optional<Numbers> base_;
    std::vector<NumberTable> tables_;
    int readings_ = 0;
    double bytes_read_ = 0;
};

}  // namespace

Scene read_and_tabulate(Sources& sources, const Source& text, const ReadOptions& options, const Budget& budget) {
    try {
        return Tabulator(sources, text, options, budget).run();
    } catch (const std::bad_alloc&) {
        throw InputError(fmt::format("{}:1:1: there is not enough memory to read this scene", text.name));
    }
}

}  // namespace rays::sdl
