// Queries, selection, feedback, maps and lists must return what Mesa returns.
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "tests/oracle/mesa/answers.hpp"
#include "tests/support/headless_gl.hpp"

namespace {

using spangle::oracle::Answers;
using spangle::oracle::Questions;

Answers ask_mesa(const char* id) {
    const std::string command = std::string("ASAN_OPTIONS=detect_leaks=0 '" MESA_ANSWERS "' ") + id;
    std::FILE* const pipe = popen(command.c_str(), "r");
    std::string text;
    char part[4096];
    while (pipe != nullptr && std::fgets(part, sizeof part, pipe) != nullptr)
        text += part;
    EXPECT_EQ(pipe != nullptr ? pclose(pipe) : -1, 0);
    Answers answers;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t tab = line.find('\t');
        std::istringstream numbers(line.substr(tab + 1));
        answers.push_back({line.substr(0, tab), {}});
        for (double v = 0; numbers >> v;)
            answers.back().values.push_back(v);
    }
    return answers;
}

Answers ask_spangle(const Questions& questions) {
    const spangle::test::HeadlessGl current(spangle::oracle::answer_size, spangle::oracle::answer_size,
                                            {EGL_STENCIL_SIZE, 8});
    return questions.ask();
}

class AnswersOf : public testing::TestWithParam<Questions> {};

/// Compares floats of two implementations: within 1e-5 of the value (GL 1.3, 2.1.1) or of 1, which also
/// covers the last bits of a colour read as an integer.
bool agree(double a, double b) {
    return std::fabs(a - b) <= std::max(1.0, std::fabs(b)) * 1e-5;
}

TEST_P(AnswersOf, AreMesas) {
    const Answers theirs = ask_mesa(GetParam().id), ours = ask_spangle(GetParam());
    ASSERT_EQ(ours.size(), theirs.size());
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        ASSERT_EQ(ours[i].question, theirs[i].question);
        ASSERT_EQ(ours[i].values.size(), theirs[i].values.size()) << i << ": " << ours[i].question;
        for (std::size_t n = 0; n < ours[i].values.size(); ++n, ++numbers)
            EXPECT_TRUE(agree(ours[i].values[n], theirs[i].values[n]))
                << i << ": " << ours[i].question << ", number " << n << ": " << ours[i].values[n]
                << ", Mesa says " << theirs[i].values[n];
    }
    std::printf("%s: %zu numbers\n", GetParam().id, numbers);
    EXPECT_GT(numbers, 50u);
}

INSTANTIATE_TEST_SUITE_P(All, AnswersOf, testing::ValuesIn(spangle::oracle::all_questions()),
                         [](const auto& info) { return std::string(info.param.id); });

} // namespace
