// Records what the program asks of GL, for `spangle profile`; SPANGLE_RECORD names the file.
#pragma once

#include <string>

namespace spangle::gl {
struct Context;
}

namespace spangle::dropin {

/// Records the context until its end, if a record was asked for.
void record(gl::Context& context);

/// Writes what was recorded up to now, if a record was asked for. Returns what went wrong, or an empty
/// string.
std::string write_recording();

} // namespace spangle::dropin
