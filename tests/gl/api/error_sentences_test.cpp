// Every error is reported in one sentence, which names the command, the argument and the rule
// (spangle/message.hpp).
#include <algorithm>
#include <set>
#include <string_view>

#include "tests/gl/api/error_sweep.hpp"
#include "tests/support/random.hpp"

namespace spangle::test {
namespace {

constexpr bool whole = sizeof SPANGLE_LEFT_OUT == 1; // whether this build has all optional systems

class ErrorSentences : public ErrorSweep {
  protected:
    ErrorSentences() {
        std::set<GLenum> all = {0, 0xDEAD, 0xFFFFFFFF};
        for (const Command& c : commands()) {
            for (const Arg& arg : c.args)
                all.insert(arg.accepted.begin(), arg.accepted.end());
            for (const Pname& pname : c.pnames)
                all.insert(pname.name);
        }
        tokens_.assign(all.begin(), all.end());
    }

    static std::string said() { return sentences().empty() ? "" : sentences().back().text; }

    /// Returns the sentence of one call, and clears the error.
    std::string sentence(void (*call)()) {
        sentences().clear();
        call();
        EXPECT_EQ(sentences().size(), glGetError() != GL_NO_ERROR ? 1u : 0u) << said();
        return said();
    }

    /// Returns good arguments, some of them replaced by values that few commands take. Client memory is never
    /// too small for them, and meshes have few points.
    std::vector<Value> hostile(const Command& c) {
        const std::size_t shapes = std::max<std::size_t>(1, c.pnames.size());
        std::vector<Value> values = good(c, random_.below(static_cast<std::uint32_t>(shapes)));
        bool reads = false;
        for (const Arg& arg : c.args)
            reads = reads || arg.kind == Kind::in || arg.kind == Kind::out;
        for (std::size_t i = 0; i < c.args.size(); ++i)
            if (random_.below(3) == 0)
                spoil(c, c.args[i], reads, values[i]);
        return values;
    }

    /// Restores the state from which good() starts, also after calls that succeeded.
    void restore() {
        if (context->inside_begin_end())
            glEnd();
#if SPANGLE_FEATURE_LISTS
        if (context->list.index != 0)
            glEndList();
#endif
        glRenderMode(GL_RENDER);
        for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
            glDisableClientState(array);
        context->pixel_store = gl::PixelStoreState{};
        context->error_code = GL_NO_ERROR;
        sentences().clear();
    }

    /// Checks the sentence of a call, or that there is none if the call raises no error. The sentence names
    /// the command `of`.
    void check(const Command& c, const std::vector<unsigned char>& before, const char* where) {
        const GLenum code = std::exchange(context->error_code, GLenum{GL_NO_ERROR});
        if (code != GL_NO_ERROR) {
            explained(c, code, where);
            EXPECT_EQ(before, snapshot()) << c.name << " changed state: " << said();
        } else {
            EXPECT_EQ(sentences().size(), 0u) << c.name << ' ' << where << ": " << said();
        }
    }

    static constexpr int rounds = 24;
    Random random_{11};

  private:
    std::vector<GLenum> tokens_;

    template <class T, std::size_t count> T one_of(const T (&values)[count]) {
        return values[random_.below(count)];
    }

    /// In C++ it is undefined to convert a number to an integer type that does not hold it. So a command of
    /// an integer type gets the nearest number that the type holds.
    static double representable(const Command& c, double number) {
        std::string_view name = c.name;
        name.remove_suffix(name.ends_with("OES") ? 3 : 0);
        double range = 0;
        switch (name.back()) {
        case 'b':
            range = 128;
            break;
        case 's':
            range = 32768;
            break;
        case 'i':
        case 'x':
            range = 2147483648.0;
            break;
        default:
            return number;
        }
        return std::clamp(number, name[name.size() - 2] == 'u' ? 0 : -range, range - 1);
    }

    void spoil(const Command& c, const Arg& arg, bool reads, Value& value) {
        static constexpr std::int64_t small[] = {INT32_MIN, -1, 0, 1, 2, 3, 5, 9},
                                      any[] = {INT32_MIN, -1, 0, 1, 2, 31, 4096, INT32_MAX},
                                      sizes[] = {INT32_MIN, -7, -1, 0, 1, 2};
        static constexpr double numbers[] = {-1e30, -1, -0.25, 0, 0.5, 1, 3, 91, 200};
        switch (arg.kind) {
        case Kind::in:
        case Kind::out:
            value.pointer = nullptr;
            return;
        case Kind::real:
            value.number = representable(c, one_of(numbers));
            return;
        case Kind::pvalue:
            value.number =
                random_.below(2) == 0
                    ? representable(c, one_of(numbers))
                    : static_cast<double>(tokens_[random_.below(static_cast<std::uint32_t>(tokens_.size()))] &
                                          0xFFFF);
            return;
        case Kind::enum_:
        case Kind::pname:
            if (arg.kind == Kind::enum_ && !arg.accepted.empty() && random_.below(2) == 0)
                value.integer = arg.accepted[random_.below(static_cast<std::uint32_t>(arg.accepted.size()))];
            else
                value.integer = tokens_[random_.below(static_cast<std::uint32_t>(tokens_.size()))];
            return;
        case Kind::sizei:
            value.integer = one_of(sizes);
            return;
        case Kind::bitfield:
            value.integer = random_.below(2) == 0 ? 0xFFFFFFFF : std::int64_t{1} << random_.below(32);
            return;
        default:
            value.integer = std::strncmp(c.family, "EvalMesh", 8) == 0 ? random_.below(4)
                            : reads                                    ? one_of(small)
                                                                       : one_of(any);
        }
    }
};

TEST_F(ErrorSentences, HostileArguments) {
    int present = 0;
    for (const Command& c : commands()) {
        present += c.present ? 1 : 0;
        for (int round = 0; c.present && round < rounds; ++round) {
            const std::vector<Value> values = hostile(c);
            if (!c.inside && round % 4 == 0)
                glBegin(GL_POINTS);
            context->error_code = GL_NO_ERROR;
            sentences().clear();
            const auto before = snapshot();
            c.call(values.data());
            check(c, before, "outside of lists");
            restore();
        }
    }
    EXPECT_GT(explained_, whole ? 3000 : 6 * present);
}

#if SPANGLE_FEATURE_LISTS
/// A recorded command raises its errors when the list is played, with the same sentence.
TEST_F(ErrorSentences, HostileArgumentsInLists) {
    for (const Command& c : commands())
        for (int round = 0; c.present && c.listing != Listing::never && round < rounds; ++round) {
            const std::vector<Value> values = hostile(c);
            glNewList(1, GL_COMPILE);
            context->error_code = GL_NO_ERROR;
            sentences().clear();
            auto before = snapshot();
            c.call(values.data());
            check(c, before, "while a list is compiled");
            glEndList();
            sentences().clear();
            before = snapshot();
            glCallList(1);
            check(c, before, "in a list");
            restore();
        }
    EXPECT_GT(explained_, 1500);
}

TEST_F(ErrorSentences, ListsSayWhatWasCompiled) {
    const char* const wrong = "glDrawArrays: mode 0xDEAD is not a primitive (GL 1.3, 2.8)";
    EXPECT_EQ(sentence([] { glDrawArrays(0xDEAD, 0, 1); }), wrong);
    EXPECT_EQ(sentence([] {
                  glNewList(1, GL_COMPILE);
                  glDrawArrays(0xDEAD, 0, 1);
                  glEndList();
                  glCallList(1);
              }),
              wrong);
    EXPECT_EQ(sentence([] {
                  glNewList(1, GL_COMPILE);
                  glViewport(0, 0, -3, 1);
                  glEndList();
                  glCallList(1);
              }),
              "glViewport: width -3 is negative (GL 1.3, 2.10.1)");
}
#endif

TEST_F(ErrorSentences, NameArgumentAndRule) {
    EXPECT_EQ(sentence([] { glBlendFunc(GL_ONE, 0xDEAD); }),
              "glBlendFunc: dfactor 0xDEAD is not a blend factor (GL 1.3, 4.1.7)");
    EXPECT_EQ(sentence([] { glTexCoordPointer(5, GL_FLOAT, 0, nullptr); }),
              "glTexCoordPointer: size 5 is not between 1 and 4 (GL 1.3, 2.8)");
    EXPECT_EQ(sentence([] { glVertex3fv(nullptr); }), "glVertex3fv: v is a null pointer");
    EXPECT_EQ(sentence([] { glEnd(); }), "glEnd: no glBegin came before (GL 1.3, 2.6.1)");
    EXPECT_EQ(sentence([] {
                  glBegin(GL_LINES);
                  glFlush();
                  glEnd();
              }),
              "glFlush: not between glBegin and glEnd (GL 1.3, 5.5)");
#if SPANGLE_FEATURE_FOG
    EXPECT_EQ(sentence([] { glFogf(GL_FOG_DENSITY, -1); }),
              "glFog: the value is out of the range of GL_FOG_DENSITY (GL 1.3, 3.10)");
    EXPECT_EQ(sentence([] { glFogf(GL_FOG_MODE, 3); }),
              "glFog: the value is none that GL_FOG_MODE takes (GL 1.3, 3.10)");
    EXPECT_EQ(sentence([] { glFogf(GL_LIGHT0, 3); }),
              "glFog: pname 0x4000 is not a parameter of this command (GL 1.3, 3.10)");
#endif
    EXPECT_EQ(sentence([] { glPopMatrix(); }), "glPopMatrix: the stack has nothing to pop (GL 1.3, 2.10)");
    EXPECT_EQ(sentence([] {
                  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, -1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
              }),
              "glTexImage2D: width -1 is negative (GL 1.3, 3.8.1)");
}

#if SPANGLE_FEATURE_BUFFERS
TEST_F(ErrorSentences, FlushedRangesTellWhichNumberIsNegative) {
    const GLubyte byte = 0;
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, 1, &byte, GL_STATIC_DRAW);
    EXPECT_EQ(sentence([] { glFlushMappedBufferRange(GL_ARRAY_BUFFER, -1, 1); }),
              "glFlushMappedBufferRange: offset is negative (GL 1.5, 2.9)");
    EXPECT_EQ(sentence([] { glFlushMappedBufferRange(GL_ARRAY_BUFFER, 0, -2); }),
              "glFlushMappedBufferRange: length -2 is negative (GL 1.5, 2.9)");
    EXPECT_EQ(sentence([] { glFlushMappedBufferRange(GL_ARRAY_BUFFER, -1, -2); }),
              "glFlushMappedBufferRange: length -2 is negative (GL 1.5, 2.9)");
}

/// A size of two gigabytes is too large for a signed word of 32 bits, but it is not negative.
TEST_F(ErrorSentences, SizesOfTwoGigabytesAreNotCalledNegative) {
    if constexpr (sizeof(GLsizeiptr) > 4) {
        const GLubyte byte = 0;
        glBindBuffer(GL_ARRAY_BUFFER, 1);
        glBufferData(GL_ARRAY_BUFFER, 1, &byte, GL_STATIC_DRAW);
        const std::string text =
            sentence([] { glBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr{1} << 31, nullptr); });
        EXPECT_FALSE(text.empty());
        EXPECT_EQ(text.find("negative"), std::string::npos) << text;
    }
}
#endif

#if SPANGLE_FEATURE_COMPRESSED_TEXTURES
TEST_F(ErrorSentences, TheLongestIsWhole) {
    const std::string text =
        sentence([] { glCompressedTexImage2D(GL_TEXTURE_2D, 0, 0xFFFFFFFF, 8, 8, 0, 8, nullptr); });
    EXPECT_TRUE(text.ends_with(" or GL_PALETTE8_RGB5_A1_OES (GL 1.3, 3.8.3)")) << text;
}
#endif

TEST_F(ErrorSentences, ImagesTellWhichSideAndValue) {
    EXPECT_EQ(
        sentence([] {
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 100000, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        }),
        "glTexImage2D: height 100000 is above the largest of this level (SPANGLE_TEXTURE_LEVELS), or no "
        "more than its border (GL 1.3, 3.8.1)");
    EXPECT_EQ(sentence([] {
                  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 100000, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
              }),
              "glTexImage2D: width 100000 is above the largest of this level (SPANGLE_TEXTURE_LEVELS), or no "
              "more than its border (GL 1.3, 3.8.1)");
    EXPECT_EQ(
        sentence([] { glTexImage2D(GL_TEXTURE_2D, 0, 0xDEAD, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); }),
        "glTexImage2D: internalformat 0xDEAD is not an internal format, or one that this build leaves "
        "out (SPANGLE_TEXTURE_FORMATS) (GL 1.3, 3.8.1)");
#if SPANGLE_FEATURE_TEXTURE_CUBE_MAP
    EXPECT_EQ(sentence([] {
                  glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                               nullptr);
              }),
              "glTexImage2D: height 4 is not the width, as a cube's is (GL 1.3, 3.8.1)");
#endif
#if SPANGLE_FEATURE_COPY_TEXTURE
    EXPECT_EQ(sentence([] { glCopyTexImage2D(GL_TEXTURE_2D, 0, 3, 0, 0, 8, 8, 0); }),
              "glCopyTexImage2D: internalformat 0x0003 is not an internal format that is copied to (GL 1.3, "
              "3.8.2)");
#endif
}

/// Profiles lower limits. A program that needs more learns which setting to change.
TEST_F(ErrorSentences, LimitsAreNamedByTheirOptions) {
    const struct {
        GLenum mode, most;
        const char* option;
    } stacks[] = {{GL_PROJECTION, GL_MAX_PROJECTION_STACK_DEPTH, "SPANGLE_PROJECTION_STACK"},
                  {GL_TEXTURE, GL_MAX_TEXTURE_STACK_DEPTH, "SPANGLE_TEXTURE_STACK"},
                  {GL_MODELVIEW, GL_MAX_MODELVIEW_STACK_DEPTH, "SPANGLE_MODELVIEW_STACK"}};
    for (const auto& stack : stacks) {
        GLint entries = 0;
        glGetIntegerv(stack.most, &entries);
        glMatrixMode(stack.mode);
        for (GLint i = 1; i < entries; ++i)
            glPushMatrix();
        EXPECT_EQ(sentence([] { glPushMatrix(); }),
                  "glPushMatrix: the stack is full (" + std::string(stack.option) + ") (GL 1.3, 2.10)");
    }
    EXPECT_EQ(sentence([] {
                  glTexImage2D(GL_TEXTURE_2D, 20, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
              }),
              "glTexImage2D: level 20 is above the smallest image of the largest texture "
              "(SPANGLE_TEXTURE_LEVELS) (GL 1.3, 3.8.1)");
}

/// Drawing raises errors without a sentence, so that vertices cost nothing more. The next other command
/// reports them.
TEST_F(ErrorSentences, DrawingIsToldByTheNextCommand) {
    const auto raise = [this] { gl::drawing_error(*context, GL_OUT_OF_MEMORY, "no room"); };
    glBegin(GL_TRIANGLES);
    sentences().clear();
    raise();
    glVertex2f(0, 0);
    glMultiTexCoord2f(GL_TEXTURE0, 0, 0);
    ASSERT_EQ(sentences().size(), 1u);
    EXPECT_EQ(said(), "glVertex: no room (GL 1.3, 2.7)");
    raise();
    glEnd();
    ASSERT_EQ(sentences().size(), 2u);
    EXPECT_EQ(said(), "glEnd: no room (GL 1.3, 2.6.1)");
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
}

/// GL keeps the first error code until it is read, but each error has its sentence.
TEST_F(ErrorSentences, LaterErrorsAreExplainedToo) {
    sentences().clear();
    glEnable(0xDEAD);
    glViewport(0, 0, -1, 1);
    ASSERT_EQ(sentences().size(), 2u);
    EXPECT_EQ(sentences()[0].code, unsigned{GL_INVALID_ENUM});
    EXPECT_EQ(sentences()[1].code, unsigned{GL_INVALID_VALUE});
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
}

} // namespace
} // namespace spangle::test
