// Standard output, kept for the program's own words: what a step's code prints goes to standard error instead.
#pragma once

#include <ostream>
#include <streambuf>

namespace rays {

/// From here on file descriptor 1, and so printf, std::cout and write(1, ...), leads to standard error; this stream
/// alone leads to what was standard output. Programs started later do not inherit it. A flush hands all text so far to
/// the system, so that a later crash does not lose it. For the rest of the process: make one at most.
class PrivateOutput : public std::ostream {
public:
    /// Throws std::runtime_error when there is no standard output.
    PrivateOutput();
    ~PrivateOutput() override;
    PrivateOutput(const PrivateOutput&) = delete;
    PrivateOutput& operator=(const PrivateOutput&) = delete;

private:
    class Buffer : public std::streambuf {
    public:
        explicit Buffer(int descriptor);
        ~Buffer() override;
        Buffer(const Buffer&) = delete;
        Buffer& operator=(const Buffer&) = delete;

    protected:
        int_type overflow(int_type c) override;
        int sync() override;

    private:
        int descriptor_;
        char text_[4096];
    };

    Buffer buffer_;
};

}  // namespace rays
