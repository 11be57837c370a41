// Tests for every entry point of the table what it must refuse, and that a refusal changes nothing (GL 1.3,
// 2.5).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>

#include "gl/context/state_table.hpp"
#include "tests/gl/api/error_sweep.hpp"

namespace spangle::test {
namespace {

TEST_F(ErrorSweep, TheTableIsWhole) {
    EXPECT_GT(commands().size(), 250u);
    for (const Command& c : commands())
        EXPECT_EQ(std::string(c.name).substr(0, 2 + std::strlen(c.family)), std::string("gl") + c.family);
}

TEST_F(ErrorSweep, GoodArgumentsAreAccepted) {
    for (const Command& c : commands()) {
        if (!c.present || !std::strcmp(c.family, "End") || !std::strcmp(c.family, "EndList") ||
            !std::strcmp(c.family, "PopMatrix") || !std::strcmp(c.family, "NewList"))
            continue;
        for (std::size_t p = 0; p < std::max<std::size_t>(1, c.pnames.size()); ++p) {
            const bool present = c.pnames.empty() || c.pnames[p].present;
            const GLenum expected = scalar_of_vector(c, p)         ? GL_INVALID_ENUM
                                    : present && !c.pnames.empty() ? c.pnames[p].code
                                    : present                      ? c.refuses
                                                                   : GL_INVALID_OPERATION;
            EXPECT_EQ(call(c, good(c, p)), expected) << c.name << " pname " << p;
            if (context->inside_begin_end())
                glEnd();
        }
        if (!std::strcmp(c.family, "PushMatrix"))
            glPopMatrix();
    }
}

TEST_F(ErrorSweep, AbsentFeaturesSayWhatIsMissing) {
    for (const Command& c : commands()) {
        if (c.present)
            continue;
        refused(c, good(c), GL_INVALID_OPERATION, "its feature is not in this build");
        const std::string said = sentences().empty() ? "" : sentences()[0].text;
        EXPECT_NE(said.find("SPANGLE_FEATURE_"), std::string::npos) << c.name;
        EXPECT_EQ(said.find(c.name), 0u);
    }
}

TEST_F(ErrorSweep, BeginEndLegality) {
    for (const Command& c : commands()) {
        if (!c.present || !std::strcmp(c.family, "End"))
            continue;
        glBegin(GL_TRIANGLES);
        const auto values = good(c);
        if (c.inside) {
            EXPECT_NE(call(c, values), GLenum{GL_INVALID_OPERATION}) << c.name;
        } else {
            refused(c, values, GL_INVALID_OPERATION, "between glBegin and glEnd");
        }
        ASSERT_TRUE(context->inside_begin_end()) << c.name;
        glEnd();
        context->error_code = GL_NO_ERROR;
    }
}

TEST_F(ErrorSweep, ReturnValuesAreZeroInside) {
    glBegin(GL_POINTS);
    EXPECT_EQ(glGetError(), 0u);
    EXPECT_EQ(glIsEnabled(GL_DITHER), GL_FALSE);
    EXPECT_EQ(glGetString(GL_VENDOR), nullptr);
    EXPECT_EQ(glIsTexture(1), GL_FALSE);
    EXPECT_EQ(glGenLists(1), 0u);
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
}

TEST_F(ErrorSweep, UnknownEnums) {
    for (const Command& c : commands())
        for (std::size_t i = 0; c.present && i < c.args.size(); ++i) {
            const Arg& arg = c.args[i];
            if (arg.kind == Kind::pname || (arg.kind == Kind::enum_ && !arg.accepted.empty()))
                for (GLenum wrong : {0xDEADu, 0xFFFFFFFFu, 0x80000000u, 0x4008u, 0x1799u}) {
                    auto values = good(c);
                    values[i].integer = wrong;
                    refused(c, values, GL_INVALID_ENUM, "argument " + std::to_string(i));
                }
        }
}

/// A token of any command is wrong in every argument that does not accept it.
TEST_F(ErrorSweep, TokensOfOtherCommands) {
    std::set<GLenum> tokens;
    for (const Command& c : commands()) {
        for (const Arg& arg : c.args)
            tokens.insert(arg.accepted.begin(), arg.accepted.end());
        for (const Pname& pname : c.pnames)
            tokens.insert(pname.name);
    }
    EXPECT_GT(tokens.size(), 250u);
    // The table of state says which tokens these commands accept.
    const std::set<std::string> queries = {"GetBooleanv", "GetIntegerv",  "GetFloatv",
                                           "GetDoublev",  "GetFixedvOES", "GetPointerv"};
    const auto is_value = [&queries](const std::string& family, GLenum token) {
        const gl::StateRow* const row = gl::find_state(token);
        return queries.contains(family) && row != nullptr &&
               (row->source == gl::Source::pointer) == (family == "GetPointerv");
    };
    for (const Command& c : commands())
        for (std::size_t i = 0; c.present && i < c.args.size(); ++i) {
            const Arg& arg = c.args[i];
            const bool is_pname = arg.kind == Kind::pname;
            if (!is_pname && (arg.kind != Kind::enum_ || arg.accepted.empty()))
                continue;
            for (const GLenum token : tokens) {
                const bool known =
                    is_value(c.family, token) ||
                    (is_pname
                         ? std::any_of(c.pnames.begin(), c.pnames.end(),
                                       [token](const Pname& p) { return p.name == token; })
                         : std::find(arg.accepted.begin(), arg.accepted.end(), token) != arg.accepted.end());
                if (known)
                    continue;
                auto values = good(c);
                values[i].integer = token;
                refused(c, values, GL_INVALID_ENUM,
                        "argument " + std::to_string(i) + " is token " + std::to_string(token));
            }
        }
}

/// Every Push has its Pop. Both raise an error if the stack is full or empty, and then change nothing (GL
/// 1.3, 2.5).
TEST_F(ErrorSweep, StacksThatAreFullOrEmpty) {
    const auto find = [](const std::string& name) {
        const auto all = commands();
        return std::find_if(all.begin(), all.end(), [&name](const Command& c) { return c.name == name; });
    };
    GLuint words[4];
    glSelectBuffer(4, words);
    glRenderMode(GL_SELECT); // names have a meaning in this mode
    context->error_code = GL_NO_ERROR;
    int stacks = 0;
    for (const Command& push : commands()) {
        const std::string name = push.name;
        if (!push.present || name.substr(0, 6) != "glPush")
            continue;
        const auto pop = find("glPop" + name.substr(6));
        ASSERT_NE(pop, commands().end()) << name;
        for (const GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
            glMatrixMode(mode);
            refused(*pop, good(*pop), GL_STACK_UNDERFLOW, "empty");
            int depth = 0;
            while (call(push, good(push)) == GL_NO_ERROR)
                ASSERT_LT(++depth, 1000);
            refused(push, good(push), GL_STACK_OVERFLOW, "full");
            for (; depth > 0; --depth)
                EXPECT_EQ(call(*pop, good(*pop)), GLenum{GL_NO_ERROR}) << pop->name;
            refused(*pop, good(*pop), GL_STACK_UNDERFLOW, "empty again");
        }
        ++stacks;
    }
    EXPECT_EQ(stacks, 1 + 2 * SPANGLE_FEATURE_ATTRIB_STACKS + SPANGLE_FEATURE_SELECTION);
    glRenderMode(GL_RENDER);
    context->error_code = GL_NO_ERROR;
}

TEST_F(ErrorSweep, EveryAcceptedTokenIsAccepted) {
    for (const Command& c : commands())
        for (std::size_t i = 0; c.present && i < c.args.size(); ++i)
            for (GLenum token :
                 c.args[i].kind == Kind::enum_ ? c.args[i].accepted : std::span<const GLenum>{}) {
                const auto of_target = std::find_if(c.pnames.begin(), c.pnames.end(), [&](const Pname& p) {
                    return i == 0 && p.target == token;
                });
                auto values = of_target == c.pnames.end()
                                  ? good(c)
                                  : good(c, static_cast<std::size_t>(of_target - c.pnames.begin()));
                values[i].integer = token;
                EXPECT_NE(call(c, values), GLenum{GL_INVALID_ENUM}) << c.name << " " << std::hex << token;
                if (context->inside_begin_end())
                    glEnd();
                if (context->list.index != 0)
                    glEndList();
                glRenderMode(GL_RENDER);
                context->error_code = GL_NO_ERROR;
            }
}

TEST_F(ErrorSweep, NegativeSizesAndValuesOutOfRange) {
    for (const Command& c : commands())
        for (std::size_t i = 0; c.present && i < c.args.size(); ++i) {
            const Arg& arg = c.args[i];
            for (std::int64_t wrong :
                 {std::int64_t{INT32_MIN}, std::int64_t{-1}, arg.low - 1, arg.high + 1}) {
                if (wrong > INT32_MAX || wrong < INT32_MIN ||
                    (arg.kind != Kind::sizei && (wrong >= arg.low && wrong <= arg.high)))
                    continue;
                if ((arg.kind != Kind::sizei || wrong >= 0) && arg.kind != Kind::int_)
                    continue;
                auto values = good(c);
                values[i].integer = wrong;
                refused(c, values, c.refuses != 0 ? c.refuses : GLenum{GL_INVALID_VALUE},
                        "argument " + std::to_string(i) + " = " + std::to_string(wrong));
            }
        }
}

TEST_F(ErrorSweep, NullPointersDoNoHarm) {
    for (const Command& c : commands())
        for (std::size_t i = 0; c.present && i < c.args.size(); ++i) {
            if (c.args[i].kind != Kind::in && c.args[i].kind != Kind::out)
                continue;
            auto values = good(c);
            values[i].pointer = nullptr;
            const auto before = snapshot();
            sentences().clear();
            const GLenum code = call(c, values);
            if (code != GL_NO_ERROR)
                explained(c, code, "null pointer");
            EXPECT_TRUE(code == GL_INVALID_VALUE || code == GL_NO_ERROR || (code != 0 && code == c.refuses))
                << c.name << ' ' << code;
            if (code != GL_NO_ERROR) {
                EXPECT_EQ(snapshot(), before) << c.name;
            }
        }
}

TEST_F(ErrorSweep, ExtremeNumbersDoNoHarm) {
    for (const Command& c : commands()) {
        if (!c.present || !std::strcmp(c.family, "NewList"))
            continue;
        for (double extreme : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300, -1e300, 3.5e38, 1e-320, -0.0}) {
            auto values = good(c);
            bool any = false;
            for (std::size_t i = 0; i < c.args.size(); ++i) {
                // Only float and double entry points can get these numbers; the compiler converts them for
                // integer types.
                const bool number = c.args[i].kind == Kind::real || c.args[i].kind == Kind::pvalue;
                const std::string name = c.name;
                if (number && (name.back() == 'f' || name.back() == 'd')) {
                    values[i].number = extreme;
                    any = true;
                }
            }
            if (any)
                call(c, values);
        }
    }
}

/// Numbers have ranges, too (GL 1.3, 3.3, 3.4 and 3.10).
TEST_F(ErrorSweep, NumbersOutOfRange) {
    const std::pair<void (*)(), GLenum> calls[] = {
        {[] { glPointSize(0); }, GL_INVALID_VALUE},
        {[] { glPointSize(-1); }, GL_INVALID_VALUE},
        {[] { glPointSize(1e-30f); }, GL_NO_ERROR},
        {[] { glLineWidth(0); }, GL_INVALID_VALUE},
        {[] { glLineWidth(-0.0f); }, GL_INVALID_VALUE},
        {[] { glLineWidth(1e-30f); }, GL_NO_ERROR},
#if SPANGLE_FEATURE_FOG
        {[] { glFogf(GL_FOG_DENSITY, -1e-30f); }, GL_INVALID_VALUE},
        {[] { glFogf(GL_FOG_DENSITY, 0); }, GL_NO_ERROR},
#endif
    };
    int n = 0;
    for (const auto& [call, code] : calls) {
        call();
        EXPECT_EQ(glGetError(), code) << n;
        ++n;
    }
}

TEST_F(ErrorSweep, ClearRefusesUnknownBits) {
    for (int bit = 0; bit < 32; ++bit) {
        const GLbitfield mask = 1u << bit;
        glClear(mask);
        const bool known = (mask & (GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT |
                                    GL_ACCUM_BUFFER_BIT)) != 0;
        EXPECT_EQ(glGetError(), known ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_VALUE}) << bit;
    }
}

TEST_F(ErrorSweep, TheFirstErrorIsKept) {
    glEnable(0xDEAD);
    glViewport(0, 0, -1, 1);
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
}

TEST_F(ErrorSweep, WithoutAContextNothingHappens) {
    gl::set_current_context(nullptr);
    for (const Command& c : commands())
        c.call(good(c).data());
    gl::set_current_context(context);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

} // namespace
} // namespace spangle::test
