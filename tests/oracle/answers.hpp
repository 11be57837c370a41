// Small programs of public GL whose result is numbers: what queries, selection, feedback and maps give back,
// to be held against Mesa's.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace spangle::oracle {

struct Answer {
    std::string question;
    std::vector<double> values;
};
using Answers = std::vector<Answer>;

/// Asks in a fresh context on a surface of `answer_size` pixels a side, RGBA8888 with 24 bits of depth.
struct Questions {
    const char* id;
    Answers (*ask)();
};
/// For GoogleTest.
inline void PrintTo(const Questions& questions, std::ostream* out) {
    *out << questions.id;
}

inline constexpr int answer_size = 64;
const std::vector<Questions>& all_questions();

} // namespace spangle::oracle
