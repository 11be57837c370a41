// Reports to a tool what a program asks for, on hosts: `spangle profile` records with it. A watched context
// has a bit of the gate set, so that commands of other contexts pay nothing. Firmware has none of this.
#pragma once

#include "gl/context/command_text.hpp"
#include "gl/context/features.hpp"
#include "gl/context/range.hpp"
#include "gl/context/threads.hpp"
#include "gl/context/types.hpp"

// Only the whole library can be watched; a subset, or a build without the names of commands, can not.
#if SPANGLE_THREADS && SPANGLE_MESSAGES && SPANGLE_FEATURE_LISTS
#define SPANGLE_WATCHED 1
#else
#define SPANGLE_WATCHED 0
#endif

/// True where this build has code that tells how far programs go (reach.hpp).
#define SPANGLE_TELLS_REACH (SPANGLE_WATCHED || SPANGLE_CHECK_RANGES)

#if SPANGLE_WATCHED

namespace spangle::raster {
struct DrawState;
struct FragmentState;
} // namespace spangle::raster

namespace spangle::gl {

struct Watcher {
    /// Called before a command runs or is compiled into a list, and before each command of a list runs.
    /// `args` are `count` words, as the command takes them; commands of a list come without.
    virtual void command(Context& context, const CommandText& text, const Arg* args, unsigned count) = 0;
    /// Called when fragment state was compiled to draw with it.
    virtual void compiled(Context& context, const raster::FragmentState& fragment,
                          raster::DrawState& state) = 0;
    /// Called when the program has reached `value` in this range (reach.hpp).
    virtual void reached(Range range, std::uint32_t value) = 0;

  protected:
    ~Watcher() = default;
};

/// Sets the watcher of a context, or removes it (null). What is drawn from here on is reported.
void watch(Context& context, Watcher* watcher);

} // namespace spangle::gl

#endif
