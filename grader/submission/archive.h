// Submissions as archives: unpacked as if they came from an enemy, packed the same for the same files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rays::grader {

/// Far more than any submission needs, far less than fills a disk.
struct ArchiveLimits {
    std::size_t entries = 2000;
    std::size_t bytes = 256u << 20;  ///< of all files, unpacked
};

/// Unpacks .tar, .tar.gz, .tgz or .zip into the empty folder `into` and returns the folder with the submission: `into`,
/// or the only folder in it. Only plain folders and regular files with plain names (safe_path.h) are made; names that
/// begin with "./" lose that. Hidden files and folders (".git", ".DS_Store", "__MACOSX") are passed over. Links,
/// devices, names that lead outside, the same name twice and what exceeds the limits are refused: throws InputError.
std::filesystem::path unpack(const std::filesystem::path& archive, const std::filesystem::path& into,
                             const ArchiveLimits& limits = {});

/// Packs files, by their names below `folder`, as .tar.gz without owner, date or mode: same files, same bytes.
/// Appears whole or not at all. Throws InputError when it cannot be written.
void pack(const std::filesystem::path& folder, const std::vector<std::string>& files,
          const std::filesystem::path& archive);

}  // namespace rays::grader
