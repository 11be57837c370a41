// Describes every entry point by the kinds of its arguments, with a uniform way to call it. The error sweep
// and the fuzzer walk this table, which is generated from gl/api/commands.
#pragma once

#include <climits>
#include <cstdint>
#include <span>

#include "gl/api/family.hpp"

namespace spangle::test {

using gl::Listing;

enum class Kind : std::uint8_t {
    real,  ///< a number of the entry point's type, in Value::number
    enum_, ///< a token, in Value::integer, as are the next kinds
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
    int count;         ///< number of values it takes
    char kind;         ///< 'c' colour, 'r' real, 'i' integer
    std::int64_t good; ///< a value that is accepted
    GLenum target;     ///< the target it belongs to; 0: the first target
    bool present;      ///< whether its optional system is in this build
    GLenum code;       ///< the error in a new context, or NO_ERROR
};

struct Arg {
    Kind kind;
    std::span<const GLenum> accepted; ///< tokens that are accepted; empty: any value may be
    std::int64_t low, high;           ///< values that are not INVALID_VALUE by the argument's own rule
    std::int64_t good;                ///< a value that is accepted together with the other good ones
    unsigned size;                    ///< bytes of the type; of one element for pointers
    char type;      ///< type of the number: b s i, B S I unsigned, l intptr, f d x; 0: no number
    unsigned count; ///< numbers at a pointer; 0: Pname::count, or other arguments decide
};

union Value {
    std::int64_t integer;
    double number;
    void* pointer;
};

struct Command {
    const char* name;
    const char* family;
    const char* row; ///< row of the feature matrix
    bool inside;     ///< whether the call is legal between Begin and End
    Listing listing;
    bool present;   ///< whether its feature is in this build
    GLenum refuses; ///< the error that every call gives, or NO_ERROR
    std::span<const Arg> args;
    std::span<const Pname> pnames;
    void (*call)(const Value* values);
};

std::span<const Command> commands();

} // namespace spangle::test
