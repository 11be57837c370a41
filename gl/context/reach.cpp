#include "gl/context/reach.hpp"

#if SPANGLE_CHECK_RANGES

#include <spangle/message.hpp>

#include "gl/context/sentence.hpp"

#define SPANGLE_TEXT_OF(macro) SPANGLE_TEXT_OF_EXPANDED(macro)
#define SPANGLE_TEXT_OF_EXPANDED(text) #text

namespace spangle::gl {

namespace {

/// Returns the number that a macro expands to, or UINT32_MAX if the macro is undefined and its name remains.
/// A profile that does not record a range does not bound it.
constexpr std::uint32_t number_of(const char* text) {
    std::uint32_t value = 0;
    for (; *text >= '0' && *text <= '9'; ++text)
        value = value * 10 + static_cast<std::uint32_t>(*text - '0');
    return *text == 0 ? value : UINT32_MAX;
}

struct Recorded {
    std::uint32_t most;
#if SPANGLE_MESSAGES
    const char *name, *counted;
#endif
};

constexpr Recorded recorded[range_count] = {
#if SPANGLE_MESSAGES
#define RANGE(name, counted) {number_of(SPANGLE_TEXT_OF(SPANGLE_RANGE_##name)), #name, counted},
#else
#define RANGE(name, counted) {number_of(SPANGLE_TEXT_OF(SPANGLE_RANGE_##name))},
#endif
#include "gl/context/ranges.inc"
#undef RANGE
};

} // namespace

void check_range(Range range, std::uint32_t value) {
    const Recorded& r = recorded[static_cast<unsigned>(range)];
    if (value <= r.most)
        return;
#if SPANGLE_MESSAGES
    Sentence out;
    out << "this program reaches ";
    out.decimal(value) << " " << r.counted << ", and its profile recorded no more than ";
    out.decimal(r.most) << " (" << r.name << " of SPANGLE_RANGES); record what it does here, too";
    message(GL_INVALID_OPERATION, out.text());
#endif
    __builtin_trap();
}

} // namespace spangle::gl

#endif
