// Reports the commands of a program to a tool, on hosts; `spangle profile` records with it. A watched context
// has a bit of its gate set, so that commands of other contexts take no more time. Firmware has no such code.
#pragma once

#include "gl/context/command_text.hpp"
#include "gl/context/features.hpp"
#include "gl/context/range.hpp"
#include "gl/context/threads.hpp"
#include "gl/context/types.hpp"

// Only the whole library can be watched, not a subset or a build without the names of commands.
#if SPANGLE_THREADS && SPANGLE_MESSAGES && SPANGLE_FEATURE_LISTS
#define SPANGLE_WATCHED 1
#else
#define SPANGLE_WATCHED 0
#endif

/// True if this build has code that reports how far programs go in their ranges (reach.hpp).
#define SPANGLE_TELLS_REACH (SPANGLE_WATCHED || SPANGLE_CHECK_RANGES)

#if SPANGLE_WATCHED

namespace spangle::raster {
struct DrawState;
struct FragmentState;
} // namespace spangle::raster

namespace spangle::gl {

struct Watcher {
    /// Called before a command runs or is compiled into a list, and before each command of a list runs.
    /// `args` are `count` words in the form that the command takes. Commands of a list come without
    /// arguments.
    virtual void command(Context& context, const CommandText& text, const Arg* args, unsigned count) = 0;
    /// Called after fragment state was compiled to draw with it.
    virtual void compiled(Context& context, const raster::FragmentState& fragment,
                          raster::DrawState& state) = 0;
    /// Called when the program has reached `value` in this range (reach.hpp).
    virtual void reached(Range range, std::uint32_t value) = 0;

  protected:
    ~Watcher() = default;
};

/// Sets the watcher of a context, or removes it (null). Commands from now on are reported to it.
void watch(Context& context, Watcher* watcher);

} // namespace spangle::gl

#endif
