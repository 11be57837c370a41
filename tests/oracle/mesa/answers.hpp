// Small programs of public GL whose result is numbers: what queries, selection, feedback and maps return. The
// numbers are compared with Mesa's.
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

/// Questions that are asked in a fresh context on a surface of `answer_size` pixels a side, RGBA8888 with 24
/// bits of depth.
struct Questions {
    const char* id;
    Answers (*ask)();
};
/// GoogleTest prints questions with this function.
inline void PrintTo(const Questions& questions, std::ostream* out) {
    *out << questions.id;
}

inline constexpr int answer_size = 64;
const std::vector<Questions>& all_questions();

} // namespace spangle::oracle
