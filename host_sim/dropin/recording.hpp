// What the program asks of GL, written down for `spangle profile`: SPANGLE_RECORD names the file.
#pragma once

#include <string>

namespace spangle::gl {
struct Context;
}

namespace spangle::dropin {

/// Records the context to its end, where a record was asked for.
void record(gl::Context& context);

/// Writes what was recorded up to now, where a record was asked for. Empty, or what went wrong.
std::string write_recording();

} // namespace spangle::dropin
