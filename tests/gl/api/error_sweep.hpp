// A context in which every entry point of the table is called, with arguments that it takes and with others.
#pragma once

#include <cstdio>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <spangle/message.hpp>

#include "gl/context/sentence.hpp"
#include "tests/gl/api/command_table.hpp"
#include "tests/gl/api/recording_context.hpp"

namespace spangle::test {

class ErrorSweep : public RecordingContext {
  protected:
    explicit ErrorSweep(const gl::Engine& engine = recording_engine)
        : RecordingContext(false, arena_bytes, engine) {}

    /// Returns arguments that are accepted together outside Begin and End.
    std::vector<Value> good(const Command& c) {
        std::size_t pname = 0;
        while (scalar_of_vector(c, pname))
            ++pname;
        return good(c, pname);
    }
    std::vector<Value> good(const Command& c, std::size_t pname) {
        std::vector<Value> values;
#if SPANGLE_FEATURE_BUFFERS
        const std::string row = c.row; // commands of buffers need a buffer that is not mapped
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
            context->list.index == 0) { // query 1 must have a result, and be active for EndQuery
            if (context->query.active == 0)
                glBeginQuery(GL_SAMPLES_PASSED, 1);
            if (std::strcmp(c.family, "EndQuery") != 0)
                glEndQuery(GL_SAMPLES_PASSED);
        }
#endif
        std::memset(client, 0, sizeof client);
        if (!c.pnames.empty()) { // changes the first value of the vector form
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

    /// Gives commands that change an image an image that they may change.
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

    /// Returns a good value as the entry point takes it: reals of fixed-point forms have 16 fraction bits.
    static std::int64_t good_value(const Command& c, std::size_t pname) {
        const bool fixed = c.pnames[pname].kind == 'r' && std::strstr(c.name, "OES") != nullptr;
        return c.pnames[pname].good * (fixed ? 65536 : 1);
    }

    GLenum call(const Command& c, const std::vector<Value>& values) {
        c.call(values.data());
        return std::exchange(context->error_code, GLenum{GL_NO_ERROR});
    }

    /// Checks the error of a call, and that the state equals its snapshot. An earlier error must be kept, and
    /// the sentence must name the command and the rule.
    void refused(const Command& c, const std::vector<Value>& values, GLenum code, const std::string& why) {
        const auto before = snapshot();
        sentences().clear();
        EXPECT_EQ(call(c, values), code) << c.name << ": " << why;
        EXPECT_EQ(before, snapshot()) << c.name << " changed state: " << why;
        explained(c, code, why);
    }

    struct Said {
        unsigned code;
        std::string text;
    };
    static std::vector<Said>& sentences() {
        static std::vector<Said> all;
        return all;
    }
    static inline int explained_ = 0;
    /// Checks that there is one sentence, "glCommand: what (section)".
    static void explained([[maybe_unused]] const Command& c, [[maybe_unused]] GLenum code,
                          [[maybe_unused]] const std::string& why) {
#if SPANGLE_MESSAGES
        ASSERT_EQ(sentences().size(), 1u) << c.name << ": " << why;
        const Said& said = sentences()[0];
        EXPECT_EQ(said.code, code) << said.text;
        EXPECT_EQ(said.text.find(std::string("gl") + c.family), 0u) << c.name << ": " << said.text;
        EXPECT_GT(said.text.size(), std::strlen(c.family) + 12) << said.text;
        EXPECT_LE(said.text.size(), gl::Sentence::most) << said.text;
        const bool has_section = said.text.find(" is a null pointer") == std::string::npos &&
                                 said.text.find(": this build has no ") == std::string::npos;
        EXPECT_TRUE(!has_section || said.text.ends_with(")")) << "cut: " << said.text;
        for (const char* vague : {"a token is none", "a number is out", "the state does not allow it"})
            EXPECT_EQ(said.text.find(vague), std::string::npos) << why << ": " << said.text;
        ++explained_;
#endif
    }
    void SetUp() override {
        RecordingContext::SetUp();
        explained_ = 0;
        on_message([](unsigned code, const char* text) { sentences().push_back({code, text}); });
    }
    void TearDown() override {
        on_message(nullptr);
        if (explained_ != 0)
            std::printf("%d errors, each with its sentence\n", explained_);
        RecordingContext::TearDown();
    }

    bool scalar_of_vector(const Command& c, std::size_t pname) {
        for (const Arg& arg : c.args)
            if (arg.kind == Kind::pvalue && c.pnames[pname].count > 1)
                return true;
        return false;
    }

    alignas(8) unsigned char client[4096];
};

} // namespace spangle::test
