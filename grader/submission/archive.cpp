#include "grader/submission/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <array>
#include <fstream>
#include <memory>

#include "core/error.h"
#include "grader/submission/safe_path.h"
#include "grader/text.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlock = 64 * 1024;

using Reader = std::unique_ptr<archive, decltype(&archive_read_free)>;
using Writer = std::unique_ptr<archive, decltype(&archive_write_free)>;
using Entry = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
    throw InputError(fmt::format("{}: {}", plain(file.filename().string()), why));
}

Reader open_archive(const fs::path& file) {
    Reader reader(archive_read_new(), archive_read_free);
    archive_read_support_format_tar(reader.get());
    archive_read_support_format_zip(reader.get());
    archive_read_support_filter_gzip(reader.get());
    if (archive_read_open_filename(reader.get(), file.c_str(), kBlock) != ARCHIVE_OK)
        refuse(file, "is no .tar.gz and no .zip archive");
    return reader;
}

bool passed_over(const std::string& name) {
    for (const fs::path& part : fs::path(name)) {
        const std::string p = part.string();
        if ((p.starts_with('.') && p != "..") || p == "__MACOSX") return true;
    }
    return false;
}

std::string entry_name(const fs::path& file, archive_entry* entry) {
    const char* raw = archive_entry_pathname(entry);
    if (!raw) refuse(file, "holds an entry without a readable name");
    std::string name = raw;
    while (name.starts_with("./")) name.erase(0, 2);
    while (name.ends_with('/')) name.pop_back();
    return name;
}

/// Copies one file out; returns its bytes. The size that the archive states is not believed.
std::size_t copy_out(const fs::path& file, archive* reader, const fs::path& target, std::size_t room) {
    std::ofstream out(target, std::ios::binary);
    std::array<char, kBlock> block;
    std::size_t total = 0;
    for (;;) {
        const auto n = archive_read_data(reader, block.data(), block.size());
        if (n == 0) break;
        if (n < 0)
            refuse(file, "is damaged: " + plain(archive_error_string(reader) ? archive_error_string(reader) : ""));
        total += static_cast<std::size_t>(n);
        if (total > room) refuse(file, "unpacks to more bytes than a submission may have");
        out.write(block.data(), n);
    }
    if (!out.flush()) throw std::runtime_error("cannot write " + target.string());
    return total;
}

fs::path only_folder_or(const fs::path& folder) {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry.path());
    return all.size() == 1 && fs::is_directory(all.front()) ? all.front() : folder;
}

void add_file(archive* writer, const std::string& name, const std::string& bytes) {
    const Entry entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    const bool good = archive_write_header(writer, entry.get()) == ARCHIVE_OK &&
                      archive_write_data(writer, bytes.data(), bytes.size()) == static_cast<la_ssize_t>(bytes.size());
    if (!good) throw InputError(name + ": cannot be packed");
}

}  // namespace

fs::path unpack(const fs::path& file, const fs::path& into, const ArchiveLimits& limits) {
    const Reader reader = open_archive(file);
    archive_entry* entry = nullptr;
    std::size_t entries = 0, bytes = 0;
    for (;;) {
        const int status = archive_read_next_header(reader.get(), &entry);
        if (status == ARCHIVE_EOF) break;
        if (status != ARCHIVE_OK) refuse(file, "is damaged, or no .tar.gz or .zip archive");
        if (++entries > limits.entries) refuse(file, fmt::format("has more than {} entries", limits.entries));
        const std::string name = entry_name(file, entry);
        if (name.empty() || passed_over(name)) continue;
        if (const std::string why = path_problem(name); !why.empty())
            refuse(file, fmt::format("the entry \"{}\" {}", plain(name, 60), why));
        const bool link = archive_entry_hardlink(entry) || archive_entry_symlink(entry);
        const auto type = archive_entry_filetype(entry);
        if (link || (type != AE_IFREG && type != AE_IFDIR))
            refuse(file, fmt::format("the entry \"{}\" is a link or something else that is no file", plain(name, 60)));
        if (type == AE_IFDIR) {
            fs::create_directories(into / name);
            continue;
        }
        if (fs::exists(into / name)) refuse(file, fmt::format("has \"{}\" twice", plain(name, 60)));
        fs::create_directories((into / name).parent_path());
        bytes += copy_out(file, reader.get(), into / name, limits.bytes - bytes);
    }
    if (entries == 0) refuse(file, "is empty");
    return only_folder_or(into);
}

void pack(const fs::path& folder, const std::vector<std::string>& files, const fs::path& target) {
    write_atomically(target, [&](const fs::path& partial) {
        const Writer writer(archive_write_new(), archive_write_free);
        archive_write_set_format_ustar(writer.get());
        archive_write_add_filter_gzip(writer.get());
        archive_write_set_filter_option(writer.get(), "gzip", "timestamp", nullptr);
        if (archive_write_open_filename(writer.get(), partial.c_str()) != ARCHIVE_OK)
            throw InputError(target.string() + ": cannot be written; check that the folder exists and has room");
        for (const std::string& name : files) add_file(writer.get(), name, read_file(folder / name));
        if (archive_write_close(writer.get()) != ARCHIVE_OK) throw InputError(target.string() + ": cannot be written");
    });
}

}  // namespace rays::grader
