#include "scene_reader/tabulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>

#include "core/error.h"
#include "scene_reader/scene_numbers.h"

namespace rays::sdl {

namespace {

/// A table is fine enough when linear interpolation misses by less than this part of the number's whole range, ...
constexpr double kTolerance = 2e-5;
/// ... or by rounding (of floats, which colours are).
constexpr double kRounding = 1e-6;
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

/// The paths of chosen numbers.
struct Paths {
    std::map<std::size_t, std::string> found;  ///< in: the numbers asked for; out: their paths
    std::vector<std::string> stack;
    std::size_t next = 0;

    void number(const char* name, double) {
        const auto wanted = found.find(next++);
        if (wanted == found.end()) return;
        for (const std::string& part : stack) wanted->second += part + ".";
        wanted->second += name;
    }
    void fixed(std::int64_t) {}
    void enter(const char* name) { stack.emplace_back(name); }
    void enter(const char* name, std::size_t i) { stack.push_back(fmt::format("{}[{}]", name, i)); }
    void leave() { stack.pop_back(); }
};

struct Variable {
    Varying::Variable kind;
    const char* name;
    double first, last;
};
constexpr Variable kTime{Varying::Variable::time, "Time", 0, 1};
constexpr Variable kWavelength{Varying::Variable::wavelength_nm, "Wavelength", 380, 780};

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
    /// samples[i][k]: number `which[k]` at first + i / (samples.size() - 1) of the range.
    struct Table {
        Variable variable;
        std::vector<std::size_t> which;
        std::vector<std::vector<double>> samples;
        std::vector<std::vector<double>> middles;  ///< samples between those, while the table gets finer
    };

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

    static double position(const Variable& variable, double part) {
        return variable.first + part * (variable.last - variable.first);
    }

    /// Numbers that were constant so far and are not any more join the table.
    void admit(Table& table, const std::vector<double>& values) {
        std::vector<std::size_t> changed;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (values[i] != base_->values[i]) changed.push_back(i);
        }
        std::vector<std::size_t> fresh;
        std::set_difference(changed.begin(), changed.end(), table.which.begin(), table.which.end(),
                            std::back_inserter(fresh));
        if (fresh.empty()) return;
        std::vector<std::size_t> all;
        std::set_union(table.which.begin(), table.which.end(), fresh.begin(), fresh.end(), std::back_inserter(all));
        for (auto& sample : table.samples) widen(sample, table.which, all);
        for (auto& sample : table.middles) widen(sample, table.which, all);
        table.which = std::move(all);
    }

    void widen(std::vector<double>& sample, const std::vector<std::size_t>& which,
               const std::vector<std::size_t>& all) {
        std::vector<double> wider;
        wider.reserve(all.size());
        std::size_t old = 0;
        for (std::size_t i : all) {
            const bool known = old < which.size() && which[old] == i;
            wider.push_back(known ? sample[old++] : base_->values[i]);
        }
        sample = std::move(wider);
    }

    std::vector<double> pick(const Table& table, const std::vector<double>& values) {
        std::vector<double> picked;
        picked.reserve(table.which.size());
        for (std::size_t i : table.which) picked.push_back(values[i]);
        return picked;
    }

    void tabulate(const Variable& variable) {
        Table table{variable, {}, {}, {}};
        const auto sample = [&](double part) {
            const std::vector<double> values = read_at(variable, position(variable, part));
            admit(table, values);
            return pick(table, values);
        };
        table.samples.push_back(sample(0));
        for (int i = 1; i <= 4; ++i) {
            auto next = sample(i / 4.0);
            table.samples.push_back(std::move(next));
        }
        while (!choices_.changed) {
            const std::size_t intervals = table.samples.size() - 1;
            std::vector<std::vector<double>> finer(2 * intervals + 1);
            for (std::size_t i = 0; i < intervals; ++i) {
                auto middle = sample((static_cast<double>(i) + 0.5) / static_cast<double>(intervals));
                table.middles.push_back(std::move(middle));
            }
            const bool fine = is_fine(table) && probes_agree(table, sample);
            for (std::size_t i = 0; i <= intervals; ++i) finer[2 * i] = std::move(table.samples[i]);
            for (std::size_t i = 0; i < intervals; ++i) finer[2 * i + 1] = std::move(table.middles[i]);
            table.samples = std::move(finer);
            table.middles.clear();
            if (fine) break;
            const double held = static_cast<double>(table.samples.size()) * static_cast<double>(table.which.size());
            if (2 * intervals > kFinest || held > kMostSamples) {
                fail(fmt::format("some number changes too abruptly with {}, or too many do; let it change smoothly",
                                 variable.name));
            }
        }
        tables_.push_back(std::move(table));
    }

    /// What a deviation of number k may be.
    static double allowed(const Table& table, std::size_t k) {
        double low = table.samples[0][k], high = low;
        for (const auto& sample : table.samples) {
            low = std::min(low, sample[k]);
            high = std::max(high, sample[k]);
        }
        return kTolerance * (high - low) + kRounding * std::max(std::abs(low), std::abs(high));
    }

    /// Rotations by different angles give lengths that differ in their last bits: that is no change.
    static bool is_constant(const Table& table, std::size_t k) {
        const double first = table.samples[0][k];
        return std::all_of(table.samples.begin(), table.samples.end(),
                           [&](const auto& sample) { return std::abs(sample[k] - first) <= 1e-14 * std::abs(first); });
    }

    static bool is_fine(const Table& table) {
        for (std::size_t k = 0; k < table.which.size(); ++k) {
            const double limit = allowed(table, k);
            for (std::size_t i = 0; i < table.middles.size(); ++i) {
                const double between = (table.samples[i][k] + table.samples[i + 1][k]) / 2;
                if (!(std::abs(table.middles[i][k] - between) <= limit)) return false;
            }
        }
        return true;
    }

    /// Values that no regular grid meets: a wave that is 0 at all grid points is found out here.
    template <class Sample>
    bool probes_agree(const Table& table, Sample sample) {
        for (double part : {0.1180339887, 0.3819660113, 0.5278640450, 0.7360679775, 0.9442719100}) {
            const std::vector<double> values = sample(part);
            const double at = part * static_cast<double>(table.samples.size() - 1);
            const auto i = static_cast<std::size_t>(at);
            const double rest = at - static_cast<double>(i);
            for (std::size_t k = 0; k < table.which.size(); ++k) {
                const double between = table.samples[i][k] * (1 - rest) + table.samples[i + 1][k] * rest;
                if (!(std::abs(values[k] - between) <= 2 * allowed(table, k))) return false;
            }
        }
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
            const bool as_expected = std::abs(both_changed.values[i] - expected) <= kRounding * std::abs(expected);
            if (depends_on_both || !as_expected) fail_for_both(i);
        }
    }

    [[noreturn]] void fail_for_both(std::size_t i) {
        Paths paths;
        paths.found[i];
        visit_numbers(std::as_const(base_scene_), paths);
        fail(fmt::format("{} depends on Time and on Wavelength; let it depend on one of them", paths.found[i]));
    }

    /// Every 2^n-th sample, as long as the left-out ones lie on the lines between the others.
    static Varying thinned(const Table& table, std::size_t k) {
        const double limit = allowed(table, k);
        const std::size_t last = table.samples.size() - 1;
        double error = 0;
        std::size_t step = last;
        for (; step > 1; step /= 2) {
            error = 0;
            for (std::size_t i = 0; i <= last; ++i) {
                const std::size_t left = std::min(i / step * step, last - step);
                const double rest = static_cast<double>(i - left) / static_cast<double>(step);
                const double line = table.samples[left][k] * (1 - rest) + table.samples[left + step][k] * rest;
                error = std::max(error, std::abs(table.samples[i][k] - line));
            }
            if (error <= limit) break;
        }
        Varying varying;
        varying.variable = table.variable.kind;
        varying.first = static_cast<Real>(table.variable.first);
        varying.last = static_cast<Real>(table.variable.last);
        // The deviation was seen at some points only; between them it is at most a little larger.
        varying.error = static_cast<Real>(2 * std::max(error, kRounding * std::abs(table.samples[0][k])) + 1e-12);
        for (std::size_t i = 0; i <= last; i += step) varying.samples.push_back(static_cast<Real>(table.samples[i][k]));
        return varying;
    }

    void write_tables() {
        Paths paths;
        for (const Table& table : tables_) {
            for (std::size_t i : table.which) paths.found[i];
        }
        visit_numbers(std::as_const(base_scene_), paths);
        for (const Table& table : tables_) {
            for (std::size_t k = 0; k < table.which.size(); ++k) {
                if (is_constant(table, k)) continue;
                Varying varying = thinned(table, k);
                varying.what = paths.found[table.which[k]];
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
    std::vector<Table> tables_;
    int readings_ = 0;
    double bytes_read_ = 0;
};

}  // namespace

void require_finite(const Scene& scene, const Source& text) {
    struct Check {
        std::size_t next = 0, bad = 0;
        bool all_finite = true;
        void number(const char*, double x) {
            if (all_finite && !std::isfinite(x)) {
                all_finite = false;
                bad = next;
            }
            ++next;
        }
        void fixed(std::int64_t) {}
        void enter(const char*) {}
        void enter(const char*, std::size_t) {}
        void leave() {}
    } check;
    visit_numbers(scene, check);
    if (check.all_finite) return;
    Paths paths;
    paths.found[check.bad];
    visit_numbers(scene, paths);
    throw InputError(fmt::format("{}:1:1: {} is not a finite number; look for a transform or a size that is too large",
                                 text.name, paths.found[check.bad]));
}

Scene read_and_tabulate(Sources& sources, const Source& text, const ReadOptions& options, const Budget& budget) {
    try {
        return Tabulator(sources, text, options, budget).run();
    } catch (const std::bad_alloc&) {
        throw InputError(fmt::format("{}:1:1: there is not enough memory to read this scene", text.name));
    }
}

}  // namespace rays::sdl
