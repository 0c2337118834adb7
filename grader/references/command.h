// The command `rays references`.
#pragma once

namespace rays {

/// references [NAME...] [--check [N]] [--hashes] [--force] ...: see --help. argv[0] is the command's own name.
/// Returns an ExitStatus; everything for people goes to standard output, problems to standard error.
int references_command(int argc, const char* const* argv);

}  // namespace rays
