// The knobs of a tier by name, and tiers that a user composes of knobs.
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
    int least, most;         ///< numbers that the knob takes; none if most < least
    std::vector<Word> words; ///< words that it takes beside numbers
    const char* trades;      ///< what the knob trades, as a sentence
    std::uint8_t (*get)(const raster::Knobs&);
    void (*set)(raster::Knobs&, std::uint8_t);

    std::string text(const raster::Knobs& knobs) const; ///< the value, in the form in which it is read
    std::string range() const;                          ///< all values in words: "2 to 13, or never"
};

/// A knob for every field, in the order of the struct.
const std::vector<Knob>& knobs();

/// Reads "BASE[,KNOB=VALUE...]", where BASE is the name of a tier. Returns what is wrong with the text, or an
/// empty string.
std::string read_knobs(std::string_view words, Tier& out);
/// Reads "NAME=BASE[,KNOB=VALUE...]". A name has letters, digits and '-', and is no name in `taken`. Returns
/// what is wrong with the text, or an empty string.
std::string read_tier(std::string_view words, const std::vector<Tier>& taken, Tier& out);

/// A table of all knobs: their ranges, their values in the three tiers and in a user's own tiers, and what
/// each trades. At least two spaces lie between columns.
std::string knob_table(const std::vector<Tier>& own = {});

} // namespace spangle::trade
