// Who is told what a program asks for, on hosts: `spangle profile` records with it. One bit of the gate keeps
// commands of a context that is watched from simply running, so that others pay nothing; firmware has none of
// this.
#pragma once

#include "gl/context/command_text.hpp"
#include "gl/context/features.hpp"
#include "gl/context/range.hpp"
#include "gl/context/threads.hpp"
#include "gl/context/types.hpp"

// The whole library records; a subset, and a build without the names of commands, does not.
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
    /// A command that is about to run or to be recorded in a list, and each record of a list that is about to
    /// run. `args` are `count` words, as the command takes them; records come without.
    virtual void command(Context& context, const CommandText& text, const Arg* args, unsigned count) = 0;
    /// A state of fragments was compiled: something is drawn with it.
    virtual void compiled(Context& context, const raster::FragmentState& fragment,
                          raster::DrawState& state) = 0;
    /// The program went as far as `value` (reach.hpp).
    virtual void reached(Range range, std::uint32_t value) = 0;

  protected:
    ~Watcher() = default;
};

/// Null: nobody watches any more. What is drawn from here on is told.
void watch(Context& context, Watcher* watcher);

} // namespace spangle::gl

#endif
