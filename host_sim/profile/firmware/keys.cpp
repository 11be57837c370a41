// Counts what is drawn with each state key, in the functions that draw rows and paths. Prints a line "key
// CALLS PIXELS TICKS WORDS" for each key. The first line has no words, and tells what counting itself takes.
#include "host_sim/profile/firmware/counting.hpp"

#include <cstdint>

#include MEASURE_BOARD
#include "host_sim/profile/key_words.hpp"
#include "raster/span/path.hpp"
#include "raster/span/rows.hpp"

namespace spangle::measure {

namespace {

using namespace raster;

/// The figures of a key while frames were counted.
struct KeyFigures {
    Key key;
    std::uint32_t calls;
    std::uint64_t pixels, ticks;
};
constexpr std::uint32_t most_keys = 128, most_states = 4;

/// A state, the functions that draw its kinds of primitives, and the keys they count for.
struct Watched {
    const DrawState* state;
    AnyFunction run[kind_count], walk[kind_count];
    std::uint32_t key[kind_count];
};

KeyFigures drawn[most_keys]; ///< the first entry has no key: it counts a call that draws nothing
std::uint32_t keys = 1;
Watched watched[most_states];
bool on;

/// The record of a state. The program stops at one state too many, and at a state that nobody compiled: such
/// a state would be counted for another.
Watched& of_state(const DrawState* state, bool make) {
    for (Watched& one : watched)
        if (one.state == state || (make && one.state == nullptr)) {
            one.state = state;
            return one;
        }
    __builtin_trap();
}

std::uint32_t place_of(const Key& key) {
    for (std::uint32_t i = 1; i < keys; ++i)
        if (drawn[i].key == key)
            return i;
    if (keys == most_keys)
        __builtin_trap();
    drawn[keys].key = key;
    return keys++;
}

template <class Draw> void count(std::uint32_t place, std::uint32_t pixels, const Draw& draw) {
    const std::uint32_t begin = now();
    draw();
    const std::uint32_t end = now();
    if (!on)
        return;
    KeyFigures& one = drawn[place];
    ++one.calls;
    one.pixels += pixels;
    one.ticks += ticks_between(begin, end);
}

template <int K> void rows(Span<Fixed>& span, const Row* row, const Row* end) {
    const Watched& state = of_state(span.state, false);
    std::uint32_t pixels = 0;
    for (const Row* at = row; at != end; ++at)
        pixels += static_cast<std::uint32_t>(at->last - at->first);
    count(state.key[K], pixels, [&] { reinterpret_cast<RowsFunction<Fixed>>(state.run[K])(span, row, end); });
}

template <int K> void paths(const DrawState& draw, const Surface& target, const Paths& path, int number) {
    const Watched& state = of_state(&draw, false);
    std::uint32_t pixels = 0;
    for (int i = 0; i < number; ++i)
        if (const std::int32_t length = path.at(Paths::count, i); length > 0)
            pixels += static_cast<std::uint32_t>(length);
    count(state.key[K], pixels,
          [&] { reinterpret_cast<PathFunction>(state.walk[K])(draw, target, path, number); });
}

constexpr RowsFunction<Fixed> row_counters[kind_count] = {&rows<0>, &rows<1>, &rows<2>, &rows<3>};
constexpr PathFunction path_counters[kind_count] = {&paths<0>, &paths<1>, &paths<2>, &paths<3>};

[[gnu::noinline]] void nothing() {
    asm volatile("");
}

/// Prints words on the output of the board.
struct Printer {
    Printer& operator<<(const char* text) {
        print(text);
        return *this;
    }
    Printer& operator<<(unsigned number) {
        print(number);
        return *this;
    }
};

} // namespace

void begin_frame() {
    on = true;
    for (int i = 0; i < 256; ++i)
        count(0, 0, nothing);
}

void end_frame() {
    on = false;
}

std::size_t counting_bytes() {
    return sizeof drawn + sizeof watched + sizeof keys + sizeof on;
}

void forget_counts() {
    for (KeyFigures& one : drawn)
        one = {};
    for (Watched& one : watched)
        one = {};
    keys = 1;
}

void print_counts() {
    for (std::uint32_t i = 0; i < keys; ++i) {
        const KeyFigures& one = drawn[i];
        Printer out;
        out << "key " << one.calls << " " << static_cast<unsigned>(one.pixels) << " "
            << static_cast<unsigned>(one.ticks) << " ";
        if (i != 0)
            profile::say(out, one.key);
        out << "\n";
    }
}

void count_state(const FragmentState& fragment, const Surface& target, DrawState& out) {
    Watched& state = of_state(&out, true);
    for (int i = 0; i < kind_count; ++i) {
        Variant& variant = out.variant[i];
        if (variant.run == nullptr || out.nothing)
            continue;
        state.key[i] = place_of(make_key(fragment, target, static_cast<Kind>(i)));
        state.run[i] = variant.run;
        state.walk[i] = variant.walk;
        variant.run = reinterpret_cast<AnyFunction>(row_counters[i]);
        if (variant.walk != nullptr)
            variant.walk = reinterpret_cast<AnyFunction>(path_counters[i]);
    }
    out.shapes = out.tiles = false; // draws rows instead, which are counted by key
}

} // namespace spangle::measure

#ifdef MEASURE_COMPILE
// Calls of the function that compiles a state come here: measure.py wraps it (Engine::compile, as the linker
// knows it).
extern "C" {
void measure_real_compile(const spangle::raster::FragmentState&, const spangle::raster::Surface&,
                          spangle::raster::DrawState&) asm("__real_" MEASURE_COMPILE);
void measure_compile(const spangle::raster::FragmentState&, const spangle::raster::Surface&,
                     spangle::raster::DrawState&) asm("__wrap_" MEASURE_COMPILE);
}

void measure_compile(const spangle::raster::FragmentState& fragment, const spangle::raster::Surface& target,
                     spangle::raster::DrawState& out) {
    measure_real_compile(fragment, target, out);
    spangle::measure::count_state(fragment, target, out);
}
#endif
