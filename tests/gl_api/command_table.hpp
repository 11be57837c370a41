// Every entry point with its argument kinds and a uniform way to call it: what the error sweep and the fuzzer
// walk. The table itself is generated from gl/api/commands.
#pragma once

#include <climits>
#include <cstdint>
#include <span>

#include "gl/api/family.hpp"

namespace spangle::test {

using gl::Listing;

enum class Kind : std::uint8_t {
    real,  ///< a number of the entry point's type, in Value::number
    enum_, ///< Value::integer, as the next ones
    int_,
    uint,
    sizei,
    bitfield,
    boolean,
    pname,  ///< one of Command::pnames
    pvalue, ///< the value of the scalar form, in Value::number
    in,     ///< client memory that is read
    out,    ///< client memory that is written
};

struct Pname {
    GLenum name;
    int count;         ///< values it takes
    char kind;         ///< c colour, r real, i integer
    std::int64_t good; ///< a value that is accepted
    GLenum target;     ///< the target it belongs to; 0: the first one
    bool present;      ///< its optional system is in this build
    GLenum code;       ///< what it raises in a context that nothing was done to
};

struct Arg {
    Kind kind;
    std::span<const GLenum> accepted; ///< of an enum; empty when any value may do
    std::int64_t low, high;           ///< what is not INVALID_VALUE by the argument's own rule
    std::int64_t good;                ///< a value that is accepted beside the other good ones
    unsigned size;                    ///< bytes of the type, of one element for pointers
    char type;      ///< of a number or those pointed at: b s i, B S I unsigned, l intptr, f d x; 0: no number
    unsigned count; ///< numbers that lie at a pointer; 0: parameters of Pname::count, or what others decide
};

union Value {
    std::int64_t integer;
    double number;
    void* pointer;
};

struct Command {
    const char* name;
    const char* family;
    const char* row; ///< of the feature matrix
    bool inside;     ///< legal between Begin and End
    Listing listing;
    bool present;   ///< its feature is in this build
    GLenum refuses; ///< what all arguments raise, or NO_ERROR
    std::span<const Arg> args;
    std::span<const Pname> pnames;
    void (*call)(const Value* values);
};

std::span<const Command> commands();

} // namespace spangle::test
