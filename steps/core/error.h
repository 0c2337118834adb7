// Errors that say where, what, and what next.
#pragma once

#include <stdexcept>
#include <string>

namespace rays {

/// Exit statuses of every program of the project.
enum ExitStatus : int { kSuccess = 0, kCheckFailed = 1, kBadInput = 2 };

/// Wrong use or bad input: the message is for a person, the program ends with kBadInput.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace rays
