// The grader's questions about a scene, answered one a line (ARCHITECTURE.md, "Questions and answers").
#pragma once

#include <iosfwd>

namespace rays {

/// Reads scene blocks and queries until the end of input. Every query gets one line, whatever happens,
/// flushed before the next query is looked at.
void answer_questions(std::istream& in, std::ostream& out);

}  // namespace rays
