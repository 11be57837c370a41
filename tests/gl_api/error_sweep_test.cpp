// Every entry point of the table: what it must refuse, and that a refusal changes nothing (GL 1.3, 2.5).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>

#include <spangle/message.hpp>

#include "gl/context/state_table.hpp"
#include "tests/gl_api/command_table.hpp"
#include "tests/gl_api/recording_context.hpp"

namespace spangle::test {
namespace {

class ErrorSweep : public RecordingContext {
  protected:
    ErrorSweep() : RecordingContext(false) {}

    /// Arguments that are accepted together outside Begin and End.
    std::vector<Value> good(const Command& c) {
        std::size_t pname = 0;
        while (scalar_of_vector(c, pname))
            ++pname;
        return good(c, pname);
    }
    std::vector<Value> good(const Command& c, std::size_t pname) {
        std::vector<Value> values;
#if SPANGLE_FEATURE_BUFFERS
        const std::string row = c.row; // what asks for a buffer has one that is not mapped
        const bool buffer = (row == "B21" || row == "B22") && gl::current_context() != nullptr;
        for (const GLenum target : {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER})
            gl::cmd::BindBuffer(*context, target, 0);
        if (buffer && !context->inside_begin_end() && context->list.index == 0) {
            for (const GLenum target : {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER}) {
                glBindBuffer(target, 1);
                glBufferData(target, 4, nullptr, GL_STATIC_DRAW);
                if (!std::strcmp(c.family, "UnmapBuffer") || !std::strcmp(c.family, "FlushMappedBufferRange"))
                    glMapBufferRange(target, 0, 1, GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT);
            }
        }
#endif
        images(c);
#if SPANGLE_FEATURE_QUERIES
        if (std::strcmp(c.row, "P11") == 0 && gl::current_context() != nullptr &&
            !context->inside_begin_end() &&
            context->list.index == 0) { // query 1 has a result; EndQuery finds it active
            if (context->query.active == 0)
                glBeginQuery(GL_SAMPLES_PASSED, 1);
            if (std::strcmp(c.family, "EndQuery") != 0)
                glEndQuery(GL_SAMPLES_PASSED);
        }
#endif
        std::memset(client, 0, sizeof client);
        if (!c.pnames.empty()) { // the vector form's first value
            const auto value = static_cast<GLint>(good_value(c, pname));
            const auto number = static_cast<GLfloat>(value);
            const GLdouble wide = number;
            if (std::strstr(c.name, "dv") != nullptr)
                std::memcpy(client, &wide, sizeof wide);
            else if (std::strstr(c.name, "fv") != nullptr)
                std::memcpy(client, &number, sizeof number);
            else
                std::memcpy(client, &value, sizeof value);
        }
        for (const Arg& arg : c.args) {
            Value v{};
            switch (arg.kind) {
            case Kind::in:
            case Kind::out:
                v.pointer = client;
                break;
            case Kind::real:
                v.number = static_cast<double>(arg.good);
                break;
            case Kind::enum_:
                v.integer = arg.good;
                if (&arg == c.args.data() && !c.pnames.empty() && c.pnames[pname].target != 0)
                    v.integer = c.pnames[pname].target;
                break;
            case Kind::pname:
                v.integer = c.pnames[pname].name;
                break;
            case Kind::pvalue:
                v.number = static_cast<double>(good_value(c, pname));
                break;
            default:
                v.integer = arg.good;
            }
            values.push_back(v);
        }
        return values;
    }

    /// What changes an image finds one that it may change.
    void images([[maybe_unused]] const Command& c) {
        if (gl::current_context() == nullptr || context->inside_begin_end() || context->list.index != 0)
            return;
#if SPANGLE_FEATURE_COMPRESSED_TEXTURES
        if (!std::strcmp(c.family, "CompressedTexSubImage2D") ||
            !std::strcmp(c.family, "GetCompressedTexImage"))
            glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_ETC1_RGB8_OES, 0, 0, 0, 0, client);
        if (!std::strcmp(c.family, "GetTexImage"))
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, client);
#endif
#if SPANGLE_FEATURE_TEXTURE_3D
        if (!std::strcmp(c.family, "CopyTexSubImage3D"))
            glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, client);
#endif
    }

    /// As the entry point takes it: reals of the fixed-point forms have 16 fraction bits.
    static std::int64_t good_value(const Command& c, std::size_t pname) {
        const bool fixed = c.pnames[pname].kind == 'r' && std::strstr(c.name, "OES") != nullptr;
        return c.pnames[pname].good * (fixed ? 65536 : 1);
    }

    GLenum call(const Command& c, const std::vector<Value>& values) {
        c.call(values.data());
        return std::exchange(context->error_code, GLenum{GL_NO_ERROR});
    }

    /// What a call raises, held against a snapshot of the state; also that an earlier error is kept.
    void refused(const Command& c, const std::vector<Value>& values, GLenum code, const std::string& why) {
        const auto before = snapshot();
        EXPECT_EQ(call(c, values), code) << c.name << ": " << why;
        EXPECT_EQ(before, snapshot()) << c.name << " changed state: " << why;
    }

    bool scalar_of_vector(const Command& c, std::size_t pname) {
        for (const Arg& arg : c.args)
            if (arg.kind == Kind::pvalue && c.pnames[pname].count > 1)
                return true;
        return false;
    }

    alignas(8) unsigned char client[4096];
};

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
    static std::string said;
    on_message([](unsigned, const char* text) { said = text; });
    for (const Command& c : commands()) {
        if (c.present)
            continue;
        said.clear();
        refused(c, good(c), GL_INVALID_OPERATION, "its feature is not in this build");
        EXPECT_NE(said.find("SPANGLE_FEATURE_"), std::string::npos) << c.name;
        EXPECT_EQ(said.find(c.name), 0u);
    }
    on_message(nullptr);
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

/// Every token of every command is a wrong one wherever it is not among the accepted.
TEST_F(ErrorSweep, TokensOfOtherCommands) {
    std::set<GLenum> tokens;
    for (const Command& c : commands()) {
        for (const Arg& arg : c.args)
            tokens.insert(arg.accepted.begin(), arg.accepted.end());
        for (const Pname& pname : c.pnames)
            tokens.insert(pname.name);
    }
    EXPECT_GT(tokens.size(), 250u);
    // What these accept stands in the table of state.
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

/// Every Push has its Pop; both say when they cannot, and change nothing then (GL 1.3, 2.5).
TEST_F(ErrorSweep, StacksThatAreFullOrEmpty) {
    const auto find = [](const std::string& name) {
        const auto all = commands();
        return std::find_if(all.begin(), all.end(), [&name](const Command& c) { return c.name == name; });
    };
    GLuint words[4];
    glSelectBuffer(4, words);
    glRenderMode(GL_SELECT); // where names have a meaning
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
            const GLenum code = call(c, values);
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
                // Only float and double entry points can be given these; a conversion to an integer type is
                // not ours.
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

/// GL 1.3, 3.3, 3.4 and 3.10: numbers have ranges, too.
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
