// The committed generated files are what the table says, the public header is C, and the versions agree.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "gl/api/names.hpp"
#include "gl/context/version.hpp"
#include "tests/gl/api/command_table.hpp"
#include "tests/source_dir.hpp"

namespace spangle::test {
namespace {

const std::string root = SPANGLE_SOURCE_DIR;

std::string read(const std::string& path) {
    std::ifstream file(root + "/" + path);
    EXPECT_TRUE(file.good()) << path;
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Generated, IsFresh) {
    EXPECT_EQ(std::system(("python3 '" + root + "/gl/api/generate.py' --check").c_str()), 0);
}

TEST(Generated, HeaderIsC) {
    for (const char* standard : {"c89 -pedantic", "c11 -pedantic"})
        EXPECT_EQ(
            std::system(
                ("echo '#include <spangle/GL/gl.h>' | cc -x c -fsyntax-only -Wall -Wextra -Werror -std=" +
                 std::string(standard) + " -I'" + root + "/gl/include' -")
                    .c_str()),
            0)
            << standard;
}

TEST(Generated, HeaderDeclaresExactlyTheTable) {
    const std::string header = read("gl/include/spangle/GL/gl.h");
    std::set<std::string> declared, known;
    for (std::size_t at = 0; (at = header.find("GLAPIENTRY gl", at)) != std::string::npos; ++at)
        declared.insert(header.substr(at + 11, header.find('(', at) - at - 11));
    for (const Command& c : commands())
        known.insert(c.name);
    EXPECT_EQ(declared, known);
}

TEST(Generated, ProcAddresses) {
    for (const Command& c : commands()) {
        EXPECT_EQ(gl::find_entry_point(c.name) != nullptr, SPANGLE_FEATURE_GET_PROC_ADDRESS != 0) << c.name;
    }
    for (const char* absent : {"", "g", "gl", "glBegi", "glBegin2", "glZ", "glAccumulate", "glVertex3xOESx"})
        EXPECT_EQ(gl::find_entry_point(absent), nullptr) << absent;
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    EXPECT_EQ(gl::find_entry_point("glVertex3f"), reinterpret_cast<gl::EntryPoint>(&glVertex3f));
#endif
}

// A library that exports names with a suffix forwards calls as these functions do.
#define ALIAS(returns, name, command, parameters, arguments)                                                 \
    [[maybe_unused]] returns name parameters {                                                               \
        return command arguments;                                                                            \
    }                                                                                                        \
    static_assert(std::is_same_v<decltype(&name), decltype(&::command)>);
namespace alias {
#include "gl/api/generated/aliases.inc"
} // namespace alias
#undef ALIAS

/// Extensions call core commands by names with a suffix; eglGetProcAddress returns the command itself.
TEST(Generated, NamesWithASuffix) {
    struct Alias {
        std::string name, command;
        gl::EntryPoint function;
    };
    const Alias aliases[] = {
#define ALIAS(returns, name, command, parameters, arguments)                                                 \
    {#name, #command, reinterpret_cast<gl::EntryPoint>(&command)},
#include "gl/api/generated/aliases.inc"
#undef ALIAS
    };
    EXPECT_GT(std::size(aliases), 125u);
    for (const Alias& alias : aliases) {
        EXPECT_EQ(alias.name.substr(0, alias.command.size()), alias.command);
        const std::string suffix = alias.name.substr(alias.command.size());
        EXPECT_TRUE(suffix == "ARB" || suffix == "EXT") << alias.name;
        EXPECT_EQ(gl::find_entry_point(alias.name.c_str()),
                  SPANGLE_FEATURE_GET_PROC_ADDRESS ? alias.function : nullptr)
            << alias.name;
    }
}

TEST(Generated, VersionIsTheProjects) {
    EXPECT_NE(read("CMakeLists.txt").find("project(Spangle VERSION " SPANGLE_VERSION), std::string::npos);
}

} // namespace
} // namespace spangle::test
