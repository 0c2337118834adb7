#include "renderer/private_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace rays {
namespace {

// Away from the small numbers that a program closes or writes to by mistake.
constexpr int kLowestDescriptor = 64;

int take_standard_output() {
    const int kept = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, kLowestDescriptor);
    if (kept < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        throw std::runtime_error(std::string("standard output cannot be set apart: ") + std::strerror(errno));
    return kept;
}

}  // namespace

PrivateOutput::Buffer::Buffer(int descriptor) : descriptor_(descriptor) { setp(text_, text_ + sizeof text_); }

PrivateOutput::Buffer::~Buffer() {
    PrivateOutput::Buffer::sync();
    ::close(descriptor_);
}

int PrivateOutput::Buffer::sync() {
    for (const char* at = pbase(); at < pptr();) {
        const auto written = ::write(descriptor_, at, static_cast<std::size_t>(pptr() - at));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return -1;  // nobody reads any more
        at += written;
    }
    setp(text_, text_ + sizeof text_);
    return 0;
}

PrivateOutput::Buffer::int_type PrivateOutput::Buffer::overflow(int_type c) {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
}

PrivateOutput::PrivateOutput() : std::ostream(nullptr), buffer_(take_standard_output()) { rdbuf(&buffer_); }

PrivateOutput::~PrivateOutput() { rdbuf(nullptr); }

}  // namespace rays
