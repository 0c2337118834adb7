// Makes steps/N_*/*.cpp from solutions/N_*/*.cpp: the marked regions become tasks (ARCHITECTURE.md, "Marked regions").
//   starters SOLUTIONS_DIR STEPS_DIR           writes the starters
//   starters --check SOLUTIONS_DIR STEPS_DIR   exit status 1 when one differs
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, int line, const std::string& what) {
    throw std::runtime_error(file.string() + ":" + std::to_string(line) + ": " + what);
}

/// Turns one solution into its starter, line by line.
class Generator {
public:
    explicit Generator(fs::path file) : file_(std::move(file)) {}

    std::string generate(std::istream& in) {
        for (std::string line; std::getline(in, line);) {
            ++number_;
            const auto indent = line.find_first_not_of(' ');
            const std::string text = indent == std::string::npos ? "" : line.substr(indent);
            if (text.starts_with("//>")) open(text.substr(3), std::string(indent, ' '));
            else if (text.starts_with("//<")) close(word(text.substr(3)));
            else if (region_.empty() || region_ == "given") keep(line);
            else in_text_ = false;
        }
        if (!region_.empty()) fail(file_, opened_, "region " + region_ + " is never closed");
        return squeeze(out_.str());
    }

private:
    static std::string word(const std::string& text) {
        std::string first;
        std::istringstream(text) >> first;
        return first;
    }

    void keep(const std::string& line) { out_ << line << '\n'; }

    void open(std::string text, const std::string& indent) {
        if (in_text_) return say(indent, text);
        if (!region_.empty()) fail(file_, number_, "region inside region " + region_);
        region_ = word(text);
        opened_ = number_;
        if (region_ == "hidden" || region_ == "given") return;
        indent_ = indent;
        in_text_ = true;
        text = text.substr(text.find(region_) + region_.size());
        is_void_ = word(text) == "void";
        if (is_void_) text = text.substr(text.find("void") + 4);
        out_ << indent << "// Task " << region_ << ":" << text << '\n';
    }

    void say(const std::string& indent, const std::string& text) {
        const auto start = text.find_first_not_of(' ');
        out_ << indent << "// " << (start == std::string::npos ? "" : text.substr(start)) << '\n';
    }

    void close(const std::string& id) {
        if (id != region_) fail(file_, number_, "//< " + id + " closes region " + (region_.empty() ? "none" : region_));
        if (id != "hidden" && id != "given")
            out_ << indent_ << "unfinished(\"" << id << "\");\n" << (is_void_ ? "" : indent_ + "return {};\n");
        region_.clear();
        in_text_ = false;
    }

    /// No two empty lines in a row, as left where helpers were taken out.
    static std::string squeeze(const std::string& text) {
        std::string result;
        for (const char c : text)
            if (!(c == '\n' && result.size() >= 2 && result.ends_with("\n\n"))) result += c;
        return result;
    }

    fs::path file_;
    std::ostringstream out_;
    std::string region_, indent_;
    int number_ = 0, opened_ = 0;
    bool in_text_ = false, is_void_ = false;
};

std::string read_file(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Steps stand in folders that begin with their number; what else solutions have has no starter.
std::vector<fs::path> solution_files(const fs::path& solutions) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(solutions)) {
        const std::string top = fs::relative(entry.path(), solutions).begin()->string();
        const bool in_step = top[0] >= '0' && top[0] <= '9';
        if (in_step && entry.path().extension() == ".cpp") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    if (files.empty()) throw std::runtime_error(solutions.string() + ": no solutions here");
    return files;
}

/// True when the starter is (now) what its solution gives.
bool make_starter(const fs::path& solution, const fs::path& starter, bool check) {
    std::ifstream in(solution);
    const std::string text = Generator(solution).generate(in);
    if (read_file(starter) == text) return true;
    if (check) {
        std::cerr << starter.string() << " is not what " << solution.string() << " gives; run ./rays starters\n";
        return false;
    }
    std::ofstream out(starter, std::ios::binary);
    if (!(out << text).flush()) throw std::runtime_error(starter.string() + ": cannot be written");
    std::cout << "wrote " << starter.string() << '\n';
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const bool check = std::erase(words, "--check") > 0;
    if (words.size() != 2) {
        std::fputs("use: starters [--check] SOLUTIONS_DIR STEPS_DIR\n", stderr);
        return 2;
    }
    try {
        bool same = true;
        for (const fs::path& solution : solution_files(words[0]))
            same &= make_starter(solution, fs::path(words[1]) / fs::relative(solution, words[0]), check);
        return same ? 0 : 1;
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}
