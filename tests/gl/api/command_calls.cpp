#include "tests/gl/api/command_calls.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "gl/context/context.hpp"
#include "tests/gl/api/command_stream.hpp"

namespace spangle::test {
namespace {

/// Bytes of the largest image: (64 + 8)^3 groups of 16 bytes, with aligned rows.
constexpr std::size_t client_bytes = std::size_t{72} * 72 * (72 * 16 + 8) + 64;

/// Tokens for parameters that take one of several tokens.
constexpr GLenum settings[] = {GL_NEAREST,
                               GL_LINEAR,
                               GL_NEAREST_MIPMAP_NEAREST,
                               GL_LINEAR_MIPMAP_NEAREST,
                               GL_NEAREST_MIPMAP_LINEAR,
                               GL_LINEAR_MIPMAP_LINEAR,
                               GL_CLAMP,
                               GL_REPEAT,
                               GL_CLAMP_TO_EDGE,
                               GL_CLAMP_TO_BORDER,
                               GL_MODULATE,
                               GL_DECAL,
                               GL_BLEND,
                               GL_REPLACE,
                               GL_ADD,
                               GL_EXP2,
                               0,
                               1,
                               2};
constexpr GLenum internal_formats[] = {GL_RGBA,
                                       GL_RGB,
                                       GL_ALPHA,
                                       GL_LUMINANCE,
                                       GL_LUMINANCE_ALPHA,
                                       GL_INTENSITY,
                                       GL_RGB8,
                                       GL_RGBA8,
                                       GL_RGB5,
                                       GL_RGB5_A1,
                                       GL_RGBA4,
                                       GL_R3_G3_B2,
                                       GL_ALPHA4,
                                       GL_LUMINANCE8,
                                       GL_INTENSITY8,
                                       GL_LUMINANCE8_ALPHA8,
                                       1,
                                       2,
                                       3,
                                       4};

/// Returns the memory that images, arrays and parameters are read from; it is the same for all streams.
const std::vector<std::uint8_t>& numbers() {
    static const auto all = [] {
        std::vector<std::uint8_t> bytes(client_bytes);
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<std::uint8_t>(i * i * 17 + i * 3);
        return bytes;
    }();
    return all;
}

/// Whether the sizes that a command takes need no client memory.
bool free_size(std::string_view family) {
    return family == "Viewport" || family == "Scissor" || family == "GenLists" || family == "DeleteLists";
}

/// Whether a command reads client memory or a mesh by a number, which must stay small.
bool reads_by_number(std::string_view family) {
    return family == "ArrayElement" || family == "DrawArrays" || family.starts_with("Map") ||
           family.starts_with("EvalMesh");
}

} // namespace

const std::uint8_t* source() {
    return numbers().data();
}

std::uint8_t* result() {
    static std::vector<std::uint8_t> bytes(client_bytes);
    return bytes.data();
}

Calls::Calls(Bytes& stream) : in_(stream) {
    for (std::size_t i = 0; i < client_.size(); ++i) // indices of every type stay below 128
        client_[i] = i % 4 == 0 ? static_cast<std::uint8_t>(i * 37 / 4 % 128) : std::uint8_t{0};
    std::fill(std::begin(elements_), std::end(elements_), client_.data());
}

/// A list that calls two lists takes exponential time, which GL allows. With one call in each list the time
/// is linear.
bool Calls::may_call_a_list(bool& compiling) {
    const gl::Context* const context = gl::current_context();
    compiling = context != nullptr && context->list.index != 0;
    if (!compiling)
        return true;
    const Called here = {context, context->list.index};
    if (std::find(called_.begin(), called_.end(), here) != called_.end())
        return false;
    called_.push_back(here);
    return true;
}

const Command& Calls::one(unsigned selected, bool (*wanted)(std::string_view family)) {
    const auto table = commands();
    const Command& c = table[selected % table.size()];
    const std::string_view family = c.family;
    bool compiling = false;
    if (family == "CallList" || family == "CallLists") {
        if (!may_call_a_list(compiling))
            return c;
    } else if (family == "EndList") {
        const void* const context = gl::current_context();
        std::erase_if(called_, [=](const Called& c) { return c.context == context; });
    }
    Value values[12];
    const Pname* pname = nullptr;
    for (std::size_t i = 0; i < c.args.size(); ++i)
        values[i] = argument(c, c.args[i], family, pname);
    if (family == "CallLists" && compiling && values[0].integer > 1)
        values[0].integer = 1;
    if (wanted == nullptr || wanted(family))
        c.call(values);
    return c;
}

Value Calls::argument(const Command& c, const Arg& arg, std::string_view family, const Pname*& pname) {
    const std::uint8_t how = in_.byte();
    Value v{};
    switch (arg.kind) {
    case Kind::in:
    case Kind::out:
        if (how % 16 != 0)
            v.pointer = c.args.size() > 4 && &arg == &c.args[3] && family == "MultiDrawElements"
                            ? static_cast<void*>(elements_)
                        : family == "DrawElements" || family == "DrawRangeElements" ||
                                family.starts_with("MultiDraw") ||
                                family.starts_with("Buffer") // buffers may hold indices, which must be small
                            ? client_.data()
                            : arg.kind == Kind::out ? result()
                                                    : const_cast<std::uint8_t*>(numbers().data()) +
                                                          how % 8 * 8; // an offset aligned for every type
        break;
    case Kind::enum_:
        if (!arg.accepted.empty() && how % 8 != 0)
            v.integer = arg.accepted[choice_of(how, 8, arg.accepted.size())];
        else
            v.integer = how % 16 == 0 ? in_.word() : in_.word() % 0x9000;
        break;
    case Kind::pname:
        pname = how % 16 != 0 ? &c.pnames[choice_of(how, 16, c.pnames.size())] : nullptr;
        v.integer = pname != nullptr ? pname->name : in_.word() % 0x9000;
        break;
    case Kind::real:
    case Kind::pvalue:
        v.number = number(in_, c, how);
        if (arg.kind == Kind::pvalue && pname != nullptr && pname->kind == 'i' && how % 4 != 0)
            v.number = how % 4 == 1 ? static_cast<double>(pname->good) : settings[how % std::size(settings)];
        if (family == "PixelStore") // rows must fit client memory
            v.number = how % 11 - 2.0;
        break;
    case Kind::sizei:
        v.integer = free_size(family) && how % 16 == 0 ? static_cast<std::int32_t>(in_.word())
                                                       : how % (most_items + 3) - 2;
        break;
    case Kind::int_:
        if (!arg.accepted.empty() && how % 8 != 0) { // chooses an internal format
            v.integer = internal_formats[how % std::size(internal_formats)];
            break;
        }
        // The value is in the range or beside it.
        if (arg.high - arg.low < most_items && how % 8 != 0) {
            v.integer = arg.low - 1 + how % (arg.high - arg.low + 3);
            break;
        }
        v.integer =
            how % 8 == 0 && !reads_by_number(family) ? static_cast<std::int32_t>(in_.word()) : how % 68 - 3;
        break;
    case Kind::boolean:
        v.integer = how % 2;
        break;
    default:
        v.integer = how % 4 == 0 ? in_.word() : how % 32;
    }
    return v;
}

double Calls::number(Bytes& in, const Command& c, std::uint8_t how) {
    const std::string_view name = c.name;
    const bool integers =
        name.find("xOES") != name.npos || name.back() == 'i' || name.back() == 's' || name.back() == 'b';
    if (how % 16 == 0 && !integers) {
        const std::uint32_t bits = in.word();
        float f;
        std::memcpy(&f, &bits, sizeof f);
        return f;
    }
    if (integers) // keeps values that every integer type can hold
        return how % 2 == 0 ? how % 100
               : name.find("ub") != name.npos || name.find("us") != name.npos || name.find("ui") != name.npos
                   ? 5
                   : -(how % 100);
    return how % 4 == 0 ? how * 0.25 - 32 : (how - 128) / 64.0;
}

} // namespace spangle::test
