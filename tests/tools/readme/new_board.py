#!/usr/bin/env python3
"""Follows docs/new-board.md to the letter: its board, glass and set-up program compile in place, and a board that cannot work does not.

usage: new_board.py COMPILER
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
ROOMS = ["gl/include", "hal/include", "raster/include", "raster/format/include"]
# The page asks for these changes in words: one include and one entry of boards::all.
TABLE = [('#include "st7789_240.hpp"', '#include "my_board.hpp"\n#include "st7789_240.hpp"'), ("all[] = {", "all[] = {&my_board, ")]
PROGRAM = """#include <spangle/boards/boards.hpp>
#include <spangle/hal/mapped_display.hpp>
using namespace spangle;
{glass}
{setup}
void scan(hal::ScanOut& port, std::uint8_t* first, std::uint8_t* second, RowSpan* rows) {{
{mapped}
    (void)display.init();
}}
void report(const char* rule, std::uint32_t detail);
void start(hal::Bus& bus) {{
{use}
}}
"""
# Each line of the board, changed so that it cannot work, and what the compiler must say.
WRONG = [(".write_hz = 40000000", ".write_hz = 400000000", "faster than this panel"), (".wait_te = false", ".wait_te = true", "no tearing-effect line"),
         (".read_back = false", ".read_back = true", "needs a read clock")]


def compiled(compiler, folder, board, program):
    boards = folder / "spangle/boards"
    (boards / "my_board.hpp").write_text(board)
    (folder / "program.cpp").write_text(program)
    include = [f"-I{folder}", *(f"-I{ROOT / room}" for room in ROOMS)]
    return subprocess.run([compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", *include, str(folder / "program.cpp")], capture_output=True, text=True)


def main():
    page = (ROOT / "docs/new-board.md").read_text().split("## 4. Firmware")[0]  # tests/system/boards follows the section on firmware
    glass, setup, mapped, board, use = re.findall(r"```cpp\n(.*?)```", page, re.S)
    use = "\n".join(line for line in use.splitlines() if not line.startswith("#include"))
    program = PROGRAM.format(glass=glass, setup=setup, mapped=mapped, use=use)
    failed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copytree(ROOT / "boards/include/spangle/boards", folder / "spangle/boards")
        table = folder / "spangle/boards/boards.hpp"
        for find, replace in TABLE:
            assert table.read_text().count(find) == 1, f"boards.hpp has not one '{find}'"
            table.write_text(table.read_text().replace(find, replace))
        done = compiled(sys.argv[1], folder, board, program)
        if done.returncode != 0:
            failed += 1
            print("docs/new-board.md does not compile\n" + done.stderr[:3000])
        for find, replace, rule in WRONG:
            assert board.count(find) == 1, f"the page's board has not one '{find}'"
            done = compiled(sys.argv[1], folder, board.replace(find, replace), program)
            if done.returncode == 0 or rule not in done.stderr:
                failed += 1
                print(f"{replace}: the compiler does not say '{rule}'\n{done.stderr[:2000]}")
    print("docs/new-board.md:", "wrong" if failed else "as it says")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
