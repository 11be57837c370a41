// The knobs of a tier by name, and tiers that a user composes of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/trade/choice.hpp"

namespace spangle::trade {

/// One field of raster::Knobs.
struct Knob {
    struct Word {
        const char* text;
        std::uint8_t value;
    };
    const char* name;
    int least, most;         ///< numbers it takes; none where most is below
    std::vector<Word> words; ///< and words
    const char* trades;      ///< a sentence
    std::uint8_t (*get)(const raster::Knobs&);
    void (*set)(raster::Knobs&, std::uint8_t);

    std::string text(const raster::Knobs& knobs) const; ///< its value, as it is read
    std::string range() const;                          ///< "2 to 13, or never"
};

/// Every field, in the order of the struct.
const std::vector<Knob>& knobs();

/// Reads "BASE[,KNOB=VALUE...]", BASE a tier. Empty, or what is wrong with it.
std::string read_knobs(std::string_view words, Tier& out);
/// Reads "NAME=BASE[,KNOB=VALUE...]". A name has letters, digits and '-', and is none of `taken`. Empty, or
/// what is wrong with it.
std::string read_tier(std::string_view words, const std::vector<Tier>& taken, Tier& out);

/// A table of all knobs: ranges, values of the three tiers and of a user's own ones, what each trades. At
/// least two spaces lie between columns.
std::string knob_table(const std::vector<Tier>& own = {});

} // namespace spangle::trade
