// Typical mistakes as text: grader/mutants/*.txt, the format of ARCHITECTURE.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rays::grader {

struct Hunk {
    std::string before, after;
    int line = 0;  ///< of the file of mutants, for messages
};

struct Mutant {
    enum class Kind {
        mutant,   ///< a mistake: must be caught
        variant,  ///< correct but different: must lose nothing
        naive     ///< the method of the textbook, for the charts of the sweeps
    };
    Kind kind = Kind::mutant;
    std::string id, task, title, seen;
    std::string file;   ///< relative to solutions/: "1_ray_casting/quadrics.cpp"
    std::string sweep;  ///< naive only: the sweep it belongs to; empty: all of its task
    std::vector<Hunk> hunks;
    std::string where;  ///< "1_ray_casting.txt:12"
};

/// Throws InputError "name:line: what" for anything that is not the format.
std::vector<Mutant> parse_mutants(std::string_view text, const std::string& name);

/// All of the folder's files, in the order of their names. Ids are unique.
std::vector<Mutant> read_mutants(const std::filesystem::path& folder);

/// The solution's source with the mistake in it. Throws InputError unless every hunk occurs exactly once.
std::string apply(const Mutant& mutant, std::string source);

}  // namespace rays::grader
