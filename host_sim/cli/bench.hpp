// spangle bench: measures how long frames take on this machine.
#pragma once

namespace spangle::cli {

/// Times every scene in each precision that this build has; prints a table, or one JSON object.
int bench(bool json);

} // namespace spangle::cli
