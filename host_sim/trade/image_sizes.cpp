// The flash and RAM that an ELF image takes, from its sections.
#include <cstring>
#include <fstream>
#include <sstream>

#include <elf.h>

#include "host_sim/trade/targets.hpp"

namespace spangle::trade {

namespace {

/// Reads a structure of the file. Returns false where the file ends too early.
template <class T> bool take(const std::string& bytes, std::uint64_t at, T& out) {
    if (at > bytes.size() || bytes.size() - at < sizeof out)
        return false;
    std::memcpy(&out, bytes.data() + at, sizeof out);
    return true;
}

} // namespace

std::string read_sizes(const std::string& image, ImageSizes& out) {
    std::ifstream file(image, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file)
        return "cannot read '" + image + "'";
    const std::string bytes = text.str();
    Elf32_Ehdr head{};
    if (!take(bytes, 0, head) || std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0 ||
        head.e_ident[EI_CLASS] != ELFCLASS32 || head.e_ident[EI_DATA] != ELFDATA2LSB)
        return "'" + image + "' is no ELF image of 32 bits";
    Elf32_Shdr names{};
    const auto section = [&](unsigned i, Elf32_Shdr& to) {
        return take(bytes, head.e_shoff + std::uint64_t{i} * head.e_shentsize, to);
    };
    if (!section(head.e_shstrndx, names))
        return "'" + image + "' has no sections";
    for (unsigned i = 0; i < head.e_shnum; ++i) {
        Elf32_Shdr s{};
        if (!section(i, s))
            return "'" + image + "' is cut off";
        if ((s.sh_flags & SHF_ALLOC) == 0)
            continue;
        // Sections with bytes are stored in flash; writable sections are copied to RAM first. The stack is
        // measured, not reserved, so that its section does not count.
        const std::uint64_t name = std::uint64_t{names.sh_offset} + s.sh_name;
        const bool stack = name < bytes.size() && std::strcmp(bytes.c_str() + name, ".stack") == 0;
        out.flash += s.sh_type != SHT_NOBITS ? s.sh_size : 0;
        out.variables += (s.sh_flags & SHF_WRITE) != 0 && !stack ? s.sh_size : 0;
    }
    return "";
}

} // namespace spangle::trade
