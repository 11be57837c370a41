// Runs other programs to their end with given streams, and tests the names of precisions and formats.
#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <set>
#include <string>

#include "host_sim/capture/names.hpp"
#include "host_sim/process/process.hpp"

namespace spangle::process {
namespace {

TEST(Process, GivesTheStatusOfTheProgram) {
    EXPECT_EQ(run({"sh", "-c", "exit 41"}).status, 41);
    EXPECT_EQ(run({"sh", "-c", "exit 41"}).error, 0);
    EXPECT_EQ(run({"sh", "-c", "kill -TERM $$"}).status, of_signals + SIGTERM);
}

/// A program that ends with the status of a shell did run; a missing program did not.
TEST(Process, TellsMissingProgramsFromThoseThatEndSo) {
    const ExitStatus ran = run({"sh", "-c", "exit 127"}), missing = run({"no-such-program-of-spangle"});
    EXPECT_EQ(ran.status, no_program);
    EXPECT_EQ(ran.error, 0);
    EXPECT_EQ(missing.status, no_program);
    EXPECT_EQ(missing.error, ENOENT);
    const ExitStatus folder = run({"/"});
    EXPECT_EQ(folder.status, could_not_run);
    EXPECT_EQ(folder.error, EACCES);
}

TEST(Process, ConnectsEachStream) {
    TemporaryFile in;
    const TemporaryFile out, error;
    ASSERT_TRUE(in.put("three words here"));
    EXPECT_EQ(
        run({"sh", "-c", "cat; echo problem >&2"}, {in.descriptor(), out.descriptor(), error.descriptor()})
            .status,
        0);
    EXPECT_EQ(out.text(), "three words here");
    EXPECT_EQ(error.text(), "problem\n");
    const TemporaryFile quiet;
    EXPECT_EQ(run({"sh", "-c", "cat && echo gone && echo heard >&2"}, {nowhere, nowhere, quiet.descriptor()})
                  .status,
              0);
    EXPECT_EQ(quiet.text(), "heard\n");
}

/// The command line ignores SIGPIPE. Programs that it runs must still end by SIGPIPE, as in a shell.
TEST(Process, HasTheUsualSignals) {
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    EXPECT_EQ(run({"sh", "-c", "kill -PIPE $$; exit 3"}).status, of_signals + SIGPIPE);
    std::signal(SIGPIPE, before);
}

TEST(Names, AreThoseOfEveryPrecisionAndFormat) {
    for (EGLint value = EGL_PRECISION_EXACT_SPANGLE; value <= EGL_PRECISION_SHADOW_FAST_SPANGLE; ++value) {
        const names::Precision* const found =
            names::find(names::precisions, names::name_of(names::precisions, value));
        ASSERT_NE(found, nullptr) << value;
        EXPECT_EQ(found->value, value);
    }
    std::set<std::string> all;
    for (const names::Format& format : names::formats) {
        all.insert(format.name);
        EXPECT_EQ(names::find(names::formats, format.name)->value, format.value);
    }
    EXPECT_EQ(all.size(), 9u);
    EXPECT_EQ(names::find(names::formats, "565"), nullptr);
    EXPECT_STREQ(names::name_of(names::formats, PixelFormat::index8), "");
    EXPECT_EQ(names::listed(names::precisions),
              "exact, balanced, fast, double, shadow, shadow-balanced or shadow-fast");
}

} // namespace
} // namespace spangle::process
