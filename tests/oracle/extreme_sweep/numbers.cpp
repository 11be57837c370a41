#include "tests/oracle/extreme_sweep/numbers.hpp"

#include <cstring>
#include <limits>

namespace spangle::test {
namespace {

using Float = std::numeric_limits<float>;
using Double = std::numeric_limits<double>;

template <class T> constexpr double least = static_cast<double>(std::numeric_limits<T>::min());
template <class T> constexpr double most = static_cast<double>(std::numeric_limits<T>::max());
constexpr double denormal = static_cast<double>(Float::denorm_min());
constexpr double tiny = static_cast<double>(Float::min());
constexpr double next_to_one = 1 + static_cast<double>(Float::epsilon());

constexpr double floats[] = {0.0,
                             -0.0,
                             denormal,
                             -denormal,
                             tiny,
                             next_to_one,
                             1,
                             -1,
                             least<GLint>,
                             2147483648.0,
                             1e38,
                             -1e38,
                             most<float>,
                             -most<float>,
                             Double::infinity(),
                             -Double::infinity(),
                             Double::quiet_NaN()};
constexpr double doubles[] = {0.0,
                              -0.0,
                              Double::denorm_min(),
                              -Double::denorm_min(),
                              Double::min(),
                              1 + Double::epsilon(),
                              1,
                              -1,
                              least<GLint>,
                              most<GLint>,
                              1e38,
                              -1e38,
                              Double::max(),
                              -Double::max(),
                              Double::infinity(),
                              -Double::infinity(),
                              Double::quiet_NaN()};
constexpr double fixeds[] = {
    0, 1, -1, 65535, 65536, 65537, -65536, least<GLfixed>, least<GLfixed> + 1, most<GLfixed>};
constexpr double ints[] = {0, 1, -1, least<GLint>, least<GLint> + 1, most<GLint>};
constexpr double uints[] = {0, 1, most<GLint>, most<GLint> + 1, most<GLuint>};
constexpr double shorts[] = {0, 1, -1, least<GLshort>, most<GLshort>};
constexpr double ushorts[] = {0, 1, most<GLushort>};
constexpr double bytes[] = {0, 1, -1, least<GLbyte>, most<GLbyte>};
constexpr double ubytes[] = {0, 1, most<GLubyte>};

template <class T> void put_as(void* array, std::size_t index, double number) {
    const T value = static_cast<T>(number);
    std::memcpy(static_cast<unsigned char*>(array) + index * sizeof value, &value, sizeof value);
}

} // namespace

std::span<const double> extremes_of(char type) {
    switch (type) {
    case 'f':
        return floats;
    case 'd':
        return doubles;
    case 'x':
        return fixeds;
    case 'i':
    case 'l':
        return ints;
    case 'I':
        return uints;
    case 's':
        return shorts;
    case 'S':
        return ushorts;
    case 'b':
        return bytes;
    case 'B':
        return ubytes;
    default:
        return {};
    }
}

void put(void* array, char type, std::size_t index, double number) {
    switch (type) {
    case 'f':
        return put_as<GLfloat>(array, index, number);
    case 'd':
        return put_as<GLdouble>(array, index, number);
    case 'x':
        return put_as<GLfixed>(array, index, number);
    case 'i':
        return put_as<GLint>(array, index, number);
    case 'I':
        return put_as<GLuint>(array, index, number);
    case 's':
        return put_as<GLshort>(array, index, number);
    case 'S':
        return put_as<GLushort>(array, index, number);
    case 'b':
        return put_as<GLbyte>(array, index, number);
    case 'B':
        return put_as<GLubyte>(array, index, number);
    default:
        return;
    }
}

} // namespace spangle::test
