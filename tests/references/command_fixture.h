// The references command in a folder of its own: what it returns and says.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "references/command.h"
#include "references/library.h"
#include "support/files.h"

namespace rays {

class ReferencesCommand : public testing::Test {
protected:
    explicit ReferencesCommand(Raster raster) : raster_(raster) {}

    void put(const std::string& name, std::string_view text) { write_atomically(folder_.path() / name, text); }

    /// Exit status; what was said goes to out_ and err_.
    int run(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(),
                         {"references", "--scenes", folder_.path().string(), "--width", std::to_string(raster_.width),
                          "--height", std::to_string(raster_.height)});
        std::vector<const char*> argv;
        for (const std::string& a : arguments) argv.push_back(a.c_str());
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int status = references_command(static_cast<int>(argv.size()), argv.data());
        out_ = testing::internal::GetCapturedStdout();
        err_ = testing::internal::GetCapturedStderr();
        return status;
    }

    ReferenceFolders folders() const { return {folder_.path()}; }
    bool err_says(const std::string& text) const { return err_.find(text) != std::string::npos; }

    TemporaryFolder folder_;
    std::string out_, err_;

private:
    Raster raster_;
};

}  // namespace rays
