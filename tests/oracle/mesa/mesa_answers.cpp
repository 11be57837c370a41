// Asks Mesa the questions of answers.hpp, and prints a line for each: the question and its numbers.
//
// usage: mesa_answers QUESTIONS
#include <cstdio>
#include <cstring>
#include <vector>

#include <GL/osmesa.h>

#include "tests/oracle/mesa/answers.hpp"

int main(int argc, char** argv) {
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
    constexpr int side = spangle::oracle::answer_size;
    std::vector<unsigned char> pixels(static_cast<std::size_t>(side) * side * 4);
    if (argc != 2 || context == nullptr ||
        OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, side, side) == 0)
        return 1;
    for (const spangle::oracle::Questions& questions : spangle::oracle::all_questions())
        if (std::strcmp(questions.id, argv[1]) == 0) {
            for (const spangle::oracle::Answer& answer : questions.ask()) {
                std::printf("%s\t", answer.question.c_str());
                for (const double value : answer.values)
                    std::printf(" %.17g", value);
                std::printf("\n");
            }
            return 0;
        }
    return 1;
}
