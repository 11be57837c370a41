// Gives every number of every entry point of the command table its extreme values, beside arguments that are
// accepted: outside Begin and End, between them, and in a display list, in each tier. A call may raise an
// error that GL allows, and must then change nothing. Queried state stays finite, and drawing breaks nothing.
// A picture that is drawn afterwards, with the state set back, must be that of a new context.
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gl/context/state_table.hpp"
#include "tests/gl/api/error_sweep.hpp"
#include "tests/oracle/extreme_sweep/numbers.hpp"
#include "tests/oracle/extreme_sweep/picture.hpp"

namespace spangle::test {
namespace {

/// SPANGLE_SWEEP=whole tries every number; otherwise each day tries one of several.
bool whole() {
    const char* const wish = std::getenv("SPANGLE_SWEEP");
    return wish != nullptr && std::string(wish) == "whole";
}

enum class Where { outside, between, in_list };

const char* name_of(Where where) {
    return where == Where::outside   ? "outside"
           : where == Where::between ? "between glBegin and glEnd"
                                     : "in a list";
}

/// A number of a call: an argument, and an element if the argument points at several.
struct Place {
    std::size_t arg, element;
};

class ExtremeSweep : public ErrorSweep {
  protected:
    ExtremeSweep() : ErrorSweep(gl::fixed_engine), pixels_(width * height * 4), depths_(pixels_.size()) {}

    /// Makes a new context of the tier, on surfaces in memory blocks of their own.
    void renew(raster::Tier tier) {
        gl::destroy_context(context);
        EXPECT_EQ(arena.used(), 0u);
        context = gl::create_context(arena, {.tier = tier, .engine = &gl::fixed_engine}, nullptr);
        ASSERT_NE(context, nullptr);
        raster::Surface s = surface();
        s.color = pixels_.data();
        s.depth = depths_.data();
        gl::make_current(context, s, false);
        save();
    }

    static void save() {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    }

    std::vector<std::uint8_t> picture() {
        leave_everything();
        save();
        draw_picture();
        leave_everything();
        std::vector<std::uint8_t> all = pixels_;
        all.insert(all.end(), depths_.begin(), depths_.end());
        context->error_code = GL_NO_ERROR;
        save();
        return all;
    }

    static std::vector<Place> places(const Command& c, std::size_t pname) {
        std::vector<Place> out;
        for (std::size_t i = 0; i < c.args.size(); ++i) {
            const Arg& arg = c.args[i];
            if (arg.kind == Kind::enum_ || arg.kind == Kind::pname || arg.kind == Kind::out || arg.type == 0)
                continue;
            if (arg.kind == Kind::pvalue && c.pnames[pname].count > 1)
                continue; // the scalar form refuses this parameter
            std::size_t elements = 1;
            if (arg.kind == Kind::in)
                elements = arg.count != 0     ? arg.count
                           : c.pnames.empty() ? 0
                                              : static_cast<std::size_t>(c.pnames[pname].count);
            for (std::size_t e = 0; e < elements; ++e)
                out.push_back({i, e});
        }
        return out;
    }

    /// Returns whether sizes and indices of the command decide how much client memory it reads or writes.
    static bool has_client_memory(const Command& c) {
        if (!c.pnames.empty()) // the name of the parameter decides which values are legal
            return false;
        for (const Arg& arg : c.args)
            if ((arg.kind == Kind::in || arg.kind == Kind::out) && arg.count == 0)
                return true;
        return false;
    }

    /// Returns accepted arguments. Numbers that the table leaves at 0 are 1 if that is accepted, too.
    std::vector<Value> sane(const Command& c, std::size_t pname) {
        auto values = good(c, pname);
        for (std::size_t i = 0; i < c.args.size(); ++i) {
            const Arg& arg = c.args[i];
            if (arg.kind == Kind::real && values[i].number == 0)
                values[i].number = arg.type == 'x' ? 65536 : 1;
            for (std::size_t e = 0; arg.kind == Kind::in && e < arg.count; ++e)
                put(client, arg.type, e, arg.type == 'x' ? 65536 : 1);
        }
        return values;
    }

    static void set(const Command& c, Place place, std::vector<Value>& values, void* client, double number) {
        const Arg& arg = c.args[place.arg];
        if (arg.kind == Kind::in) {
            put(client, arg.type, place.element, number);
            return;
        }
        if (arg.kind == Kind::real || arg.kind == Kind::pvalue) {
            values[place.arg].number = number;
            return;
        }
        values[place.arg].integer = static_cast<std::int64_t>(number);
        // Client memory is smaller than such numbers ask for.
        if (std::fabs(number) > 64 && has_client_memory(c))
            for (std::size_t i = 0; i < c.args.size(); ++i)
                if (c.args[i].kind == Kind::in || c.args[i].kind == Kind::out)
                    values[i].pointer = nullptr;
    }

    /// Returns whether GL allows the error (GL 1.3, 2.5). Numbers out of range are INVALID_VALUE, and tokens
    /// given as numbers are INVALID_ENUM. A command that is illegal where it is called is INVALID_OPERATION.
    /// Attributes of vertices take all numbers.
    static bool allowed(const Command& c, Place place, std::size_t pname, Where where, double number,
                        GLenum code) {
        if (where == Where::between && !c.inside)
            return code == GL_INVALID_OPERATION;
        if (c.refuses != GL_NO_ERROR && code == c.refuses)
            return true;
        const Arg& arg = c.args[place.arg];
        const bool of_pname = arg.kind == Kind::pvalue || (arg.kind == Kind::in && !c.pnames.empty());
        if (of_pname) {
            const Pname& p = c.pnames[pname];
            return code == GL_NO_ERROR || (!p.present && code == GL_INVALID_OPERATION) ||
                   (p.code != GL_NO_ERROR && code == p.code) || (p.kind != 'c' && code == GL_INVALID_VALUE) ||
                   (p.kind == 'i' && code == GL_INVALID_ENUM);
        }
        if (arg.kind == Kind::real || arg.kind == Kind::in)
            return code == GL_NO_ERROR || (code == GL_INVALID_VALUE && !c.inside);
        const bool out_of_range = (arg.kind == Kind::sizei && number < 0) ||
                                  (arg.kind == Kind::int_ && (number < static_cast<double>(arg.low) ||
                                                              number > static_cast<double>(arg.high)));
        if (out_of_range)
            return code == GL_INVALID_VALUE;
        return code == GL_NO_ERROR || code == GL_INVALID_VALUE || code == GL_INVALID_OPERATION ||
               code == GL_OUT_OF_MEMORY || code == GL_STACK_OVERFLOW || code == GL_STACK_UNDERFLOW ||
               (code == GL_INVALID_ENUM && !arg.accepted.empty());
    }

    /// No query may return NaN or an infinity.
    void expect_finite_state(const std::string& call) {
        for (const gl::GroupedRows& part : gl::all_state())
            for (const gl::StateRow& row : part.rows) {
                const gl::Kind kind = gl::kind_of(row.source);
                if (row.left_out() || kind == gl::Kind::integer || row.source == gl::Source::pointer)
                    continue;
                for (GLenum i = 0; i < row.names; ++i) {
                    GLfloat values[gl::most_values] = {};
                    glGetFloatv(row.name + i, values);
                    for (const GLfloat value : values)
                        EXPECT_TRUE(std::isfinite(value))
                            << call << " leaves " << value << " in token " << row.name + i;
                }
            }
    }

    struct Tried {
        long calls = 0, errors = 0, pictures = 0;
        std::map<std::string, long> commands;
    };

    void try_one(const Command& c, std::size_t pname, Place place, Where where, double number, Tried& tried) {
        context->error_code = GL_NO_ERROR;
        auto values = sane(c, pname);
        set(c, place, values, client, number);
        const std::string text = std::string(c.name) + " argument " + std::to_string(place.arg) + "." +
                                 std::to_string(place.element) + " pname " + std::to_string(pname) + " = " +
                                 std::to_string(number) + " " + name_of(where);
        SCOPED_TRACE(text);
        if (where == Where::in_list)
            glNewList(5, GL_COMPILE_AND_EXECUTE);
        if (where == Where::between)
            glBegin(GL_TRIANGLES);
        context->error_code = GL_NO_ERROR;
        const auto before = snapshot();
        const GLenum code = call(c, values);
        const bool same = snapshot() == before;
        EXPECT_TRUE(allowed(c, place, pname, where, number, code)) << text << " raises " << std::hex << code;
        if (code != GL_NO_ERROR && where != Where::in_list) {
            EXPECT_TRUE(same) << text << " raises " << std::hex << code << " and changes state";
        }
        ++tried.calls;
        ++tried.commands[c.name];
        tried.errors += code != GL_NO_ERROR ? 1 : 0;
        if (where == Where::between) {
            for (int i = 0; i < 3; ++i)
                glVertex2i(i % 2, i / 2);
            if (context->inside_begin_end())
                glEnd();
        }
        if (where == Where::in_list) {
            if (context->inside_begin_end())
                glEnd();
            if (context->list.index != 0)
                glEndList();
            glCallList(5);
        }
        if (!same || where != Where::outside) {
            if (context->inside_begin_end())
                glEnd();
            if (context->list.index != 0)
                glEndList();
            expect_finite_state(text);
            draw_primitives();
        }
        sentences().clear();
    }

    void sweep(raster::Tier tier) {
        const bool all = whole();
        renew(tier);
        const auto reference = picture();
        ASSERT_GT(std::count_if(reference.begin(), reference.end(), [](std::uint8_t b) { return b != 0; }),
                  4000);
        EXPECT_EQ(picture(), reference) << "leave_everything() does not set the state back";
        Tried tried;
        unsigned turn = static_cast<unsigned>(tier);
        for (const Command& c : commands()) {
            if (!c.present)
                continue;
            renew(tier);
            for (std::size_t p = 0; p < std::max<std::size_t>(1, c.pnames.size()); ++p)
                for (const Place place : places(c, p)) {
                    const auto numbers = extremes_of(c.args[place.arg].type);
                    for (const Where where : {Where::outside, Where::between, Where::in_list}) {
                        if (!all && (where != Where::outside && turn % 4 != 0)) {
                            ++turn;
                            continue;
                        }
                        for (std::size_t n = all ? 0 : turn % numbers.size(); n < numbers.size();
                             n += all ? 1 : numbers.size()) {
                            try_one(c, p, place, where, numbers[n], tried);
                            if (HasFailure() && ++failures_ > 20)
                                return;
                            ++tried.pictures;
                            if (picture() != reference) {
                                ADD_FAILURE()
                                    << c.name << " argument " << place.arg << "." << place.element << " = "
                                    << numbers[n] << " " << name_of(where) << " changes a later picture";
                                renew(tier);
                            }
                        }
                        turn += 7;
                    }
                }
        }
        std::printf("%ld calls of %zu entry points, %ld errors, %ld pictures\n", tried.calls,
                    tried.commands.size(), tried.errors, tried.pictures);
        EXPECT_GT(tried.commands.size(), 200u);
        EXPECT_GT(tried.errors, 100);
    }

  private:
    std::vector<std::uint8_t> pixels_, depths_;
    int failures_ = 0;
};

TEST_F(ExtremeSweep, Exact) {
    sweep(raster::Tier::exact);
}
TEST_F(ExtremeSweep, Balanced) {
    sweep(raster::Tier::balanced);
}
TEST_F(ExtremeSweep, Fast) {
    sweep(raster::Tier::fast);
}

} // namespace
} // namespace spangle::test
